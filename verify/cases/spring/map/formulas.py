"""Eqs. 1-9 of the accordion spring, and the exact elastica with a guided head."""

import math
from collections.abc import Iterator, Mapping
from functools import lru_cache

import numpy as np

from analytic.spring import energy, frame
from analytic.spring.elastica import Elastica
from verify.case import Case, Quantity, shared
from verify.cases.spring.limits import Share
from verify.cases.spring.map.inputs import SHARES, Cell, MapInputs
from verify.papers.ledger import published

MOST = 24  # segments of an elastica that a check has time for
TEST_FORCE = 11.0  # N, the largest of Sec. 4
PARTS = tuple(map(Share, SHARES))
NOT_FOUND = f"no equilibrium of the guided elastica was found up to {SHARES[-1]:.0%} compression"
EXACT = "exact elastica"


@lru_cache(maxsize=4)
def pressed(q: MapInputs) -> Mapping[str, float]:
    """Exact axial and lateral forces [N] on a guided head, by name, for several displacements.

    The result is empty if Newton's method finds no state on the path. `refusal` and `warnings` then
    state this.
    """
    try:
        return _pressed(q)
    except ArithmeticError:
        return {}


def _pressed(q: MapInputs) -> Mapping[str, float]:
    EA = q.E * q.h * q.b
    line = Elastica(
        frame.pieces(**q.path), EI=EA * q.b**2 / 12, EA=EA, GA=5 / 6 * EA / (2 * (1 + q.nu))
    )
    steps = np.unique([*np.linspace(0.075, SHARES[0], 4), 0.45, *SHARES])
    states = dict(zip(steps, line.path("guided", steps * q.length), strict=True))
    values = {f"F_{share}": states[share].F for share in PARTS}
    near = [line.unloaded()]
    for part in np.linspace(0.25, 1, 4):
        near = [*near[-1:], line.displaced("guided", part * q.x_r, near, aside=part * q.y_r)]
    values |= {"F_x": near[-1].F, "F_y": float(near[-1].head[3])}
    values["F_x_straight"] = line.path("guided", np.linspace(0.25, 1, 4) * q.x_r)[-1].F
    return values


def of_paper(q: Case) -> bool:
    """Whether this is the spring of the paper's tests."""
    return q.is_default


class MapFormulas(MapInputs, Case):
    """Forces by Eq. 9 and by the elastica; nan if the elastica has no solution."""

    @Quantity("J", "mm^3", "integral of the squared lever arm of the force", equation="7",
              role="step", tex=r"\int (M/F)^2 ds")  # fmt: skip
    def J(self) -> float:
        return float(energy.flexibility(**self.cell.eqs))

    @Quantity("k_1", "N/mm", "stiffness", equation="9", tex=r"\frac{E h b^3}{12 J}")
    def k1(self) -> float:
        return float(energy.stiffness(**self.cell.eqs, h=self.h, E=self.E))

    @Quantity("L_0", "mm", "length between the leaves of head and tail", role="geometry")
    def L0(self) -> float:
        return self.length

    @Quantity("F({0:g} L_0)", "N",
              "force of the guided head at a displacement of {0:.0%} of the length",
              source=EXACT).over(PARTS)  # fmt: skip
    def F(self, share: Share) -> float:
        return self._pressed.get(f"F_{share}", math.nan)

    @Quantity("k_1 U(0.3 L_0)", "N", "force by Eq. 9 at a displacement of 30% of the length",
              source="Eq. 9",
              tex=r"0.3 k_1 L_0")  # fmt: skip
    def linear_0_3(self) -> float:
        return self.k1 * SHARES[0] * self.L0

    @Quantity("k_1 U(0.6 L_0)", "N", "force by Eq. 9 at a displacement of 60% of the length",
              source="Eq. 9",
              tex=r"0.6 k_1 L_0")  # fmt: skip
    def linear_0_6(self) -> float:
        return self.k1 * SHARES[1] * self.L0

    F_x_straight = Quantity(
        "F_x(x_r)", "N", "axial force at the end of a straight path of the roller", role="step",
        source=EXACT,
    ).reads(lambda q: q._pressed.get("F_x_straight", math.nan))  # fmt: skip
    F_x = Quantity("F_x", "N", "axial force at the end of the roller's slanted path",
                   source=EXACT).reads(lambda q: q._pressed.get("F_x", math.nan))  # fmt: skip
    F_y = Quantity("F_y", "N", "transverse force at the end of the roller's slanted path",
                   source=EXACT).reads(lambda q: q._pressed.get("F_y", math.nan))  # fmt: skip

    @Quantity("e_r", "%", "relative amount by which the force by Eq. 9 is below the force by "
              "Eq. 10, at the largest test force",
              source="Eqs. 9 and 10", when=of_paper)  # fmt: skip
    def error_of_tests(self) -> float:
        U = (TEST_FORCE - published("wang2023:eq10-ab-intercept").value) / (
            published("wang2023:k2-fea").value * 1e3
        )
        return 1 - self.k1 * U / TEST_FORCE

    @property
    def cell(self) -> Cell:
        """The spring of the inputs, described like a cell of the maps."""
        return Cell(self.n, self.b, self.r, self.L1, self.alpha)

    @shared
    def _pressed(self) -> Mapping[str, float]:
        return pressed(self) if self.n <= MOST else {}

    def refusal(self) -> str:
        """Reason why nothing is compared: too many segments, or no equilibrium was found."""
        if self.n > MOST:
            return f"n = {self.n} segments are more than {MOST}: check it without --fem"
        return "" if self._pressed else f"{NOT_FOUND}: check it without --fem"

    def warnings(self) -> Iterator[str]:
        """Warnings if Eq. 9 is inaccurate."""
        if self.n <= MOST and not self._pressed:
            yield NOT_FOUND
        for share, linear in zip(PARTS, (self.linear_0_3, self.linear_0_6), strict=True):
            if math.isfinite(F := self.F(share)) and abs(m := linear / F - 1) > 0.02:
                yield (
                    f"at a displacement of {share:.0%} of the length, the error of Eq. 9 is "
                    f"{m:+.1%} against the force of the guided spring (without contact of leaves)"
                )
