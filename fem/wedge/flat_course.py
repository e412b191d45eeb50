"""Rollers between flats and a round race under increasing load, with interpolation."""

import math
from collections.abc import Callable, Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from fem.wedge.course import Course
from fem.wedge.flat import State
from fem.wedge.flat_place import Pitch, Place
from fem.wedge.flat_start import Start, after

Array = NDArray[np.float64]

QUANTITIES = ("T", "N", "N race", "F_t", "F_t race", "d_i", "d_o", "a_i", "a_o", "p_i", "p_o", "U")


class FlatCourse(Course):
    """Series of `states` of a clutch with rollers of length `L` [m], by ascending load.

    The quantity `along` increases from state to state: integrals are over its logarithm.
    """

    by: ClassVar[str] = "T"
    along: ClassVar[str] = "T"

    def __init__(self, q: Pitch, L: float, states: Sequence[State]) -> None:
        self.q = q
        self.last = states[-1]
        rows = [read(L, state) for state in states]
        self.at_states = {name: np.array([row[name] for row in rows]) for name in QUANTITIES}
        self.psi = np.array([s.place.psi for s in states])

    def place(self, value: float, by: str = "T") -> Place:
        """Position of the roller's centre in the state in which the quantity `by` is `value`."""
        return Place.overlapping(self.q, self.at("d_i", value, by), self.at("d_o", value, by))

    def start(self, T: float) -> Start:
        """Approximate state of the pitch under the torque T [N m], scaled from the last state."""
        last = after(self.last)
        return last.scaled(self.at("d_o", T) / last.d[1])

    def share(self, T: float, where: str = "") -> float:
        """Ratio F_t/N under the torque T [N m] at the flat, or at the race (`where` = " race")."""
        return self.at(f"F_t{where}", T) / self.at(f"N{where}", T)

    def force_at_angle(self, psi: float) -> float:
        """Normal force [N] at which the centre of the roller has the angle `psi` [rad]."""
        low, high = np.sort(self.psi[[0, -1]])
        if not low <= psi <= high:
            raise ArithmeticError(
                f"the angle {psi:.4g} rad is outside the range of the states, whose largest angle "
                f"is {high:.4g} rad"
            )
        sense, rigid = self.q.sense, math.cos(self.q.rigid_angle)
        opened, wanted = sense * (rigid - np.cos(self.psi)), sense * (rigid - math.cos(psi))
        # nearly a power of N
        spline = CubicSpline(np.log(opened), np.log(self.at_states["N"]))
        return float(np.exp(spline(math.log(wanted))))

    def torsion_by_energy(self, T: Array) -> Array:
        """Wind-up [rad] under the torques T [N m]: integral of dU/T from zero load."""
        U = self.logarithm("U", self.along)
        return self._up_to(lambda t: np.exp(U(t) - self.log_torque(t)) * U(t, 1), T)

    def torsion_by_rolling(self, T: Array) -> Array:
        """Wind-up [rad] under the torques T [N m] for rolling without slip.

        It is the integral of (dd_i + dd_o)/(R tan(alpha)).
        """
        q = self.q
        d_i, d_o = self.logarithm("d_i", self.along), self.logarithm("d_o", self.along)

        def slope(t: Array) -> Array:
            inner, outer = np.exp(d_i(t)), np.exp(d_o(t))
            to_flat, to_race = (inner, outer) if q.sense > 0 else (outer, inner)
            y = q.flat + q.sense * q.r - q.sense * to_flat
            rho = q.race - q.sense * q.r + q.sense * to_race
            tangent = np.sqrt((rho - y) / (rho + y))
            return np.asarray((inner * d_i(t, 1) + outer * d_o(t, 1)) / (q.race * tangent))

        return self._up_to(slope, T)

    def log_torque(self, t: Array) -> Array:
        """Logarithm of the torque in states with the logarithm `t` of the quantity `along`."""
        return t

    def log_along(self, T: Array) -> Array:
        """Logarithm of the quantity `along` at the torque T: inverse of `log_torque`."""
        return np.asarray(np.log(T))

    def _up_to(self, slope: Callable[[Array], Array], T: Array) -> Array:
        """Integrals of a slope from zero to the torques T."""
        return self.integral(slope, self.along, self.log_along(np.atleast_1d(T)))


def read(L: float, state: State) -> dict[str, float]:
    """Values of the `QUANTITIES` in a state of a clutch with rollers of length `L` [m], by name.

    Torque [N m] and energy [J] belong to the clutch, forces [N] to one roller. Approaches and
    half-widths are in m, pressures in Pa.
    """
    (N, F_t), (N_race, F_race) = state.on_flat, state.on_race
    (a_i, a_o), (p_i, p_o) = state.widths, state.peaks
    return {
        "T": state.torque * L, "N": N * L, "N race": N_race * L, "F_t": F_t * L,
        "F_t race": F_race * L, "d_i": state.place.d_i, "d_o": state.place.d_o,
        "a_i": a_i, "a_o": a_o, "p_i": p_i, "p_o": p_o,
        "U": state.solution.strain_energy * L * state.start.q.z,
    }  # fmt: skip
