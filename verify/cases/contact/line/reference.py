"""Finite-element models of the three line contacts: meshes, materials, supports, results."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level
from verify.cases.contact.window import field
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.pressed_line import PressedLine

VIEW = 4.0  # half-widths about the contact whose cells are displayed
# x/a of the profile; the slope at the edge is infinite, and the last coarse cell errs most
STATIONS = np.linspace(0.0, 0.85, 18)


def disc_fem(q: Any, P: float, guess: float, level: int) -> "PressedLine":
    """Solution of a quarter of the disc on the flat y = 0 under the load P [N/m]."""
    from fem.contact.pairs import Obstacle, Pair
    from fem.contact.pressed_line import PressedLine
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle, Flat
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        return ContactProblem(
            quarter_disc(R=q.R, zone=zone, cells=cells, refine=refine),
            materials=Elastic(E=q.E, nu=q.nu), assumption="plane strain",
            supports={"axis": "x", "middle": "y"}, obstacles={"flat": Obstacle(Flat())},
            contacts=[
                Pair(slave="surface", master="flat", slave_shape=Circle((0.0, q.R), q.R))
            ],
        )  # fmt: skip

    return PressedLine(build, level, P=P, guess=guess, arc=q.R, softness=q.softness, cut="middle")


def pair_fem(q: Any, level: int) -> "PressedLine":
    """Solution of quarters of both rollers under the load."""
    from fem.contact.shapes import Circle
    from meshes.contact.disc import quarter_disc

    return _two_bodies(
        q, level, ("upper", "lower"), q.R_1, {"lower.middle": "y"}, "lower.surface",
        Circle((0.0, -q.R_2), q.R_2),
        lambda fine: quarter_disc(R=q.R_2, below=True, **fine),
    )  # fmt: skip


def race_fem(q: Any, level: int) -> "PressedLine":
    """Solution of a quarter of the roller in half of a race with a fixed rim, under the load."""
    from fem.contact.shapes import Circle
    from meshes.contact.race import half_race

    return _two_bodies(
        q, level, ("roller", "race"), q.R, {"race.rim": "xy"}, "race.bore",
        Circle((0.0, q.r_i), q.r_i, hollow=True),
        lambda fine: half_race(r_i=q.r_i, r_o=q.r_o, **fine),
    )  # fmt: skip


def _two_bodies(
    q: Any, level: int, names: tuple[str, str], R: float, held: dict[str, str], master: str,
    shape: Any, mesh: Any,
) -> "PressedLine":  # fmt: skip
    """Solution of a quarter disc of radius R, pressed on a body with the mesh `mesh(fine)`."""
    from fem.contact.pairs import Pair
    from fem.contact.pressed_line import PressedLine
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.join import join

    upper, lower = names

    def build(zone: float, cells: int, refine: int) -> ContactProblem:
        fine: dict[str, Any] = {"zone": zone, "cells": cells, "refine": refine}
        return ContactProblem(
            join({upper: quarter_disc(R=R, **fine), lower: mesh(fine)}),
            materials={upper: Elastic(E=q.E_1, nu=q.nu_1), lower: Elastic(E=q.E_2, nu=q.nu_2)},
            assumption="plane strain",
            supports={f"{upper}.axis": "x", f"{lower}.axis": "x", f"{upper}.middle": "y", **held},
            contacts=[
                Pair(slave=f"{upper}.surface", master=master,
                     slave_shape=Circle((0.0, R), R), master_shape=shape)
            ],
        )  # fmt: skip

    return PressedLine(
        build, level, P=q.P, guess=q.guess, arc=R, softness=q.softness, cut=f"{upper}.middle"
    )


def result(
    found: "PressedLine", level: int, supports: tuple[str, ...],
    others: "Mapping[str, PressedLine] | None" = None,
) -> Level:  # fmt: skip
    """Values and profiles of `level`; values of `others` are added, its keys as suffixes."""
    shear, depth = found.shear()
    values = found.values() | found.balance(supports) | {"tau_max": shear, "z": depth}
    u_it = {key: found.rounding(key, value) for key, value in values.items()}
    for where, other in (others or {}).items():
        for key, value in other.values().items():
            values[f"{key}{where}"] = value
            u_it[f"{key}{where}"] = other.rounding(key, value)
    touch, (x, _) = found.touch, found.load
    order, nodes = np.argsort(x), np.argsort(touch.x[0])
    profile = np.interp(STATIONS * found.guess, touch.x[0, nodes], touch.pressure[nodes])
    arrays = {"x": x[order], "p": touch.p[order], "weight": touch.weight[order],
              "profile": profile}  # fmt: skip
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=(near(found),))


def near(found: "PressedLine") -> Field:
    """Field of the cells near the contact: largest shear stress/p_0, von Mises stress [Pa]."""
    from fem.plane.cell_fields import cut_out, largest_shear

    cells = cut_out(
        found.solution.plane.cells(),
        lambda centre: np.asarray(np.abs(centre).max(axis=1) < VIEW * found.a),
    )
    return field("contact", cells, {
        "shear": (largest_shear(cells["stress"]) / found.peak, "1"),
        "von_mises": (cells["von_mises"], "Pa"),
    })  # fmt: skip
