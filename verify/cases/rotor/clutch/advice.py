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
    "offset": "the offset",
    "crown": "the crown",
    "gap": "the gap",
    "together": "offset, crown and gap together",
}


def findings(q: ClutchStiffness) -> Sequence[str]:
    held = q.K_zz_pinned / q.K_zz
    offset, gap = (q.in_state[key] for key in ("offset", "gap"))
    rolled = (
        "would roll over between the races"
        if held <= 0
        else f"would have {held:.0%} of the torsional stiffness"
    )
    return (
        f"under {q.T:g} N m every sprag carries {q.N:.4g} N and deflects by {q.delta_0 * 1e6:.3g} "
        f"µm, and the wind-up is {math.degrees(q.twist):.3g}°; the clutch acts as an isotropic "
        f"bearing of {q.K_xx / 1e6:.4g} N/µm and a torsion spring of {q.K_zz:.4g} N m/rad",
        f"under torque alone, bending and torsion are not coupled; an offset of {q.e * 1e6:g} µm "
        f"causes a coupling of {abs(offset.coupling):.2%} of √(K_xx K_zz); with {q.missing} of "
        f"{q.Z} sprags missing, it is {abs(gap.coupling):.2%}",
        "the stiffness grows with the tenth root of the torque: half the torque lowers it by "
        f"{1 - 0.5**0.1:.1%}; Eq. 3 omits tan²ν = {math.tan(q.nu) ** 2:.2%} of the stiffness under "
        f"even load, and tan ν = {math.tan(q.nu):.2%} under uneven load; with {q.missing} of the "
        f"sprags missing, x and y are coupled by {gap.K_xy / gap.K_xx:.2%} of K_xx, and y and "
        "torsion by tan ν of K_xz; by Eq. 3 both couplings are zero",
        "d_t = R_i tan ν is constant only if the sprags roll: struts pinned to both races "
        f"{rolled}",
    )


def summary(q: ClutchStiffness) -> Mapping[str, Any]:
    offset, gap = (q.in_state[key] for key in ("offset", "gap"))
    return {
        "verdict": "open" if open_slices(q, "together") else "closed", "K_xx": q.K_xx,
        "K_tilt": q.K_tilt, "K_zz": q.K_zz, "K_xz_offset": offset.K_xz, "K_xz_gap": gap.K_xz,
    }  # fmt: skip


def open_slices(q: ClutchStiffness, key: str) -> int:
    """Number of slices without contact in an uneven state."""
    state = q.in_state[key]
    return int((state.sums.deformation(state.at_T) <= 0).sum())


def open_ends(q: ClutchStiffness, key: str) -> bool:
    """Whether, in the state `key`, a sprag is in contact only over a part of its length."""
    state = q.in_state[key]
    closed = state.sums.deformation(state.at_T) > 0
    return bool((closed.any(-1) & ~closed.all(-1)).any())


def refusal(q: ClutchStiffness) -> str:
    """Reason why struts do not cover the inputs; empty if they do."""
    twist = float(preload_twist(q.clutch(), T=q.T))
    if twist > LARGEST_TWIST:
        return (
            f"the wind-up is {math.degrees(twist):.3g}° under {q.T:g} N m, but may be at most "
            f"{math.degrees(LARGEST_TWIST):.3g}° for rolling sprags; check it without --fem"
        )
    if open_ends(q, "crown") or open_ends(q, "together"):
        return (
            f"the crown's drop of {q.drop * 1e6:g} µm leaves the ends of the sprags without "
            f"contact under {q.T:g} N m, so that slices converge too slowly; check it without --fem"
        )
    return ""


def _above(K: float, leaning: float) -> str:
    return f"{leaning / (K - leaning):.2%} too large" if leaning < K else "no stiffness remains"


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
            f"K_tilt = {q.K_tilt:.4g} N m/rad does not include the inclination of the sprag forces "
            f"as the race tilts, which reduces it by {leaning:.4g} N m/rad: "
            f"{_above(q.K_tilt, leaning)}"
        )
    for key, what in WORDS.items():
        if count := open_slices(q, key):
            share = count / q.n_s / (q.Z - (q.missing if q.in_state[key].with_gap else 0))
            yield f"under {what}, {share:.0%} of the contacts are open (δ_jk < 0)"
    if q.twist > LARGEST_TWIST:
        yield (
            f"the races rotate by {math.degrees(q.twist):.3g}° under {q.T:g} N m, farther than the "
            "sprags can roll: use more sprags, or a larger wedge angle"
        )
    if math.tan(q.nu) > FRICTION:
        yield (
            f"tan ν = {math.tan(q.nu):.3g} is more than the friction {FRICTION:g} that oiled "
            "steel hardly exceeds: the clutch slips"
        )
