"""Finite elements of a roller freewheel under torque: the sweep, read where formulas stand."""

import math

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.fem import State
from verify.cases.freewheel.inputs import StarInputs
from verify.cases.freewheel.sweep import Sweep, given_angle, rigid_force
from verify.core.case import FemResult
from verify.core.figures import Field

Array = NDArray[np.float64]

LEVELS = (4, 7, 10)  # cells on the half-width of the fine zones
GRID = np.linspace(0.1, 1.0, 10)  # of T, where profiles are compared
ACROSS = np.linspace(-0.95, 0.95, 39)  # of the half-width, where pressures are
SPLINE = 5e-6  # of a value: what splines between the states may miss, twice that of phi


def fem(q: StarInputs, level: int) -> FemResult:
    sweep, T = Sweep(q, level), q.T
    N_0, place = rigid_force(q), sweep.place(q.T)
    values = {
        "alpha": place.psi / 2,
        "N": sweep.at("N", T),
        "F_t/N": (ratio(sweep, T, "") + ratio(sweep, T, " race")) / 2,
        "s": arc(q, np.array([place.psi]), np.array([place.d_o]))[0],
        "phi": sweep.torsion_by_energy(np.array([T]))[0],
        "N at angle": at_angle(sweep, given_angle(q)),
    }
    values |= {f"{name} at N": sweep.at(name, N_0, "N") for name in
               ("d_i", "d_o", "a_i", "a_o", "p_i", "p_o", "T")}  # fmt: skip
    values |= statics(q, sweep)
    grid = GRID * T
    at_grid = [sweep.place(t) for t in grid]
    psi, d_o = np.array([(p.psi, p.d_o) for p in at_grid]).T
    arrays = {
        "profile, alpha": psi / 2, "profile, s": arc(q, psi, d_o),
        "profile, phi": sweep.torsion_by_energy(grid),
        "shares": shares(sweep),
        "loads": np.array([sweep.psi if k == "psi" else sweep.at_states[k]
                           for k in ("T", "N", "psi", "d_i", "d_o")]),
        "profile, p on the star": across(sweep.last, 0),
        "profile, p on the ring": across(sweep.last, 1),
    }  # fmt: skip
    return FemResult(
        h=1 / level, values={k: float(v) for k, v in values.items()},
        u_it={k: SPLINE * abs(float(v)) * (2 if k == "phi" else 1) for k, v in values.items()},
        arrays=arrays, fields=(field(sweep.last),),
    )  # fmt: skip


def at_angle(sweep: Sweep, psi: float) -> float:
    """Normal force [N] with the roller's centre at the angle `psi` [rad]."""
    low, high = np.sort(sweep.psi[[0, -1]])
    if not low <= psi <= high:
        raise ArithmeticError(f"the angle {psi:.4g} rad lies beyond the states' {high:.4g} rad")
    sense, rigid = sweep.q.sense, math.cos(rigid_angle(sweep.q))
    opened, wanted = sense * (rigid - np.cos(sweep.psi)), sense * (rigid - math.cos(psi))
    # nearly a power of N
    spline = CubicSpline(np.log(opened), np.log(sweep.at_states["N"]))
    return float(np.exp(spline(math.log(wanted))))


def rigid_angle(q: OneClutch) -> float:
    """The angle psi [rad] without load."""
    return math.acos((q.flat + q.sense * q.r) / (q.race - q.sense * q.r))


def ratio(sweep: Sweep, T: float, where: str) -> float:
    """F_t/N at the flat, or at the race."""
    return sweep.at(f"F_t{where}", T) / sweep.at(f"N{where}", T)


def arc(q: OneClutch, psi: Array, to_race: Array) -> Array:
    """Way s [m] of the roller's centre about the axis, as seen from the cam."""
    rho = q.race - q.sense * q.r + q.sense * to_race
    return np.asarray(rho * (psi - rigid_angle(q)) * q.sense)


def statics(q: OneClutch, sweep: Sweep) -> dict[str, float]:
    """What forces in balance leave between torque, normal and tangential forces, all relative."""
    T, place = q.T, sweep.place(q.T)
    tan = math.tan(place.psi / 2)
    N, F_t, on_race = sweep.at("N", T), sweep.at("F_t", T), sweep.at("F_t race", T)
    on_cam = q.z * (N * place.x - F_t * q.flat)
    rolling, energy = (f(np.array([T]))[0]
                       for f in (sweep.torsion_by_rolling, sweep.torsion_by_energy))  # fmt: skip
    force = np.add(*(np.array(t.force) for t in sweep.last.solution.touches))
    size = np.hypot(*sweep.last.solution.touches[0].force)
    return {
        "flat's F_t/N": ratio(sweep, T, "") / tan - 1,
        "race's F_t/N": ratio(sweep, T, " race") / tan - 1,
        "T on the race": q.z * q.race * on_race / T - 1,
        "T on the cam": on_cam / T - 1,
        "rolling": rolling / energy - 1,
        "forces": float(np.hypot(*force)) / float(size),
        "unlike N": sweep.at("N race", T) / N - 1,
        "unlike F_t": on_race / F_t - 1,
    }


def shares(sweep: Sweep) -> Array:
    """F_t/N (2, m) of the states, at the star and at the ring."""
    s = sweep.at_states
    return np.array([s["F_t"] / s["N"], s["F_t race"] / s["N race"]])


def across(state: State, contact: int) -> Array:
    """Pressure over the largest of Hertz at `ACROSS`, on the half-width that its moments say."""
    touch = state.solution.touches[contact]
    s, load = touch.along(), touch.p * touch.weight
    a, P = touch.half_width(), load.sum()
    order = np.argsort(s)
    return np.asarray(np.interp(ACROSS * a, s[order], touch.p[order]) * np.pi * a / (2 * P))


def field(state: State) -> Field:
    """The sector with displacements and von Mises' stress."""
    cells = state.solution.plane.cells()
    return Field(
        name="sector", points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"]},
        cell_data={"stress": cells["stress"], "von_mises": cells["von_mises"],
                   "log_mises": np.log10(np.maximum(cells["von_mises"] / 1e6, 10.0))},
        units={"displacement": "m", "stress": "Pa", "von_mises": "Pa", "log_mises": "1"},
    )  # fmt: skip
