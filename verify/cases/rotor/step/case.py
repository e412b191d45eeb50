"""Stepped rotating shaft: error of beam theory at a step of the diameter."""

from collections.abc import Iterator
from functools import partial
from typing import Any, ClassVar, Literal, Self

import numpy as np

from analytic.rotor.stepped import SLICES, SteppedShape, stepped_beam
from analytic.rotor.transfer_model import TransferMatrixRotor
from analytic.rotor.transfer_modes import transfer_critical_speeds, whirl_frequencies
from verify.case import (
    Comparison,
    Level,
    Quantity,
    State,
    approximation,
    drawn_by,
    identity,
    limit,
    shared,
    underived,
)
from verify.cases.rotor.step import figures as drawn
from verify.cases.rotor.step.inputs import MODES, NEAR_ONE, SteppedShaft
from verify.core.case import Context
from verify.core.figures import Picture, Table
from verify.form.adapter import adapted
from verify.judging.checks import Accepted, Exact

CORNER = 2 * 0.5445  # energy's order at a free corner of 270°: sin(1.5 π x) = -x sin(1.5 π)
CLAIMED = 0.003  # difference of the paper's beams from other beams
BEAM = "Timoshenko's beam with Hutchinson's shear coefficient"
WEAK = "weak form"
Sense = Literal["forward", "backward"]
SENSES: tuple[Sense, ...] = ("forward", "backward")
Points = tuple[list[float], list[float], list[float]]


class SteppedBeam(SteppedShaft):
    """Beam theory overestimates the stiffness of a shaft with a step in diameter.

    The reason is that the corners of the thick part carry little stress. An elastic body of
    revolution gives the errors of two beams: one with nominal diameters, and one with the stiffness
    of the 45° rule. Different models of the same beam agree within the numerical uncertainty. The
    paper prints no dimensions; the dimensions here were chosen for this project.
    """

    id = "rotor-step"
    title = "Rotating shaft with a step"
    source = "huang2022"
    place = "Sec. 1 (Timoshenko's beam elements); Sec. 2.1 (0.3 % difference from other elements)"
    levels: ClassVar = (1, 2, 3)
    cone: ClassVar[bool] = False  # whether the 45° rule reduces the stiffness of the beam below
    slices: ClassVar[int] = SLICES
    readings: ClassVar = (
        "a bearing of the elastic body is a spring that acts on the mean displacement of the seat; "
        "a bearing of a beam is a spring at the middle of the seat",
        "45° rule: in the thick part, the diameter used for the stiffness is d_1 plus twice the "
        "distance from the step, but at most d_2; masses are those of the nominal diameters",
    )
    assumptions: ClassVar = (
        "linear elasticity without damping; the re-entrant corners of 270° are sharp, so that the "
        "energy of finite elements converges at least with order 2 · 0.5445 = 1.089 (Williams), "
        "and faster on graded meshes",
        "the shaft is one body without shrink fit",
        BEAM,
    )

    @Quantity("ω_{0}{1[0]}", "rad/s", "whirl frequency, mode {0} {1}").over(MODES, SENSES)
    def whirl(self, j: int, sense: Sense) -> float:
        return float(self._whirl[sense][j - 1])

    @Quantity("Ω_c", "r/min", "first critical speed", safe="too low")
    def critical(self) -> float:
        return float(transfer_critical_speeds(self._rotor, count=1, whirl="forward").speeds[0])

    @Quantity("Δω_2", "rad/s", "gyroscopic splitting of mode 2", tex=r"\omega_{2f} - \omega_{2b}")
    def split(self) -> float:
        return self.whirl(2, "forward") - self.whirl(2, "backward")

    @Quantity("ω_1f/ω_1f'", "1", "frequency of mode 1 forward with nominal diameters, "
                                "divided by the same frequency computed by the 45° rule",
              role="step", tex=r"\frac{\omega_{1f}}{\omega_{1f}'}")  # fmt: skip
    def over_cone(self) -> float:
        return float(self.whirl(1, "forward") / self.by_rule.whirl(1, "forward"))

    @property
    def shape(self) -> SteppedShape:
        """Dimensions of the stepped shaft for the formulas."""
        return SteppedShape(L=self.L, d_1=self.d_1, d_2=self.d_2, L_2=self.L_2, start=self.start,
                            seats=self.seats)  # fmt: skip

    def rotor(self, *, cone: bool = False, slices: int = SLICES) -> TransferMatrixRotor:
        """The shaft as a Timoshenko beam; with `cone`, its stiffness follows the 45° rule."""
        return stepped_beam(self.shape, E=self.E, nu=self.nu, rho=self.rho, k=self.k, cone=cone,
                            slices=slices)  # fmt: skip

    @shared
    def _rotor(self) -> TransferMatrixRotor:
        return self.rotor(cone=self.cone, slices=self.slices)

    @shared
    def _whirl(self) -> dict[Sense, Any]:
        count = len(MODES)
        return {
            w: whirl_frequencies(self._rotor, [self.n], count=count, whirl=w)[0] for w in SENSES
        }

    @shared
    def by_rule(self) -> Self:
        """The shaft with the stiffness of the 45° rule."""
        return self.variant(cone=True)

    @shared
    def _coarse(self) -> Self:
        """The beam with half as many slices in the cones, and four times the slicing error."""
        return self.variant(cone=True, slices=SLICES // 2)

    def _slice_error(self, j: int) -> float:
        """Relative error of mode j caused by the slices of the cones."""
        coarse, fine = (beam.whirl(j, "forward") for beam in (self._coarse, self.by_rule))
        return float(abs(coarse / fine - 1) / 3)

    def _slice_error_of_split(self) -> float:
        """Error of the gyroscopic splitting caused by the slices, over the frequency of mode 2."""
        off = abs(self._coarse.split - self.by_rule.split)
        return float(off / self.by_rule.whirl(2, "forward") / 3)

    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def reference(self, level: int) -> Level:
        """Results of closed-form elements, the weak form of both beams, and the elastic body."""
        from verify.cases.rotor.step.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows of beams against other beam models and the body, and rows on conclusions."""
        yield from self._beams()
        yield from self._inertia()
        yield from self._against_body()
        first = SteppedBeam.whirl(1, "forward")
        yield limit(first, "frequency of mode 1 at rest as d_2 goes to d_1", "ω", exponent=None,
                    points=self._without_step)  # fmt: skip
        for name, margin, more in (
            ("beam theory overestimates the frequencies of modes 1 to 3", self._too_fast, {}),
            ("the 45° rule removes more than half of the frequency error of mode 1",
             self._helps, {}),
            ("the frequency error of mode 1 exceeds the printed difference between beam models",
             self._beyond_claim, {"printed": ("huang2022:frequency-deviation-bound",)}),
        ):  # fmt: skip
            check = Accepted(name=name, symbol="ω", unit="1", margin=margin, **more)  # type: ignore[arg-type]
            yield Comparison(check=check, quantity=first)

    def _beams(self) -> Iterator[Comparison]:
        """Rows of closed-form elements and of the weak form against the exact beam."""
        beam, fast = SteppedBeam, "both methods solve the same beam equation"
        options: dict[str, Any] = {"unit": "rad/s", "shares": BEAM}
        for q, words in self._named((1, "forward"), (1, "backward"), (3, "forward")):
            yield identity(q, f"beam_{q.name}", order=2,
                           name=f"beam elements (Timoshenko): {words}",
                           symbol=q.symbol if q == beam.critical else "ω",
                           sensitivity=(2e-3, fast), **options)  # fmt: skip
        options |= {"symbol": "ω", "by": WEAK}
        for j in (1, 3):
            q = beam.whirl(j, "forward")
            yield identity(q, f"weak_{q.name}",
                           name=f"weak form of the beam: whirl frequency of mode {j} forward",
                           order=4, sensitivity=(2e-3, fast), **options)  # fmt: skip
        options |= {"state": self._states[1], "order": 2}
        for j in MODES:
            q = beam.whirl(j, "forward")
            yield identity(q, f"weak_cone_{q.name}", uncertainty=partial(self._slice_error, j),
                           name="weak form of the beam by the 45° rule: whirl frequency of mode "
                                f"{j} forward",
                           sensitivity=(5e-4, fast), **options)  # fmt: skip
        yield identity(
            beam.split, "weak_cone_split", uncertainty=self._slice_error_of_split,
            scale={"ω_2f'": lambda: self.by_rule.whirl(2, "forward")},
            name="weak form of the beam by the 45° rule: gyroscopic splitting of mode 2",
            sensitivity=(1e-4, fast), **options,
        )  # fmt: skip

    def _inertia(self) -> Iterator[Comparison]:
        for q in (SteppedBeam.mass, SteppedBeam.polar):
            check = Exact(name=f"{q.what} of the elastic body", symbol=q.symbol, unit=q.unit,
                          fem=f"{q.name}_error", scale=q.name, bound=1e-11,
                          bound_reason="Gauss quadrature is exact on straight cells")  # fmt: skip
            yield Comparison(check=check, quantity=q)

    def _against_body(self) -> Iterator[Comparison]:
        """Rows of both beams against the elastic body."""
        sources = (
            "not derived, only computed: the corners of the thick part carry little stress",
            "not derived, only computed: the 45° rule is a rule of thumb",
        )
        modes = ((1, "forward"), (1, "backward"), (2, "forward"), (3, "forward"))
        for state, source in zip(self._states, sources, strict=True):
            for q, words in self._named(*(m for m in modes if not state.key or m[1] == "forward")):
                yield approximation(q, f"solid_{q.name}", name=f"{state.words}: {words}",
                                    symbol="ω", unit="rad/s", state=state, order=CORNER,
                                    expected=underived(source))  # fmt: skip

    @property
    def _states(self) -> tuple[State, State]:
        rule = State(self.by_rule, "cone", "beam by the 45° rule", "{}'")
        return State(self, "", "beam with nominal diameters"), rule

    @staticmethod
    def _named(*modes: tuple[int, str]) -> Iterator[tuple[Quantity, str]]:
        """Quantities of the frequencies and the critical speed, with their names in rows."""
        yield from (
            (SteppedBeam.whirl(j, sense), f"whirl frequency of mode {j} {sense}")
            for j, sense in modes
        )
        yield SteppedBeam.critical, "first critical speed"

    @staticmethod
    def _errors(context: Context, beam: "SteppedBeam") -> tuple[Any, float]:
        """Errors (modes,) of forward whirl against the body, and their uncertainty."""
        runs = np.array([context.series(f"solid_whirl_{j}_forward")[1] for j in MODES])
        formula = np.array([beam.whirl(j, "forward") for j in MODES])
        return formula / runs[:, -1] - 1, 3 * float(abs(runs[:, -1] / runs[:, -2] - 1).max())

    def _too_fast(self, context: Context) -> tuple[float, float, str]:
        """Smallest error of modes 1 to 3; positive if the beam overestimates the stiffness."""
        m, U = self._errors(context, self)
        return float(m.min()), U, ", ".join(f"{x:+.2%}" for x in m)

    def _helps(self, context: Context) -> tuple[float, float, str]:
        """Relative reduction of the frequency error of mode 1 by the 45° rule, minus one half."""
        (m, *_), U = self._errors(context, self)
        (left, *_), _ = self._errors(context, self.by_rule)
        return (
            0.5 - abs(left / m),
            U / m,
            f"the frequency error is {m:+.2%} with nominal diameters, {left:+.2%} by the 45° rule",
        )

    def _beyond_claim(self, context: Context) -> tuple[float, float, str]:
        """Amount by which the relative frequency error of mode 1 exceeds 0.3 %."""
        (m, *_), U = self._errors(context, self)
        return float(m) - CLAIMED, U, f"the frequency error of mode 1 is {m:+.2%}"

    def _without_step(self, levels: Any) -> Points:
        """Error of the beam at rest as d_2 approaches d_1."""
        runs = np.array([r.arrays["near_one"] for r in levels])
        formula = [
            whirl_frequencies(self.with_middle(r, self.L_2 / self.L).rotor(), [0.0], count=1)[0][0]
            for r in NEAR_ONE
        ]  # fmt: skip
        u = np.abs(runs[-1] / runs[-2] - 1)
        return [r - 1 for r in NEAR_ONE], (formula / runs[-1] - 1).tolist(), u.tolist()

    def tables(self, context: Context) -> Iterator[Table]:
        """Table of frequencies of both beams and of the elastic body."""
        if context.fem:
            yield drawn.frequencies(self, context.fem[-1].values)

    def pictures(self) -> Iterator[Picture]:
        """Picture of mode 1 of the body."""
        yield drawn.MODE

    def warnings(self) -> Iterator[str]:
        """Warning if the 45° rule changes the beam's frequencies by 0.2 % or more."""
        off = max(self.whirl(j, "forward") / self.by_rule.whirl(j, "forward") - 1 for j in MODES)
        if off >= 0.002:
            yield (
                f"the 45° rule lowers the beam's frequencies by up to {off:.1%}: the frequencies "
                "of the beam with nominal diameters are too high by about this amount or more; "
                "compare with the elastic body"
            )


STEP = adapted(SteppedBeam)
