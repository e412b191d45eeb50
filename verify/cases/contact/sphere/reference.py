"""Finite elements of spheres: quarter discs turned about the axis, their cuts driven along it."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.case import Level
from verify.cases.contact.errors import fem_errors
from verify.cases.contact.sphere.inputs import BODIES, END, PAIRS, SphereInputs
from verify.cases.contact.window import cut
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

ZONE, CELLS = 1.5, 6  # of fine cells: width over a, and number of cells on the coarsest mesh
HIT, STEPS = 1e-12, 30  # of the load, within which it is met, and by how many steps
ACROSS = np.linspace(0.0, 0.95, 39)  # r/a of the plotted pressure
DEEP = np.linspace(0.05, 2.5, 50)  # z/a of the plotted stresses
ABOUT, WIDE = (0.25, 0.75), 0.3  # z/a about the largest shear stress, and r/a
VIEW = 4.0  # half-widths about the contact whose cells are kept


def solve(q: SphereInputs, level: int) -> Level:
    """One level of both contacts."""
    values: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields: list[Field] = []
    round_off = HIT
    for pair in PAIRS:
        found, profiles, state = solve_pair(q.of(pair), level)
        end = END[pair]
        values |= {f"{key}{end}": value for key, value in found.items()}
        arrays |= {f"{key}{end}": array for key, array in profiles.items()}
        round_off = max(round_off, state.plane.residual)
        fields.append(field(state, pair, VIEW * q.of(pair).width))
    u_it = {key: round_off * abs(value) for key, value in values.items()}
    u_it |= {key: round_off * float(np.abs(v).max()) for key, v in arrays.items()}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields))


def solve_pair(
    q: SphereInputs, level: int
) -> tuple[dict[str, float], dict[str, Any], "ContactSolution"]:
    """Numbers of one contact by the names of the quantities, profiles, and the state."""
    spheres, a = problem(q, level), q.width
    hertz = a**2 / q.hertz["R"]
    given = spheres.solve(displacements={"upper.middle": {"y": -hertz}})
    approach, state = at_load(spheres, q.P, hertz, given)
    touch = state.touches[0]
    values = {
        "a": touch.half_width(), "p_0": peak(touch.x[0], touch.pressure, a),
        "approach": approach, "force": push(given),
        "upper_balance": state.plane.reaction("upper.middle")[1] + push(state),
    }  # fmt: skip
    if q.pair == "sphere":
        values["lower_balance"] = state.plane.reaction("lower.middle")[1] - push(state)
    arrays: dict[str, Any] = {}
    for body in BODIES[q.pair]:
        inside = state.plane.in_body(body)
        largest, depth = largest_shear(inside.x, inside.stress, a)
        values |= {f"tau_{body}": largest, f"z_{body}": a * depth}
        side = 1.0 if body == "upper" else -1.0
        arrays[f"axis_{body}"] = np.array(axis(state, side * a * DEEP)).ravel()
    order = np.argsort(touch.x[0])
    arrays["p"] = np.interp(a * ACROSS, touch.x[0][order], touch.pressure[order])
    return values, arrays, state


def problem(q: SphereInputs, level: int) -> "ContactProblem":
    """The upper sphere with its equator driven along y, on a rigid flat or on the lower sphere."""
    from fem.contact.pairs import Obstacle, Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle, Flat
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.join import join

    fine: dict[str, Any] = {"zone": ZONE * q.width, "cells": CELLS, "refine": level}
    meshes = {"upper": quarter_disc(R=q.R_1, **fine)}
    materials = {"upper": Elastic(E=q.E_1, nu=q.nu_1)}
    master, shape, obstacles = "flat", None, {"flat": Obstacle(Flat())}
    if q.pair == "sphere":
        meshes["lower"] = quarter_disc(R=q.R_2, below=True, **fine)
        materials["lower"] = Elastic(E=q.E_2, nu=q.nu_2)
        master, shape, obstacles = "lower.surface", Circle((0.0, -q.R_2), q.R_2), {}
    return ContactProblem(
        join(meshes), materials=materials, assumption="axisymmetric", obstacles=obstacles,
        supports={f"{body}.{cut}": motion for body in meshes
                  for cut, motion in (("axis", "x"), ("middle", "y"))},
        contacts=[Pair(slave="upper.surface", master=master, master_shape=shape,
                       slave_shape=Circle((0.0, q.R_1), q.R_1))],
    )  # fmt: skip


def push(state: "ContactSolution") -> float:
    """The force on the upper sphere along y [N]."""
    return -state.touches[0].force[1]


def at_load(
    spheres: "ContactProblem", P: float, approach: float, state: "ContactSolution"
) -> tuple[float, "ContactSolution"]:
    """Approach [m] at which the force is `P`, by secants from a state at `approach`.

    NotFoundError where they do not meet it.
    """
    force, step = push(state), 0.6 * approach * (P / push(state) - 1)
    for _ in range(STEPS):
        if abs(force / P - 1) <= HIT:
            return approach, state
        before, approach = force, approach + step
        state = spheres.solve(displacements={"upper.middle": {"y": -approach}}, after=state)
        force = push(state)
        if force != before:
            step *= (P - force) / (force - before)
    raise fem_errors().NotFoundError(f"the load {P:g} N is missed by {force / P - 1:.1e} of it")


def peak(r: Array, p: Array, a: float) -> float:
    """Pressure in the middle: sqrt(1 - r²/a²) (b + c r²/a²) fitted to that on the inner half.

    The one node on the axis carries next to no area, and its own pressure scatters.
    """
    s = r[r < a / 2] / a
    ellipse = np.sqrt(1 - s**2)
    columns = np.column_stack([ellipse, ellipse * s**2])
    return float(np.linalg.lstsq(columns, p[r < a / 2], rcond=None)[0][0])


def axis(state: "ContactSolution", y: Array) -> tuple[Array, Array]:
    """Radial and axial stress (m,) on the axis."""
    stress = state.plane.at(np.array([np.zeros_like(y), y])).stress
    return stress[0], stress[1]


def largest_shear(x: Array, stress: Array, a: float) -> tuple[float, float]:
    """Largest shear stress on the axis and its depth over `a`.

    Of a polynomial, even in r, through (sigma_r - sigma_z)/2 at the points `x` (2, m) about there:
    single stresses jump from cell to cell.
    """
    r, z = x[0] / a, np.abs(x[1]) / a
    near = (r < WIDE) & (z > ABOUT[0]) & (z < ABOUT[1])
    r, z, shear = r[near], z[near], (stress[0] - stress[1])[near] / 2
    columns = [z**i * r ** (2 * j) for j in range(3) for i in range(6 - j)]
    fit = np.linalg.lstsq(np.array(columns).T, shear, rcond=None)[0]
    fine = np.linspace(*ABOUT, 4001)
    on_axis = np.polynomial.polynomial.polyval(fine, fit[:6])
    best = int(np.argmax(on_axis))
    return float(on_axis[best]), float(fine[best])


def field(state: "ContactSolution", name: str, reach: float) -> Field:
    """The cells about the contact."""
    cells, _ = cut(state.plane.cells(), lambda centre: np.hypot(*centre.T) < reach)
    xx, yy, _, around = cells["stress"].T
    data = {"stress": cells["stress"], "von_mises": cells["von_mises"], "axial_stress": yy,
            "hoop_stress": around, "radial_stress": xx}  # fmt: skip
    return Field(
        name=name, points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"]}, cell_data=data,
        units={"displacement": "m", **dict.fromkeys(data, "Pa")},
    )  # fmt: skip
