"""The sector of a roller freewheel over its load, by finite elements, and what lies between.

States are taken at overlaps of the contacts that grow from next to nothing to where the normal
force is that of a rigid clutch, N_0 = T/(z R tan(alpha_0)), and beyond the torque T.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fem.wedge.course import Course
from verify.cases.contact.errors import fem_errors
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.fem import Place, Sector, State

Array = NDArray[np.float64]

COARSE = 3  # cells on the half-width of the meshes that say where contacts lie
SHARES = (0.012, 0.045, 0.15, 0.42, 0.82, 1.06)  # of the overlap under N_0
STICKS = 2.0  # friction over tan(alpha): well above what the roller needs
NEAR, MOST = 2e-3, 12  # how near N_0 the end of the sweep is, and in how many steps
FIRST = 16.0  # overlap over N/(L E'), about
GIVEN = 10.0  # N_0/(L E'): approaches at an angle that is given
SPLIT = 0.33  # and the star's part of it
QUANTITIES = ("T", "N", "N race", "F_t", "F_t race", "d_i", "d_o", "a_i", "a_o", "p_i", "p_o", "U")


@dataclass(frozen=True)
class Start:
    """Where a state lies, about: overlap of both contacts [m], half-widths [m] and drags [m]."""

    d: tuple[float, float]
    widths: tuple[float, float]
    drags: tuple[float, float]

    def scaled(self, share: float) -> "Start":
        """The same for overlaps that are `share` of these."""
        root = math.sqrt(share)
        return Start(
            (share * self.d[0], share * self.d[1]),
            (root * self.widths[0], root * self.widths[1]),
            (share * self.drags[0], share * self.drags[1]),
        )

    def state(self, q: OneClutch, cells: int) -> State:
        """The state that overlaps like this."""
        place = Place.overlapping(q, *self.d)
        sector = Sector(place, self.widths, cells, mu=STICKS * math.tan(place.psi / 2))
        return sector.rest(self.drags)


def after(state: State) -> Start:
    """A start that overlaps as much as that of `state`, shared as where this came to rest."""
    start, rest = state.start, state.place
    share = (start.d_i + start.d_o) / (rest.d_i + rest.d_o)
    return Start((share * rest.d_i, share * rest.d_o), state.widths, state.drags)


def rigid_force(q: OneClutch) -> float:
    """N_0 = T/(z R tan(alpha_0)) [N]: what a rigid clutch would press with."""
    cos = (q.flat + q.sense * q.r) / (q.race - q.sense * q.r)
    return q.T / (q.z * q.race) * math.sqrt((1 + cos) / (1 - cos))


def given_angle(q: OneClutch) -> float:
    """An angle psi [rad] that N_0 does not reach: both approaches `GIVEN` N_0/(L E') together."""
    d = GIVEN * rigid_force(q) / q.L * (1 - q.nu**2) / q.E
    return Place.overlapping(q, d / 2, d / 2).psi


@lru_cache(maxsize=16)
def starts(q: OneClutch) -> tuple[Start, ...]:
    """Starts of all states of the sweep, from coarse meshes."""
    P = rigid_force(q) / q.L
    whole = FIRST * P * (1 - q.nu**2) / q.E
    d = (SPLIT * whole, (1 - SPLIT) * whole)
    now = Start(d, (math.sqrt(q.r * d[0] / 2), math.sqrt(q.r * d[1] / 3)), (0.0, 0.0))
    for _ in range(MOST):
        state = now.state(q, COARSE)
        share = P / state.on_flat[0]
        now = after(state).scaled(share**0.95)  # approaches grow a little slower than forces
        if abs(share - 1) < NEAR:
            break
    else:
        raise fem_errors().NotFoundError(
            f"the normal force of a rigid clutch is missed by {share - 1:.1%}"
        )
    found, before = [], 1.0
    for share in sorted(SHARES, reverse=True):
        now = after(now.scaled(share / before).state(q, COARSE))
        found.append(now)
        before = share
    return tuple(found)


class Sweep(Course):
    """States of the sector on meshes of `cells`, and splines between them.

    What `along` names grows from state to state: integrals run over its logarithm.
    """

    by = along = "T"

    def __init__(self, q: OneClutch, cells: int) -> None:
        self._take(q, [start.state(q, cells) for start in reversed(starts(q))])

    def _take(self, q: OneClutch, states: list[State]) -> None:
        self.q = q
        self.last = states[-1]
        self.at_states = {name: np.array([read(q, s)[name] for s in states]) for name in QUANTITIES}
        self.psi = np.array([s.place.psi for s in states])

    def place(self, value: float, by: str = "T") -> Place:
        """Where the roller's centre is."""
        return Place.overlapping(self.q, self.at("d_i", value, by), self.at("d_o", value, by))

    def torsion_by_energy(self, T: Array) -> Array:
        """Torsion [rad] as the integral of dU/T, with a power law below the first state."""
        U = self.logarithm("U", self.along)
        return self._up_to(lambda t: np.exp(U(t) - self.log_torque(t)) * U(t, 1), T)

    def torsion_by_rolling(self, T: Array) -> Array:
        """Torsion [rad] as the integral of (dd_i + dd_o)/(R tan(alpha)): exact rolling."""
        d_i, d_o, q = self.logarithm("d_i", self.along), self.logarithm("d_o", self.along), self.q

        def slope(t: Array) -> Array:
            inner, outer = np.exp(d_i(t)), np.exp(d_o(t))
            to_flat, to_race = (inner, outer) if q.sense > 0 else (outer, inner)
            y = q.flat + q.sense * q.r - q.sense * to_flat
            rho = q.race - q.sense * q.r + q.sense * to_race
            tangent = np.sqrt((rho - y) / (rho + y))
            return np.asarray((inner * d_i(t, 1) + outer * d_o(t, 1)) / (q.race * tangent))

        return self._up_to(slope, T)

    def log_torque(self, t: Array) -> Array:
        """Logarithm of the torque where that of what the states run along is `t`."""
        return t

    def log_along(self, T: Array) -> Array:
        """And the other way round."""
        return np.asarray(np.log(T))

    def _up_to(self, slope: Callable[[Array], Array], T: Array) -> Array:
        """Integrals of a slope up to torques."""
        return self.integral(slope, self.along, self.log_along(np.atleast_1d(T)))


def read(q: OneClutch, state: State) -> dict[str, float]:
    """Torque [N m], energy [J] of the clutch; forces [N] on one roller, lengths, pressures."""
    (N, F_t), (N_race, F_race) = state.on_flat, state.on_race
    (a_i, a_o), (p_i, p_o) = state.widths, state.peaks
    return {
        "T": state.torque * q.L, "N": N * q.L, "N race": N_race * q.L, "F_t": F_t * q.L,
        "F_t race": F_race * q.L, "d_i": state.place.d_i, "d_o": state.place.d_o,
        "a_i": a_i, "a_o": a_o, "p_i": p_i, "p_o": p_o,
        "U": state.solution.strain_energy * q.L * q.z,
    }  # fmt: skip
