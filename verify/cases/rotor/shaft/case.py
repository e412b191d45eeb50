"""Uniform turning shaft: three beam theories, two kinds of elements, and the elastic body."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.rotor.pochhammer import bending_frequency
from verify.cases.rotor.shaft import figures as shown
from verify.cases.rotor.shaft.claims import (
    CEILING,
    FormulasLimit,
    errors,
    euler_limit,
    inertia_and_shear,
    known,
    neglected,
    sense,
    timoshenko_limit,
)
from verify.cases.rotor.shaft.fem import MODES, SLENDER, THEORIES, fem
from verify.cases.rotor.shaft.inputs import ShaftInputs
from verify.cases.rotor.shaft.tolerances import FINE, slender, within_ceiling
from verify.core.case import Case, Output, Scan, Values
from verify.judging.checks import Accepted, Approximation, Identity, Limit, Order
from verify.judging.judge import DEMAND
from verify.judging.tolerance_checks import SUBJECT, Agreement

FOUR = "elements of order four"


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


def whirl(
    name: str, key: str, fem_key: str, *, formal: float, by: str = "", demand: float = 1e-3
) -> Identity:
    symbol = "Ω_c" if "critical" in key else "ω"
    return Identity(name=name, symbol=symbol, unit="rad/s", analytic=key, fem=fem_key, by=by,
                    formal=formal, demand=demand,
                    demand_reason=FOUR if formal == 4 else "elements of order two")  # fmt: skip


NEIGHBOURS = "tells an order from its neighbours"
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
                      source="his equation solved anew, over the cylinder of elasticity; ± 5e-5")
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
              demand=demand, demand_reason=NEIGHBOURS if demand > DEMAND else "")
        for words, key, of, order, demand in (
            ("Euler's elements", "beam euler 1 forward", "euler 1 forward", 4, DEMAND),
            ("Rayleigh's elements", "beam rayleigh 1 forward", "rayleigh 1 forward", 4, DEMAND),
            ("Timoshenko's elements", "beam timoshenko 1 forward", "timoshenko 1 forward", 2, 0.1),
            ("the weak form", "weak timoshenko 1 forward", "timoshenko 1 forward", 4, DEMAND),
            ("the elastic body", "solid 1 forward", "exact 1 forward", 4, 0.03),
        )
    ),
    Agreement(name="Timoshenko's beam is within 0.2 % of the elastic body, modes 1 to 3",
              symbol="ω", unit="rad/s", pair=within_ceiling, accepted=CEILING,
              source=SUBJECT),
    Agreement(name="32 elements are within 1e-5 at d/L = 0.03, mode 1", symbol="ω", unit="rad/s",
              pair=slender, accepted=FINE,
              source=SUBJECT),
    Accepted(name="turning speeds forward whirl up and slows backward whirl down", symbol="ω",
             unit="1", margin=sense),
)  # fmt: skip


FASTEST = 600.0  # rim speed [m/s] that hardly any steel bears


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
    if (rim := q.n * q.d_o / 2) > FASTEST:
        found.append(f"its rim runs at {rim:.0f} m/s: steel bursts at some {FASTEST:.0f} m/s")
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
    reference=fem,
    levels=(1, 2, 4, 8),
    scans=(
        Scan(
            vary=(
                "L=200mm,300mm,400mm,600mm,1200mm", "d_i=0mm,30mm,50mm",
                "n=2000r/min,10000r/min,30000r/min",
            ),
            star=True,
        ),
    ),
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
