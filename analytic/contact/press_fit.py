r"""Press fit: a stack of concentric walls with interference between neighbours.

At every interface the bore of the outer wall and the rim of the inner wall, which differ by the
interference before assembly, get one common radius:

.. math:: u_{j+1}(r_j) - u_j(r_j) = \delta_j,

with Lamé's displacements of each wall under the contact pressures on both sides. This is a
tridiagonal linear system. A solid shaft is a wall with r_i = 0. Pressures are positive in
compression. Interferences are radial (half the difference of diameters) and positive if the parts
overlap. Any consistent units.

Range: linear elasticity, small strain, radii of an interface equal except for the interference; end
faces free to move axially (plane stress) or axially fixed (plane strain).

References
----------
.. [1] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed.,
   McGraw-Hill 1970, art. 28.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, Assumption, finite, in_plane, not_negative, positive


@dataclass(frozen=True)
class Wall:
    """Ring (or, with r_i = 0, solid shaft) with its radii [length], E [stress] and nu [1].

    Raises ValueError unless 0 <= r_i < r_o and E > 0.
    """

    r_i: float
    r_o: float
    E: float
    nu: float

    def __post_init__(self) -> None:
        positive(self.E, "Young's modulus", "Pa")
        in_plane(self.E, self.nu, "plane stress")
        if not 0 <= self.r_i < self.r_o < np.inf:
            raise ValueError(
                f"radii of a wall must satisfy 0 <= r_i < r_o, got r_i={self.r_i} m, "
                f"r_o={self.r_o} m"
            )

    def stresses(self, r: ArrayLike, *, p_i: float, p_o: float) -> tuple[Array, Array]:
        """Radial and hoop stress [stress] at the radii r under the pressures at bore and rim."""
        r = self._inside(r)
        A, B = self._constants(p_i, p_o)
        bend = B / np.where(r > 0, r, 1.0) ** 2  # B = 0 where r may be 0
        return A - bend, A + bend

    def displacement(
        self, r: ArrayLike, *, p_i: float, p_o: float, assumption: Assumption
    ) -> Array:
        """Radial displacement [length] at the radii r; outward is positive."""
        r = self._inside(r)
        E, nu = in_plane(self.E, self.nu, assumption)
        A, B = self._constants(p_i, p_o)
        return np.asarray(((1 - nu) * A * r + (1 + nu) * B / np.where(r > 0, r, 1.0)) / E)

    def strain_energy(self, *, p_i: float, p_o: float, assumption: Assumption) -> float:
        """Strain energy [stress x length²] of the wall per unit axial length.

        It is half the work of the pressures.
        """
        bore, rim = self.displacement([self.r_i, self.r_o], p_i=p_i, p_o=p_o, assumption=assumption)
        return float(np.pi * (p_i * self.r_i * bore - p_o * self.r_o * rim))

    def _constants(self, p_i: float, p_o: float) -> tuple[float, float]:
        area = self.r_o**2 - self.r_i**2
        A = (p_i * self.r_i**2 - p_o * self.r_o**2) / area
        return A, (p_i - p_o) * self.r_i**2 * self.r_o**2 / area

    def _inside(self, r: ArrayLike) -> Array:
        r = not_negative(r, "radius", "m")
        slack = 1e-12 * self.r_o
        if not np.all((r >= self.r_i - slack) & (r <= self.r_o + slack)):
            raise ValueError(f"radius r must lie in the wall [{self.r_i}, {self.r_o}] m, got {r} m")
        return r


def contact_pressures(
    walls: Sequence[Wall],
    interferences: ArrayLike,
    *,
    p_i: float = 0.0,
    p_o: float = 0.0,
    assumption: Assumption,
) -> Array:
    """Pressures [stress] at the interfaces from the innermost outward, shape (walls - 1,).

    p_i acts on the innermost bore, p_o on the outermost rim. Raises ValueError if an interface
    opens (negative pressure).

    >>> steel = {"E": 2.0, "nu": 0.25}
    >>> shaft, hub = Wall(r_i=0.0, r_o=1.0, **steel), Wall(r_i=1.0, r_o=2.0, **steel)
    >>> p = contact_pressures([shaft, hub], 0.1, assumption="plane stress")
    >>> p.round(12).tolist()  # E delta / r (1 - (r/r_o)²) / 2
    [0.075]
    """
    delta = _interferences(walls, interferences)
    stiffness = _stiffness(walls, assumption)
    lost = interferences_lost(walls, p_i=p_i, p_o=p_o, assumption=assumption)
    pressures = np.asarray(stiffness @ (delta - lost))
    if np.any(pressures < 0):
        j = int(np.argmin(pressures))
        least = delta[j] - pressures[j] / stiffness[j, j]
        raise ValueError(
            f"interface {j} (0 is the innermost) at r={walls[j].r_o:g} m opens: its interference "
            f"{delta[j]:g} m must exceed {least:g} m for the given pressures and other "
            "interferences"
        )
    return pressures


def pressure_of_overlap(
    inner: Wall, outer: Wall, *, p_i: float = 0.0, p_o: float = 0.0, assumption: Assumption
) -> float:
    """Pressure [stress] on the rim of `inner`, whose r_o exceeds r_i of `outer` before assembly.

    Each wall has its initial radius. Both surfaces transmit the same force, so that the pressure on
    the outer wall is r_o/r_i times the pressure on the inner wall. `contact_pressures` uses one
    radius for both and neglects terms of the order of overlap over radius. Raises ValueError if the
    walls do not overlap or lose contact.

    >>> steel = {"E": 2.0, "nu": 0.25}
    >>> shaft, hub = Wall(r_i=0.0, r_o=1.0, **steel), Wall(r_i=1 - 1e-6, r_o=2.0, **steel)
    >>> p = pressure_of_overlap(shaft, hub, assumption="plane stress")
    >>> round(p * 1e6, 5)  # 3/4 of E times the overlap
    0.75
    """
    finite([p_i, p_o], "pressures", "Pa")
    overlap = inner.r_o - outer.r_i
    if not 0 < overlap < 0.1 * inner.r_o:
        raise ValueError(
            "the overlap of the walls must be positive and less than a tenth of r_o, got "
            f"{overlap} m"
        )

    def gap(p: float, p_i: float, p_o: float) -> float:
        bore = outer.displacement(
            outer.r_i, p_i=p * inner.r_o / outer.r_i, p_o=p_o, assumption=assumption
        )
        rim = inner.displacement(inner.r_o, p_i=p_i, p_o=p, assumption=assumption)
        return float(bore - rim)

    p = (overlap - gap(0.0, p_i, p_o)) / gap(1.0, 0.0, 0.0)
    if p < 0:
        raise ValueError(f"the walls lose contact: their overlap of {overlap:g} m is too small")
    return p


def interferences_lost(
    walls: Sequence[Wall], *, p_i: float = 0.0, p_o: float = 0.0, assumption: Assumption
) -> Array:
    """Decrease of interference [length] by p_i and p_o at each interface, shape (walls - 1,).

    The decrease is the gap that p_i and p_o would open between walls without contact pressure. For
    two walls, it equals the interference at which the contact opens. It is negative if p_i and p_o
    increase the contact pressure.
    """
    finite([p_i, p_o], "pressures", "Pa")
    _check_stack(walls)
    return _gaps(walls, [p_i, *[0.0] * (len(walls) - 1), p_o], assumption)


def opening_interference(
    walls: Sequence[Wall],
    interferences: ArrayLike,
    *,
    interface: int,
    p_i: float = 0.0,
    p_o: float = 0.0,
    assumption: Assumption,
) -> float:
    """Interference [length] at which one interface opens; all other interferences are given.

    Interface 0 is the innermost.
    """
    delta = _interferences(walls, interferences)
    if not 0 <= interface < len(delta):
        raise ValueError(
            f"interface must be an integer from 0 to {len(delta) - 1}, got {interface}"
        )
    row = _stiffness(walls, assumption)[interface]
    lost = interferences_lost(walls, p_i=p_i, p_o=p_o, assumption=assumption)
    return float(delta[interface] - row @ (delta - lost) / row[interface])


def _stiffness(walls: Sequence[Wall], assumption: Assumption) -> Array:
    """Matrix of contact pressures per interference: inverse of the gaps under unit pressures."""
    units = np.eye(len(walls) + 1)[1:-1]
    return np.asarray(np.linalg.inv(np.array([_gaps(walls, u, assumption) for u in units]).T))


def _gaps(walls: Sequence[Wall], pressures: ArrayLike, assumption: Assumption) -> Array:
    """Gaps u_(j+1) - u_j at all interfaces under `pressures`, listed from the bore to the rim."""
    p = np.asarray(pressures)
    bore, rim = np.array(
        [
            wall.displacement([wall.r_i, wall.r_o], p_i=i, p_o=o, assumption=assumption)
            for wall, i, o in zip(walls, p[:-1], p[1:], strict=True)
        ]
    ).T
    return np.asarray(bore[1:] - rim[:-1])


def _interferences(walls: Sequence[Wall], interferences: ArrayLike) -> Array:
    _check_stack(walls)
    delta = np.atleast_1d(finite(interferences, "interferences", "m"))
    if delta.shape != (len(walls) - 1,):
        raise ValueError(
            f"{len(walls)} walls must have {len(walls) - 1} interferences, got {delta} m"
        )
    return delta


def _check_stack(walls: Sequence[Wall]) -> None:
    if len(walls) < 2:
        raise ValueError(f"a press fit must have at least two walls, got {len(walls)}")
    for inner, outer in pairwise(walls):
        if abs(inner.r_o - outer.r_i) > 1e-6 * inner.r_o:
            raise ValueError(
                "neighbouring walls must have the same nominal radius at their interface, got "
                f"r_o={inner.r_o} m, r_i={outer.r_i} m"
            )
