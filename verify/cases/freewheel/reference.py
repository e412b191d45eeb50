"""What the sweep of a sector, of star or cup, is read for: under a torque, at N_0, at an angle."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from fem.wedge.flat import State
from fem.wedge.flat_course import FlatCourse as Sweep
from fem.wedge.flat_place import Pitch, Place
from verify.case import plane_field
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.fem import NAMES
from verify.cases.freewheel.sweep import rigid_force
from verify.core.figures import Field

Array = NDArray[np.float64]

LEVELS = (4, 7, 10)  # cells on the half-width of the fine zones
GRID = np.linspace(0.1, 1.0, 10)  # of T, where profiles are compared
ACROSS = np.linspace(-0.95, 0.95, 39)  # of the half-width, where pressures are
SPLINE = 5e-6  # of a value: what splines between the states may miss, twice that of phi


def under_torque(q: OneClutch, sweep: Sweep) -> dict[str, float]:
    """Angle, force, way and torsion under T, approaches and contacts at N_0; statics."""
    T, N_0, place = q.T, rigid_force(q), sweep.place(q.T)
    values = {
        "alpha": place.psi / 2,
        "N": sweep.at("N", T),
        "mu_T": (ratio(sweep, T, "") + ratio(sweep, T, " race")) / 2,
        "s": float(arc(q, np.array([place.psi]), np.array([to_race(place)]))[0]),
        "phi": float(sweep.torsion_by_energy(np.array([T]))[0]),
    }
    for name in ("d_i", "d_o", "a_i", "a_o", "p_i", "p_o", "T"):
        values[f"{name}_rigid"] = sweep.at(name, N_0, "N")
    return values | statics(q, sweep)


def over_torque(q: OneClutch, sweep: Sweep) -> dict[str, Array]:
    """Profiles over the torque, what the states are, and pressures of the heaviest one."""
    grid, at = GRID * q.T, sweep.at_states
    psi, d = np.array([(p.psi, to_race(p)) for p in map(sweep.place, grid)]).T
    names = NAMES[q.sense]
    inner, outer = (names.cam, names.race)[:: q.sense]
    return {
        "alpha_over_T": psi / 2,
        "s_over_T": arc(q, psi, d),
        "phi_over_T": sweep.torsion_by_energy(grid),
        "shares": np.array([at["F_t"] / at["N"], at["F_t race"] / at["N race"]]),
        "loads": np.array([at["T"], at["N"], sweep.psi, at["d_i"], at["d_o"]]),
        f"p_on_{inner}": across(sweep.last, 0),
        f"p_on_{outer}": across(sweep.last, 1),
    }


def to_race(place: Place) -> float:
    """Approach [m] of roller and race."""
    return place.d_o if place.q.sense > 0 else place.d_i


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


def rigid_angle(q: OneClutch | Pitch) -> float:
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
    tan, torque = math.tan(place.psi / 2), np.array([T])
    N, F_t, on_race = sweep.at("N", T), sweep.at("F_t", T), sweep.at("F_t race", T)
    on_cam = q.z * (N * place.x - F_t * q.flat)
    rolling, energy = sweep.torsion_by_rolling(torque)[0], sweep.torsion_by_energy(torque)[0]
    touches = sweep.last.solution.touches
    force, size = np.add(*(np.array(t.force) for t in touches)), np.hypot(*touches[0].force)
    return {
        "share_flat": ratio(sweep, T, "") / tan - 1,
        "share_race": ratio(sweep, T, " race") / tan - 1,
        "torque_race": q.z * q.race * on_race / T - 1,
        "torque_cam": on_cam / T - 1,
        "rolling": float(rolling / energy - 1),
        "forces": float(np.hypot(*force)) / float(size),
        "unlike_N": sweep.at("N race", T) / N - 1,
        "unlike_F_t": on_race / F_t - 1,
    }


def across(state: State, contact: int) -> Array:
    """Pressure over the largest of Hertz at `ACROSS`, on the half-width that its moments say."""
    touch = state.solution.touches[contact]
    s, load = touch.along(), touch.p * touch.weight
    a, P = touch.half_width(), load.sum()
    order = np.argsort(s)
    return np.asarray(np.interp(ACROSS * a, s[order], touch.p[order]) * np.pi * a / (2 * P))


def field(state: State) -> Field:
    """The sector with displacements and von Mises' stress."""
    plane: Any = state.solution.plane
    return plane_field(plane, "stress", "von_mises", "log_mises", name="sector")
