"""Finite-element model of spheres: axisymmetric hemispheres with displaced equators."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.case import Level
from verify.cases.contact.sphere.inputs import BODIES, END, PAIRS, SphereInputs
from verify.cases.contact.window import field, named
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.problem import ContactProblem
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

ZONE, CELLS = 1.5, 6  # fine cells: width of the zone over a; number, coarsest mesh
ACROSS = np.linspace(0.0, 0.95, 39)  # r/a of the plotted pressure
DEEP = np.linspace(0.05, 2.5, 50)  # z/a of the plotted stresses
VIEW = 4.0  # half-widths about the contact whose cells are stored


def solve(q: SphereInputs, level: int) -> Level:
    """Results of both contacts on the mesh of `level`."""
    from fem.contact.point_contact import HIT

    values: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields: list[Field] = []
    round_off = HIT
    for pair in PAIRS:
        found, profiles, state = solve_pair(q.of(pair), level)
        end = END[pair]
        values |= named(found, end)
        arrays |= named(profiles, end)
        round_off = max(round_off, state.plane.residual)
        fields.append(near(state, pair, VIEW * q.of(pair).width))
    u_it = {key: round_off * abs(value) for key, value in values.items()}
    u_it |= {key: round_off * float(np.abs(v).max()) for key, v in arrays.items()}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields))


def solve_pair(
    q: SphereInputs, level: int
) -> tuple[dict[str, float], dict[str, Any], "ContactSolution"]:
    """Values of one contact (by names of quantities), its profiles, and its solution."""
    from fem.contact.point_contact import (
        at_load,
        axis_stresses,
        largest_axis_shear,
        middle_pressure,
        push,
    )

    spheres, a = problem(q, level), q.width
    hertz = a**2 / q.hertz["R"]
    given = spheres.solve(displacements={"upper.middle": {"y": -hertz}})
    approach, state = at_load(spheres, q.P, hertz, given)
    touch = state.touches[0]
    values = {
        "a": touch.half_width(), "p_0": middle_pressure(touch.x[0], touch.pressure, a),
        "approach": approach, "force": push(given),
        "upper_balance": state.plane.reaction("upper.middle")[1] + push(state),
    }  # fmt: skip
    if q.pair == "sphere":
        values["lower_balance"] = state.plane.reaction("lower.middle")[1] - push(state)
    arrays: dict[str, Any] = {}
    for body in BODIES[q.pair]:
        inside = state.plane.in_body(body)
        largest, depth = largest_axis_shear(inside.x, inside.stress, a)
        values |= {f"tau_{body}": largest, f"z_{body}": a * depth}
        side = 1.0 if body == "upper" else -1.0
        arrays[f"axis_{body}"] = np.array(axis_stresses(state, side * a * DEEP)).ravel()
    order = np.argsort(touch.x[0])
    arrays["p"] = np.interp(a * ACROSS, touch.x[0][order], touch.pressure[order])
    return values, arrays, state


def problem(q: SphereInputs, level: int) -> "ContactProblem":
    """Problem of the upper sphere on a rigid flat or on the lower sphere.

    The equator of the upper sphere is displaced along y.
    """
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


def near(state: "ContactSolution", name: str, reach: float) -> Field:
    """Field of the cells near the contact, with stresses [Pa]."""
    from fem.plane.cell_fields import cut_out

    cells = cut_out(state.plane.cells(), lambda centre: np.hypot(*centre.T) < reach)
    xx, yy, _, around = cells["stress"].T
    data = {"stress": cells["stress"], "von_mises": cells["von_mises"], "axial_stress": yy,
            "hoop_stress": around, "radial_stress": xx}  # fmt: skip
    return field(name, cells, {key: (values, "Pa") for key, values in data.items()})
