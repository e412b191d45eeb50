"""Formulas of a finite line contact: strips, slices of the paper, independent slices."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.contact import hertz_line, lamina, palmgren, slices
from analytic.contact.crown import slice_centres
from analytic.contact.roller_parts import RollerParts
from analytic.contact.strip_error import neglected
from analytic.contact.strips import Strips, press_strips
from verify.case import Quantity, count, shared
from verify.cases.contact.roller.inputs import Roller
from verify.core.figures import Array

BEYOND, MIDDLE = "largest pressure outside the end zones d", "pressure at mid-length"
STRIPS = (
    r"\max_{|y_k| \le l/2 - d} p_k,\quad p_k = \frac{2 q_k}{\pi b_k},\quad "
    r"b_k = \sqrt{\frac{4 q_k R}{\pi E*}},\quad \sum_k C_{jk}(b_k) q_k = \delta - z_j"
)
SLICES = (
    r"z_j + \Bigl(\sum_k S_{jk} q_k\Bigr)^{9/10},\quad "
    r"S_{jk} = \frac{n_s \delta_P^{10/9}}{F} \frac{n_s w_{jk}}{\sum w}"
)
LAMINA = r"z_j + \left(\frac{n_s \delta_P^{10/9}}{F} q_j\right)^{9/10}"


def roller(q: Roller, n: int) -> dict[str, Any]:
    """Arguments common to all models with n strips or slices."""
    z = q.gap(slice_centres(length=q.L, slices=n))
    return {"gap": z, "length": q.L, "R": q.R, "E_star": q.E_star, "load": q.F}


def parts(q: Roller, p: Array, line: Array, approach: Any) -> RollerParts:
    """Values of a model along the roller: pressures `p`, line loads `line`, approach."""
    y = slice_centres(length=q.L, slices=len(p))
    return RollerParts(y=y, p=p, line=line, delta=float(approach), length=q.L, d=q.d)


def by_strips(q: Roller, n: int) -> tuple[Strips, RollerParts]:
    """Solution of n strips, and its values along the roller."""
    found = press_strips(**roller(q, n))
    return found, parts(q, found.pressure, found.q, found.approach)


class StripRoller(Roller):
    """A roller divided into strips, each with Hertz's elliptical pressure across the contact."""

    if TYPE_CHECKING:

        @property
        def n(self) -> int:
            """Number of strips over the length: an input, or derived from inputs."""

    @Quantity("p_0", "MPa", "Hertz's pressure of the uniform line load", source="Hertz",
              tex=r"\sqrt{\frac{F E*}{\pi l R}}")  # fmt: skip
    def p_0(self) -> float:
        return float(hertz_line.peak_pressure(P=self.F / self.L, R=self.R, E_star=self.E_star))

    p_max = Quantity("p_max", "MPa", f"{BEYOND}, strips", source="strips", safe="too high",
                     tex=STRIPS).reads(lambda q: q.strips.p_max)  # fmt: skip
    q_mid = Quantity("q", "N/mm", "line load at mid-length, strips",
                     role="step").reads(lambda q: q.strips.q_mid)  # fmt: skip

    @Quantity("b_m", "µm", "half-width at mid-length, strips", role="step", source="Hertz",
              tex=r"\sqrt{\frac{4 q R}{\pi E*}}")  # fmt: skip
    def b_mid(self) -> float:
        return float(np.sqrt(4 * self.q_mid * self.R / (np.pi * self.E_star)))

    p_mid = Quantity("p", "MPa", f"{MIDDLE}, strips", source="strips", safe="too high",
                     tex=r"\frac{2 q}{\pi b_m}").reads(lambda q: q.strips.p_mid)  # fmt: skip

    @Quantity("F_1", "N", "load in the more loaded end zone d, strips", role="step",
              tex=r"\int_{l/2 - d}^{l/2} q\,dy")  # fmt: skip
    def F_1(self) -> float:
        return max(self.strips.ends)

    @Quantity("p_d", "MPa", "Hertz's pressure for the line load averaged over the more loaded "
              "end zone d, strips", source="strips", safe="too high",
              tex=r"\sqrt{\frac{F_1 E*}{\pi d R}}")  # fmt: skip
    def p_d(self) -> float:
        return float(np.sqrt(self.F_1 / self.d * self.E_star / (np.pi * self.R)))

    @Quantity("F_d", "N", "load in both end zones d, strips", source="strips", safe="too high")
    def F_d(self) -> float:
        low, high = self.strips.ends
        return low + high

    @Quantity("F_d/F", "1", "share of the load in both end zones d, strips", role="step",
              tex=r"\frac{F_d}{F}")  # fmt: skip
    def end_share(self) -> float:
        return self.F_d / self.F

    p_largest = Quantity("p_n", "MPa",
                         "largest pressure of n strips, ends included; at loaded ends, this "
                         "pressure grows with n", role="step",
                         ).reads(lambda q: q.strips.p.max())  # fmt: skip
    delta = Quantity("δ", "µm", "approach, strips", source="strips").reads(lambda q: q.strips.delta)

    @Quantity("l_c", "mm", "length in contact, strips", role="step")
    def l_c(self) -> float:
        return float(self._strips[0].carries.mean() * self.L)

    @shared
    def _strips(self) -> tuple[Strips, RollerParts]:
        return by_strips(self, self.n)

    @property
    def strips(self) -> RollerParts:
        """Values along the roller by n strips."""
        return self._strips[1]

    @shared
    def twice(self) -> RollerParts:
        """Values along the roller by 2 n strips."""
        return by_strips(self, 2 * self.n)[1]

    @property
    def loaded_ends(self) -> int:
        """Number of loaded ends: 0, 1 or 2."""
        carries = self._strips[0].carries
        return int(carries[0]) + int(carries[-1])

    @shared
    def neglected(self) -> Mapping[str, float]:
        """Estimated relative deviation of the half-space from strips, by key; NaN if unknown."""
        solved, along = self._strips
        missing = neglected(solved)
        return {
            "p_max": float(missing.pressure[along.place]),
            "p_top": float(missing.pressure[int(np.argmax(along.p))]),
            "p_mid": float(missing.mid),
            "delta": float(missing.approach),
        }


class SlicedRoller(StripRoller):
    """A roller divided into slices: coupled slices of the paper, and independent slices."""

    slices: int = count(
        50, "n_s", "number of slices of Eqs. 2-5; the paper prints none", ge=10, le=401
    )

    @Quantity("δ_P", "µm", "approach by Palmgren's law for steel", role="step",
              source="Palmgren; units N and m", fitted=True,
              tex=r"3.84 \cdot 10^{-10.4} \frac{F^{0.9}}{l^{0.8}}")  # fmt: skip
    def delta_P(self) -> float:
        return float(palmgren.approach(load=self.F, length=self.L))

    p_max_slices = Quantity("p_max", "MPa", f"{BEYOND}, slices", source="Eqs. 2-5", form_of="p_max",
                            safe="too high").reads(lambda q: q.sliced("slices").p_max)  # fmt: skip
    p_mid_slices = Quantity("p", "MPa", f"{MIDDLE}, slices", source="Eqs. 2-5", form_of="p_mid",
                            safe="too high").reads(lambda q: q.sliced("slices").p_mid)  # fmt: skip
    delta_slices = Quantity("δ", "µm", "approach, slices", source="Eqs. 2-5", form_of="delta",
                            tex=SLICES).reads(lambda q: q.sliced("slices").delta)  # fmt: skip
    p_max_lamina = Quantity(
        "p_max", "MPa", f"{BEYOND}, independent slices", form_of="p_max", safe="too high",
    ).reads(lambda q: q.sliced("independent").p_max)  # fmt: skip
    p_mid_lamina = Quantity(
        "p", "MPa", f"{MIDDLE}, independent slices", form_of="p_mid", safe="too high",
    ).reads(lambda q: q.sliced("independent").p_mid)  # fmt: skip
    delta_lamina = Quantity("δ", "µm", "approach, independent slices", form_of="delta",
                            tex=LAMINA).reads(lambda q: q.sliced("independent").delta)  # fmt: skip

    @shared
    def _sliced(self) -> Mapping[str, RollerParts]:
        found = {}
        for name, model in (("slices", slices), ("independent", lamina)):
            one = model.press(**roller(self, self.slices))
            found[name] = parts(self, one.peak_pressure, one.line_load, one.approach)
        return found

    def sliced(self, model: str) -> RollerParts:
        """Values along the roller by `model`: coupled ("slices") or "independent" slices."""
        return self._sliced[model]
