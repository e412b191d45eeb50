"""Statements on the stiffness of a clutch, and warnings on the range of validity."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from analytic.rotor.clutch_state import preload_twist
from verify.cases.rotor.clutch.formulas import ClutchStiffness

FRICTION = 0.1  # upper estimate for oiled steel
LARGEST_TWIST = 0.35  # rad, 20 deg
ROUGH = 0.5e-6  # m, roughness of ground races: deflections below it follow no contact law
LEANS = 0.02  # reduction of K_tilt by leaning forces without a warning
WORDS = {
    "offset": "an offset",
    "crown": "a crown",
    "gap": "missing sprags",
    "together": "offset, crown and missing sprags together",
}


def findings(q: ClutchStiffness) -> Sequence[str]:
    held = q.K_zz_pinned / q.K_zz
    offset, gap = (q.in_state[key] for key in ("offset", "gap"))
    rolled = (
        "would roll over between the races"
        if held <= 0
        else f"would reduce the torsional stiffness to {held:.0%} of K_zz"
    )
    return (
        f"under {q.T:g} N m, the normal force of each sprag is {q.N:.4g} N, the deflections of "
        f"its two contacts add up to {q.delta_0 * 1e6:.3g} µm, and the wind-up of the races is "
        f"{math.degrees(q.twist):.3g}°; the clutch acts as an isotropic bearing with the stiffness "
        f"{q.K_xx / 1e6:.4g} N/µm and as a torsion spring with {q.K_zz:.4g} N m/rad",
        "under torque alone, bending and torsion are not coupled; with an offset of "
        f"{q.e * 1e6:g} µm, the coupling K_xz is {abs(offset.coupling):.2%} of √(K_xx K_zz); with "
        f"{q.missing} of {q.Z} sprags missing, K_xz is {abs(gap.coupling):.2%} of √(K_xx K_zz)",
        "the stiffness is proportional to the tenth root of the torque: if the torque is halved, "
        f"the stiffness decreases by {1 - 0.5**0.1:.1%}; Eq. 3 neglects the inclination of the "
        f"sprag forces, and thus tan²ν = {math.tan(q.nu) ** 2:.2%} of the stiffness under even "
        f"load and terms of the order of tan ν = {math.tan(q.nu):.2%} under uneven load; with "
        f"{q.missing} of the sprags missing, the coupling of x and y is "
        f"{gap.K_xy / gap.K_xx:.2%} of K_xx, and "
        "the coupling of y and torsion is K_xz tan ν; by Eq. 3, both couplings are zero",
        "d_t = R_i tan ν is constant only if the sprags roll on the races: sprags pinned to both "
        f"races {rolled}",
    )


def summary(q: ClutchStiffness) -> Mapping[str, Any]:
    offset, gap = (q.in_state[key] for key in ("offset", "gap"))
    return {
        "verdict": "open" if open_slices(q, "together") else "closed", "K_xx": q.K_xx,
        "K_tilt": q.K_tilt, "K_zz": q.K_zz, "K_xz_offset": offset.K_xz, "K_xz_gap": gap.K_xz,
    }  # fmt: skip


def open_slices(q: ClutchStiffness, key: str) -> int:
    """Number of slices, over all sprags, that have no contact in the state `key`."""
    state = q.in_state[key]
    return int((state.sums.deformation(state.at_T) <= 0).sum())


def open_ends(q: ClutchStiffness, key: str) -> bool:
    """Whether, in the state `key`, a sprag is in contact only over a part of its length."""
    state = q.in_state[key]
    closed = state.sums.deformation(state.at_T) > 0
    return bool((closed.any(-1) & ~closed.all(-1)).any())


def refusal(q: ClutchStiffness) -> str:
    """Reason why the struts of the reference do not cover the inputs; empty if they do."""
    twist = float(preload_twist(q.clutch(), T=q.T))
    if twist > LARGEST_TWIST:
        return (
            f"the wind-up is {math.degrees(twist):.3g}° under {q.T:g} N m, but the struts of the "
            f"reference are valid up to {math.degrees(LARGEST_TWIST):.3g}° for rolling sprags; "
            "check it without --fem"
        )
    if open_ends(q, "crown") or open_ends(q, "together"):
        return (
            f"the crown's drop of {q.drop * 1e6:g} µm leaves the ends of the sprags without "
            f"contact under {q.T:g} N m, so that the results of the model with struts converge "
            "too slowly with the number of slices; check it without --fem"
        )
    return ""


def _above(K: float, leaning: float) -> str:
    return (
        f"K_tilt is {leaning / (K - leaning):.2%} too large"
        if leaning < K
        else "no stiffness remains"
    )


def warnings(q: ClutchStiffness) -> Iterator[str]:
    if q.delta_0 < ROUGH:
        yield (
            f"T = {q.T:g} N m deflects the sprags by {q.delta_0 * 1e6:.3g} µm, less than the "
            f"roughness of the races ({ROUGH * 1e6:g} µm): the preload is too small, and the "
            "stiffness is uncertain"
        )
    leaning = q.leaning
    if leaning > LEANS * abs(q.K_tilt - leaning):
        yield (
            f"K_tilt = {q.K_tilt:.4g} N m/rad neglects that the sprag forces incline as the race "
            f"tilts; their inclination reduces the tilting stiffness by {leaning:.4g} N m/rad: "
            f"{_above(q.K_tilt, leaning)}"
        )
    for key, what in WORDS.items():
        if count := open_slices(q, key):
            share = count / q.n_s / (q.Z - (q.missing if q.in_state[key].with_gap else 0))
            yield f"with {what}, {share:.0%} of the slices have no contact (δ_jk < 0)"
    if q.twist > LARGEST_TWIST:
        yield (
            f"the wind-up of the races is {math.degrees(q.twist):.3g}° under {q.T:g} N m, larger "
            "than the sprags can follow by rolling: use more sprags, or a larger wedge angle"
        )
    if math.tan(q.nu) > FRICTION:
        yield (
            f"tan ν = {math.tan(q.nu):.3g} exceeds the friction coefficient {FRICTION:g}, which "
            "oiled steel hardly exceeds: the clutch slips"
        )
