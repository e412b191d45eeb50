"""Springs and rigid discs that follow the mean motions of boundaries of a body, in harmonic 1."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array
from skfem import Basis

from fem.fourier.vibration_parts import mean_motion
from fem.plane.discretisation import Array


@dataclass(frozen=True, kw_only=True)
class Mount:
    """Isotropic spring from a boundary to the ground, or to another boundary `to`.

    The ends of the spring follow the mean motions of the boundaries. `k` acts across the axis
    [force/length], `k_tilt` against tilting [force x length/rad].
    """

    boundary: str
    k: float = 0.0
    k_tilt: float = 0.0
    to: str = ""

    def __post_init__(self) -> None:
        for name, value in (("k", self.k), ("k_tilt", self.k_tilt)):
            if not 0 <= value < np.inf:
                raise ValueError(f"spring stiffness must not be negative, got {name}={value:g}")


@dataclass(frozen=True, kw_only=True)
class RigidDisc:
    """Rigid disc whose centre follows the mean motion of `boundary`.

    `polar` and `diametral` are its moments of inertia [mass x length^2]; `ratio` is the ratio of
    its speed to the speed of the rotor.
    """

    boundary: str
    mass: float
    polar: float
    diametral: float
    ratio: float = 1.0

    def __post_init__(self) -> None:
        if min(self.mass, self.polar, self.diametral) < 0 or self.polar > 2 * self.diametral:
            raise ValueError(
                "a disc must have mass >= 0 and 0 <= polar <= 2 diametral, got "
                f"mass={self.mass:g}, polar={self.polar:g}, diametral={self.diametral:g}"
            )


def pulls_of(basis: Basis, T: csr_array, mounts: Sequence[Mount]) -> list[Array]:
    """Vectors c (free,), one for each stiffness of a spring, with the energy (c . q)^2/2.

    q (free,) are the free unknowns in u = T q.
    """
    found = []
    for mount in mounts:
        c = mean_motion(basis, mount.boundary)
        if mount.to:
            c = c - mean_motion(basis, mount.to)
        stiffness = (mount.k, mount.k_tilt)
        found += [
            np.sqrt(k) * row for k, row in zip(stiffness, np.asarray(T.T @ c).T, strict=True) if k
        ]
    return found


def inertias(
    basis: Basis,
    T: csr_array,
    discs: Sequence[RigidDisc],
    of: Callable[[RigidDisc], tuple[float, float]],
) -> csr_array:
    """Inertia matrix (free, free) of all discs.

    `of` returns the inertia of a disc against lateral motion, and against tilt.
    """
    motions = [c for d in discs for c in np.asarray(T.T @ mean_motion(basis, d.boundary)).T]
    weights = np.array([of(disc) for disc in discs]).ravel()
    return squares(motions, weights, T.shape[1])


def squares(rows: Sequence[Array], weights: Array, size: int) -> csr_array:
    """Sum (size, size) of the weighted outer products of each of `rows` with itself."""
    if not len(rows):
        return csr_array((size, size))
    C = csr_array(np.array(rows))
    return csr_array(C.T @ (C * weights[:, None]))
