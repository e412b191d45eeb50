"""Readings for the sprag clutch of Huang et al. 2018: Table 2, pressure reductions, Eq. 16."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from verify.papers.digits import half_last_digit
from verify.papers.ledger import published
from verify.studies.readings.problem import Problem
from verify.studies.readings.readings import result, switched
from verify.studies.readings.search import Reading


def printed(name: str) -> float:
    """A printed value of the paper in its printed unit."""
    return published(f"huang2018:{name}").value


def half(name: str) -> float:
    """Half a unit of the last printed place of a value, in the printed unit."""
    return half_last_digit(published(f"huang2018:{name}").printed)


def error(q: Mapping[str, Any]) -> float:
    """Difference of two values relative to one value or to their mean, raised to a power [%]."""
    base = q["actual"] + q["of"] * (q["predicted"] - q["actual"])
    return float(100 * (abs(q["actual"] - q["predicted"]) / base) ** q["power"])


def squared(q: Mapping[str, Any]) -> float:
    """Difference of two pressures, raised to a power, over the number of points [MPa^power]."""
    return float((q["actual"] - q["predicted"]) ** q["power"] / q["points"])


def _row(number: int) -> dict[str, Any]:
    pair = {name: printed(f"table2-row{number}-{name}") for name in ("actual", "predicted")}
    return pair | {"of": 0.0, "power": 1.0, "points": 1.0}


def _rounded(number: int) -> dict[str, float]:
    return {name: half(f"table2-row{number}-{name}") for name in ("actual", "predicted")}


def _error_readings() -> tuple[Reading, ...]:
    return (
        switched("of", "relative to the predicted value", of=1.0),
        switched("of", "relative to the mean of both values", of=0.5),
        switched("power", "squared", power=2.0),
        switched("power", "square root", power=0.5),
        *result()[:2],
    )


def _square_readings() -> tuple[Reading, ...]:
    return (
        switched("power", "difference, not squared", power=1.0),
        switched("points", "divided by the 10 points of the table", points=10.0),
        switched("points", "divided by 9 points", points=9.0),
        switched("points", "divided by the 125 points of the design", points=125.0),
        switched("points", "divided by the 5 levels", points=5.0),
        Reading(name="square root", of="the number itself", result=lambda v, _q: math.sqrt(abs(v))),
        *result(),
    )


def reduction(q: Mapping[str, Any]) -> float:
    """Reduction of the pressure by the optimised crown [%]."""
    base = q["before"] + q["of"] * (q["after"] - q["before"])
    return float(100 * (q["before"] - q["after"]) / base)


def _reduction(torque: int) -> dict[str, Any]:
    return {"before": printed(f"stress-{torque}nm-unmodified"),
            "after": printed(f"stress-{torque}nm-optimised"), "of": 0.0}  # fmt: skip


def _rounded_pair(torque: int) -> dict[str, float]:
    return {"before": half(f"stress-{torque}nm-unmodified"),
            "after": half(f"stress-{torque}nm-optimised")}  # fmt: skip


def _reduction_readings() -> tuple[Reading, ...]:
    return (
        switched("of", "relative to the optimised pressure", of=1.0),
        switched("of", "relative to the mean of both values", of=0.5),
        switched("before", "3500 MPa of 25 N m before", before=printed("stress-25nm-unmodified")),
        switched("after", "2980 MPa of 25 N m after", after=printed("stress-25nm-optimised")),
        Reading(name="pressures rounded to tens", of="rounding",
                rounding={"before": 5.0, "after": 5.0}),
        Reading(name="pressures rounded to hundreds", of="rounding",
                rounding={"before": 50.0, "after": 50.0}),
        *result()[:2],
    )  # fmt: skip


def raised(q: Mapping[str, Any]) -> float:
    """Pressure at 40 N m [MPa], extrapolated from 25 N m by a power of the ratio of forces."""
    return float(q["pressure"] * q["ratio"] ** q["power"])


def _raised(kind: str) -> dict[str, Any]:
    ratio = printed("torque-40") / printed("torque-25")
    return {"pressure": printed(f"stress-25nm-{kind}"), "ratio": ratio, "power": 0.5}


def _raised_readings(kind: str) -> tuple[Reading, ...]:
    """Readings of the exponent and of the ratio of forces.

    The ratio from the pressures of the other crown is included, but is no independent evidence.
    """
    laws = {"point contact: cube root": 1 / 3, "Palmgren's law: 0.45": 0.45, "linear": 1.0,
            "two thirds": 2 / 3, "Palmgren's approach: 0.9": 0.9}  # fmt: skip
    other = {"optimised": "unmodified", "unmodified": "optimised"}[kind]
    pair = printed(f"stress-40nm-{other}") / printed(f"stress-25nm-{other}")
    return (
        *(switched("power", law, power=power) for law, power in laws.items()),
        switched("ratio", "forces of the engagement, 1.594", ratio=1.594),
        switched("ratio", f"ratio of the {other} pair", ratio=pair**2),
        *result(),
    )


def lever(q: Mapping[str, Any]) -> float:
    """Lever arm [mm] by the bracketed term of Eq. 16, without deflections."""
    return float(q["share"] * q[q["radius"]])


def _arm_readings() -> tuple[Reading, ...]:
    return (
        switched("share", "the whole bracket instead of half of it", share=1.0),
        switched("share", "a quarter of the bracket instead of half of it", share=0.25),
        switched("radius", "radius R_id of the bore", radius="R_id"),
        switched("radius", "outer radius R_ed", radius="R_ed"),
        switched("radius", "radius r_i of the sprag", radius="r_i"),
        *result()[2:],
    )


def _arms(radius: str) -> dict[str, Any]:
    names = {"R_i": "r-i", "R_e": "r-e", "R_id": "r-id", "R_ed": "r-ed", "r_i": "r-i1"}
    radii = {symbol: printed(f"table1-{name}") for symbol, name in names.items()}
    return radii | {"share": 0.5, "radius": radius}


def _problem(name: str, **more: Any) -> Problem:
    return Problem(reference=f"huang2018:{name}", **more)


def _errors(number: int) -> Problem:
    return _problem(
        f"table2-row{number}-error", case="sprag-crown", formula=error,
        what="difference of actual and predicted value, relative to the actual value",
        inputs=lambda: _row(number),
        rounding=_rounded(number), readings=_error_readings, errata=("table-2-row-10-error",),
    )  # fmt: skip


def _squares(number: int) -> Problem:
    return _problem(
        f"table2-row{number}-mse", case="sprag-crown",
        what="squared difference of actual and predicted value",
        formula=squared, inputs=lambda: _row(number) | {"power": 2.0}, rounding=_rounded(number),
        readings=_square_readings,
    )  # fmt: skip


def _column(name: str, parts: tuple[Problem, ...]) -> Problem:
    """A column of Table 2 as one problem with all its numbers."""
    return replace(parts[0], reference=f"huang2018:{name}", errata=(name,), parts=parts)


ROWS = (1, 2, 3, 5, 6, 7, 8, 9, 10)  # in row 4 both values are one

PROBLEMS = (
    _column("table-2-relative-error", tuple(map(_errors, ROWS))),
    _errors(10),
    _column("table-2-mse", tuple(map(_squares, ROWS))),
    _problem(
        "stress-40nm-reduction", case="sprag-clutch",
        what="reduction computed from the two printed pressures",
        formula=reduction, inputs=lambda: _reduction(40), rounding=_rounded_pair(40),
        readings=_reduction_readings, errata=("sec-4-2-2-percentage",),
    ),
    *(
        _problem(
            f"stress-40nm-{kind}", case="sprag-clutch",
            what="printed pressure at 25 N m times the square root of the torque ratio",
            formula=raised,
            inputs=lambda kind=kind: _raised(kind),
            readings=lambda kind=kind: _raised_readings(kind),
            rounding={"pressure": half(f"stress-25nm-{kind}")}, errata=("sec-4-2-force-ratio",),
        )
        for kind in ("unmodified", "optimised")
    ),
    _problem(
        "eq-16-lever-arms", case="sprag-clutch", what="lever arm of Eq. 16 at the inner race",
        formula=lever, inputs=lambda: _arms("R_i"), readings=_arm_readings, derived="11.11",
        unit="mm", errata=("eq-16-lever-arms",),
    ),
)  # fmt: skip
