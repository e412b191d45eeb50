"""Partial slip of two equal rollers (Cattaneo) and the cycle of an alternating force (Mindlin)."""

from collections.abc import Iterator
from typing import Any, ClassVar

from verify.case import (
    AlongLine,
    Comparison,
    Drawn,
    Level,
    Quantity,
    Scan,
    State,
    balance,
    fact,
)
from verify.cases.contact.slip import figures as drawn
from verify.cases.contact.slip.claims import (
    AGREE,
    HALF_PLANES,
    L2,
    HalfPlanes,
    l2_margin,
    neglected,
    step_order_fem,
    two_ways,
)
from verify.cases.contact.slip.formulas import SlipFormulas
from verify.cases.contact.slip.inputs import SHARES, STAGES, key
from verify.cases.contact.slip.reference import solve
from verify.core.figures import Picture
from verify.form.adapter import adapted
from verify.judging.profile_checks import Within
from verify.judging.tolerance_checks import Agreement, suites

FE_SHARES = (0.5, 0.9)  # amplitudes whose slip strips the meshes resolve
SECANT = "loads are met within 1e-12 of P, and states within 1e-11"
SLIDING = "every node at its limit of friction, to round-off"
STICK: dict[str, Any] = {"demand": 2e-3, "demand_reason": "the stick zone is known to 0.2 %"}
SHARED = "friction law of Coulomb"


class SlippingRollers(SlipFormulas):
    """Before a sprag slides, its contact slips at the edges and sticks in the middle.

    Cattaneo and Mindlin give the slip zones, the displacement and the energy lost in a cycle.
    Finite elements of two elastic rollers, pressed together and pushed sideways, verify them.
    """

    id = "contact-slip"
    title = "Partial slip and the cycle of an alternating force"
    source = "huang2018"
    place = "Eqs. 11-14, what lies between stick and slip"
    levels: ClassVar = (24, 40, 56)
    scans: ClassVar = (Scan(vary=("share=0.3,0.6,0.9", "mu=0.1,0.2"), star=True),)
    readings: ClassVar = (
        "R is the rollers' radius, and both are elastic: relative radius R/2, 1/E* = 2 (1 − ν²)/E",
        "long rollers: plane strain, and P, Q per unit length",
        "one coefficient of friction, for sticking and for sliding",
        "Q is the force that passes through the contact, not the sum on both rollers",
    )
    assumptions: ClassVar = (
        "equal materials: tangential forces do not change the pressure (Dundurs' β = 0)",
        "small strain; P held while Q changes; no wear, no rate",
        "two half discs, each held along its cut: half planes up to terms of (a/R)²",
        "P and Q are met to 1e-12 by the cut's displacements (secant steps)",
        "P, μ and ν are not the paper's: μ from a usual lubricated steel contact, P so that "
        "a/R = 0.01",
        "stick half-width: from the moments of q, (c/a)² = 4 M₂/(M₀ a²) − 1",
        "displacements count beyond the chord from 0 to Q = 0.8 μP: the elastic part, linear in "
        "Q, cancels without being known",
    )

    def reference(self, level: int) -> Level:
        """Two half discs pressed together, pushed, and swung."""
        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Stick zone, tractions, displacements, energy; balances."""
        by = SlippingRollers
        at = {k: State(self.at_share(k), key(k), f"Q/(μP) = {k:g}", displayed=False)
              for k in SHARES}  # fmt: skip
        for k in SHARES:
            yield _half_planes(by.c, f"{by.c.what}, {at[k].words}", state=at[k], **STICK)
        yield _half_planes(by.c, f"{by.c.what} at Q_max", **STICK)
        for k in SHARES:
            yield self._traction(by.q_1, f"k = {k:g}", k)
        for k in SHARES[:-1]:
            yield _half_planes(by.beyond_chord, f"{by.beyond_chord.what}, {at[k].words}",
                               state=at[k], symbol="δ − δ_c")  # fmt: skip
        for stage in STAGES:
            yield self._traction(by.q_0, f"Q/Q_max = {stage:g}", stage)
        yield _half_planes(by.delta_0, "cycle: displacement left at Q = 0")
        yield _half_planes(by.W, "cycle: energy lost, work of friction", fem="work")
        yield _half_planes(by.W, "cycle: energy lost, area of the loop", fem="area",
                           symbol="∮Q dδ")  # fmt: skip
        energies = Agreement(
            name="cycle: both energies agree within 0.1 %", symbol="W", unit="J/m", pair=two_ways,
            accepted=AGREE, source=suites("two sums over one solution"), by="friction's work",
            everywhere=True,
        )  # fmt: skip
        yield Comparison(check=energies)
        yield fact("cycle: order of the loop's area in its steps above 1.8", "p", step_order_fem)
        yield from self._balances()

    def _traction(self, q: Quantity, name: str, at: float) -> Comparison:
        """The traction at `at`; its error is relative to its norm at this Q, or at Q_max."""
        first = q.name == "q_1"
        formula, scale = (self.first_traction, at) if first else (self.cycle_traction, 1.0)
        what = f"Q/(μP) = {at:g}" if first else name
        check = Within(
            name=f"{'' if first else 'cycle: '}traction within 3 % in L2, {what}", symbol="q",
            unit="1", paper_only=True, margin=l2_margin(name, formula, at, scale), accepted=L2,
        )  # fmt: skip
        return Comparison(check=check, quantity=q, shares=SHARED)

    def _balances(self) -> Iterator[Comparison]:
        peak, load = {"peak pressure": self.p_0}, {"load": self.P}
        couple = {"couple": self.P * self.R}
        for residual, name, symbol, unit, of, bound, because in (
            ("steps", "cycle: one step and many steps coincide", "Δq", "MPa", peak, 1e-9, SECANT),
            ("closure", "cycle: first and last state coincide", "Δq", "MPa", peak, 1e-9, SECANT),
            ("sliding", "sliding: Q = μP", "Q − μP", "N/mm", {"limit": self.limit}, 1e-10, SLIDING),
            ("cuts", "balance of both cuts", "ΣF", "N/mm", load, 1e-9, SECANT),
            ("passed_on", "balance of cut and contact", "ΣF", "N/mm", load, 1e-9, SECANT),
            ("moment", "balance of moments, cut and contact", "ΣM", "N", couple, 1e-9, SECANT),
        ):
            yield balance(residual, name, symbol, unit, of=of, bound=bound, because=because)

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Tractions, growth of the slip strips, the loop of a cycle, energies."""
        yield from drawn.figures()

    def pictures(self) -> Iterator[Picture]:
        """Shear stress about the contact at Q_max."""
        w = 2.0 * self.a
        yield Picture(
            field="pushed", data="shear_at_nodes", symbol="τ_max/p_0", unit="1", factor=self.p_0,
            caption="Largest shear stress about the contact at Q_max, over p_0, from means of "
            "cells at nodes", displacement="", window=(-w, -w, w, w),
        )  # fmt: skip

    sketch = drawn.sketch

    def refusal(self) -> str:
        """Amplitudes whose slip or stick the meshes do not resolve."""
        low, high = FE_SHARES
        if low <= self.share <= high:
            return ""
        return (
            f"Q/(μP) = {self.share:g}: the meshes resolve slip and stick of amplitudes from "
            f"{low:g} to {high:g}; check it without --fem"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the contact is wide, if surfaces yield, and if friction is high."""
        if neglected(self) > HALF_PLANES * 10:
            yield (
                f"a/R = {self.a / self.R:.3g}: the rollers are no half planes, the formulas err "
                f"by up to {neglected(self):.1%}"
            )
        if self.hardness is not None and self.p_0 > self.hardness:
            yield (
                f"p_0 = {self.shown('p_0')} exceeds p_lim = {self.shown('hardness')}: the surfaces "
                "yield, contact and slip strips grow"
            )
        if self.hardness is None and self.p_0 > 0.02 * self.E:
            yield (
                f"p_0 = {self.shown('p_0')} is {self.p_0 / self.E:.1%} of E: most steels yield "
                "before; give p_lim"
            )
        if self.mu > 0.5:
            yield (
                f"μ = {self.mu:g}: friction this high brings the largest shear stress to the "
                "surface, and yielding there before sliding"
            )


def _half_planes(
    q: Quantity, name: str, *, state: State | None = None, fem: str = "", symbol: str = "",
    **more: Any,
) -> Comparison:  # fmt: skip
    """A formula of half planes against discs."""
    number = f"{q.name}_{state.key}" if state else q.name
    check = HalfPlanes(name=name, symbol=symbol or q.symbol, unit=q.unit, analytic=number,
                       fem=fem or number, formal=1, **more)  # fmt: skip
    return Comparison(check=check, quantity=q, state=state, shares=SHARED)


SLIP = adapted(SlippingRollers)
