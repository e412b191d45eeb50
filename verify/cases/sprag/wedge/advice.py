"""Statements on the results of a wedged sprag, and input limits of its finite elements."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from analytic.sprag.closure import wedged
from verify.cases.sprag.wedge.formulas import WedgeFormulas

HARD = 4000e6  # Pa, static limit of hardened rollers (ISO 76)
FRICTION = 0.1  # upper estimate for oiled steel
WIDE = 0.12  # largest a/r for these finite elements, which assume small displacements
BENT = 0.1  # deflection over a race's wall above which its forces shift along it
MOST = 1.9  # end of the finite-element stroke over N_0
ZONES = 2.2  # half-widths that meshes need between a contact and a flank
NEAREST = 0.29  # over half the outline: a quarter, plus the uncertainty of the rotation
TURNED = 0.6  # rad


def advice(q: WedgeFormulas) -> Iterator[str]:
    """Sentences: whether the clutch holds, its deflections, the error of the paper's equations."""
    if q.T_roll < q.T:
        yield (
            f"rolls over: a contact reaches the sprag's flank at {q.T_roll:.4g} N m, below "
            f"T = {q.T:g} N m; all results below are for sprags without flanks"
        )
    else:
        yield (
            f"holds if the friction coefficient exceeds tan ν = {math.tan(q.nu_T):.4f} at the "
            f"inner race and tan ω = {math.tan(q.omega_T):.4f} at the outer race; with less "
            "friction, "
            "the sprags slip"
        )
    yield (
        f"the total deflection at a sprag is {q.H * 1e6:.3g} µm under {q.N:.4g} N, the sprag "
        f"rotation is {math.degrees(q.alpha):.3g}°, and the wind-up is "
        f"{math.degrees(q.theta):.3g}°"
    )
    rigid = q.at_share(1.0)
    yield (
        f"with Palmgren's law and Eqs. 9, 10 as printed, the error of the sprag rotation is "
        f"{q.alpha_paper / q.alpha - 1:+.0%}; the error of the deflection is "
        f"{rigid.H_composite / rigid.H - 1:+.0%}, but Eqs. 9, 10 omit a part of the deflection"
    )


def summary(q: WedgeFormulas) -> Mapping[str, Any]:
    """Verdict and main results, for JSON output."""
    verdict = "too much pressure" if max(q.p_i, q.p_e) > HARD else "holds"
    return {
        "verdict": "rolls over" if q.T_roll < q.T else verdict,
        "friction needed": math.tan(q.nu_T), "N": q.N, "rotation_deg": math.degrees(q.alpha),
        "p_i": q.p_i, "p_o": q.p_e,
    }  # fmt: skip


def warnings(q: WedgeFormulas) -> Iterator[str]:
    """Warnings if the sprags roll over, slip or exceed the pressure limit."""
    if q.T_roll < q.T:
        yield f"a contact reaches the sprag's flank at {q.T_roll:.4g} N m: the sprags roll over"
    if q.bodies.column is None:
        yield (
            f"the sprag width b = {q.b * 1e3:g} mm exceeds the width of the rounded profile: the "
            "sprag is replaced by a disc between the races"
        )
    if math.tan(q.nu_T) > FRICTION:
        yield (
            f"tan ν = {math.tan(q.nu_T):.3g} exceeds {FRICTION:g}, an upper estimate of the "
            "friction coefficient of oiled steel: the clutch slips"
        )
    p = max(q.p_i, q.p_e)
    if p > HARD:
        yield (
            f"the pressure {p / 1e6:.4g} MPa exceeds {HARD / 1e6:g} MPa, the static limit of "
            "hardened rollers (ISO 76)"
        )


def refusal(q: WedgeFormulas) -> str:
    """Reason why the finite elements cannot compute these inputs; empty if they can."""
    N = MOST * q.N_0
    at, (a_i, a_e) = wedged(q.clutch, N), map(float, q.bodies.half_widths(np.asarray(N)))
    column, without = q.bodies.column, "; check it without --fem"
    load = f"{N:.4g} N ({MOST:g} N_0, the end of the compared forces)"
    if column is None:
        return (
            f"the sprag width b = {q.b * 1e3:g} mm exceeds the width of the rounded profile"
            f"{without}"
        )
    turned, alpha_b = float(at.turned), float(at.alpha_b)
    wide = max(a_i / q.r_i, a_i / q.R_i, a_e / float(q.sprag.r_e))
    if not math.isfinite(alpha_b):
        return f"no equilibrium exists at {load}{without}"
    if wide > WIDE:
        return (
            f"the half-width of a contact is {wide:.3g} of its radius under {load}; it must not "
            f"exceed {WIDE:g}, because displacements are not small{without}"
        )
    room_i = (column.turned - turned) * float(at.rho) / ZONES
    room_e = (column.alpha_b - alpha_b) * float(q.sprag.r_e) / ZONES
    near = min(column.nearest(turned=turned, alpha_b=alpha_b))
    if room_i < a_i or room_e < a_e or near < NEAREST or alpha_b > TURNED:
        return (
            f"under {load} the sprags rotate by {math.degrees(alpha_b):.3g}°: their contacts reach "
            f"the flanks{without}"
        )
    for name, wall, yields in (
        ("inner", q.R_i - q.R_id, at.yields.race_i), ("outer", q.R_ed - q.R_e, at.yields.race_e)
    ):  # fmt: skip
        if float(yields) > BENT * wall:
            return (
                f"the {name} race deflects by {float(yields) * 1e6:.4g} µm under {load}, more than "
                f"{BENT:g} of its wall thickness: displacements are not small{without}"
            )
    return ""
