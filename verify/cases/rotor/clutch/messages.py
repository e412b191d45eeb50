"""What a clutch's stiffness means in words, and when it means nothing."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from analytic.rotor.clutch_state import preload_twist, under_torque
from verify.cases.rotor.clutch.inputs import ClutchInputs
from verify.cases.rotor.clutch.model import STATES, pinned_torsion, tilted
from verify.core.case import Values

FRICTION = 0.1  # what oiled steel hardly exceeds
LARGEST_TWIST = 0.35  # rad, 20 deg
ROUGH = 0.5e-6  # m, roughness of ground races: yields below it follow no contact law
LEANS = 0.02  # of K_tilt, that leaning forces take without a warning
WORDS = {"offset": "the offset", "crown": "the crown", "gap": "the gap", "together": "all of it"}


def findings(q: ClutchInputs, v: Values) -> Sequence[str]:
    held = pinned_torsion(q, k=v["k"], N=v["N"]) / v["K_zz"]
    rolled = (
        "would go through between the races"
        if held <= 0
        else f"would keep {held:.0%} of the torsional stiffness"
    )
    return (
        f"under {q.T:g} N m every sprag bears {v['N']:.4g} N and yields {v['delta_0'] * 1e6:.3g} "
        f"µm, the races turn by {math.degrees(v['twist']):.3g}°; the clutch is an isotropic "
        f"bearing of {v['K_xx'] / 1e6:.4g} N/µm and a torsion spring of {v['K_zz']:.4g} N m/rad",
        "under the torque alone it couples no bending with torsion; an offset of "
        f"{q.e * 1e6:g} µm couples {abs(v['coupling, offset']):.2%} of √(K_xx K_zz), "
        f"{q.missing} missing of {q.Z} sprags {abs(v['coupling, gap']):.2%}",
        "the stiffness goes with the tenth root of the torque, half of it takes "
        f"{1 - 0.5**0.1:.1%}; Eq. 3 leaves out tan²ν = {math.tan(q.nu) ** 2:.2%} of an even "
        f"load's stiffnesses, and tan ν = {math.tan(q.nu):.2%} where the load is uneven: with "
        f"{q.missing} missing, x is coupled with y by "
        f"{v['K_xy, gap, along struts'] / v['K_xx, gap']:.2%} of K_xx, y with torsion by tan ν "
        "of K_xz, both none by Eq. 3",
        f"d_t = R_i tan ν stays the same only as sprags roll: struts held in both races {rolled}",
    )


def summary(q: ClutchInputs, v: Values) -> Mapping[str, Any]:
    return {
        "verdict": "open" if open_slices(q, "together") else "closed", "K_xx": v["K_xx"],
        "K_tilt": v["K_tilt"], "K_zz": v["K_zz"], "K_xz_offset": v["K_xz, offset"],
        "K_xz_gap": v["K_xz, gap"],
    }  # fmt: skip


def open_slices(q: ClutchInputs, name: str) -> int:
    """Number of slices without contact in an uneven state."""
    state = STATES[name]
    clutch = q.clutch(crowned=state.crowned, gap=state.gap)
    at = under_torque(clutch, T=q.T, offset=(q.e if state.offset else 0.0, 0, 0, 0))
    return int((clutch.deformation(at) <= 0).sum())


def open_ends(q: ClutchInputs, name: str) -> bool:
    """Whether a sprag bears on a part of its length alone."""
    state = STATES[name]
    clutch = q.clutch(crowned=state.crowned, gap=state.gap)
    at = under_torque(clutch, T=q.T, offset=(q.e if state.offset else 0.0, 0, 0, 0))
    closed = clutch.deformation(at) > 0
    return bool((closed.any(-1) & ~closed.all(-1)).any())


def too_large(q: ClutchInputs) -> str:
    """Why struts are not asked."""
    twist = float(preload_twist(q.clutch(), T=q.T))
    if twist > LARGEST_TWIST:
        return (
            f"the races turn by {math.degrees(twist):.3g}° under {q.T:g} N m, beyond "
            f"{math.degrees(LARGEST_TWIST):.3g}°: no sprag rolls so far; check it without --fem"
        )
    if open_ends(q, "crown") or open_ends(q, "together"):
        return (
            f"the crown's drop of {q.drop * 1e6:g} µm leaves the sprags' ends open under {q.T:g} "
            "N m: slices converge too slowly there; check it without --fem"
        )
    return ""


def _above(K: float, leaning: float) -> str:
    return f"{leaning / (K - leaning):.2%} too large" if leaning < K else "no stiffness at all"


def warnings(q: ClutchInputs, v: Values) -> Sequence[str]:
    found = []
    if v["delta_0"] < ROUGH:
        found.append(
            f"T = {q.T:g} N m presses the sprags by {v['delta_0'] * 1e6:.3g} µm, less than races "
            f"are rough ({ROUGH * 1e6:g} µm): nearly no preload, the stiffness is a guess"
        )
    leaning = tilted(q, STATES["uniform"])
    if leaning > LEANS * abs(v["K_tilt"] - leaning):
        found.append(
            f"K_tilt = {v['K_tilt']:.4g} N m/rad leaves out that the sprags' forces lean as the "
            f"race tilts, which takes {leaning:.4g} N m/rad: it is {_above(v['K_tilt'], leaning)}"
        )
    for name, what in WORDS.items():
        if count := open_slices(q, name):
            share = count / q.n_s / (q.Z - (q.missing if STATES[name].gap else 0))
            found.append(f"under {what} {share:.0%} of the contacts are open: δ_jk below zero")
    if v["twist"] > LARGEST_TWIST:
        found.append(
            f"the races turn by {math.degrees(v['twist']):.3g}° under {q.T:g} N m, farther than "
            "sprags roll: more sprags, or a larger wedge angle"
        )
    if math.tan(q.nu) > FRICTION:
        found.append(
            f"tan ν = {math.tan(q.nu):.3g} is more than the friction {FRICTION:g} that oiled "
            "steel hardly exceeds: the clutch slips"
        )
    return found
