"""The spring as a plane body of quadratic cells; shear forces of 1 N act at head and tail."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from verify.case import Level, plane_field
from verify.cases.spring.inputs import AccordionInputs
from verify.core.figures import Array

LEVELS = (1, 2, 4, 8)
MOST_UNKNOWNS = 1_000_000  # some six gigabytes


def solve(q: AccordionInputs, level: int) -> Level:
    """Results of one level in plane stress and in plane strain."""
    from fem.plane.material import Assumption, Elastic
    from fem.plane.solve import solve_plane
    from fem.unit_load import stiffness
    from meshes.spring.strip import strip

    along = cells_along(q, level)
    mesh = strip(**q.path, b=q.b, through=level, per_arc=along["arc"], per_leaf=along["leaf"])
    tail = mesh.p[:, np.unique(mesh.facets[:, mesh.boundaries["tail"]])].mean(axis=1)
    x, y = float(tail[0]), float(tail[1])
    states: tuple[tuple[str, Assumption], ...] = (("k", "plane stress"), ("k_wide", "plane strain"))
    values, u_it, fields = {}, {}, []
    for name, assumption in states:
        body = solve_plane(
            mesh, materials=Elastic(E=q.E, nu=q.nu), assumption=assumption, thickness=q.h,
            supports={"tail": "y"},
            anchors={(x, y): "x"},  # the tail's shear balances the force
            tractions={"head": sheared(q, 0.0, 1.0), "tail": sheared(q, x, -1.0)},
        )  # fmt: skip
        values[name], u_it[name] = stiffness(body)
        fields.append(plane_field(body, "stress", "von_mises", name=assumption))
    return Level(h=1 / level, values=values, u_it=u_it, fields=tuple(fields))


def sheared(q: AccordionInputs, centre: float, force: float) -> Callable[[Any], Array]:
    """Function that returns parabolic shear stress [Pa] on an end face, with resultant `force`."""

    def traction(x: Any) -> Array:
        shape = 1.5 * (1 - (2 * (x[0] - centre) / q.b) ** 2)
        return np.array([force / (q.b * q.h) * shape, np.zeros_like(shape)])

    return traction


def cells_along(q: AccordionInputs, level: int) -> dict[str, int]:
    """Numbers of cells along a leaf and along an arc.

    With quadratic cells of length l, the relative error of the bending of a leaf or arc of length L
    is of the order of (l/L)^2 (l/b)^2.
    """
    lengths = {"leaf": q.leaf, "arc": q.R * q.alpha}
    return {k: level * max(4, round(2.2 * math.sqrt(v / q.b))) for k, v in lengths.items()}


def refusal(q: AccordionInputs) -> str:
    """Reason why the mesh would be too large for the memory; empty if it is not."""
    cells = cells_along(q, LEVELS[-1])
    along = cells["leaf"] * q.n + cells["arc"] * 2 * q.n
    unknowns = 2 * (2 * LEVELS[-1] + 1) * (2 * along + 1)
    if unknowns <= MOST_UNKNOWNS:
        return ""
    return (
        f"n = {q.n} segments of this thin strip need {unknowns:,} unknowns, more than "
        f"{MOST_UNKNOWNS:,}: check it without --fem, or use case spring-accordion"
    )
