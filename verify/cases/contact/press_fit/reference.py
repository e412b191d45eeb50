"""Finite-element model of a press fit: quarters of both walls, joined by contact only."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level, plane_field
from verify.cases.contact.press_fit.inputs import FITS, FitInputs
from verify.cases.contact.window import named

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

EPS = float(np.finfo(np.float64).eps)
TURNS = np.linspace(0.02, np.pi / 2 - 0.02, 41)  # where the pressure is plotted [rad]
PROFILE_ANGLE = np.radians(30.0)  # angle of the stations across: no symmetry line of the mesh
ACROSS = 7  # stations in each wall


def solve(q: FitInputs, level: int) -> Level:
    """Results of all fits on the mesh of `level`."""
    values: dict[str, float] = {}
    u_it: dict[str, float] = {}
    arrays: dict[str, Any] = {}
    fields = []
    worst = 0.0
    for one in FITS:
        of, end = q.of(one), f"_{one.key}" if one.key else ""
        fit = solve_fit(of, level)
        found = read(of, fit)
        size = sizes(found)
        round_off = fit.plane.residual + EPS * q.r_f / q.delta
        worst = max(worst, round_off)
        values |= named(found, end)
        u_it |= named({key: round_off * size[key] for key in found}, end)
        u_it[f"scatter{end}"] = jitter(q, fit.touches[0].x.shape[1])
        if one.walls != "overlapping rings":
            cells = ("stress", "von_mises", "hoop_stress")
            fields.append(plane_field(fit.plane, *cells, name=one.name))
        if not one.key:
            arrays = profiles(q, fit)
    u_it |= {key: worst * float(np.abs(v).max()) for key, v in arrays.items()}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=tuple(fields))


def sizes(found: dict[str, float]) -> dict[str, float]:
    """Scale of the round-off of each value of `found`: the largest value of its kind.

    Positions are rounded to EPS r_f, and the interference is a difference of positions.
    """
    largest: dict[str, float] = {}
    for key, value in found.items():
        kind = key.split("_")[0]
        largest[kind] = max(largest.get(kind, 0.0), abs(value))
    return {key: largest[key.split("_")[0]] for key in found}


def jitter(q: FitInputs, around: int) -> float:
    """Scatter [Pa] of the pressure due to rounded positions of nodes (`around` per quarter).

    Rounding changes the distance between neighbouring nodes by EPS r_f. The cells of the inner wall
    are the shorter ones.
    """
    return EPS * q.E_i * around / (np.pi / 2)


def solve_fit(q: FitInputs, level: int) -> "ContactSolution":
    """Solution of quarters of both walls; three cells of the inner wall face two of the outer."""
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import quarter_disc
    from meshes.join import join
    from meshes.ring.quarter import quarter_ring

    rim, bore = q.surfaces
    supports = {"outer.x=0": "x", "outer.y=0": "y"}
    pressures = {"outer.rim": q.p_o}
    if q.walls == "shaft":  # the quarter that touches the origin from below, moved to the rings'
        fine: dict[str, Any] = {"zone": q.r_f / 2, "cells": 5, "refine": 2 * level}
        inner = quarter_disc(R=q.r_f, below=True, **fine).translated((0.0, q.r_f))
        supports |= {"inner.axis": "x", "inner.middle": "y"}
    else:
        inner = quarter_ring(r_i=q.r_i, r_o=rim, refine=3 * level)
        supports |= {"inner.x=0": "x", "inner.y=0": "y"}
        pressures["inner.bore"] = q.p_i
    drawn = q.walls == "overlapping rings"
    fit = ContactProblem(
        join({"inner": inner, "outer": quarter_ring(r_i=bore, r_o=q.r_o, refine=2 * level)}),
        materials={"inner": Elastic(E=q.E_i, nu=q.nu_i), "outer": Elastic(E=q.E_o, nu=q.nu_o)},
        assumption=q.ends, supports=supports,
        contacts=[
            Pair(
                slave="inner.surface" if q.walls == "shaft" else "inner.rim", master="outer.bore",
                slave_shape=Circle((0.0, 0.0), rim), master_shape=Circle((0.0, 0.0), bore, True),
                interference=0.0 if drawn else q.delta, press_fit=drawn,
            )
        ],
    )  # fmt: skip
    return fit.solve(pressures=pressures)


def read(q: FitInputs, fit: "ContactSolution") -> dict[str, float]:
    """Values of the solution `fit`, by names of quantities."""
    from fem.contact.round_fit import mean_and_scatter, means_on

    touch, plane = fit.touches[0], fit.plane
    p, scatter = mean_and_scatter(touch)
    push = touch.force[0]
    found = {
        "p": p,
        "scatter": scatter,
        "U": 4 * fit.strain_energy,
        "outer_balance": plane.reaction("outer.x=0")[0] + push - q.p_o * q.r_o,
    }
    if q.walls == "shaft":
        sides = {"inner_rim": "inner.surface"}
        found["inner_balance"] = plane.reaction("inner.axis")[0] - push
    else:
        sides = {"inner_bore": "inner.bore", "inner_rim": "inner.rim"}
        found["inner_balance"] = plane.reaction("inner.x=0")[0] + q.p_i * q.r_i - push
    for place, name in (sides | {"outer_bore": "outer.bore", "outer_rim": "outer.rim"}).items():
        found[f"u_{place}"], found[f"hoop_{place}"] = means_on(plane, name)
    return found


def stations(q: FitInputs) -> Any:
    """Radii [m] of the profile, shape (m,): equally many in both walls, none at the contact."""
    off = 1e-3
    return np.concatenate([
        np.linspace(a + off * (b - a), b - off * (b - a), ACROSS)
        for a, b in ((q.r_i, q.r_f), (q.r_f, q.r_o))
    ])  # fmt: skip


def profiles(q: FitInputs, fit: "ContactSolution") -> dict[str, Any]:
    """Pressure [Pa] along the fit, and radial and hoop stresses [Pa] across both walls."""
    from fem.contact.round_fit import pressure_at

    across = fit.plane.at(np.outer([np.cos(PROFILE_ANGLE), np.sin(PROFILE_ANGLE)], stations(q)))
    _, radial, hoop, _ = across.polar()
    along = pressure_at(fit.touches[0], TURNS)
    return {"p along": along, "profile hoop": hoop, "profile radial": radial}
