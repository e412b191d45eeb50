r"""Load paths of the test rig (Nagler, Lohrengel, Sec. 6): T and F_ax as functions of time.

1. `AxialRamp`: first the torque increases, then the axial load;
2. `AlternatingAxial`: first the torque increases, then the axial load alternates with increasing
   amplitude;
3. `BothAlternating`: both alternate in phase, the axial load with increasing amplitude.

`ratio` is F_ax/T. If both loads alternate about zero in phase, the ratio is that of their
amplitudes, also where both are zero. If the mean torque is positive but smaller than the amplitude,
T passes through zero under axial load, where the ratio is infinite. Times are in s.

References
----------
.. [1] N. Nagler, A. Lohrengel, Forsch. Ingenieurwes. 85(4), 2021, Sec. 6, load cases 1 to 3.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, not_negative, positive
from analytic.freewheel.rules import require


class LoadPath(ABC):
    """Torque and axial load as functions of the time from 0 to `duration` [s]."""

    duration: float

    @abstractmethod
    def torque(self, t: ArrayLike) -> Array:
        """Torque T [force x length], positive in the locking direction."""

    @abstractmethod
    def axial_load(self, t: ArrayLike) -> Array:
        """Axial load F_ax [force]."""

    def ratio(self, t: ArrayLike) -> Array:
        """Ratio F_ax/T [1/length]; 0 without axial load."""
        T, F_ax = self.torque(t), self.axial_load(t)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(F_ax == 0, 0.0, F_ax / T)


@dataclass(frozen=True, kw_only=True)
class AxialRamp(LoadPath):
    """Load path 1: torque rises to T within `rise`, then F_ax from 0 to F until `duration`.

    >>> path = AxialRamp(T=20.0, F=3000.0, rise=1.0, duration=3.0)
    >>> path.torque([0.5, 2.0]).tolist(), path.axial_load([0.5, 2.0]).tolist()
    ([10.0, 20.0], [0.0, 1500.0])
    """

    T: float
    F: float
    rise: float
    duration: float

    def __post_init__(self) -> None:
        positive(self.T, "torque", "N m")
        not_negative(self.F, "axial load", "N")
        _check_times(self.rise, self.duration)

    def torque(self, t: ArrayLike) -> Array:
        return np.asarray(self.T * np.clip(np.asarray(t) / self.rise, 0, 1))

    def axial_load(self, t: ArrayLike) -> Array:
        return np.asarray(self.F * _growth(t, self.rise, self.duration))


@dataclass(frozen=True, kw_only=True)
class AlternatingAxial(AxialRamp):
    """Load path 2: torque rises to T within `rise`, then F_ax alternates with rising amplitude.

    F_ax has the `frequency` [1/s], and its amplitude rises from 0 to F until `duration`.
    """

    frequency: float

    def __post_init__(self) -> None:
        super().__post_init__()
        positive(self.frequency, "frequency", "Hz")

    def axial_load(self, t: ArrayLike) -> Array:
        turn = 2 * np.pi * self.frequency * (np.asarray(t) - self.rise)
        return np.asarray(self.F * _growth(t, self.rise, self.duration) * np.sin(turn))


@dataclass(frozen=True, kw_only=True)
class BothAlternating(LoadPath):
    """Load path 3: torque T_m + T sin wt, and F_ax in phase, whose amplitude rises from 0 to F.

    >>> path = BothAlternating(T=20.0, F=3000.0, frequency=1.0, duration=10.0)
    >>> path.ratio([0.0, 5.0]).tolist()  # ratio of the amplitudes if F_ax and T vanish
    [0.0, 75.0]
    """

    T: float
    F: float
    frequency: float
    duration: float
    T_m: float = 0.0

    def __post_init__(self) -> None:
        positive(self.T, "torque's amplitude", "N m")
        not_negative(self.F, "axial load", "N")
        not_negative(self.T_m, "mean torque", "N m")
        positive(self.frequency, "frequency", "Hz")
        positive(self.duration, "duration", "s")

    def torque(self, t: ArrayLike) -> Array:
        return np.asarray(self.T_m + self.T * np.sin(self._turn(t)))

    def axial_load(self, t: ArrayLike) -> Array:
        return np.asarray(self.F * _growth(t, 0.0, self.duration) * np.sin(self._turn(t)))

    def ratio(self, t: ArrayLike) -> Array:
        if self.T_m > 0:
            return super().ratio(t)
        return np.asarray(self.F / self.T * _growth(t, 0.0, self.duration))

    def _turn(self, t: ArrayLike) -> Array:
        return np.asarray(2 * np.pi * np.mod(self.frequency * np.asarray(t), 1.0))  # exactly 0


def _growth(t: ArrayLike, start: float, end: float) -> Array:
    return np.asarray(np.clip((np.asarray(t) - start) / (end - start), 0, 1))


def _check_times(rise: float, duration: float) -> None:
    positive(rise, "rise time", "s")
    require(rise < duration, "the rise must end before the path", "s", rise=rise, duration=duration)
