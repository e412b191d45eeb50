"""Formulas of lateral buckling: Haringx's column of the units of a spring, exact elastica."""

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import lru_cache
from typing import ClassVar, Self

import numpy as np

from analytic.spring import column, frame, stability
from analytic.spring.elastica import Elastica
from verify.case import Case, Quantity, shared
from verify.cases.spring.buckling.inputs import DRIFT, TAILS, BucklingInputs
from verify.cases.spring.claims import loaded
from verify.cases.spring.inputs import strip_of
from verify.cases.spring.limits import Share

MOST = 24  # segments of an elastica that a check has time for
SEARCHED = np.linspace(0.05, 0.75, 15)  # compressions over the free length, for critical points
HELD_HEADS: tuple[column.Head, ...] = ("hinged", "guided")
UNIT = "unit-load integrals of a middle unit"
HARINGX = "Haringx's column"
EXACT = "exact elastica"


def elastica(q: BucklingInputs, tail: frame.Tail) -> Elastica:
    """Exact elastica of the leaves and arcs of the spring."""
    EA = q.E * q.h * q.b
    GA = 5 / 6 * EA / (2 * (1 + q.nu))
    return Elastica(frame.pieces(**q.path, tail=tail), EI=EA * q.b**2 / 12, EA=EA, GA=GA)


@lru_cache(maxsize=8)
def critical_point(q: BucklingInputs, tail: frame.Tail) -> Mapping[str, float]:
    """Critical point with a free head, by the elastica, and drift of the head before it, by name.

    The result is empty if the determinant does not change its sign on the path. The first steps
    are small, because slender springs buckle at a small displacement.
    Raises ArithmeticError if a state is not found; this does not mean that the spring buckles.
    """
    line = elastica(q, tail)
    load = line.linear_load()
    start = load * _flexibility(q, tail) / q.length
    steps = np.concatenate([min(start, 0.05) * np.linspace(0.5, 1.5, 3), SEARCHED])
    found = stability.critical(line, "free", np.unique(steps) * q.length)
    if found is None:
        return {}
    k_y = stability.lateral_stiffness(line.unloaded())
    values = {"U_cr": found.U, "F_cr": found.F, "F_lin": load, "k_y": k_y}
    state = line.unloaded()
    for share in sorted({*map(Share, np.linspace(0.2, 0.8, 4)), *DRIFT}):
        state = line.pushed((share * q.P, 0.0), state)
        if share in DRIFT:
            values[f"drift_{share}"] = state.drift
    return values


def _flexibility(q: BucklingInputs, tail: frame.Tail) -> float:
    return 1 / frame.stiffness(**q.path, **strip_of(q), head="guided", tail=tail, theory="shear")


class BucklingFormulas(BucklingInputs, Case):
    """Quantities of the lateral buckling of a spring; nan if it does not buckle."""

    tail: ClassVar[frame.Tail] = "arc"  # clamped end of the elastica

    U_cr = Quantity("U_cr", "mm", "displacement at which the spring with a free head buckles",
                    source=EXACT).reads(lambda q: q._critical.get("U_cr", math.nan))  # fmt: skip
    F_cr = Quantity("F_cr", "N", "force at which the spring with a free head buckles", source=EXACT,
                    safe="too low").reads(lambda q: q._critical.get("F_cr", math.nan))  # fmt: skip
    F_lin = Quantity("F_lin", "N", "linear buckling load of the undeformed spring",
                     source=EXACT).reads(lambda q: q._critical.get("F_lin", math.nan))  # fmt: skip
    k_y = Quantity("k_y", "N/mm", "lateral stiffness of the guided head, unloaded",
                   source=EXACT).reads(lambda q: q._critical.get("k_y", math.nan))  # fmt: skip

    @Quantity(
        "u_y({0:g} P)",
        "mm",
        "lateral displacement of a free head under {0:g} times the Euler load P",
        source=EXACT,
    ).over(DRIFT)
    def drift(self, share: Share) -> float:
        return self._critical.get(f"drift_{share}", math.nan)

    @Quantity("L_0", "mm", "length between the leaves of head and tail", role="geometry")
    def L0(self) -> float:
        return self.length

    pitch = Quantity("p", "mm", "pitch of a middle unit", role="step",
                     source=UNIT).reads(lambda q: q._unit.pitch)  # fmt: skip
    a_B = Quantity("a_B", "1/N/m", "rotational flexibility of a unit", role="step",
                   source=UNIT).reads(lambda q: q._unit.turn)  # fmt: skip
    a_C = Quantity("a_C", "mm/N", "axial flexibility of a unit", role="step",
                   source=UNIT).reads(lambda q: q._unit.axial)  # fmt: skip
    a_S = Quantity("a_S", "mm/N", "transverse flexibility of a unit", role="step",
                   source=UNIT).reads(lambda q: q._unit.lateral)  # fmt: skip

    @Quantity("1/a_B", "N m", "rotational stiffness of a middle unit", source=UNIT,
              tex=r"\frac{1}{a_B}")  # fmt: skip
    def unit_turn(self) -> float:
        return 1 / self.a_B

    @Quantity("1/a_C", "N/mm", "axial stiffness of a middle unit", source=UNIT,
              tex=r"\frac{1}{a_C}")  # fmt: skip
    def unit_axial(self) -> float:
        return 1 / self.a_C

    @Quantity("1/a_S", "N/mm", "transverse stiffness of a middle unit", source=UNIT,
              tex=r"\frac{1}{a_S}")  # fmt: skip
    def unit_lateral(self) -> float:
        return 1 / self.a_S

    @Quantity("B", "N mm^2", "bending stiffness of the column", role="step", source=HARINGX)
    def B(self) -> float:
        return self.pitch / self.a_B

    @Quantity("C", "N", "axial stiffness of the column", role="step", source=HARINGX)
    def C(self) -> float:
        return self.pitch / self.a_C

    @Quantity("S", "N", "shear stiffness of the column", role="step", source=HARINGX)
    def S(self) -> float:
        return self.pitch / (self.a_S - self.pitch**2 * self.a_B / 12)

    @Quantity("λ", "1", "slenderness of the column", role="step", source=HARINGX)
    def slenderness(self) -> float:
        return self.C * self.L0**2 / self.B

    xi = Quantity(
        "ξ", "1", "relative shortening at buckling, head free", role="step",
        source=HARINGX, tex=r"\frac{\pi^2}{2 \lambda (1 + \sqrt{1 - (1 - C/S) \pi^2/\lambda})}",
    ).reads(lambda q: q._shortening("free"))  # fmt: skip

    @Quantity("(kL)^2", "1", "square of the product of wave number and length, π²/4",
              role="step", source=HARINGX, tex=r"\lambda \xi (1 - (1 - C/S) \xi)")  # fmt: skip
    def waves(self) -> float:
        return math.pi**2 / 4 if math.isfinite(self.xi) else math.nan

    @Quantity("U_H", "mm", "displacement at buckling, free head, Haringx's column",
              source=HARINGX)  # fmt: skip
    def column_U(self) -> float:
        return self.xi * self.L0

    @Quantity("U_H({0})", "mm", "displacement at buckling, {0} head, Haringx's column",
              source=HARINGX).over(HELD_HEADS)  # fmt: skip
    def column_held(self, head: column.Head) -> float:
        return self._shortening(head) * self.L0

    @Quantity("F_H", "N", "force at buckling, free head, Haringx's column", source=HARINGX,
              safe="too low", tex=r"C \xi")  # fmt: skip
    def column_F(self) -> float:
        force = float(column.critical_force("free", **self.path, **strip_of(self)))
        return force if math.isfinite(self.xi) else math.nan

    @Quantity("U_w", "mm", "displacement at F with a guided head, linear theory",
              source="force method", when=loaded)  # fmt: skip
    def deflection(self) -> float:
        return (self.F or 0.0) / frame.stiffness(
            **self.path, **strip_of(self), head="guided", tail="arc", theory="shear"
        )

    @shared
    def _unit(self) -> column.Unit:
        return column.unit(L1=self.L1, radius=self.R, alpha=self.alpha, **strip_of(self))

    @shared
    def _critical(self) -> Mapping[str, float]:
        if self.n <= MOST:
            with suppress(ArithmeticError):  # no value: `refusal` and `warnings` have the reason
                return critical_point(self, self.tail)
        return {}

    def _shortening(self, head: column.Head) -> float:
        """Shortening at which the column buckles, relative to its length; nan if it does not."""
        xi = float(column.critical_shortening(head, **self.path, b=self.b, nu=self.nu))
        return xi if math.isfinite(xi) else math.nan

    def held(self, tail: frame.Tail) -> Self:
        """The spring with the tail clamped at `tail`."""
        return self.variant(tail=tail)

    def warnings(self) -> Iterator[str]:
        """Warnings if the force requires a guided head, or if critical points are missing."""
        free, hinged = self.column_U, self.column_held("hinged")
        if math.isnan(free):
            yield "the spring is too short to buckle laterally, for any support of the head"
            return
        tails = {tail: self.held(tail).U_cr for tail in TAILS}
        if self.F is not None:
            found = (free, *tails.values())
            least = min(U for U in found if math.isfinite(U))
            for head, limit in (("free", least), ("hinged", hinged)):
                if limit < self.deflection:
                    yield (
                        f"F = {self.F:g} N compresses the spring by {self.deflection * 1e3:.3g} "
                        f"mm; with a {head} head, it buckles at {limit * 1e3:.3g} mm: the head "
                        "needs a guide"
                    )
        if self.n > MOST:
            yield f"more than {MOST} segments: results by Haringx's column only"
        elif missing := [tail for tail, U in tails.items() if math.isnan(U)]:
            yield f"no critical point of the elastica was found for tail = {' and '.join(missing)}"
