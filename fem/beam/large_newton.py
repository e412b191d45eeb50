"""Newton's method for a geometrically exact frame with one load factor.

The geometric stiffness takes the section forces that the last step predicted, not those of the
new displacements (mixed integration points, Magisano, Leonetti & Garcea 2017): the root is the
same, and stiff members, whose axial force a finite rotation upsets, converge with large steps.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from fem.beam.large_elements import Elements, Extended
from fem.beam.large_loading import Loading, Mask
from fem.beam.large_state import State
from fem.beam.section import Array
from fem.beam.terms import Term

TOLERANCE = 1e-10  # residual, relative to the forces between nodes and elements
ROUND_OFF = 1e-7  # the same where steps have become round-off
STILL = 1e-14  # a step that is round-off, relative to the size of the frame
MAX_ITERATIONS = 25
MAX_SETTLEMENTS = 40
MAX_TURN = 1.5  # rotation in one iteration [rad] beyond which the tangent means nothing


class Control(Protocol):
    """What closes the equations besides equilibrium: a given factor, a given arc.

    `kink` is how far a step may leave its prediction where terms have kinks, relative to the
    length of the prediction, squared.
    """

    kink: float

    def correct(self, moved: Array, step: Array, push: Array) -> float:
        """Change of the factor; all arrays (3n,).

        `moved` is the displacement since the start, `step` the next one at constant factor
        and `push` the displacement per factor.
        """
        ...

    def speed(self, push: Array, moved: Array) -> float:
        """Change of the factor over the whole step at the rate of the place of `push`."""
        ...


class ConvergenceError(ArithmeticError):
    """Newton's method failed; a smaller step may help."""


@dataclass(frozen=True)
class Tangent:
    """Factorised stiffness: `push` (3n,) is du/dfactor, `negative` its negative pivots."""

    K: csc_array
    solve: Callable[[Array], Array]
    push: Array
    negative: int


@dataclass(frozen=True)
class Response:
    """What the frame answers at some displacements; `size` measures its nodal forces."""

    strain_energy: float
    term_energy: float
    internal: Array
    residual: Array
    size: float
    K: csc_array
    predict: Callable[[Array], Array]  # section forces after a step


@dataclass(frozen=True)
class Balance:
    """Equilibrium of a frame under base + factor x pattern with held components."""

    points: Array
    elements: Elements
    terms: Sequence[Term]
    base: Loading
    pattern: Loading
    held: Mask

    @property
    def length(self) -> float:
        """Size of the frame, which makes couples and rotations comparable."""
        return float(np.hypot(*np.ptp(self.points, axis=0)))

    @property
    def weights(self) -> Array:
        """Of displacements (3n,) where they are compared: lengths by the frame's, and per node."""
        return np.tile([self.length**-2, self.length**-2, 1.0], len(self.points)) / len(self.points)

    def positions(self, u: Extended) -> Array:
        x = u.astype(float)
        x[:, :2] += self.points
        return x

    def respond(self, u: Extended, factor: float, stress: Array | None = None) -> Response:
        """Residual and tangent; `stress` stands in the geometric stiffness."""
        e = self.elements
        strain, _, t = e.strains(u)
        S, true = e.increments(strain, t), e.moduli * strain
        internal, parts = e.forces(S, true)
        size = self._measure(parts) ** 2
        K = e.tangent_stiffness(S, strain, t, true if stress is None else stress)
        energy = float(((true * strain).sum(axis=-1) * e.weight).sum()) / 2
        stored, x = 0.0, self.positions(u)
        for term in self.terms:
            part, force, slope = term.evaluate(x)
            stored, internal, K = stored + part, internal + force, csc_array(K + slope)
            size += self._measure(force.reshape(-1, 3)) ** 2
        acting = self.base.plus(factor, self.pattern)
        if (slope := acting.slope(u)) is not None:
            K = csc_array(K - slope)
        forces = acting.forces(u)
        size += self._measure(forces.reshape(-1, 3)) ** 2
        residual = np.where(self.held, 0.0, forces - internal)

        def predict(step: Array) -> Array:
            return e.moduli * (strain + e.change(S, step.reshape(-1, 3)))

        return Response(energy, stored, internal, residual, math.sqrt(size), K, predict)

    def factorise(self, u: Extended, K: csc_array) -> Tangent:
        """Tangent at held components; ConvergenceError where it is singular."""
        free = ~self.held
        try:
            factor = splu(
                reduced(K, free),
                permc_spec="MMD_AT_PLUS_A",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError as error:  # SuperLU's word for a zero pivot
            raise ConvergenceError("the tangent stiffness is singular") from error

        def solve(f: Array) -> Array:
            step = np.zeros(f.size)
            step[free] = factor.solve(f[free])
            return step

        push = self.pattern.moved.copy()
        push += solve(self.pattern.forces(u) - K @ push)
        return Tangent(K, solve, push, int((factor.U.diagonal() < 0).sum()))

    def solve(
        self, start: State, step: Array, change: float, stress: Array, control: Control
    ) -> tuple[Extended, float, Response, tuple[float, ...]]:
        """Displacements, factor and response in equilibrium, and the residuals on the way.

        Begins with the predicted `step` and `change` of the factor; ConvergenceError otherwise.
        """
        u, factor = start.exact + step.reshape(-1, 3), start.factor + change
        history: list[float] = []
        noise = self.elements.noise * self.length
        settlements, last = 0, MAX_ITERATIONS
        while len(history) < last:
            found = self.respond(u, factor, stress)
            size = self._measure(found.residual.reshape(-1, 3))
            history.append(size / found.size if found.size else 0.0)
            still = self._moved(step) < STILL and size < max(ROUND_OFF * found.size, noise)
            if history[-1] < TOLERANCE or still:
                if not self._unsettled(u):
                    return u, factor, found, tuple(history)
                settlements, last = settlements + 1, len(history) + MAX_ITERATIONS
                if settlements > MAX_SETTLEMENTS:
                    raise ConvergenceError(f"the terms do not settle in {MAX_SETTLEMENTS} rounds")
                found = self.respond(u, factor)
            if not math.isfinite(history[-1]):
                break
            tangent = self.factorise(u, found.K)
            step = tangent.solve(found.residual)
            more = control.correct((u - start.exact).astype(float).ravel(), step, tangent.push)
            step = step + more * tangent.push
            if not float(abs(step[2::3]).max()) < MAX_TURN:
                break
            stress = found.predict(step)
            u, factor = u + step.reshape(-1, 3), factor + more
        tried = len(history)
        raise ConvergenceError(f"relative residual {history[-1]:.1e} after {tried} iterations")

    def _unsettled(self, u: Extended) -> bool:
        asked = [term.settle(self.positions(u)) for term in self.terms]  # every one of them
        return any(asked)

    def _measure(self, f: Array) -> float:
        """Norm of forces and couples (..., 3), couples divided by the frame's length."""
        return math.sqrt(float((f[..., :2] ** 2).sum() + (f[..., 2] ** 2).sum() / self.length**2))

    def _moved(self, step: Array) -> float:
        x, y, turn = abs(step).reshape(-1, 3).max(axis=0)
        return max(float(max(x, y)) / self.length, float(turn))


def reduced(K: csc_array, free: Mask) -> csc_array:
    """Rows and columns that are free."""
    column = np.repeat(np.arange(K.shape[1]), np.diff(K.indptr))
    keep = free[K.indices] & free[column]
    number = np.cumsum(free) - 1
    starts = np.concatenate([[0], np.cumsum(np.bincount(column[keep], minlength=free.size)[free])])
    size = int(free.sum())
    return csc_array((K.data[keep], number[K.indices[keep]], starts), shape=(size, size))
