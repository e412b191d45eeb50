"""Whirling of elastic bodies of revolution that rotate about one axis at different speeds.

solid = FourierSolid(mesh, Elastic(E=210e9, nu=0.3))
found = RotatingSolid(solid, 7850.0, springs=(Mount(boundary="rim", k=1e8),)).modes(1000.0)

The equations are those of harmonic n with amplitudes u = (U, V, W) at the speed Omega and the
angular frequency w. A wave with w > 0 is a forward wave, in the sense of Omega > 0:

    K u + w Omega G u - w^2 M u = 0,    and with x = (u, w u)
    diag(K, M) x = w [[-Omega G, M], [M, 0]] x.

The second form is symmetric, with a positive definite left side, and requires only the factors of K
at any speed. Lanczos' method finds the largest 1/w of both signs.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.linalg import LinearOperator, eigsh

from fem.cholesky import Cholesky
from fem.fourier.loads import turn_of
from fem.fourier.solid import FourierSolid
from fem.fourier.supports import free_unknowns
from fem.fourier.vibration_held import check_held_or_sprung
from fem.fourier.vibration_mounts import (
    Mount,
    RigidDisc,
    inertias,
    pulls_of,
    squares,
)
from fem.fourier.vibration_parts import by_body, gyroscopic_form, mass_matrix, mean_motion
from fem.plane.discretisation import Array
from fem.rotor.splitting import Whirl, gyroscopic_splitting

RESIDUAL_LIMIT = 1e-5  # relative to a mode, in the energy's norm: its frequency errs by the square
TOLERANCE = 1e-12  # Lanczos', of 1/w
NO_SPEED = 1e-12  # 1/Omega^2 of the lowest speed: below, roots are zero but for round-off
SEED = 1


@dataclass(frozen=True)
class WhirlModes:
    """Angular frequencies (count,) of forward and backward waves at `speed`, in ascending order.

    `forward_shapes` and `backward_shapes` (unknowns, count) contain amplitudes (U, V, W) of unit
    modal mass. `splitting` (count,) is the forward minus the backward frequency. The relative
    accuracy of `splitting` is that of a frequency, also if both frequencies are nearly equal.
    """

    speed: float
    forward: Array
    backward: Array
    forward_shapes: Array
    backward_shapes: Array
    splitting: Array


@dataclass(frozen=True)
class RotatingSolid:
    """Bodies of `solid` with the density `rho`, rotating at `ratio` times the speed of the rotor.

    Density and ratio are one value for all bodies, or one for each body of the mesh. Springs and
    discs belong to harmonic n = 1. Raises ValueError for a density that is not positive, n < 1,
    springs or discs if n is not 1, and bodies that can move rigidly.
    """

    solid: FourierSolid
    rho: float | Mapping[str, float]
    ratio: float | Mapping[str, float] = 1.0
    springs: tuple[Mount, ...] = ()
    discs: tuple[RigidDisc, ...] = ()
    n: int = 1

    def __post_init__(self) -> None:
        if self.n != int(self.n) or self.n < 1:
            raise ValueError(f"waves around the axis require a harmonic n >= 1, got n={self.n}")
        if self.n != 1 and (self.springs or self.discs):
            raise ValueError(f"springs and discs require harmonic n = 1, got n={self.n}")
        if np.any(by_body(self.solid.basis, self.rho, "density") <= 0):
            raise ValueError(f"density must be positive, got rho={self.rho}")
        by_body(self.solid.basis, self.ratio, "ratio of speeds")

    @cached_property
    def T(self) -> csr_array:
        """Matrix T of u = T q, with the free unknowns q in their order of elimination."""
        solid = self.solid
        return free_unknowns(solid.basis, solid.supports, self.n, False, solid.place)

    @cached_property
    def K(self) -> csr_array:
        """Stiffness (free, free), including springs."""
        K_0, K_1, K_2 = self.solid.parts
        K = turn_of(self.n) * (self.T.T @ (K_0 + self.n * K_1 + self.n**2 * K_2) @ self.T)
        pulls = pulls_of(self.solid.basis, self.T, self.springs)
        check_held_or_sprung(self.solid.basis, self.T, self.n, pulls)
        return csr_array(K + squares(pulls, np.ones(len(pulls)), self.T.shape[1]))

    @cached_property
    def M(self) -> csr_array:
        """Mass (free, free), including discs."""
        density = by_body(self.solid.basis, self.rho, "density")
        return self._inertia(density, np.eye(3)) + inertias(
            self.solid.basis, self.T, self.discs, lambda disc: (disc.mass, disc.diametral)
        )

    @cached_property
    def G(self) -> csr_array:
        """Gyroscopic matrix (free, free) for unit speed of the rotor."""
        density = by_body(self.solid.basis, self.rho, "density")
        ratio = by_body(self.solid.basis, self.ratio, "ratio of speeds")
        return self._inertia(density * ratio, gyroscopic_form(self.n)) + inertias(
            self.solid.basis, self.T, self.discs, lambda disc: (0.0, disc.ratio * disc.polar)
        )

    @cached_property
    def factor(self) -> Cholesky:
        """Factors of K, which are used at all speeds."""
        return Cholesky(self.K)

    def modes(self, speed: float, count: int = 4) -> WhirlModes:
        """Lowest `count` forward and backward modes at `speed` [rad/time].

        Raises ArithmeticError if the residual of a mode exceeds 1e-5 of its elastic forces.
        """
        K, M, size = self.K, self.M, self.K.shape[0]
        if not np.isfinite(speed) or not 1 <= count < size // 2:
            raise ValueError(
                "modes require a finite speed and 1 <= count < half of the free unknowns, "
                f"got speed={speed:g}, count={count}"
            )
        G = self.G if speed else csr_array((size, size))

        last = np.zeros(size)

        def right(x: Array) -> Array:
            q, y = x[:size], x[size:]
            last[:] = q
            return np.concatenate([M @ y - speed * (G @ q), M @ q])

        def left(x: Array) -> Array:
            return np.concatenate([K @ x[:size], M @ x[size:]])

        def solved(x: Array) -> Array:
            # ARPACK calls this right after `right`: the second half is M q, whose solution is q
            return np.concatenate([self.factor.solve(x[:size]), last])

        found, x = eigsh(
            _operator(right, 2 * size), 2 * count, M=_operator(left, 2 * size),
            Minv=_operator(solved, 2 * size), which="BE", tol=TOLERANCE, v0=_start(2 * size),
            ncv=max(20, 5 * count),
        )  # fmt: skip
        q = x[:size] / np.sqrt((x[:size] * (M @ x[:size])).sum(axis=0))
        # w^2 - 2 half w - q K q = 0 is stationary at a mode: errors of q enter by their square
        half = speed * (q * (G @ q)).sum(axis=0) / 2
        w = half + np.sign(found) * np.sqrt(half**2 + (q * (K @ q)).sum(axis=0))
        self._check(w, q, K @ q + (w * speed) * (G @ q) - w**2 * (M @ q))
        ahead, behind = _sorted(w, q)
        splitting = gyroscopic_splitting(speed, M, G, ahead, behind)
        forward, backward = (np.asarray(self.T @ whirl.shapes) for whirl in (ahead, behind))
        return WhirlModes(speed, ahead.w, behind.w, forward, backward, splitting)

    def critical_speeds(self, count: int = 2, *, excitation: float = 1.0) -> tuple[Array, Array]:
        """Speeds Omega (found,) at which `excitation` Omega is a natural frequency, and mode shape.

        The lowest `count` speeds are returned. There are fewer if gyroscopic forces prevent some
        modes from having a critical speed: only positive roots 1/Omega^2 of (e^2 M - e G) u = K
        u/Omega^2 belong to speeds, with e = `excitation`. A negative `excitation` gives backward
        modes.
        """
        e, size = excitation, self.K.shape[0]
        B = csr_array(e**2 * self.M - e * self.G)
        found, q = eigsh(
            B, count, M=self.K, Minv=_operator(self.factor.solve, size), which="LA",
            tol=TOLERANCE, v0=_start(size), ncv=max(20, 5 * count),
        )  # fmt: skip
        q = q[:, found > found.max(initial=0.0) * NO_SPEED]
        q = q / np.sqrt((q * (self.M @ q)).sum(axis=0))
        speeds = np.sqrt((q * (self.K @ q)).sum(axis=0) / (q * (B @ q)).sum(axis=0))
        self._check(speeds, q, self.K @ q - speeds**2 * (B @ q))
        order = np.argsort(speeds)
        return speeds[order], np.asarray(self.T @ q[:, order])

    def motion(self, boundary: str, shapes: Array) -> Array:
        """Mean lateral displacement and tilt (2, ...) of `boundary` in `shapes` (unknowns, ...)."""
        return np.asarray(mean_motion(self.solid.basis, boundary).T @ shapes)

    def _inertia(self, density: Array, form: Array) -> csr_array:
        whole = mass_matrix(self.solid.cells, self.solid.basis, self.n, density, form)
        return csr_array(self.T.T @ whole @ self.T)

    def _check(self, w: Array, q: Array, residual: Array) -> None:
        """Raise ArithmeticError if the residual of modes of unit modal mass exceeds its limit."""
        missed = abs((residual * self.factor.solve(residual)).sum(axis=0))
        error = np.sqrt(missed / ((q * (self.K @ q)).sum(axis=0) + w**2))
        if not np.all(error < RESIDUAL_LIMIT):
            raise ArithmeticError(
                f"modes of harmonic {self.n} have too large a residual, {error.max():.1e}"
            )


def _operator(apply, size: int) -> LinearOperator:
    return LinearOperator((size, size), matvec=apply, dtype=float)


def _start(size: int) -> Array:
    """Initial vector with components of all modes, identical in every run."""
    return np.random.default_rng(SEED).standard_normal(size)


def _sorted(w: Array, shapes: Array) -> tuple[Whirl, Whirl]:
    """Forward and backward whirl, each by ascending frequency."""
    ahead = np.flatnonzero(w > 0)
    behind = np.flatnonzero(w < 0)
    ahead, behind = ahead[np.argsort(w[ahead])], behind[np.argsort(-w[behind])]
    return Whirl(w[ahead], shapes[:, ahead]), Whirl(-w[behind], shapes[:, behind])
