"""Finite-element results of the polyhedral ring under pressure and under the hub force."""

import numpy as np

from verify.case import Level
from verify.cases.polyhedral.fem import (
    ARC,
    UNIT,
    expanded,
    factors_fem,
    in_fillet_fem,
    pressed_fem,
    pushed_fem,
    stations,
)
from verify.cases.polyhedral.inputs import HubRing
from verify.core.case import Values

FINEST = 6  # level of the pictures
DRAWN = (3, 6, 12)  # flats of the rings in the pictures


def solve(q: HubRing, level: int) -> Level:
    """Results for `level`: K in plane stress and strain, stresses, effect of the hub force."""
    from fem.plane.sectors import radial

    ring, long = (pressed_fem(q, level, a, ARC) for a in ("plane stress", "plane strain"))
    outward = factors_fem(q, ring)
    p = UNIT * q.j_D / 2 / outward["mid"]
    values = stiffness(q, outward) | {
        "K_mid_strain": stiffness(q, factors_fem(q, long))["K_mid"], "fillet": fillet_fem(q, level),
    }  # fmt: skip
    # forces of half a sector: the pressure's resultant turns the chord of the bore
    c, s = np.cos(q.half_angle), np.sin(q.half_angle)
    cuts = [np.array(ring.reaction(name)[:2]) for name in ("mid", "corner")]
    push = UNIT * np.array([q.d_i / 2 * s, q.apothem - q.d_i / 2 * c])
    values["balance_x"], values["balance_y"] = cuts[0] + cuts[1] + push
    values["sigma_tr"] = float(np.hypot(*cuts[1])) / q.delta_1 * p / UNIT
    for at, hub in zip(("e", "corner"), pushed_fem(q, level), strict=True):
        mid, corner = radial(hub, q.d_e / 2, np.array([0.0, q.half_angle]))
        values |= {f"hub_{at}_mid": float(mid), f"hub_{at}_corner": float(corner)}
    arrays = {"outside": radial(ring, q.d_e / 2, stations(q)) * p / UNIT}
    drawn = dict.fromkeys((*DRAWN, q.z)) if level == FINEST else ()
    return Level(
        h=1 / level, values=values, u_it=round_off(values, ring.residual), arrays=arrays,
        fields=tuple(expanded(q, z) for z in drawn),
    )  # fmt: skip


def stiffness_fem(q: HubRing, level: int) -> Level:
    """K by its three definitions, in plane stress, for `level`."""
    ring = pressed_fem(q, level, "plane stress", ARC)
    values = stiffness(q, factors_fem(q, ring))
    return Level(h=1 / level, values=values, u_it=round_off(values, ring.residual))


def both_fem(q: HubRing, level: int) -> Level:
    """K by its three definitions in plane stress, and K_mid in plane strain, for `level`.

    The larger of the residuals of the two solutions applies to all values.
    """
    narrow, wide = (pressed_fem(q, level, a, ARC) for a in ("plane stress", "plane strain"))
    values = stiffness(q, factors_fem(q, narrow)) | {
        "K_mid_strain": stiffness(q, factors_fem(q, wide))["K_mid"]
    }
    residual = max(narrow.residual, wide.residual)
    return Level(h=1 / level, values=values, u_it=round_off(values, residual))


def stiffness(q: HubRing, outward: Values) -> dict[str, float]:
    """K_mid, K_mean and 1/K_corner ("flexibility"), from displacements [m] under `UNIT`."""
    thin = 2 * q.delta_1 * q.E / (q.d_i * q.d_m)  # p_1 over j_D
    per = {where: UNIT / 2 / thin / u for where, u in outward.items()}
    return {"K_mid": per["mid"], "K_mean": per["mean"], "flexibility": 1 / per["corner"]}


def round_off(values: Values, residual: float) -> dict[str, float]:
    """Round-off error of each value, by key; `residual` is the relative residual of the energy."""
    return {key: max(residual**0.5, 1e-11) * abs(value) for key, value in values.items()}


def fillet_fem(q: HubRing, level: int) -> float:
    """Largest hoop stress [Pa] of the fillet when the ring reaches its rollers.

    All cells are as coarse as the cells at the fillet. With finer cells only at the fillet, the
    errors caused by the cells of fillet and wall have opposite signs and similar sizes.
    """
    ring = pressed_fem(q, level, "plane stress")
    return in_fillet_fem(q, ring) * q.j_D / 2 / factors_fem(q, ring)["mid"]
