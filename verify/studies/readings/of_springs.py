"""Readings for the accordion spring of Wang et al.: Eqs. 1 to 10, and derived equations."""

import math
from collections.abc import Mapping
from typing import Any

from analytic.spring.garbled import flexibility
from analytic.spring.stages import stages
from verify.cases.spring.inputs import AccordionInputs
from verify.cases.spring.stages.inputs import StagesInputs
from verify.papers.ledger import published
from verify.studies.readings.problem import Problem
from verify.studies.readings.readings import elastic, result, switched
from verify.studies.readings.search import Reading

QUARTER, SEMICIRCLE = math.pi / 2, math.pi
N_PER_MM = 1e3


def printed(name: str) -> float:
    """A printed value of the paper in its printed unit."""
    return published(f"wang2023:{name}").value


def spring() -> dict[str, Any]:
    """Dimensions and elastic constants of the printed spring in SI units."""
    q = AccordionInputs()
    return {name: getattr(q, name) for name in ("n", "b", "h", "r", "L1", "alpha", "E", "nu")}


def energy_stiffness(q: Mapping[str, Any]) -> float:
    """Stiffness k_1 [N/mm] by Eqs. 1 to 9 with the reading that the options in `q` select."""
    r = q["r"] + q["arcs"] * q["b"] / 2
    inner = q["r"] + q["halves"] * q[q["thickness"]] / 2
    L2 = q["leaves"] * q["L1"] / math.sin(q["alpha"]) + 2 * inner / math.tan(q["alpha"])
    f = flexibility(
        q["n"], q["L1"] / 2, r, L2, q["alpha"], q["signs"], q["start"], (q["head"], q["tail"])
    )
    return float(q["E"] * q["h"] * q["b"] ** 3 / 12 / f / N_PER_MM)


# Eqs. 1 to 9 as the text has them
LITERAL = {
    "leaves": 2.0, "thickness": "h", "halves": 1.0, "arcs": 0.0, "signs": "M_2 as printed",
    "start": 1.0, "head": QUARTER, "tail": QUARTER,
}  # fmt: skip
# closed loops about the centre line, by statics
STATICS = LITERAL | {"leaves": 1.0, "thickness": "b", "arcs": 1.0, "signs": "alternating"}
ADOPTED = STATICS | {"arcs": 0.0}


def _stiffness_readings() -> tuple[Reading, ...]:
    """Readings of ambiguous terms in Eqs. 1 to 9, and general readings for a bent strip."""
    return (
        switched("leaves", "L_1 instead of 2 L_1 in L_2", leaves=1.0),
        switched("leaves", "L_1/2 instead of 2 L_1 in L_2", leaves=0.5),
        switched("thickness", "b instead of h in L_2", thickness="b"),
        switched("halves", "r instead of r + h/2 in L_2", halves=0.0),
        switched("halves", "r + h instead of r + h/2 in L_2", halves=2.0),
        switched("arcs", "radius r + b/2 in the arcs", arcs=1.0),
        switched("signs", "alternating sign of the term F x in M_2", signs="alternating"),
        switched("signs", "sign + in every segment", signs="all plus"),
        switched("start", "moment F L_1/2 at the first inner segment", start=0.0),
        *elastic("E", "nu")[:1],
        *result()[:2],
    )


def _arc_readings() -> tuple[Reading, ...]:
    """Readings of the radii of the arcs and the lengths of the straight parts."""
    return (
        switched("arcs", "inner radius r in the arcs", arcs=0.0),
        switched("arcs", "outer radius r + b in the arcs", arcs=2.0),
        switched("halves", "r in L_2", halves=0.0),
        switched("halves", "r + b in L_2", halves=2.0),
        switched("leaves", "2 L_1 in L_2", leaves=2.0),
        switched("start", "moment F L_1/2 at the first inner segment", start=0.0),
        switched("head", "semicircle in the head", head=SEMICIRCLE),
        switched("tail", "semicircle in the tail", tail=SEMICIRCLE),
        *elastic("E", "nu")[:1],
        *result()[:2],
    )


def _end_readings() -> tuple[Reading, ...]:
    """Readings of the angles of the end arcs, and of the radii."""
    return (
        switched("head", "quarter circle in the head", head=QUARTER),
        switched("tail", "quarter circle in the tail", tail=QUARTER),
        switched("arcs", "radius r + b/2 in the arcs", arcs=1.0),
        switched("halves", "r in L_2", halves=0.0),
        switched("start", "moment F L_1/2 at the first inner segment", start=0.0),
        *elastic("E", "nu")[:1],
        *result()[:2],
    )


def staged(key: str, q: Mapping[str, Any]) -> float:
    """Stiffness [N/mm] of one linear stage: `key` is "k1" or "k2"."""
    inputs = StagesInputs()
    path = inputs.path if q["arcs"] else inputs.paper_path
    factor = inputs.widest if q["wide"] else 1.0
    found = stages(
        **path, b=q["b"], h=q["h"], E=q["E"], nu=q["nu"], width_factor=factor, head=q["head"],
        tail=q["tail"],
    )  # fmt: skip
    return float(getattr(found, key)) / N_PER_MM


def _stage_readings() -> tuple[Reading, ...]:
    """Readings of the supports of head and tail, the radius of the arcs, and the strip's width."""
    return (
        switched("tail", "tail clamped at mid-leaf", tail="mid-leaf"),
        switched("head", "head guided", head="guided"),
        switched("arcs", "radius r + b/2 in the arcs", arcs=1.0),
        switched("wide", "E I/(1 − ν²) instead of E I", wide=1.0),
    )


def force_error(q: Mapping[str, Any]) -> float:
    """Mean (or RMS) relative difference [%] between F and k U; Eq. 10 gives U under the force F."""
    apart = []
    for F in q["forces"]:
        second = q["F_A"] < F
        k, c = (q["k2"], q["c2"]) if second else (q["k1"], q["c1"])
        by_theory = q["k"] * (F - c) / k
        apart.append(100 * abs(F - by_theory) / (by_theory if q["of_theory"] else F))
    return (
        math.sqrt(sum(x * x for x in apart) / len(apart)) if q["rms"] else sum(apart) / len(apart)
    )


def _eq_10() -> dict[str, Any]:
    lines = {"k1": printed("k1-fea"), "c1": printed("eq10-oa-intercept"),
             "k2": printed("k2-fea"), "c2": printed("eq10-ab-intercept")}  # fmt: skip
    U = (lines["c1"] - lines["c2"]) / (lines["k2"] - lines["k1"])
    return lines | {"F_A": lines["k1"] * U + lines["c1"], "of_theory": False, "rms": False}


def _error_readings() -> tuple[Reading, ...]:
    """Readings of the force at which the error is taken, and of the kind of error."""
    A, every = _eq_10()["F_A"], tuple(float(F) for F in range(1, 12))
    return (
        *(switched("forces", f"at {F:g} N", forces=(F,)) for F in (1.0, 2.0, 8.0, 9.0, 10.0, 18.0)),
        switched("forces", "at the end of stage OA", forces=(A,)),
        switched("forces", "mean over 1 to 11 N", forces=every),
        switched("forces", "mean over stage OA", forces=tuple(F for F in every if A > F)),
        Reading(name="root mean square over 1 to 11 N", of="forces",
                inputs=lambda _q: {"forces": every, "rms": True}),
        switched("of_theory", "relative to the theoretical force", of_theory=True),
    )  # fmt: skip


def small_error(q: Mapping[str, Any]) -> float:
    """Relative difference [%] of Eq. 10 from the test force at the same displacement."""
    U = (q["F"] - q["c_test"]) / q["k_test"]
    by_fe = float(q["k"] * U + q["c"])
    return float(100 * abs(by_fe - q["F"]) / (by_fe if q["of_fe"] else q["F"]))


def _small() -> dict[str, Any]:
    return {"F": 1.0, "k": printed("k1-fea"), "c": printed("eq10-oa-intercept"),
            "k_test": printed("k1-test"), "c_test": 0.0, "of_fe": False}  # fmt: skip


def _small_readings() -> tuple[Reading, ...]:
    return (
        switched("F", "at 2 N", F=2.0),
        switched("c", "without the constant of Eq. 10", c=0.0),
        switched("c", "ten times the constant of Eq. 10", c=0.055),
        switched("k", "k_1 of the theory", k=printed("k1-theory")),
        switched("k", "k_2 of Eq. 10", k=printed("k2-fea")),
        switched("k_test", "k_2 of the tests", k_test=printed("k2-test")),
        switched("of_fe", "relative to the force of the finite elements", of_fe=True),
        *result()[:2],
    )


def _problem(name: str, **more: Any) -> Problem:
    return Problem(reference=f"wang2023:{name}", **more)


PROBLEMS = (
    _problem(
        "k1-theory", case="spring-accordion", what="stiffness k_1 by Eqs. 1 to 9 as printed",
        formula=energy_stiffness, inputs=lambda: spring() | LITERAL, readings=_stiffness_readings,
        errata=("eq-3-leaf-length", "eq-3-leaf-moment"), most=3,
    ),
    _problem(
        "arc-radius", case="spring-accordion",
        what="k_1 by Eqs. 1 to 9 on the centre line of the strip",
        formula=energy_stiffness, inputs=lambda: spring() | STATICS, readings=_arc_readings,
        derived=published("wang2023:k1-theory").printed, unit="N/mm", errata=("arc-radius",),
    ),
    _problem(
        "s-i-arc-angle", case="spring-accordion",
        what="k_1 by Eqs. 1 to 9 with semicircles at the ends",
        formula=energy_stiffness, readings=_end_readings,
        inputs=lambda: spring() | ADOPTED | {"head": SEMICIRCLE, "tail": SEMICIRCLE},
        derived=published("wang2023:k1-theory").printed, unit="N/mm",
        errata=("s-i-arc-angle", "eq-5-range"),
    ),
    *(
        _problem(
            f"{key}-fea", case="spring-stages", what=f"{key[0]}_{key[1]} by linear theory",
            formula=lambda q, key=key: staged(key, q),
            inputs=lambda: spring() | {"tail": "arc", "head": "free", "arcs": 0.0, "wide": 0.0},
            readings=_stage_readings, most=4,
        )
        for key in ("k1", "k2")
    ),
    _problem(
        "theory-fea-error-max", case="spring-map",
        what="error of the force k_1 U at 11 N, relative to Eq. 10",
        formula=force_error, readings=_error_readings,
        inputs=lambda: _eq_10() | {"k": printed("k1-theory"), "forces": (11.0,)},
        errata=("theory-error-six-percent",),
    ),
    _problem(
        "fea-test-error-small-compression", case="spring-stages",
        what="difference at 1 N between the force by Eq. 10 and a straight line through zero with "
        "the slope k_1 of the tests",
        formula=small_error, inputs=_small, readings=_small_readings,
        errata=("fea-error-small-compression",),
    ),
)  # fmt: skip
