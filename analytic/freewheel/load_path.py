r"""Load paths of the test rig (Nagler, Lohrengel, Sec. 6): T and F_ax over time.

1. `AxialRamp`: torque first, then a growing axial load;
2. `AlternatingAxial`: torque first, then an alternating axial load of growing amplitude;
3. `BothAlternating`: both alternate in phase, the axial load with a growing amplitude.

`ratio` is F_ax/T. In phase about zero it stays finite where both vanish, the amplitudes' ratio;
with a mean torque smaller than its amplitude T passes through zero under axial load: infinite.
Times in s.

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
    """Torque and axial load over the time from 0 to `duration` [s]."""

    duration: float

    @abstractmethod
    def torque(self, t: ArrayLike) -> Array:
        """T [force x length], positive in the locking direction."""

    @abstractmethod
    def axial_load(self, t: ArrayLike) -> Array:
        """F_ax [force]."""

    def ratio(self, t: ArrayLike) -> Array:
        """F_ax/T [1/length]; 0 without axial load."""
        T, F_ax = self.torque(t), self.axial_load(t)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(F_ax == 0, 0.0, F_ax / T)


@dataclass(frozen=True, kw_only=True)
class AxialRamp(LoadPath):
    """Torque up to T in `rise`, then F_ax from 0 to F until `duration` (load case 1).

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
    """Torque up to T in `rise`, then F_ax alternates with `frequency` [1/s], its amplitude growing
    from 0 to F until `duration` (load case 2).
    """  # noqa: D205

    frequency: float

    def __post_init__(self) -> None:
        super().__post_init__()
        positive(self.frequency, "frequency", "Hz")

    def axial_load(self, t: ArrayLike) -> Array:
        turn = 2 * np.pi * self.frequency * (np.asarray(t) - self.rise)
        return np.asarray(self.F * _growth(t, self.rise, self.duration) * np.sin(turn))


@dataclass(frozen=True, kw_only=True)
class BothAlternating(LoadPath):
    """T_m + T sin and F_ax in phase, its amplitude growing from 0 to F (load case 3).

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
