"""Case of partial slip of two equal rollers (Cattaneo), and cycles of force (Mindlin)."""

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
SECANT = "loads are reached within 1e-12 of P, and contact states within 1e-11"
SLIDING = "all nodes reach the limit of friction, except for round-off"
STICK: dict[str, Any] = {
    "demand": 2e-3, "demand_reason": "the meshes resolve the width of the stick zone to 0.2 %",
}  # fmt: skip
SHARED = "Coulomb's law of friction"


class SlippingRollers(SlipFormulas):
    """Before a sprag slides, its contact slips at the edges and sticks in the middle.

    The formulas of Cattaneo and Mindlin give the slip zones, the displacement and the energy lost
    in a cycle. The reference is a finite-element model of two elastic rollers under a normal force
    and an alternating tangential force.
    """

    id = "contact-slip"
    title = "Partial slip under an alternating tangential force"
    source = "huang2018"
    place = "Eqs. 11-14, partial slip between sticking and sliding"
    levels: ClassVar = (24, 40, 56)
    scans: ClassVar = (Scan(vary=("share=0.3,0.6,0.9", "mu=0.1,0.2"), star=True),)
    readings: ClassVar = (
        "R is the radius of each elastic roller: relative radius R/2, 1/E* = 2 (1 − ν²)/E",
        "the rollers are long: plane strain; P and Q are forces per unit length",
        "sticking and sliding have the same coefficient of friction",
        "Q is the tangential force in the contact, not the sum of the forces on both rollers",
    )
    assumptions: ClassVar = (
        "equal materials: tangential forces do not change the pressure (Dundurs' β = 0)",
        "small strain; P is constant while Q changes; no wear, no effect of speed",
        "two half discs, each supported on its cut, replace half-planes; the error is about (a/R)²",
        "the displacements of the upper cut are adjusted by the secant method until P and Q are "
        "reached within 1e-12 of P",
        "P, μ and ν are assumed, because the paper does not give them: μ is usual for lubricated "
        "steel, and P results in a/R = 0.01",
        "the stick half-width is computed from the moments M₀, M₂ of the traction q: (c/a)² = "
        "4 M₂/(M₀ a²) − 1",
        "the rows state displacements minus the chord of the force-displacement curve between "
        "Q = 0 and Q = 0.8 μP, so that the elastic part, linear in Q, cancels",
    )

    def reference(self, level: int) -> Level:
        """Results of two half discs under P and Q: first loading, and a cycle of Q."""
        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: stick zone, tractions, displacements, energy, balances."""
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
        yield _half_planes(by.delta_0, "cycle: residual displacement at Q = 0")
        yield _half_planes(by.W, "cycle: energy lost, by the work of friction", fem="work")
        yield _half_planes(by.W, "cycle: energy lost, by the area of the loop", fem="area",
                           symbol="∮Q dδ")  # fmt: skip
        energies = Agreement(
            name="cycle: area of the loop and work of friction agree within 0.1 %",
            symbol="W", unit="J/m", pair=two_ways, accepted=AGREE,
            source=suites("both energies are sums over the same solution"),
            by="work of friction", everywhere=True,
        )  # fmt: skip
        yield Comparison(check=energies)
        yield fact("cycle: area of the loop converges with an order above 1.8 in the number of "
                   "steps", "p", step_order_fem)  # fmt: skip
        yield from self._balances()

    def _traction(self, q: Quantity, name: str, at: float) -> Comparison:
        """Row: L2 error of the traction at `at`, which is Q/(μP), or Q/Q_max in the cycle.

        The error is relative to the norm of the traction at this Q; in the cycle, at Q_max.
        """
        first = q.name == "q_1"
        formula, scale = (self.first_traction, at) if first else (self.cycle_traction, 1.0)
        what = f"Q/(μP) = {at:g}" if first else name
        check = Within(
            name=f"{'' if first else 'cycle: '}L2 error of the traction below 3 %, {what}",
            symbol="q", unit="1", paper_only=True, margin=l2_margin(name, formula, at, scale),
            accepted=L2,
        )  # fmt: skip
        return Comparison(check=check, quantity=q, shares=SHARED)

    def _balances(self) -> Iterator[Comparison]:
        peak, load = {"peak pressure": self.p_0}, {"P": self.P}
        couple = {"P R": self.P * self.R}
        for residual, name, symbol, unit, of, bound, because in (
            ("steps", "cycle: traction at −Q_max equal after one step and after many steps", "Δq",
             "MPa", peak, 1e-9, SECANT),
            ("closure", "cycle: traction at Q_max equal at the start and at the end", "Δq", "MPa",
             peak, 1e-9, SECANT),
            ("sliding", "tangential force in sliding equals μP", "Q − μP", "N/mm",
             {"μP": self.limit}, 1e-10, SLIDING),
            ("cuts", "balance of forces on the two half discs", "ΣF", "N/mm", load, 1e-9, SECANT),
            ("passed_on", "balance of forces on the upper half disc", "ΣF", "N/mm", load, 1e-9,
             SECANT),
            ("moment", "balance of moments on the upper half disc", "ΣM", "N", couple, 1e-9,
             SECANT),
        ):  # fmt: skip
            yield balance(residual, name, symbol, unit, of=of, bound=bound, because=because)

    def figures(self) -> Iterator[AlongLine | Drawn]:
        """Figures: tractions, growth of the slip zones, loop of a cycle, energies."""
        yield from drawn.figures()

    def pictures(self) -> Iterator[Picture]:
        """Picture of the shear stress near the contact at Q_max."""
        w = 2.0 * self.a
        yield Picture(
            field="pushed", data="shear_at_nodes", symbol="τ_max/p_0", unit="1", factor=self.p_0,
            caption="Maximum shear stress over p_0 near the contact at Q_max; stresses of cells "
            "are averaged at nodes", displacement="", window=(-w, -w, w, w),
        )  # fmt: skip

    sketch = drawn.sketch

    def refusal(self) -> str:
        """Reason for not solving amplitudes whose slip or stick zone the meshes do not resolve."""
        low, high = FE_SHARES
        if low <= self.share <= high:
            return ""
        return (
            f"Q/(μP) = {self.share:g}: the meshes resolve slip and stick zones for amplitudes from "
            f"{low:g} to {high:g}; run `check` without --fem"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the contact is wide, the surfaces yield, or friction is high."""
        if neglected(self) > HALF_PLANES * 10:
            yield (
                f"a/R = {self.a / self.R:.3g}: the formulas replace the rollers by half-planes and "
                f"err by up to {neglected(self):.1%}"
            )
        if self.hardness is not None and self.p_0 > self.hardness:
            yield (
                f"p_0 = {self.shown('p_0')} exceeds p_lim = {self.shown('hardness')}: the surfaces "
                "yield, so that contact and slip zones grow"
            )
        if self.hardness is None and self.p_0 > 0.02 * self.E:
            yield (
                f"p_0 = {self.shown('p_0')} is {self.p_0 / self.E:.1%} of E: most steels yield "
                "below 2 %; enter p_lim"
            )
        if self.mu > 0.5:
            yield (
                f"μ = {self.mu:g}: with this friction, the largest shear stress is at the "
                "surface, which yields there before it slides"
            )


def _half_planes(
    q: Quantity, name: str, *, state: State | None = None, fem: str = "", symbol: str = "",
    **more: Any,
) -> Comparison:  # fmt: skip
    """Row: the formula `q` of half-planes against finite elements of discs."""
    number = f"{q.name}_{state.key}" if state else q.name
    check = HalfPlanes(name=name, symbol=symbol or q.symbol, unit=q.unit, analytic=number,
                       fem=fem or number, formal=1, **more)  # fmt: skip
    return Comparison(check=check, quantity=q, state=state, shares=SHARED)


SLIP = adapted(SlippingRollers)
