"""Required friction coefficient along a load path: its largest value, time of slip, and class.

After the torque has passed through zero, the clutch overruns and needs no friction (nan). As the
torque goes to zero at constant F_ax/T, alpha goes to alpha_0, and mu_req goes to the finite value
tan(alpha_0) sqrt(1 + (R F_ax/T)²). This is the smallest value of an inner cam, whose angle
increases with the torque, and the largest value of an outer cam. If the torque passes through zero
but the axial load does not, mu_req is infinite at the nearest time with T >= 0, because friction is
zero without normal force.
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
        """Ratio mu/mu_req over time."""
        return criterion.safety(mu=self.mu, mu_req=self.mu_req)

    @property
    def peak(self) -> float:
        """Largest mu_req of the path."""
        return float(np.nanmax(self.mu_req))

    @property
    def when(self) -> float:
        """Time [s] of the largest mu_req."""
        return float(self.t[np.nanargmax(self.mu_req)])

    @property
    def slips_at(self) -> float:
        """First of the times [s] with mu_req > mu; infinite if there is no such time."""
        slipping = np.flatnonzero(self.mu_req > self.mu)
        return float(self.t[slipping[0]]) if slipping.size else np.inf

    @property
    def light(self) -> str:
        """Class (traffic light) of the path, from its largest mu_req."""
        return str(criterion.traffic_light(self.mu / self.peak))


def follow(
    clutch: RollerClutch, path: LoadPath, *, mu: float, t: ArrayLike | None = None
) -> Course:
    """Required friction of one clutch along `path`, at equally spaced times or at `t` [s].

    With about 100 points in time per load cycle, the peak is too low by at most the fraction 5e-4.
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
    """Load over time; values that are zero within round-off are set to 0."""
    return np.where(np.abs(load) <= AT_ZERO * np.abs(load).max(initial=0.0), 0.0, load)


def _released_under_load(T: Array, F_ax: Array) -> NDArray[np.bool_]:
    """True for times at which the torque passes through zero under axial load, while T >= 0.

    These are the times with T > 0 next to a time with T < 0, if the axial load has the same sign at
    both, and the times with T = 0 and an axial load.
    """
    passing = (T[1:] * T[:-1] < 0) & (F_ax[1:] * F_ax[:-1] > 0)
    beside = np.zeros(T.shape, dtype=np.bool_)
    beside[1:] |= passing
    beside[:-1] |= passing
    return np.asarray((beside & (T > 0)) | ((T == 0) & (F_ax != 0)), dtype=np.bool_)
