"""Recommendations for a freewheel that slips, and its sensitivity to dimensions."""

import math

from analytic.freewheel.remedies import (
    bearing,
    friction_for,
    moved_to,
    per_micrometre,
    to_spare,
    until_pop_through,
)
from verify.cases.freewheel.clutch.classes import past_corners
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Values

DEGREE = math.degrees(1.0)
GOALS = (1.0, 1.1)  # target mu/mu_req: Coulomb's limit, and a margin of 10 %


def advice(q: ClutchInputs, v: Values) -> list[str]:
    """Recommended changes with which friction transmits T and F_ax; empty if none is necessary."""
    if q.T <= 0:
        return []
    if q.duty.under is None:
        return [stiffer(q)]
    if past_corners(q, v):
        L = q.L * q.T / v["T_corner"]
        return [f"the rollers just reach the ends of the flats if L = {L * 1e3:.5g} mm"]
    if v["safety"] >= 1 and v["mu_0"] <= q.mu:
        return []
    return [
        flats(q),
        f"or, at this X: {_each([f'μ = {friction_for(q.duty, g):.4g}' for g in GOALS])}",
    ]


def flats(q: ClutchInputs) -> str:
    """Recommended distance X of the flats for each target ratio mu/mu_req."""
    needed = [moved_to(q.duty, goal) for goal in GOALS]
    if math.isnan(needed[0]):
        return "no value of X is sufficient at this T and F_ax"
    parts = []
    for dX in needed:
        if math.isnan(dX):
            parts.append("no value of X")
            continue
        angle = float(q.moved(dX).cam.alpha0) * DEGREE
        parts.append(f"X = {(q.X + dX) * 1e3:.7g} mm ({dX * 1e6:+.3g} µm, α_0 = {angle:.3f}°)")
    return f"recommended at this T and F_ax: {_each(parts)}"


def _each(parts: list[str]) -> str:
    return ", ".join(
        f"μ/μ_req = {goal:.1f} with {text}" for goal, text in zip(GOALS, parts, strict=True)
    )


def stiffer(q: ClutchInputs) -> str:
    """Text that names dimensions with which the clutch would have an equilibrium at its torque."""
    found = [f"{name} = {value * 1e3:.5g} mm" if name != "X"
             else f"X = {value * 1e3:.7g} mm ({(value - q.X) * 1e6:+.3g} µm)"
             for name, value in bearing(q.duty)]  # fmt: skip
    if not found:
        return (
            "no R_a, X or L near the given values is sufficient for this torque: the clutch is too "
            "small"
        )
    housing = "" if q.is_star else "; R_a is the outer radius of the housing of a drawn cup"
    return f"sufficient for this torque: {', or '.join(found)}, or more rollers{housing}"


def sensitive(q: ClutchInputs, v: Values) -> list[str]:
    """Messages: change of alpha_0 for 1 µm on each dimension, and changes of X that cause slip."""
    by, ratio = q.slopes, per_micrometre(q.duty)
    turned = ", ".join(
        f"+1 µm of {s.name} changes α_0 by {s.slope * 1e-6 * DEGREE:+.3f}°"
        + (f" (μ/μ_req by {100 * ratio[s.name]:+.2g} %)" if ratio else "")
        for s in by
    )
    shares = [s for s in sorted(by, key=lambda s: -s.share) if s.share > 0]
    parts = ", ".join(f"{s.name} {100 * s.share:.0f} %" for s in shares)
    found = [
        f"sensitivity of α_0: {turned}"
        + (f"; contributions to the variance of α_0: {parts}" if parts else "")
    ]
    if v.get("safety", 0.0) >= 1 and v["mu_0"] <= q.mu:
        found += _ends_of_X(q)
    return found


def _ends_of_X(q: ClutchInputs) -> list[str]:
    """Deviations of X at which the contacts slip or the rollers pop through, smallest first."""
    limits = [
        (to_spare(q.duty), "smaller", "the contacts slip"),
        (until_pop_through(q.duty), "larger", "the rollers pop through between flat and race"),
    ]
    near = sorted(one for one in limits if math.isfinite(one[0]))
    parts = [f"if X is {side} by {dX * 1e6:.3g} µm, {what}" for dX, side, what in near]
    return ["; ".join(parts)] if parts else []
