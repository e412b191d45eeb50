r"""A roller of finite length on a half-space, by boundary elements (`half_space`).

The gap is :math:`x^2/2R + z(y) + \theta y` with the relative radius R, the crown z and y from
mid-length. Pressure acts only on |y| < l/2, but the half-space continues beyond the ends of the
roller. Any consistent units.

Range: see `half_space`. Without a crown, the pressure is singular at the ends: the largest computed
pressure increases as 1/sqrt(cell) and has no meaning without the cell size. The pressure at
mid-length, the approach and the load of an end zone (`end_load`) converge.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive
from analytic.contact.half_space import press_half_space, whole_counts
from analytic.contact.half_space_contact import HalfSpaceContact, centres

Crown = Callable[[Array], ArrayLike] | ArrayLike
SCOUT = 32  # cells across that find the contact's width before the real ones are laid
MARGIN = 1.25  # over the contact's width, or over Hertz's width if the former is unknown
WIDER = 1.5  # for a patch whose sides the contact reaches
MOST = 40  # times that a patch is made wider


@dataclass(frozen=True, kw_only=True)
class RollerContact:
    """Contact of a roller of `length` l; arrays have one value per cell along the roller, (ny,)."""

    contact: HalfSpaceContact
    length: float

    @property
    def y(self) -> Array:
        """Positions y [length] of the cell centres along the roller."""
        return self.contact.y

    @property
    def line_load(self) -> Array:
        """Line load q [force/length] along the roller."""
        return np.asarray(self.contact.pressure.sum(axis=0) * self.contact.cell[0])

    @property
    def centre_pressure(self) -> Array:
        """Pressure at x = 0; for an even number of cells, interpolated by an even parabola in x."""
        return _middle(self.contact.pressure)

    @property
    def half_width(self) -> Array:
        """Half-width b [length] of the ellipse with the pressure's variance; 0 without load."""
        p, x = self.contact.pressure, self.contact.x[:, None]
        total = p.sum(axis=0)
        share = p / np.where(total > 0, total, 1.0)
        mean = (share * x).sum(axis=0)
        return np.asarray(2 * np.sqrt((share * (x - mean) ** 2).sum(axis=0)))

    @property
    def mid_pressure(self) -> float:
        """Pressure [stress] at x = 0, y = 0."""
        return float(_middle(self.centre_pressure))

    @property
    def peak_pressure(self) -> float:
        """Largest pressure [stress] at x = 0."""
        return float(self.centre_pressure.max())

    def end_load(self, stretch: float) -> tuple[float, float]:
        """Loads [force] within `stretch` of the ends -l/2, l/2; a cut cell counts in proportion."""
        stretch = float(positive(stretch, "stretch", "m"))
        if stretch > self.length:
            raise ValueError(f"stretch must not exceed the length {self.length} m, got {stretch} m")
        force = self.line_load * self.contact.cell[1]
        cells = stretch / self.contact.cell[1]
        share = np.clip(cells - np.arange(force.size), 0.0, 1.0)
        return float(share @ force), float(share[::-1] @ force)


def press_roller(
    crown: Crown = 0.0,
    *,
    R: float,
    length: float,
    E_star: float,
    load: float | None = None,
    approach: float | None = None,
    cells: tuple[int, int] = (64, 256),
    tilt: float = 0.0,
    width: float | None = None,
    **how: Any,
) -> RollerContact:
    """Contact of a roller under either `load` [force] or `approach` [length].

    `crown` is the profile z(y) [length]: a function, its values at the cells (ny,) or a number.
    `tilt` is the angle θ [rad] about x. `width` [length] is the full width of the grid across the
    roller. If it is omitted, a coarse solution gives it; a study of mesh refinement should set it.
    A grid is widened if the contact reaches its sides. Other arguments: see `HalfSpace.press`.
    Raises ValueError unless R, length, E_star and load are positive.

    >>> found = press_roller(R=1.0, length=100.0, E_star=np.pi, load=100.0, cells=(32, 64))
    >>> hertz = np.sqrt(found.line_load[32])  # sqrt(P E* / (pi R)) of the load in the middle
    >>> bool(abs(found.mid_pressure / hertz - 1) < 0.01)
    True
    """
    cells = whole_counts(cells)
    R, length = float(positive(R, "relative radius", "m")), float(positive(length, "length", "m"))
    E_star = float(positive(E_star, "contact modulus", "Pa"))
    profile = _profile(crown, centres(cells[1], length / cells[1]), float(finite(tilt, "tilt", "")))

    def pressed(across: int, patch: float) -> HalfSpaceContact:
        hx = patch / across
        gap = centres(across, hx)[:, None] ** 2 / (2 * R) + profile
        return press_half_space(
            gap, cell=(hx, length / cells[1]), E_star=E_star, load=load, approach=approach, **how
        )

    if width is None:
        if load is not None:
            b = np.sqrt(4 * float(positive(load, "load", "N")) * R / (np.pi * E_star * length))
        else:  # pressure acts within the overlap
            deepest = float(finite(approach or 0.0, "approach", "m")) - float(profile.min())
            b = np.sqrt(2 * R * deepest) if deepest > 0 else length / cells[1]
        scout = _within(pressed, SCOUT, 2 * MARGIN * float(b))
        reach = np.abs(scout.x[scout.carries.any(axis=1)]).max(initial=0.0) + scout.cell[0] / 2
        width = MARGIN * 2 * float(reach)
    return RollerContact(contact=_within(pressed, cells[0], width), length=length)


def _within(
    pressed: Callable[[int, float], HalfSpaceContact], across: int, patch: float
) -> HalfSpaceContact:
    """Contact on a grid of width `patch`, widened until the contact does not reach its sides."""
    patch = float(positive(patch, "width of the patch", "m"))
    for _ in range(MOST):
        found = pressed(across, patch)
        if across < 3 or not found.carries[[0, -1]].any():
            return found
        patch *= WIDER
    raise ArithmeticError(
        f"the contact reaches the sides of every grid narrower than {patch:.3g} m: use a lower load"
    )


def _profile(crown: Crown, y: Array, tilt: float) -> Array:
    heights = finite(crown(y) if callable(crown) else crown, "crown", "m")
    if heights.shape not in ((), y.shape):
        raise ValueError(
            f"the crown must have one height per cell along the roller, {y.shape}, got "
            f"{heights.shape}"
        )
    return np.asarray(np.broadcast_to(heights, y.shape) + tilt * y)


def _middle(values: Array) -> Array:
    """Values (n, ...) interpolated to the middle of their first axis; error of fourth order."""
    n = len(values)
    if n % 2:
        return np.asarray(values[n // 2])
    inner = (values[n // 2 - 1] + values[n // 2]) / 2
    if n < 4:
        return np.asarray(inner)
    return np.asarray((9 * inner - (values[n // 2 - 2] + values[n // 2 + 1]) / 2) / 8)
