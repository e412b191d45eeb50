"""Partner of the clutch's formulas: struts between rigid hubs, inclined, in exact kinematics."""

import math
from typing import TYPE_CHECKING

import numpy as np

from verify.case import Level
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.cases.rotor.clutch.struts_fem import (
    pinned_by_fem,
    rolling_by_fem,
    tilted_by_fem,
    yields_for_fem,
)
from verify.core.figures import Array

if TYPE_CHECKING:
    from fem.rotor.struts import Joint

TORQUES = (0.1, 0.2, 0.4, 0.7, 1.0)  # shares of T
ANGLES = (0.08, 0.2, 0.4, 0.7, 1.0)  # shares of nu
STIFFER = (10.0, 20.0, 40.0, 70.0, 100.0)  # yields smaller by these
OFFSETS = (0.25, 0.5, 1.0, 1.5, 2.0)  # shares of the offset
SMALL = (2e-3, 4e-3, 8e-3, 0.014, 0.02)  # offsets over the yield
HARD = 1e3  # the same where twists are to stay small
COARSE = 8  # slices where tilts do not matter
SIX = {"K_xx": (0, 0), "K_yy": (1, 1), "K_tilt": (4, 4), "K_zz": (5, 5), "K_xz": (0, 5),
       "K_xy": (0, 1), "K_yz": (1, 5)}  # fmt: skip


def off_diagonal(q: SpragLink, K: Array) -> float:
    """Largest entry off the diagonal [N/m], tilts over L and the twist over R_i."""
    size = np.array([1, 1, 1, q.L, q.L, q.R_i])
    return float(np.abs((K - np.diag(np.diag(K))) / np.outer(size, size)).max())


def solve(q: SpragLink, level: int) -> Level:
    """Struts in all states, cut into `level` slices."""
    uniform, pinned = rolling_by_fem(q, level), pinned_by_fem(q, level)
    joints = {
        "": uniform,
        "_offset": rolling_by_fem(q, level, dx=q.e),
        "_crown": rolling_by_fem(q, level, drop=q.drop),
        "_gap": rolling_by_fem(q, level, missing=q.missing),
        "_together": rolling_by_fem(q, level, dx=q.e, drop=q.drop, missing=q.missing),
    }
    values = {
        f"{entry}{name}": float(joint.tangent()[at])
        for name, joint in joints.items()
        for entry, at in SIX.items()
    }
    K, P = uniform.tangent(), pinned.tangent()
    values |= {
        "off_diagonal": off_diagonal(q, K), "off_diagonal_pinned": off_diagonal(q, P),
        "K_xx_pinned": float(P[0, 0]), "K_zz_pinned": float(P[5, 5]),
        "axial_pinned": float(P[2, 2]), "axial": float(K[2, 2]),
        "exponent": exponent_by_fem(q, level, uniform),
        "torque": float(uniform.loads()[5]) - q.T, "torque_pinned": float(pinned.loads()[5]) - q.T,
    }  # fmt: skip
    u_it = {key: 1e-12 * abs(value) for key, value in values.items() if key.startswith("K")}
    for name in joints:  # sums whose terms cancel
        u_it[f"K_xy{name}"] = 1e-12 * values[f"K_xx{name}"]
        u_it[f"K_yz{name}"] = 1e-12 * math.sqrt(values[f"K_yy{name}"] * values[f"K_zz{name}"])
    aside = tilted_by_fem(q, level).tangent()
    values |= {"K_y_tilt_x": float(aside[1, 3]), "K_x_tilt_y": float(aside[0, 4])}
    across = 1e-12 * math.sqrt(aside[1, 1] * aside[3, 3])
    u_it |= {"K_y_tilt_x": across, "K_x_tilt_y": across}
    u_it["exponent"] = 1e-12
    return Level(h=1 / level, values=values, u_it=u_it, arrays=series_by_fem(q))


def exponent_by_fem(q: SpragLink, count: int, whole: "Joint") -> float:
    """Exponent of K_xx over the torque, from the least of the torques to T."""
    least = rolling_by_fem(q, count, T=TORQUES[0] * q.T)
    return -math.log(whole.tangent()[0, 0] / least.tangent()[0, 0]) / math.log(TORQUES[0])


def series_by_fem(q: SpragLink) -> dict[str, Array]:
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
