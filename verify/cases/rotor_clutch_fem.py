"""Partner of the clutch's formulas: struts between rigid hubs, inclined, in exact kinematics."""

import math
from typing import TYPE_CHECKING

import numpy as np

from verify.case import FemResult
from verify.cases.rotor_clutch_inputs import ClutchInputs
from verify.shown import Array

if TYPE_CHECKING:
    from fem.rotor.struts import Joint

POWER = 10 / 9  # of a line contact
START = 1e-3  # rad, to press the struts at all
TORQUES = (0.1, 0.2, 0.4, 0.7, 1.0)  # shares of T
ANGLES = (0.08, 0.2, 0.4, 0.7, 1.0)  # shares of nu
STIFFER = (10.0, 20.0, 40.0, 70.0, 100.0)  # yields smaller by these
OFFSETS = (0.25, 0.5, 1.0, 1.5, 2.0)  # shares of the offset
SMALL = (2e-3, 4e-3, 8e-3, 0.014, 0.02)  # offsets over the yield
HARD = 1e3  # the same where twists are to stay small
COARSE = 8  # slices where tilts do not matter
SIX = {"K_xx": (0, 0), "K_yy": (1, 1), "K_tilt": (4, 4), "K_zz": (5, 5), "K_xz": (0, 5),
       "K_xy": (0, 1), "K_yz": (1, 5)}  # fmt: skip


def slices_for_fem(q: ClutchInputs, psi: Array, count: int) -> tuple[Array, Array]:
    """Angle [rad] and height [m] of all `count` slices of sprags at psi (Z,)."""
    z = q.L * ((np.arange(count) + 0.5) / count - 0.5)
    return np.repeat(psi, count), np.tile(z, psi.size)


def law_for_fem(q: ClutchInputs) -> float:
    """Force of a sprag over its yield to the power 10/9 [N/m^(10/9)], from what 1 kN does to it.

    Palmgren's yield of one contact is 3.84e-5 N^0.9/l^0.8 in newtons and millimetres.
    """
    yields = 2 * 3.84e-8 * 1e3**0.9 / (1e3 * q.L) ** 0.8 if q.a is None else q.a
    return float(1e3 / yields**POWER)


def rolling_by_fem(
    q: ClutchInputs, count: int, *, T: float | None = None, nu: float | None = None,
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


def tilted_by_fem(q: ClutchInputs, count: int) -> "Joint":
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


def yields_for_fem(q: ClutchInputs) -> float:
    """Yield [m] of every sprag's contacts under T alone."""
    return float((q.T / q.Z / q.R_i / math.tan(q.nu) / law_for_fem(q)) ** (1 / POWER))


def pinned_by_fem(q: ClutchInputs, count: int, *, stiffer: float = 1.0) -> "Joint":
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


def off_diagonal(q: ClutchInputs, K: Array) -> float:
    """Largest entry off the diagonal [N/m], tilts over L and the twist over R_i."""
    size = np.array([1, 1, 1, q.L, q.L, q.R_i])
    return float(np.abs((K - np.diag(np.diag(K))) / np.outer(size, size)).max())


def fem(q: ClutchInputs, level: int) -> FemResult:
    uniform, pinned = rolling_by_fem(q, level), pinned_by_fem(q, level)
    joints = {
        "uniform": uniform,
        "offset": rolling_by_fem(q, level, dx=q.e),
        "crown": rolling_by_fem(q, level, drop=q.drop),
        "gap": rolling_by_fem(q, level, missing=q.missing),
        "together": rolling_by_fem(q, level, dx=q.e, drop=q.drop, missing=q.missing),
    }
    values = {
        f"{entry}, {name}": float(joint.tangent()[at])
        for name, joint in joints.items()
        for entry, at in SIX.items()
    }
    K, P = uniform.tangent(), pinned.tangent()
    values |= {
        "off-diagonal": off_diagonal(q, K), "off-diagonal, pinned": off_diagonal(q, P),
        "K_xx, pinned": float(P[0, 0]), "K_zz, pinned": float(P[5, 5]),
        "axial, pinned": float(P[2, 2]), "axial": float(K[2, 2]),
        "exponent": exponent_by_fem(q, level, uniform),
        "torque": float(uniform.loads()[5]) - q.T, "torque, pinned": float(pinned.loads()[5]) - q.T,
    }  # fmt: skip
    u_it = {key: 1e-12 * abs(value) for key, value in values.items() if key.startswith("K")}
    for name in joints:  # sums whose terms cancel
        u_it[f"K_xy, {name}"] = 1e-12 * values[f"K_xx, {name}"]
        u_it[f"K_yz, {name}"] = 1e-12 * math.sqrt(values[f"K_yy, {name}"] * values[f"K_zz, {name}"])
    aside = tilted_by_fem(q, level).tangent()
    values |= {"K_y,γx, tilted": float(aside[1, 3]), "K_x,γy, tilted": float(aside[0, 4])}
    across = 1e-12 * math.sqrt(aside[1, 1] * aside[3, 3])
    u_it |= {"K_y,γx, tilted": across, "K_x,γy, tilted": across}
    u_it["exponent"] = 1e-12
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=series_by_fem(q))


def exponent_by_fem(q: ClutchInputs, count: int, whole: "Joint") -> float:
    """Exponent of K_xx over the torque, from the least of the torques to T."""
    least = rolling_by_fem(q, count, T=TORQUES[0] * q.T)
    return -math.log(whole.tangent()[0, 0] / least.tangent()[0, 0]) / math.log(TORQUES[0])


def series_by_fem(q: ClutchInputs) -> dict[str, Array]:
    """Stiffnesses over torque, wedge angle and offset, and pinned ones over how much yields."""
    by_torque = [rolling_by_fem(q, COARSE, T=share * q.T).tangent() for share in TORQUES]
    # the same normal forces at all angles
    torques = [q.T * math.tan(share * q.nu) / math.tan(q.nu) for share in ANGLES]
    flat = [
        rolling_by_fem(q, COARSE, nu=share * q.nu, T=T, stiffer=HARD)
        for share, T in zip(ANGLES, torques, strict=True)
    ]
    aside = [rolling_by_fem(q, COARSE, dx=share * q.e).tangent()[0, 5] for share in OFFSETS]
    yields = yields_for_fem(q)
    small = [rolling_by_fem(q, COARSE, dx=s * yields).tangent()[0, 5] for s in SMALL]
    stiff = [pinned_by_fem(q, COARSE, stiffer=s).tangent()[5, 5] for s in STIFFER]
    return {
        "K_xx over T": np.array([K[0, 0] for K in by_torque]),
        "K_zz over T": np.array([K[5, 5] for K in by_torque]),
        "K_xx over nu": np.array([joint.tangent()[0, 0] for joint in flat]),
        "K_xz over offset": np.array(aside),
        "K_xz over small offsets": np.array(small),
        "K_zz over yield, pinned": np.array(stiff),
    }
