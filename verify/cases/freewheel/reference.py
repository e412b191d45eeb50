"""Results of the sweep of a sector of star or cup: under T, at N_0 and at a given angle."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from fem.wedge.flat import State
from fem.wedge.flat_balance import balance, over_hertz
from fem.wedge.flat_course import FlatCourse as Sweep
from verify.case import plane_field
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.sweep import rigid_force
from verify.core.figures import Field

Array = NDArray[np.float64]

LEVELS = (4, 7, 10)  # cells on the half-width of the fine zones
GRID = np.linspace(0.1, 1.0, 10)  # torques of the compared profiles, over T
ACROSS = np.linspace(-0.95, 0.95, 39)  # positions of the pressures over the half-width
SPLINE = 5e-6  # relative error of splines between the states; twice for phi


def under_torque(q: OneClutch, sweep: Sweep) -> dict[str, float]:
    """Values under T (angle, force, travel, wind-up, residuals) and at N_0 (contacts)."""
    T, N_0, place = q.T, rigid_force(q), sweep.place(q.T)
    values = {
        "alpha": place.psi / 2,
        "N": sweep.at("N", T),
        "mu_T": (sweep.share(T) + sweep.share(T, " race")) / 2,
        "s": float(sweep.q.arc(np.array([place.psi]), np.array([place.to_race]))[0]),
        "phi": float(sweep.torsion_by_energy(np.array([T]))[0]),
    }
    for name in ("d_i", "d_o", "a_i", "a_o", "p_i", "p_o", "T"):
        values[f"{name}_rigid"] = sweep.at(name, N_0, "N")
    return values | balance(sweep, T)


def over_torque(q: OneClutch, sweep: Sweep) -> dict[str, Array]:
    """Profiles over the torque, loads of all states, and pressures in the state of largest load."""
    grid, at = GRID * q.T, sweep.at_states
    psi, d = np.array([(p.psi, p.to_race) for p in map(sweep.place, grid)]).T
    names, touches = sweep.q.names, sweep.last.solution.touches
    inner, outer = (names.cam, names.race)[:: q.sense]
    return {
        "alpha_over_T": psi / 2,
        "s_over_T": sweep.q.arc(psi, d),
        "phi_over_T": sweep.torsion_by_energy(grid),
        "shares": np.array([at["F_t"] / at["N"], at["F_t race"] / at["N race"]]),
        "loads": np.array([at["T"], at["N"], sweep.psi, at["d_i"], at["d_o"]]),
        f"p_on_{inner}": over_hertz(touches[0], ACROSS),
        f"p_on_{outer}": over_hertz(touches[1], ACROSS),
    }


def field(state: State) -> Field:
    """Field of the sector with displacements and von Mises stress."""
    plane: Any = state.solution.plane
    return plane_field(plane, "stress", "von_mises", "log_mises", name="sector")
