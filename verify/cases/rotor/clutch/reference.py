"""Reference for the clutch's formulas: inclined struts between rigid hubs, exact kinematics."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from verify.case import Level
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.core.figures import Array

if TYPE_CHECKING:
    from fem.rotor.sprag_struts import SpragStruts

TORQUES = (0.1, 0.2, 0.4, 0.7, 1.0)  # shares of T
ANGLES = (0.08, 0.2, 0.4, 0.7, 1.0)  # shares of nu
STIFFER = (10.0, 20.0, 40.0, 70.0, 100.0)  # divisors of the deflections
OFFSETS = (0.25, 0.5, 1.0, 1.5, 2.0)  # shares of the offset
SMALL = (2e-3, 4e-3, 8e-3, 0.014, 0.02)  # offsets over the deflection
HARD = 1e3  # stiffer springs for small twists
COARSE = 8  # slices if tilts do not matter
SIX = {"K_xx": (0, 0), "K_yy": (1, 1), "K_tilt": (4, 4), "K_zz": (5, 5), "K_xz": (0, 5),
       "K_xy": (0, 1), "K_yz": (1, 5)}  # fmt: skip


def struts_fem(q: SpragLink) -> "SpragStruts":
    """Clutch of the inputs as struts."""
    from fem.rotor.sprag_struts import SpragStruts

    return SpragStruts(T=q.T, Z=q.Z, R_i=q.R_i, R_e=q.R_e, nu=q.nu, L=q.L, yields_at_kn=q.a,
                       missing=q.missing)  # fmt: skip


def solve(q: SpragLink, level: int) -> Level:
    """Results of struts in all states, with `level` slices for each sprag."""
    struts = struts_fem(q)
    uniform, pinned = struts.rolling(level), struts.pinned(level)
    joints = {
        "": uniform,
        "_offset": struts.rolling(level, dx=q.e),
        "_crown": struts.rolling(level, drop=q.drop),
        "_gap": struts.rolling(level, gone=q.missing),
        "_together": struts.rolling(level, dx=q.e, drop=q.drop, gone=q.missing),
    }
    values = {
        f"{entry}{name}": float(joint.tangent()[at])
        for name, joint in joints.items()
        for entry, at in SIX.items()
    }
    K, P = uniform.tangent(), pinned.tangent()
    least = replace(struts, T=TORQUES[0] * q.T).rolling(level).tangent()
    values |= {
        "off_diagonal": struts.off_diagonal(K), "off_diagonal_pinned": struts.off_diagonal(P),
        "K_xx_pinned": float(P[0, 0]), "K_zz_pinned": float(P[5, 5]),
        "axial_pinned": float(P[2, 2]), "axial": float(K[2, 2]),
        "exponent": -math.log(K[0, 0] / least[0, 0]) / math.log(TORQUES[0]),
        "torque": float(uniform.loads()[5]) - q.T, "torque_pinned": float(pinned.loads()[5]) - q.T,
    }  # fmt: skip
    u_it = {key: 1e-12 * abs(value) for key, value in values.items() if key.startswith("K")}
    for name in joints:  # sums whose terms cancel
        u_it[f"K_xy{name}"] = 1e-12 * values[f"K_xx{name}"]
        u_it[f"K_yz{name}"] = 1e-12 * math.sqrt(values[f"K_yy{name}"] * values[f"K_zz{name}"])
    aside = struts.tilted(level, q.e).tangent()
    values |= {"K_y_tilt_x": float(aside[1, 3]), "K_x_tilt_y": float(aside[0, 4])}
    across = 1e-12 * math.sqrt(aside[1, 1] * aside[3, 3])
    u_it |= {"K_y_tilt_x": across, "K_x_tilt_y": across}
    u_it["exponent"] = 1e-12
    return Level(h=1 / level, values=values, u_it=u_it, arrays=series_fem(q, struts))


def series_fem(q: SpragLink, struts: "SpragStruts") -> dict[str, Array]:
    """Arrays of stiffnesses: over torque, over wedge angle, over offset.

    With pinned ends, the stiffness is given over the deflection.
    """
    by_torque = [replace(struts, T=x * q.T).rolling(COARSE).tangent() for x in TORQUES]
    flat = []
    for share in ANGLES:  # equal normal forces at all angles
        T = q.T * math.tan(share * q.nu) / math.tan(q.nu)
        flat.append(replace(struts, nu=share * q.nu, T=T).rolling(COARSE, stiffer=HARD))
    yields = struts.yields
    aside, small = (
        [struts.rolling(COARSE, dx=dx).tangent()[0, 5] for dx in offsets]
        for offsets in ([share * q.e for share in OFFSETS], [s * yields for s in SMALL])
    )
    stiff = [struts.pinned(COARSE, stiffer=s).tangent()[5, 5] for s in STIFFER]
    return {
        "K_xx over T": np.array([K[0, 0] for K in by_torque]),
        "K_zz over T": np.array([K[5, 5] for K in by_torque]),
        "K_xx over nu": np.array([joint.tangent()[0, 0] for joint in flat]),
        "K_xz over offset": np.array(aside),
        "K_xz over small offsets": np.array(small),
        "K_zz over deflection, pinned": np.array(stiff),
    }
