"""Inputs of a roller freewheel on the load paths of the test rig (Nagler, Lohrengel, Sec. 6)."""

from pydantic import model_validator

from verify.cases.freewheel.pulled import Pulled
from verify.core.inputs import quantity

MOST = 1000  # cycles of a path


class PathInputs(Pulled):
    """The clutch of `Pulled`, whose axial load grows up to F_ax on three paths."""

    F_ax: float = quantity("3 kN", "N", "F_ax", "axial load on the whole clutch at the path's end",
                           gt=0, le=1e9, claims="nagler2021:rig-axial-load")  # fmt: skip
    T_m: float = quantity("0 N m", "N m", "T_m",
                          "mean torque of load case 3, about which T is the amplitude",
                          ge=0, le=1e9)  # fmt: skip
    f: float = quantity("30 Hz", "Hz", "f", "frequency of load cases 2 and 3", gt=0, le=1e5,
                        claims="nagler2021:rig-frequency")  # fmt: skip
    rise: float = quantity("0.1 s", "s", "t_T", "time in which the torque comes up, load cases 1 "
                           "and 2", gt=0, le=1e6)  # fmt: skip
    duration: float = quantity("0.5 s", "s", "t_end", "end of the path, where the axial load "
                               "reaches F_ax", gt=0, le=1e6)  # fmt: skip
    rho: float = quantity("7850 kg/m^3", "kg/m^3", "ρ", "density of the ring", gt=0, le=1e5)

    @model_validator(mode="after")
    def _times(self) -> "PathInputs":
        if not self.rise < self.duration:
            raise ValueError(
                f"the torque comes up before the path ends: rise < duration, got rise = "
                f"{self.rise:g} s, duration = {self.duration:g} s"
            )
        if self.f * self.duration > MOST:
            raise ValueError(
                f"a path has at most {MOST} cycles, got f duration = {self.f * self.duration:g}"
            )
        return self

    @property
    def T_peak(self) -> float:
        """Largest torque of load case 3 [N m]."""
        return self.T_m + self.T

    @property
    def T_critical(self) -> float:
        """Torque [N m] of load case 3 at which the least axial amplitude slips, at most T_peak.

        About zero it is the peak, F_ax/T is the same all the time and alpha largest; about a mean
        that keeps it positive the trough, where F_ax is as large and N least. Between lies a zero
        under axial load: 0.
        """
        if self.T_m == 0:
            return self.T
        return max(self.T_m - self.T, 0.0)
