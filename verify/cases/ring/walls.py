"""Functions for all cases of circular rings: input checks, finite elements, figures."""

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import AlongLine, sketches
from verify.core.figures import Array, Shape
from verify.form.sketches import polar

if TYPE_CHECKING:
    from fem.plane.material import Assumption
    from fem.plane.solution import PlaneSolution

ACROSS = 13  # stations over the wall
ASKEW = 30.0  # degrees: their direction, on no line of the mesh's symmetry
FAST = 1e-3, "the fields are smooth: curved quadratic cells give errors far below 1 %"
SQUARED: dict[str, Any] = {
    "demand": 0.025,
    "demand_reason": "the order must be 4 ± 0.1; theory: twice the order 2 of the energy norm",
}
PROFILE_NOTE = (
    "Line: formula. Dots: finite elements on a radius at 30°. Lower diagram: formula minus finite "
    "elements; band: tolerance."
)


def check_wall(r_i: float, r_o: float, names: tuple[str, str] = ("r_i", "r_o")) -> None:
    """Raise ValueError if the radii [m] form no ring, or if the wall is thinner than r_o/1000."""
    if not r_i < r_o:
        raise ValueError(
            f"a ring needs {names[0]} < {names[1]}, got r_i = {r_i * 1e3:g} mm, "
            f"r_o = {r_o * 1e3:g} mm"
        )
    if r_o - r_i < 1e-3 * r_o:
        raise ValueError(
            f"the wall, {(r_o - r_i) * 1e3:g} mm, must be at least 1/1000 of r_o = "
            f"{r_o * 1e3:g} mm: give a thicker wall"
        )


def quarter_fem(
    q: Any, r_i: float, r_o: float, assumption: "Assumption", refine: int, *,
    straight: bool = False, **loads: Any,
) -> "PlaneSolution":  # fmt: skip
    """Solution of a quarter of a ring of the material of `q`, symmetric on both cuts."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring

    return solve_plane(
        quarter_ring(r_i=r_i, r_o=r_o, refine=refine, straight=straight),
        materials=Elastic(E=q.E, nu=q.nu), assumption=assumption,
        supports={"x=0": "x", "y=0": "y"}, **loads,
    )  # fmt: skip


def stations(q: Any) -> Array:
    """Radii [m] of the profiles, from bore to rim, shape (m,)."""
    return np.linspace(q.r_i, q.r_o, ACROSS)


def across(q: Any, solution: Any) -> Iterator[tuple[str, Array]]:
    """Pairs of name and values across the wall: radial displacement [m], two stresses [Pa]."""
    found = solution.at(np.outer(polar(1.0, ASKEW), stations(q))).polar()
    for name, values in zip(("displacement", "radial_stress", "hoop_stress"), found, strict=False):
        yield f"profile_{name}", values


def profiles(
    q: Any, assumption: str, stresses: Any, displacement: Any, *, stress: float, moved: float
) -> Iterator[AlongLine]:
    """Figures: stresses and displacement across the wall.

    Tolerances are relative to the scales `stress` [Pa] and `moved` [m].
    """
    shared: dict[str, Any] = {"x": ("r", "mm"), "at": stations(q), "note": PROFILE_NOTE}
    ends = f"across the wall, {assumption}"
    yield AlongLine(title=f"Hoop stress {ends}", y=("σ_θ", "MPa"), order=2.0, scale=stress,
                    curve=lambda r: stresses(r)[1], reference="profile_hoop_stress",
                    **shared)  # fmt: skip
    yield AlongLine(title=f"Radial stress {ends}", y=("σ_r", "MPa"), order=2.0, scale=stress,
                    curve=lambda r: stresses(r)[0], reference="profile_radial_stress",
                    **shared)  # fmt: skip
    yield AlongLine(title=f"Radial displacement {ends}", y=("u_r", "µm"), order=3.0, scale=moved,
                    curve=displacement, reference="profile_displacement", **shared)  # fmt: skip


def quarter(inner: float) -> Iterator[Shape]:
    """Shapes of a ring with outer radius 1, the modelled quarter, and both axes."""
    yield from sketches.ring(inner, 1.0)
    arcs = [polar(1.0, d) for d in np.linspace(0, 90, 73)]
    arcs += [polar(inner, d) for d in np.linspace(90, 0, 73)]
    yield Shape(style="modelled", points=np.array(arcs))
    yield Shape(style="axis", points=np.array([[-1.12, 0.0], [1.12, 0.0]]))
    yield Shape(style="axis", points=np.array([[0.0, -1.12], [0.0, 1.12]]))
    yield sketches.leader((1.18, 0.98), (0.75, 0.52), "FE: a quarter")


def radii(labels: Iterable[tuple[str, float, float]]) -> Iterator[Shape]:
    """Lines from labels to circles; each item of `labels` is (text, angle [deg], radius)."""
    for label, degrees, at in labels:
        yield sketches.leader(polar(1.32, degrees), polar(at, degrees), label)
