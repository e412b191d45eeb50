"""Stepped turning shaft: what a step of the diameter makes of beam theory."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Literal

import numpy as np

from analytic.rotor.transfer_modes import critical_speeds, whirl_frequencies
from verify.cases.rotor.step import figures as shown
from verify.cases.rotor.step.fem import MODES, NEAR_ONE, fem, middle
from verify.cases.rotor.step.inputs import SLICES, StepInputs
from verify.core.case import Case, Context, Output, Values
from verify.judging.checks import Accepted, Approximation, Exact, Identity, Limit

CORNER = 2 * 0.5445  # energy's order at a free corner of 270°: sin(1.5 π x) = -x sin(1.5 π)
WHIRLS: tuple[Literal["forward", "backward"], ...] = ("forward", "backward")
BEAMS = (("drawn", False), ("45°", True))
CLAIMED = 0.003  # what the paper's beams differ by from other beams


def analytic(q: StepInputs) -> Values:
    values: dict[str, Any] = {}
    for name, cone in BEAMS:
        rotor = q.rotor(cone=cone)
        for whirl in WHIRLS:
            found = whirl_frequencies(rotor, [q.n], count=len(MODES), whirl=whirl)[0]
            values |= {f"{name} {j} {whirl}": found[j - 1] for j in MODES}
        values[f"{name} critical"] = critical_speeds(rotor, count=1, whirl="forward").speeds[0]
    values |= by_the_rule(q, values)
    values["mass"] = sum(q.rho * np.pi / 4 * d**2 * length for length, d, _ in q.parts)
    values["polar"] = sum(q.rho * np.pi / 32 * d**4 * length for length, d, _ in q.parts)
    return {key: float(value) for key, value in values.items()}


def by_the_rule(q: StepInputs, v: Values) -> Values:
    """What turning splits mode 2 by, and what is left of slices in that and in the frequencies.

    Slices of mean diameter leave an error of second order: half as many differ by three times it.
    """
    coarse, found = q.rotor(cone=True, slices=SLICES // 2), {}
    half = {w: whirl_frequencies(coarse, [q.n], count=len(MODES), whirl=w)[0] for w in WHIRLS}
    for j in MODES:
        found[f"slices {j}"] = abs(half["forward"][j - 1] / v[f"45° {j} forward"] - 1) / 3
    split, less = v["45° 2 forward"] - v["45° 2 backward"], half["forward"][1] - half["backward"][1]
    return found | {"45° split": split, "slices split": abs(less - split) / v["45° 2 forward"] / 3}


def errors(context: Context, name: str) -> tuple[Any, float]:
    """Errors (modes,) of a beam's forward whirl against the body, and their uncertainty."""
    runs = np.array([context.series(f"solid {j} forward")[1] for j in MODES])
    formula = np.array([context.analytic[f"{name} {j} forward"] for j in MODES])
    return formula / runs[:, -1] - 1, 3 * float(abs(runs[:, -1] / runs[:, -2] - 1).max())


def too_fast(context: Context) -> tuple[float, float, str]:
    """Least error of modes 1 to 3, which a step leaves positive: a beam counts dead corners."""
    m, U = errors(context, "drawn")
    return float(m.min()), U, ", ".join(f"{x:+.2%}" for x in m)


def helps(context: Context) -> tuple[float, float, str]:
    """By how much more than half the 45° rule reduces the error of mode 1, over it."""
    (m, *_), U = errors(context, "drawn")
    (left, *_), _ = errors(context, "45°")
    return 0.5 - abs(left / m), U / m, f"{m:+.2%} as drawn, {left:+.2%} by the rule"


def beyond_claim(context: Context) -> tuple[float, float, str]:
    """By how much a step's error exceeds 0.3 %."""
    (m, *_), U = errors(context, "drawn")
    return float(m) - CLAIMED, U, f"{m:+.2%} in mode 1"


def without_step(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Error of the beam at rest as d_2 comes down to d_1."""
    q = context.inputs
    runs = np.array([r.arrays["near one"] for r in context.fem])
    formula = [
        whirl_frequencies(middle(q, r, q.L_2 / q.L).rotor(), [0.0], count=1)[0][0]
        for r in NEAR_ONE
    ]  # fmt: skip
    u = np.abs(runs[-1] / runs[-2] - 1)
    return [r - 1 for r in NEAR_ONE], (formula / runs[-1] - 1).tolist(), u.tolist()


def identity(name: str, key: str, fem_key: str, *, formal: float, by: str = "") -> Identity:
    return Identity(name=name, symbol="Ω_c" if "critical" in key else "ω", unit="rad/s",
                    analytic=key, fem=fem_key, by=by, formal=formal, demand=2e-3,
                    demand_reason="elements against the exact beam")  # fmt: skip


CHECKS = (
    *(
        identity(f"closed-form elements, {words}", f"drawn {key}", f"beam {key}", formal=2)
        for key, words in (("1 forward", "mode 1 forward"), ("1 backward", "mode 1 backward"),
                           ("3 forward", "mode 3 forward"), ("critical", "critical speed"))
    ),
    *(
        identity(f"weak form, mode {j} forward", f"drawn {j} forward", f"weak {j} forward",
                 formal=4, by="weak form")
        for j in (1, 3)
    ),
    *(
        replace(identity(f"weak form, 45° rule, mode {j} forward", f"45° {j} forward",
                         f"weak 45° {j} forward", formal=2, by="weak form"),
                residual=f"slices {j}", demand=5e-4)
        for j in MODES
    ),
    replace(
        identity("weak form, 45° rule, what turning splits mode 2 by", "45° split",
                 "weak 45° split", formal=2, by="weak form"),
        scale="45° 2 forward", residual="slices split", demand=1e-4,
    ),
    *(
        Exact(name=f"{words} of the elastic body", symbol=symbol, unit=unit, fem=f"{key} error",
              scale=key, bound=1e-11, bound_reason="Gauss' rule is exact on straight cells")
        for key, words, symbol, unit in (("mass", "mass", "m", "kg"),
                                         ("polar", "polar moment of inertia", "I_p", "kg m^2"))
    ),
    *(
        Approximation(name=f"beam as drawn, {words}", symbol="ω", unit="rad/s",
                      analytic=f"drawn {key}", fem=f"solid {key}", formal=CORNER, interval=None,
                      source="measured: corners that carry nothing")
        for key, words in (("1 forward", "mode 1 forward"), ("1 backward", "mode 1 backward"),
                           ("2 forward", "mode 2 forward"), ("3 forward", "mode 3 forward"),
                           ("critical", "critical speed"))
    ),
    *(
        Approximation(name=f"beam by the 45° rule, {words}", symbol="ω", unit="rad/s",
                      analytic=f"45° {key}", fem=f"solid {key}", formal=CORNER, interval=None,
                      source="measured: an engineer's rule")
        for key, words in (("1 forward", "mode 1 forward"), ("2 forward", "mode 2 forward"),
                           ("3 forward", "mode 3 forward"), ("critical", "critical speed"))
    ),
    Limit(name="the beam's error as d_2 goes to d_1", symbol="ω", unit="1", points=without_step,
          exponent=None),
    Accepted(name="a step makes the beam too fast in modes 1 to 3", symbol="ω", unit="1",
             margin=too_fast),
    Accepted(name="the 45° rule takes off more than half of the error of mode 1", symbol="ω",
             unit="1", margin=helps),
    Accepted(name="a step's error exceeds what beams differ by from other beams", symbol="ω",
             unit="1", margin=beyond_claim, printed=("huang2022:frequency-deviation-bound",)),
)  # fmt: skip


def warnings(_: StepInputs, v: Values) -> Sequence[str]:
    off = max(v[f"drawn {j} forward"] / v[f"45° {j} forward"] - 1 for j in MODES)
    if off < 0.002:
        return ()
    return (
        f"the 45° rule lowers the beam's frequencies by up to {off:.1%}: the beam as drawn "
        "overestimates them at the steps by about as much or more; compare with the elastic body",
    )


def output(key: str, what: str, unit: str = "rad/s") -> Output:
    return Output(key=key, symbol="Ω_c" if unit == "r/min" else "ω", unit=unit, what=what)


STEP = Case(
    id="rotor-step",
    title="Turning shaft with a step",
    paper="huang2022",
    place="Sec. 1 (Timoshenko's beam elements); Sec. 2.1 (0.3 % against other beam elements)",
    lead="Beams agree with beams to the last digit, whatever the shaft looks like. Where its "
    "diameter steps, the corners of the thick part carry nothing, and a beam is too stiff: the "
    "elastic body of revolution says by how much, and what the 45° rule repairs. The paper prints "
    "no dimension: those are this project's.",
    inputs=StepInputs,
    analytic=analytic,
    reference=fem,
    levels=(1, 2, 3),
    checks=CHECKS,
    outputs=(
        *(output(f"{name} {j} forward", f"mode {j} forward, {words}")
          for name, words in (("drawn", "beam as drawn"), ("45°", "beam by the 45° rule"))
          for j in MODES),
        output("drawn critical", "first critical speed, beam as drawn", "r/min"),
        output("45° critical", "first critical speed, beam by the 45° rule", "r/min"),
    ),
    readings=(
        "a bearing is a spring on the mean motion of its seat, on a beam one at the seat's middle",
        "45° rule: from a step on, the diameter that is stiff grows by twice the distance; masses "
        "are as drawn",
    ),
    assumptions=(
        "linear elasticity, no damping, sharp corners: at 270° the energy of finite elements "
        "converges with order 2 · 0.5445 = 1.089 at least (Williams), faster on graded meshes",
        "one body: nothing shrunk on",
        "Timoshenko's beam with Hutchinson's shear coefficient",
    ),
    warnings=warnings,
    equations=shown.equations,
    tables=shown.tables,
    sketch=shown.sketch,
    figures=shown.figures,
    pictures=shown.pictures,
)  # fmt: skip
