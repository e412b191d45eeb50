"""What a wedged sprag's numbers mean in words, and what its meshes cannot do."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from analytic.sprag.closure import wedged
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge.model import elastic, half_widths, rigid_force, sprag_column
from verify.core.case import Values

HARD = 4000e6  # Pa, what hardened rollers bear in static contact (ISO 76)
FRICTION = 0.1  # what oiled steel hardly exceeds
WIDE = 0.12  # a/r up to which these finite elements, small in displacements, are asked
BENT = 0.1  # of a race's wall: by how much more it bends, its forces move along it
MOST = 1.9  # of N_0, that the stroke of the finite elements goes to
ZONES = 2.2  # half-widths that meshes need between a contact and a flank
NEAREST = 0.29  # of half the outline: a quarter, and what the rotation is uncertain by
TURNED = 0.6  # rad


def verdict(q: WedgeInputs, v: Values) -> str:
    if v["T_roll"] < q.T:
        return "rolls over"
    return "too much pressure" if max(v["p_i"], v["p_e"]) > HARD else "holds"


def findings(q: WedgeInputs, v: Values) -> Sequence[str]:
    tan = math.tan(v["nu"])
    if v["T_roll"] < q.T:
        first = (
            f"rolls over: a contact reaches the sprag's flank at {v['T_roll']:.4g} N m, before "
            f"T = {q.T:g} N m; all below is of sprags without flanks"
        )
    else:
        first = (
            f"holds with friction above tan ν = {tan:.4f} at the inner race and "
            f"{math.tan(v['omega']):.4f} at the outer; below, the sprags slide out"
        )
    near = v["alpha printed"] / v["alpha"] - 1
    return (
        first,
        f"{v['H'] * 1e6:.3g} µm yield under {v['N']:.4g} N and turn each sprag by "
        f"{math.degrees(v['alpha']):.3g}°, the races by {math.degrees(v['theta']):.3g}°",
        f"with Palmgren's law and Eqs. 9, 10 as printed the rotation is {near:+.0%} off: yields "
        f"{v['H composite, N_0'] / v['H, N_0'] - 1:+.0%}, and a share of them lost on the inner "
        "side",
    )


def summary(q: WedgeInputs, v: Values) -> Mapping[str, Any]:
    return {
        "verdict": verdict(q, v), "friction needed": math.tan(v["nu"]), "N": v["N"],
        "rotation_deg": math.degrees(v["alpha"]), "p_i": v["p_i"], "p_o": v["p_e"],
    }  # fmt: skip


def warnings(q: WedgeInputs, v: Values) -> Sequence[str]:
    found = []
    if v["T_roll"] < q.T:
        found.append(
            f"a contact reaches the sprag's flank at {v['T_roll']:.4g} N m: the sprags roll over"
        )
    if sprag_column(q) is None:
        found.append(
            f"sprags b = {q.b * 1e3:g} mm wide are wider than they are round: a disc between the "
            "races stands for them"
        )
    if math.tan(v["nu"]) > FRICTION:
        found.append(
            f"tan ν = {math.tan(v['nu']):.3g} is more than the friction {FRICTION:g} that oiled "
            "steel hardly exceeds: the clutch slips"
        )
    p = max(v["p_i"], v["p_e"])
    if p > HARD:
        found.append(
            f"pressure {p / 1e6:.4g} MPa exceeds the {HARD / 1e6:g} MPa of static contact of "
            "hardened rollers (ISO 76)"
        )
    return found


def too_large(q: WedgeInputs) -> str:
    """Why finite elements refuse these inputs, or nothing."""
    N = MOST * rigid_force(q)
    at, (a_i, a_e) = wedged(elastic(q), N), map(float, half_widths(q, np.asarray(N)))
    column, without = sprag_column(q), "; check it without --fem"
    if column is None:
        return f"sprags b = {q.b * 1e3:g} mm wide are wider than they are round{without}"
    turned, alpha_b = float(at.turned), float(at.alpha_b)
    wide = max(a_i / q.r_i, a_i / q.R_i, a_e / float(q.sprag.r_e))
    if not math.isfinite(alpha_b):
        return f"the sprags never bear {N:.4g} N{without}"
    if wide > WIDE:
        return (
            f"contacts are {wide:.3g} r wide under {N:.4g} N, beyond {WIDE:g}: displacements are "
            f"not small{without}"
        )
    room_i = (column.turned - turned) * float(at.rho) / ZONES
    room_e = (column.alpha_b - alpha_b) * float(q.sprag.r_e) / ZONES
    near = min(column.nearest(turned=turned, alpha_b=alpha_b))
    if room_i < a_i or room_e < a_e or near < NEAREST or alpha_b > TURNED:
        return (
            f"under {N:.4g} N the sprags turn by {math.degrees(alpha_b):.3g}°, their contacts come "
            f"to the flanks{without}"
        )
    for name, wall, yields in (
        ("inner", q.R_i - q.R_id, at.yields.race_i), ("outer", q.R_ed - q.R_e, at.yields.race_e)
    ):  # fmt: skip
        if float(yields) > BENT * wall:
            return (
                f"the {name} race deflects by {float(yields) * 1e6:.4g} µm under {N:.4g} N, more "
                f"than {BENT:g} of its wall: displacements are not small{without}"
            )
    return ""
