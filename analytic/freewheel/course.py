"""Required friction along a load path: its peak, when the clutch slips, its class.

After the torque has passed through zero the clutch overruns and needs no friction (nan). As torque
goes to zero at constant F_ax/T, alpha goes to alpha_0 and mu_req to
tan(alpha_0) sqrt(1 + (R F_ax/T)²): finite, the least of an inner cam, whose angle grows with the
torque, and the most of an outer cam. Where torque passes through zero while the axial load does
not, mu_req is infinite at the last locked time: no friction holds without normal force.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array
from analytic.freewheel import criterion, state
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.load_path import LoadPath

POINTS = 4001
AT_ZERO = 1e-10  # over the largest load: round-off at zero crossings after thousands of cycles


@dataclass(frozen=True, kw_only=True, eq=False)
class Course:
    """Loads, clamping angle [rad] and mu_req over the times `t` [s]; nan in overrunning."""

    t: Array
    T: Array
    F_ax: Array
    alpha: Array
    mu_req: Array
    mu: float

    @property
    def safety(self) -> Array:
        """mu/mu_req over time."""
        return criterion.safety(mu=self.mu, mu_req=self.mu_req)

    @property
    def peak(self) -> float:
        """Largest mu_req."""
        return float(np.nanmax(self.mu_req))

    @property
    def when(self) -> float:
        """Time [s] of the largest mu_req."""
        return float(self.t[np.nanargmax(self.mu_req)])

    @property
    def slips_at(self) -> float:
        """First time [s] of these at which mu_req exceeds mu; infinite if it never does."""
        slipping = np.flatnonzero(self.mu_req > self.mu)
        return float(self.t[slipping[0]]) if slipping.size else np.inf

    @property
    def light(self) -> str:
        """Class of the path, by its largest mu_req."""
        return str(criterion.traffic_light(self.mu / self.peak))


def follow(
    clutch: RollerClutch, path: LoadPath, *, mu: float, t: ArrayLike | None = None
) -> Course:
    """Course of one clutch along `path`, at evenly spaced times unless `t` [s] names them.

    A cycle needs some 100 times: the peak is then too small by at most 5e-4.
    """
    t = np.linspace(0, path.duration, POINTS) if t is None else np.asarray(t, dtype=np.float64)
    criterion.friction(mu)
    T, F_ax = _without_round_off(path.torque(t)), _without_round_off(path.axial_load(t))
    locked = T >= 0
    alpha = np.where(locked, state.loaded(clutch, np.where(locked, T, 0.0)).alpha, np.nan)
    mu_req = criterion.required_friction_of_ratio(
        alpha=alpha, ratio=path.ratio(t), R=clutch.cam.race
    )
    mu_req = np.where(_released_under_load(T, F_ax), np.inf, mu_req)
    return Course(t=t, T=T, F_ax=F_ax, alpha=alpha, mu_req=mu_req, mu=mu)


def _without_round_off(load: Array) -> Array:
    """The load over time, with values that are zero within round-off set to 0."""
    return np.where(np.abs(load) <= AT_ZERO * np.abs(load).max(initial=0.0), 0.0, load)


def _released_under_load(T: Array, F_ax: Array) -> NDArray[np.bool_]:
    """Locked times next to overrunning times, with an axial load of constant sign in between.

    A time without torque but with an axial load is one of them.
    """
    passing = (T[1:] * T[:-1] < 0) & (F_ax[1:] * F_ax[:-1] > 0)
    beside = np.zeros(T.shape, dtype=np.bool_)
    beside[1:] |= passing
    beside[:-1] |= passing
    return np.asarray((beside & (T > 0)) | ((T == 0) & (F_ax != 0)), dtype=np.bool_)
