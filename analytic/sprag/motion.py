"""Motion data of an engagement: inertias, springs, damping, friction, torque and initial speeds."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, not_negative, positive


@dataclass(frozen=True, kw_only=True)
class Motion:
    """All data of Eqs. 12-16 that are not geometry; SI units.

    `k_out` is the torsional stiffness of the support of the outer race, `C_rl` the damping between
    the races. `K_r` and `alpha_max` are the stiffness and the unloaded rotation of the energizing
    springs, which press the sprags on the races. Raises ValueError for invalid values.
    """

    m_g: float  # kg
    I_g: float  # kg m², of one sprag about its centroid
    I_bi: float
    I_be: float
    K_r: float  # N m/rad, per sprag
    alpha_max: float  # rad, where the blades are slack; negative, they hold the sprags off
    C_rl: float  # N m s/rad
    k_out: float  # N m/rad
    mu_s: float
    mu_c: float
    gamma_b: float  # s/m

    def __post_init__(self) -> None:
        for name, unit in (("m_g", "kg"), ("I_g", "kg m²"), ("I_bi", "kg m²"), ("I_be", "kg m²"),
                           ("k_out", "N m/rad"), ("mu_s", ""), ("mu_c", "")):  # fmt: skip
            positive(getattr(self, name), name, unit)
        for name, unit in (("K_r", "N m/rad"), ("C_rl", "N m s/rad"), ("gamma_b", "s/m")):
            not_negative(getattr(self, name), name, unit)
        finite(self.alpha_max, "alpha_max", "rad")
        if self.mu_c > self.mu_s:
            raise ValueError(
                "friction must not increase with the sliding speed (mu_c <= mu_s), got "
                f"mu_c={self.mu_c}, mu_s={self.mu_s}"
            )


@dataclass(frozen=True, kw_only=True, eq=False)
class Torque:
    """Torque [N m] on the inner race, linear between `times` [s] and constant after the last."""

    times: Array
    values: Array

    def __post_init__(self) -> None:
        if self.times.shape != self.values.shape or self.times.ndim != 1 or not len(self.times):
            raise ValueError(
                f"a torque must have one value per time, got {self.values.shape} values [N m] for "
                f"{self.times.shape} times [s]"
            )
        finite(self.values, "torque", "N m")
        if np.any(np.diff(finite(self.times, "times", "s")) <= 0):
            raise ValueError(f"times of a torque must increase, got {self.times} s")

    @classmethod
    def step(cls, torque: float, *, t_ramp: float = 0.0) -> "Torque":
        """Constant `torque` [N m] after a linear rise from 0 over `t_ramp` [s].

        >>> Torque.step(25.0, t_ramp=0.1).at([0.05, 1.0]).tolist()
        [12.5, 25.0]
        """
        if not_negative(t_ramp, "ramp", "s") == 0:
            return cls(times=np.array([0.0]), values=np.array([float(torque)]))
        return cls(times=np.array([0.0, t_ramp]), values=np.array([0.0, float(torque)]))

    def at(self, t: ArrayLike) -> Array:
        """Torque [N m] at the times `t` [s]."""
        return np.asarray(np.interp(np.asarray(t, dtype=np.float64), self.times, self.values))


@dataclass(frozen=True, kw_only=True)
class Speeds:
    """Initial speeds [rad/s] of races and sprags, positive in the driving direction.

    The speed of an overrunning inner race is negative.
    """

    inner: float = 0.0
    outer: float = 0.0
    phi: float = 0.0  # of the sprags' centroids about the clutch's axis
