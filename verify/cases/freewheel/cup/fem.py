"""Finite elements of a drawn-cup clutch under torque: the sweep, read where formulas stand."""

import numpy as np

from verify.cases.freewheel.cup.inputs import CupInputs
from verify.cases.freewheel.cup.sweep import CupSweep, given_angle
from verify.cases.freewheel.sweep import rigid_force
from verify.cases.freewheel.torque.fem import (
    GRID,
    SPLINE,
    across,
    arc,
    at_angle,
    field,
    ratio,
    shares,
    statics,
)
from verify.core.case import FemResult

LEVELS = (4, 7, 10)  # cells on the half-width of the fine zones
COURSE = 3e-5  # of a value: what splines between states miss
BEGINNING = 1e-4  # of phi: what a power below the first state misses


def fem(q: CupInputs, level: int) -> FemResult:
    sweep, T = CupSweep(q, level), q.T
    N_0, place = rigid_force(q), sweep.place(q.T)
    N_top, T_top = sweep.summit
    values = {
        "alpha": place.psi / 2, "N": sweep.at("N", T),
        "F_t/N": (ratio(sweep, T, "") + ratio(sweep, T, " race")) / 2,
        "s": arc(q, np.array([place.psi]), np.array([place.d_i]))[0],
        "phi": sweep.torsion_by_energy(np.array([T]))[0],
        "N at angle": at_angle(sweep, given_angle(q)), "T summit": T_top,
        "alpha summit": sweep.place(N_top, "N").psi / 2,
        "falls": float(-np.diff(sweep.psi).max() / sweep.psi[0]),
        "past the summit": 1 - sweep.at_states["T"][-1] / T_top,
    }  # fmt: skip
    values |= {f"{name} at N": sweep.at(name, N_0, "N") for name in
               ("d_i", "d_o", "a_i", "a_o", "p_i", "p_o", "T")}  # fmt: skip
    values |= statics(q, sweep)
    grid = GRID * T
    psi, d_i = np.array([(p.psi, p.d_i) for p in map(sweep.place, grid)]).T
    states = sweep.at_states
    arrays = {
        "profile, alpha": psi / 2, "profile, s": arc(q, psi, d_i),
        "profile, phi": sweep.torsion_by_energy(grid), "shares": shares(sweep),
        "loads": np.array([sweep.psi if k == "psi" else states[k]
                           for k in ("T", "N", "psi", "d_i", "d_o")]),
        "profile, p on the shaft": across(sweep.last, 0),
        "profile, p on the cup": across(sweep.last, 1),
    }  # fmt: skip
    u_it = {k: SPLINE * abs(float(v)) for k, v in values.items()}
    u_it |= {k: COURSE * abs(float(values[k])) for k in ("T summit", "N", "alpha", "s")}
    u_it["phi"] = BEGINNING * abs(float(values["phi"]))
    return FemResult(
        h=1 / level, values={k: float(v) for k, v in values.items()}, u_it=u_it, arrays=arrays,
        fields=(field(sweep.last),),
    )  # fmt: skip
