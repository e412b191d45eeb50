"""Finite-element model of partial slip: two half discs under P and an alternating Q."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from verify.case import Level
from verify.cases.contact.slip.inputs import CHORD, SHARES, STAGES, SlipInputs, key
from verify.cases.contact.window import field
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.driven_discs import DrivenDiscs
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

GROWTH = np.linspace(0.1, 0.85, 16)  # Q/(mu P) at which the stick zone's growth is plotted
SIDES = ("upper", "lower")
ZONE = 1.1  # half-width of the fine cells over Hertz's
SWEEP, SWEPT = 80, 0.92  # steps of the first loading and Q/(mu P) at its end
STEPS = 32  # steps of a swing from Q_max to -Q_max
ACROSS = np.linspace(-0.95, 0.95, 39)  # x/a of the profiles
AROUND = np.linspace(-1.0, 1.0, 17)  # Q/Q_max of the points of the loop, on both branches
VIEW = 3.0  # half-widths about the contact whose cells are stored


def solve(q: SlipInputs, level: int) -> Level:
    """Results of the first loading and of a cycle on the mesh of `level`."""
    from fem.contact.driven_discs import DrivenDiscs
    from fem.contact.pairs import Pair
    from fem.contact.problem import ContactProblem
    from fem.contact.shapes import Circle
    from fem.plane.material import Elastic
    from meshes.contact.disc import half_disc
    from meshes.join import join

    fine: dict[str, Any] = {"R": q.R, "zone": ZONE * q.width, "cells": round(ZONE * level)}
    problem = ContactProblem(
        join({side: half_disc(**fine, refine=1, below=side == "lower") for side in SIDES}),
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane strain",
        supports={"lower.middle": "xy", "upper.middle": "xy"},
        contacts=[
            Pair(
                slave="upper.surface", master="lower.surface", friction=q.mu,
                slave_shape=Circle((0.0, q.R), q.R), master_shape=Circle((0.0, -q.R), q.R),
            )
        ],
    )  # fmt: skip
    rollers = DrivenDiscs(problem, P=q.P, approach=q.width**2 / q.R)
    values, u_it, arrays = loading(q, rollers)
    cycled, jitter, tractions, fields = cycle(q, rollers)
    return Level(
        h=1 / level, values=values | cycled, u_it=u_it | jitter, arrays=arrays | tractions,
        fields=fields,
    )  # fmt: skip


def loading(
    q: SlipInputs, rollers: "DrivenDiscs"
) -> tuple[dict[str, float], dict[str, float], dict[str, Array]]:
    """Values, iteration errors and tractions of the first loading, which ends with sliding."""
    from fem.contact.slip_course import push

    state, cut = rollers.pressed
    values: dict[str, float] = {"a": state.touches[0].half_width((0.0, 0.0))}
    arrays: dict[str, Array] = {}
    for k in SHARES:
        state, cut = rollers.loaded(k * q.mu * q.P, cut, state)
        arrays |= traction(q, state, f"k = {k:g}")
    end, limit = rollers.loaded(SWEPT * q.mu * q.P, cut, state)
    slid = rollers.at(limit * (4.0, 1.0), end).touches[0]
    values["sliding"] = slid.friction_force - q.mu * slid.normal_force

    swept = push(rollers, limit[0], limit=q.mu * q.P, steps=SWEEP)
    arrays["profile, growth"] = swept.growth(GROWTH)
    jitter = swept.loop_jitter(q.share) * q.mu * q.P
    u_it = {"work": jitter, "area": jitter}
    for name, share in (*((f"c_{key(s)}", s) for s in SHARES), ("c", q.share)):
        values[name], u_it[name] = swept.stick_half_width(share, values["a"])
    for share in SHARES:
        name = f"beyond_chord_{key(share)}"
        values[name], u_it[name] = swept.beyond_chord(share, CHORD)
    return values, u_it, arrays


def cycle(
    q: SlipInputs, rollers: "DrivenDiscs"
) -> tuple[dict[str, float], dict[str, float], dict[str, Array], tuple[Field, ...]]:
    """Values, iteration errors, tractions and fields of the cycle Q_max, -Q_max, Q_max."""
    from fem.contact.partial_slip import apart, beyond_chord, loop_area, smoothed
    from fem.contact.slip_course import swing

    state, cut = rollers.pressed
    Q_max = q.share * q.mu * q.P
    first, top = rollers.loaded(Q_max, cut, state)
    arrays = traction(q, first, "Q/Q_max = 1")
    for stage in STAGES:
        state, _ = rollers.loaded(stage * Q_max, top * (stage, 1.0), first)
        arrays |= traction(q, state, f"Q/Q_max = {stage:g}")
    back = state  # -Q_max, in one step

    swung = swing(rollers, first, top, Q_max, STEPS)
    x, Q = swung.x, swung.Q
    arrays |= {"loop, x": x, "loop, Q": Q, "profile, loop": beyond_chord(x, Q, AROUND)}
    area, coarser = (loop_area(x[::n], Q[::n]) for n in (1, 2))
    moved, force = swung.half
    remaining, left, _ = smoothed(force / Q_max, moved, 0.0, window=5.0 * 2 / STEPS)
    values = {
        "steps": apart(swung.opposite, back), "closure": apart(swung.last, first),
        "work": swung.work, "area": area, "delta_0": remaining,
    }  # fmt: skip
    u_it = {"delta_0": left, "area_by_steps": abs(area - coarser)}

    plane, touch = first.plane, first.touches[0]
    upper, lower = (np.array(plane.reaction(f"{side}.middle")) for side in SIDES)
    # about the origin; the force on a cut balances the force on the half disc's surface
    values["cuts"] = float(np.hypot(*(upper + lower)[:2]))
    values["passed_on"] = float(np.hypot(*(upper[:2] - np.array(touch.force))))
    values["moment"] = float(upper[2] + touch.moment(on="slave"))
    return values, u_it, arrays, (near(q, plane.cells()),)


def traction(q: SlipInputs, state: "ContactSolution", name: str) -> dict[str, Array]:
    """Arrays of the tangential traction [Pa]: at integration points, and at x/a = `ACROSS`."""
    touch = state.touches[0]
    order = np.argsort(touch.x[0])
    loaded = touch.p > 0
    return {
        f"points, {name}": np.array([touch.along((0.0, 0.0)), touch.q, touch.weight])[:, loaded],
        f"profile, {name}": np.interp(ACROSS * q.width, touch.x[0][order], touch.traction[order]),
    }


def near(q: SlipInputs, whole: Mapping[str, Array]) -> Field:
    """Field of the cells near the contact: stresses and maximum shear stress [Pa]."""
    from fem.plane.cell_fields import at_nodes, cut_out, largest_shear

    cells = cut_out(whole, lambda centre: np.asarray(np.abs(centre).max(axis=1) <= VIEW * q.width))
    stress = cells["stress"]
    smooth = largest_shear(at_nodes(cells["points"], cells["cells"], stress))
    return field(
        "pushed", cells, {"stress": (stress, "Pa"), "largest_shear": (largest_shear(stress), "Pa")},
        at_nodes={"shear_at_nodes": (smooth, "Pa")},
    )  # fmt: skip
