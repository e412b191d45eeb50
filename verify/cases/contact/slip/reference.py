"""Finite elements of partial slip: two half discs pressed together, pushed, and swung."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import cumulative_trapezoid

from verify.case import Level
from verify.cases.contact.slip.inputs import CHORD, SHARES, STAGES, SlipInputs, key
from verify.cases.contact.slip.read import AROUND, near, traction
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.driven_discs import DrivenDiscs

Array = NDArray[np.float64]

GROWTH = np.linspace(0.1, 0.85, 16)  # Q/(mu P) at which the stick zone's growth is plotted
SIDES = ("upper", "lower")
ZONE = 1.1  # half-width of the fine cells over Hertz's
SWEEP, SWEPT = 80, 0.92  # steps of the first loading and Q/(mu P) at its end
STEPS = 32  # of a swing from Q_max to -Q_max


def solve(q: SlipInputs, level: int) -> Level:
    """One level: the first loading and a cycle."""
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
    """First loading: stick half-widths, displacements, tractions; sliding at its end."""
    from fem.contact.partial_slip import smoothed, stick_share

    state, cut = rollers.pressed
    values: dict[str, float] = {"a": state.touches[0].half_width((0.0, 0.0))}
    u_it: dict[str, float] = {}
    arrays: dict[str, Array] = {}
    for k in SHARES:
        state, cut = rollers.loaded(k * q.mu * q.P, cut, state)
        arrays |= traction(q, state, f"k = {k:g}")
    end, limit = rollers.loaded(SWEPT * q.mu * q.P, cut, state)
    slid = rollers.at(limit * (4.0, 1.0), end).touches[0]
    values["sliding"] = slid.friction_force - q.mu * slid.normal_force

    state, cut = rollers.pressed
    swept = []
    for x in np.linspace(0.0, limit[0], SWEEP + 1)[1:]:
        state = rollers.at(np.array([x, cut[1]]), state)
        touch = state.touches[0]
        swept.append((touch.friction_force / (q.mu * q.P), stick_share(touch), x))
    k, c2, x = np.array(swept).T
    arrays["profile, growth"] = np.sqrt([smoothed(k, c2, share)[0] for share in GROWTH])
    # Masing: each branch of a cycle is the first loading, twice as large
    area = 8 * cumulative_trapezoid(k, x, initial=0.0) - 4 * k * x
    jitter = smoothed(k, area, q.share)[2] * q.mu * q.P
    u_it |= {"work": jitter, "area": jitter}
    for name, share in (*((f"c_{key(s)}", s) for s in SHARES), ("c", q.share)):
        c2_k, u, _ = smoothed(k, c2, share)
        values[name] = values["a"] * np.sqrt(c2_k)
        u_it[name] = u * values[name] / (2 * c2_k)
    far, u_far, _ = smoothed(k, x, CHORD)
    for share in SHARES:
        x_k, u, _ = smoothed(k, x, share)
        part, name = share / CHORD, f"beyond_chord_{key(share)}"
        values[name] = x_k - part * far
        u_it[name] = float(np.hypot(u, part * u_far))
    return values, u_it, arrays


def cycle(
    q: SlipInputs, rollers: "DrivenDiscs"
) -> tuple[dict[str, float], dict[str, float], dict[str, Array], tuple[Field, ...]]:
    """Q_max, -Q_max, Q_max: tractions on the way, work of friction, area of the loop."""
    from fem.contact.partial_slip import apart, beyond_chord, loop_area, smoothed

    state, cut = rollers.pressed
    Q_max = q.share * q.mu * q.P
    first, top = rollers.loaded(Q_max, cut, state)
    values: dict[str, float] = {}
    arrays = traction(q, first, "Q/Q_max = 1")
    for stage in STAGES:
        state, _ = rollers.loaded(stage * Q_max, top * (stage, 1.0), first)
        arrays |= traction(q, state, f"Q/Q_max = {stage:g}")
    back = state  # -Q_max, in one step

    steps = np.linspace(1.0, -1.0, STEPS + 1)[1:]
    state, work, swung = first, 0.0, [(top[0], Q_max)]
    for x in top[0] * np.concatenate([steps, -steps]):
        state = rollers.at(np.array([x, top[1]]), state)
        touch = state.touches[0]
        work += float(np.abs(touch.traction * touch.slip) @ touch.mortar.size)
        swung.append((x, touch.friction_force))
        if len(swung) == STEPS + 1:
            values["steps"] = apart(state, back)
    values |= {"closure": apart(state, first), "work": work}
    arrays["loop, x"], arrays["loop, Q"] = np.array(swung).T
    arrays["profile, loop"] = beyond_chord(arrays["loop, x"], arrays["loop, Q"], AROUND)
    area, coarser = (loop_area(arrays["loop, x"][::n], arrays["loop, Q"][::n]) for n in (1, 2))
    values["area"] = area
    down, moved = arrays["loop, Q"][: STEPS + 1] / Q_max, arrays["loop, x"][: STEPS + 1]
    values["delta_0"], left, _ = smoothed(down, moved, 0.0, window=5.0 * 2 / STEPS)
    u_it = {"delta_0": left, "area_by_steps": abs(area - coarser)}

    plane, touch = first.plane, first.touches[0]
    upper, lower = (np.array(plane.reaction(f"{side}.middle")) for side in SIDES)
    # about the origin; what a cut holds is what its half disc's surface receives, reversed
    values["cuts"] = float(np.hypot(*(upper + lower)[:2]))
    values["passed_on"] = float(np.hypot(*(upper[:2] - np.array(touch.force))))
    values["moment"] = float(upper[2] + touch.moment(on="slave"))
    return values, u_it, arrays, (near(q, plane.cells()),)
