"""Uniform turning shaft: three beam theories, two kinds of elements, and the elastic body."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.rotor.pochhammer import bending_frequency
from verify.case import Case, Context, Output, Values
from verify.cases import rotor_shaft_shown as shown
from verify.cases.rotor_shaft_fem import MODES, RATIOS, SLENDER, THEORIES, fem
from verify.cases.rotor_shaft_inputs import ShaftInputs
from verify.checks import Accepted, Approximation, Identity, Limit, Order

FOUR = "elements of order four"
CEILING = 0.002  # of a uniform tube's frequencies, Timoshenko's beam against the elastic body
NEAR = 5e-5  # how well the error of a formula is known beforehand
SMALL = 0.3  # of rotary inertia and shear, up to which their series is used
TOWARDS = (0.0125, 0.025, 0.05, 0.125)  # diameters over lengths of Timoshenko's limit
DIGITS = 2e-12  # of both sides there


def analytic(q: ShaftInputs) -> Values:
    s, body = q.shaft(), q.cylinder()
    values: dict[str, Any] = {}
    for j in MODES:
        k = j * np.pi / q.L
        for theory in THEORIES:
            pair = s.whirl(j, Omega=q.n, theory=theory)
            values |= dict(zip((f"{theory} {j} forward", f"{theory} {j} backward"), pair,
                               strict=True))  # fmt: skip
            values[f"{theory} {j} at rest"] = s.whirl(j, theory=theory)[0]
        ahead, behind = body.whirl(k, Omega=q.n)
        values |= {f"exact {j} forward": ahead[0], f"exact {j} backward": behind[0]}
        values[f"exact {j} at rest"] = body.whirl(k)[0][0]
    values["Pochhammer 1"] = bending_frequency(
        k=np.pi / q.L, r_o=q.d_o / 2, r_i=q.d_i / 2, E=q.E, nu=q.nu, rho=q.rho
    )
    for theory in THEORIES:
        values[f"{theory} critical"] = s.critical_speed(1, theory=theory)
    values["exact critical"] = body.critical_speeds(np.pi / q.L)[0]
    for name in ("timoshenko", "exact"):
        values[f"{name} split"] = values[f"{name} 1 forward"] - values[f"{name} 1 backward"]
    values["slender"] = q.shaft(L=q.d_o / SLENDER).whirl(1, theory="timoshenko")[0]
    e, shear = inertia_and_shear(q)
    values |= {"rotary share": e / 2, "shear share": e * shear / 2}
    return {key: float(value) for key, value in values.items()}


def inertia_and_shear(q: ShaftInputs) -> tuple[float, float]:
    """I k^2/A of mode 1, and E/(kappa G): rotary inertia and, times that, shear [1]."""
    s = q.shaft()
    return s.I / s.A * (np.pi / q.L) ** 2, q.E * s.A / s.S


def neglected(theory: str) -> Any:
    """Interval of the error of mode 1 by Timoshenko's equation, W the square over Euler's.

    1 - W (1 + a) + s e^2 W^2 = 0 with a = e (1 + s): Euler's error is 1/sqrt(W) - 1 = a/2 less
    a^2/8 + s e^2/2 to second order, Rayleigh's is e s/2 less no more than that. Twice the second
    order is allowed, downwards.
    """

    def interval(q: ShaftInputs, _: Values) -> tuple[float, float] | None:
        e, s = inertia_and_shear(q)
        a = e * (1 + s)
        leading = a / 2 if theory == "euler" else e * s / 2
        return (leading - a**2 / 4 - s * e**2, leading) if a < SMALL else None

    return interval


def known(j: int) -> Any:
    """Interval about Timoshenko's error against the cylinder of three-dimensional elasticity."""

    def interval(_: ShaftInputs, v: Values) -> tuple[float, float]:
        m = v[f"timoshenko {j} at rest"] / v[f"exact {j} at rest"] - 1
        return m - NEAR, m + NEAR

    return interval


def whirl(
    name: str, key: str, fem_key: str, *, formal: float, by: str = "", demand: float = 1e-3
) -> Identity:
    symbol = "Ω_c" if "critical" in key else "ω"
    return Identity(name=name, symbol=symbol, unit="rad/s", analytic=key, fem=fem_key, by=by,
                    formal=formal, demand=demand,
                    demand_reason=FOUR if formal == 4 else "elements of order two")  # fmt: skip


def errors(key: str, of: str) -> Any:
    """Errors of a frequency against the formula `of`, per level."""

    def found(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(key)
        return h, [value / context.analytic[of] - 1 for value in v]

    return found


def euler_limit(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Euler's error at rest against the elastic body, as the shaft gets slender.

    Beside the meshes' uncertainty stands that of a first term alone: (k r)^2 of it.
    """
    q = context.inputs
    runs = np.array([r.arrays["limit"] for r in context.fem])
    formula = [q.shaft(L=q.d_o / ratio).whirl(1, theory="euler")[0] for ratio in RATIOS]
    d = formula / runs[-1] - 1
    u = np.abs(runs[-1] / runs[-2] - 1) + np.abs(d) * (np.pi / 2 * np.array(RATIOS)) ** 2
    return list(RATIOS), d.tolist(), u.tolist()


@dataclass(frozen=True, kw_only=True)
class FormulasLimit(Limit):
    """Both sides are formulas: no finite elements."""

    @property
    def needs_fem(self) -> bool:
        return False


def timoshenko_limit(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Timoshenko's error at rest against the cylinder of elasticity, its first term likewise."""
    q, d = context.inputs, []
    for ratio in TOWARDS:
        exact = q.cylinder().whirl(np.pi * ratio / q.d_o)[0][0]
        d.append(q.shaft(L=q.d_o / ratio).whirl(1, theory="timoshenko")[0] / exact - 1)
    u = DIGITS + np.abs(d) * (np.pi / 2 * np.array(TOWARDS)) ** 2
    return list(TOWARDS), d, u.tolist()


def within_ceiling(context: Context) -> tuple[float, float, str]:
    """What is left of 0.2 % between Timoshenko's beam and the elastic body, modes 1 to 3."""
    runs = [context.series(f"solid {j} at rest")[1] for j in MODES]
    m = [context.analytic[f"timoshenko {j} at rest"] / v[-1] - 1 for j, v in zip(MODES, runs,
         strict=True)]  # fmt: skip
    U = max(abs(v[-1] / v[-2] - 1) for v in runs)
    return CEILING - max(map(abs, m)), U, ", ".join(f"{x:+.4%}" for x in m)


def slender(context: Context) -> tuple[float, float, str]:
    """What is left of 1e-5 at the finest level, 32 elements on a shaft of d/L = 0.03."""
    m = context.series("beam slender")[1][-1] / context.analytic["slender"] - 1
    return 1e-5 - abs(m), 1e-9, f"{m:.1e}"


def sense(context: Context) -> tuple[float, float, str]:
    """The least share by which forward whirl is faster, where elements name it so."""
    v = context.fem[-1].values
    share = [v[f"{name} split"] / v[f"{name} 1 forward"]
             for name in ("beam timoshenko", "weak timoshenko", "solid")]  # fmt: skip
    named = v["beam sense"] == 2  # the faster of the pair is +1, the slower -1
    return min(share) if named else -1.0, 1e-9, f"by {min(share):.2%} of the frequency"


CHECKS = (
    *(
        whirl(f"elements of {t.capitalize()}, {words}", f"{t} {key}", f"beam {t} {key}",
              formal=2 if t == "timoshenko" else 4,
              demand=2e-3 if t == "timoshenko" and key[0] == "3" else 1e-3)
        for t in THEORIES
        for key, words in (("1 forward", "mode 1 forward"), ("1 backward", "mode 1 backward"),
                           ("3 forward", "mode 3 forward"), ("critical", "critical speed"))
    ),
    *(
        whirl(f"weak form of {t.capitalize()}, mode {key}", f"{t} {key}", f"weak {t} {key}",
              formal=4, by="weak form")
        for t, key in (("euler", "3 forward"), ("rayleigh", "1 backward"),
                       ("timoshenko", "1 forward"), ("timoshenko", "3 forward"))
    ),
    whirl("elastic body at rest, Pochhammer's equation", "Pochhammer 1", "solid 1 at rest",
          formal=4),
    *(
        whirl(f"elastic body, {words}", f"exact {key}", f"solid {key}", formal=4)
        for key, words in (("1 forward", "mode 1 forward"), ("1 backward", "mode 1 backward"),
                           ("2 forward", "mode 2 forward"), ("3 forward", "mode 3 forward"),
                           ("critical", "critical speed"))
    ),
    whirl("what turning splits mode 1 by, elements", "timoshenko split", "beam timoshenko split",
          formal=2),
    whirl("what turning splits mode 1 by, elastic body", "exact split", "solid split", formal=4),
    *(
        Approximation(name=f"Timoshenko's beam, mode {j}, at rest", symbol="ω", unit="rad/s",
                      analytic=f"timoshenko {j} at rest", fem=f"solid {j} at rest", formal=4,
                      interval=known(j), demand=1e-3, demand_reason=FOUR,
                      source="the cylinder of three-dimensional elasticity, 5e-5 about it")
        for j in MODES
    ),
    *(
        Approximation(name=f"{t.capitalize()}'s beam, mode 1, at rest", symbol="ω", unit="rad/s",
                      analytic=f"{t} 1 at rest", fem="solid 1 at rest", formal=4,
                      interval=neglected(t),
                      source="what it neglects, in Timoshenko's equation to second order")
        for t in ("euler", "rayleigh")
    ),
    Limit(name="Euler's beam as d/L goes to 0", symbol="ω", unit="1", points=euler_limit,
          exponent=2),
    FormulasLimit(name="Timoshenko's beam as d/L goes to 0", symbol="ω", unit="1",
                  points=timoshenko_limit, exponent=4),
    *(
        Order(name=f"order of {words}", symbol="p", unit="1", errors=errors(key, of), order=order,
              demand=0.1, demand_reason="tells an order from its neighbours")
        for words, key, of, order in (
            ("Euler's elements", "beam euler 1 forward", "euler 1 forward", 4),
            ("Rayleigh's elements", "beam rayleigh 1 forward", "rayleigh 1 forward", 4),
            ("Timoshenko's elements", "beam timoshenko 1 forward", "timoshenko 1 forward", 2),
            ("the weak form", "weak timoshenko 1 forward", "timoshenko 1 forward", 4),
            ("the elastic body", "solid 1 forward", "exact 1 forward", 4),
        )
    ),
    Accepted(name="Timoshenko's beam is within 0.2 % of the elastic body, modes 1 to 3",
             symbol="ω", unit="1", margin=within_ceiling),
    Accepted(name="32 elements are within 1e-5 at d/L = 0.03, mode 1", symbol="ω", unit="1",
             margin=slender),
    Accepted(name="turning speeds forward whirl up and slows backward whirl down", symbol="ω",
             unit="1", margin=sense),
)  # fmt: skip


def warnings(q: ShaftInputs, v: Values) -> Sequence[str]:
    found = []
    if (error := v["euler 1 at rest"] / v["exact 1 at rest"] - 1) > 0.02:
        found.append(f"Euler's beam is {error:+.1%} off at mode 1: take Timoshenko's")
    worst = max((v[f"timoshenko {j} at rest"] / v[f"exact {j} at rest"] - 1 for j in MODES),
                key=abs)  # fmt: skip
    if abs(worst) > CEILING:
        found.append(f"Timoshenko's beam is {worst:+.2%} off in modes 1 to 3: too stubby or thin")
    near = min(abs(q.n / v["exact critical"] - 1), 1.0)
    if near < 0.1:
        found.append(f"{q.n * 30 / np.pi:.5g} r/min is within {near:.0%} of the critical speed")
    return found


def output(key: str, what: str, unit: str = "rad/s", *, judged: bool = True) -> Output:
    symbol = "Ω_c" if unit == "r/min" else "ω"
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


SHAFT = Case(
    id="rotor-shaft",
    title="Uniform shaft that turns",
    paper="huang2022",
    place="Sec. 1: rotors of Timoshenko's beam elements (Nelson)",
    lead="The elements of which the paper's rotors are made, on a shaft with closed forms: "
    "Euler's, Rayleigh's and Timoshenko's. The same shaft as an elastic body, whose whirl "
    "elasticity gives exactly, says what a beam leaves out. The paper prints no dimension: those "
    "are this project's.",
    inputs=ShaftInputs,
    analytic=analytic,
    fem=fem,
    levels=(1, 2, 4, 8),
    checks=CHECKS,
    outputs=(
        *(output(f"timoshenko {j} {way}", f"mode {j} {way}, Timoshenko", judged=j != 2)
          for j in MODES for way in ("forward", "backward")),
        output("exact 1 forward", "mode 1 forward, elasticity"),
        output("exact 1 backward", "mode 1 backward, elasticity"),
        output("euler critical", "first critical speed, Euler", "r/min"),
        output("rayleigh critical", "first critical speed, Rayleigh", "r/min"),
        output("timoshenko critical", "first critical speed, Timoshenko", "r/min"),
        output("exact critical", "first critical speed, elasticity", "r/min"),
    ),
    readings=(
        "the shear coefficient is Hutchinson's; with Cowper's the error falls with (d/L)² alone",
        "terms in Ω² and the stiffness of centrifugal stress are left out together: they cancel "
        "where sections turn as if rigid",
    ),
    assumptions=(
        "ends held across and free along, bearings rigid",
        "linear elasticity, no damping",
        "critical speeds are those of synchronous forward whirl",
    ),
    warnings=warnings,
    equations=shown.equations,
    tables=shown.tables,
    sketch=shown.sketch,
    figures=shown.figures,
)  # fmt: skip
