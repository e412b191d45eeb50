"""Struts between rigid hubs under the clutch's torque, with rolling ends or held in both races."""

import math
from typing import TYPE_CHECKING

import numpy as np

from verify.cases.rotor.clutch.inputs import SpragLink
from verify.core.figures import Array

if TYPE_CHECKING:
    from fem.rotor.struts import Joint

POWER = 10 / 9  # of a line contact
START = 1e-3  # rad, to press the struts at all


def slices_for_fem(q: SpragLink, psi: Array, count: int) -> tuple[Array, Array]:
    """Angle [rad] and height [m] of all `count` slices of sprags at psi (Z,)."""
    z = q.L * ((np.arange(count) + 0.5) / count - 0.5)
    return np.repeat(psi, count), np.tile(z, psi.size)


def law_for_fem(q: SpragLink) -> float:
    """Force of a sprag over its yield to the power 10/9 [N/m^(10/9)], from what 1 kN does to it.

    Palmgren's yield of one contact is 3.84e-5 N^0.9/l^0.8 in newtons and millimetres.
    """
    yields = 2 * 3.84e-8 * 1e3**0.9 / (1e3 * q.L) ** 0.8 if q.a is None else q.a
    return float(1e3 / yields**POWER)


def rolling_by_fem(
    q: SpragLink, count: int, *, T: float | None = None, nu: float | None = None,
    dx: float = 0.0, drop: float = 0.0, missing: int = 0, stiffer: float = 1.0,
) -> "Joint":  # fmt: skip
    """Struts with rolling ends under a torque, the inner hub held at dx, all from no load on."""
    from fem.rotor.struts import Joint, power_law
    from fem.rotor.struts_kinds import Rolling

    nu, T = q.nu if nu is None else nu, q.T if T is None else T
    step = 2 * math.pi / q.Z
    psi = step * (np.arange(missing, q.Z, dtype=float) - (q.missing - 1) / 2)
    angle, z = slices_for_fem(q, psi, count)
    law = power_law(law_for_fem(q) * stiffer**POWER / count / math.cos(nu) ** (POWER + 1), POWER)
    cams = Rolling(
        angle=angle + nu, z=z, lever=q.R_i * math.sin(nu), reach=q.R_i * math.cos(nu),
        s_0=-2 * drop * (2 * z / q.L) ** 2 * math.cos(nu),
    )  # fmt: skip
    # from a twist that has every strut in contact: cams, offsets and drops are of its size
    lost = 2 * drop + abs(dx)
    twist = START + lost / (q.R_i * math.tan(nu))
    started = Joint.at_rest(cams, law).moved(np.array([dx, 0, 0, 0, 0, twist]))
    return started.under(np.array([0, 0, 0, 0, 0, T]), (5,))


def tilted_by_fem(q: SpragLink, count: int) -> "Joint":
    """Struts from half a pitch on under T, the inner hub held aside at one end, twice as far."""
    from fem.rotor.struts import Joint, power_law
    from fem.rotor.struts_kinds import Rolling

    angle, z = slices_for_fem(q, 2 * math.pi * (np.arange(q.Z) + 0.5) / q.Z, count)
    yields = yields_for_fem(q)
    cams = Rolling(
        angle=angle + q.nu, z=z, lever=q.R_i * math.sin(q.nu), reach=q.R_i * math.cos(q.nu)
    )
    law = power_law(law_for_fem(q) / count / math.cos(q.nu) ** (POWER + 1), POWER)
    # the twist first: what is left to turn about z then hardly turns the axis of the tilt
    twisted = Joint.at_rest(cams, law).moved(
        np.array([0, 0, 0, 0, 0, yields / (q.R_i * math.tan(q.nu))])
    )
    dx = min(q.e, yields / 4)
    held = twisted.moved(np.array([dx, 0, 0, 0, 2 * dx / q.L, 0]))
    return held.under(np.array([0, 0, 0, 0, 0, q.T]), (5,))


def yields_for_fem(q: SpragLink) -> float:
    """Yield [m] of every sprag's contacts under T alone."""
    return float((q.T / q.Z / q.R_i / math.tan(q.nu) / law_for_fem(q)) ** (1 / POWER))


def pinned_by_fem(q: SpragLink, count: int, *, stiffer: float = 1.0) -> "Joint":
    """Struts held in both races, placed as they stand under T."""
    from fem.rotor.struts import Joint, power_law
    from fem.rotor.struts_kinds import Pinned

    psi, z = slices_for_fem(q, 2 * math.pi * np.arange(q.Z) / q.Z, count)
    h = q.R_i * math.sin(q.nu)
    away = psi + q.nu - math.asin(h / q.R_e)
    k = law_for_fem(q) * stiffer**POWER / math.cos(q.nu) ** (POWER + 1)
    struts = Pinned(
        a=np.stack([q.R_i * np.cos(psi), q.R_i * np.sin(psi), z], axis=1),
        b=np.stack([q.R_e * np.cos(away), q.R_e * np.sin(away), z], axis=1),
        s_0=(q.T / (q.Z * h) / k) ** (1 / POWER),
    )
    return Joint.at_rest(struts, power_law(k / count, POWER))
