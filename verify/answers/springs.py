"""Criteria and design stiffness of the accordion spring."""

import math
from typing import Any

from analytic.spring import column, energy, frame
from analytic.spring.wide_leaf import width_factor
from verify.answers.answer import Quantity
from verify.answers.assessment import Assessment
from verify.answers.strengths import strip_strength
from verify.core.case import Values

FREE_STAGE = 0.47  # of the free length, where the leaves of the paper's spring touch (Wang 2023)
LARGEST_STROKE = 0.6  # of the free length (Eq. 12)
CRITICAL = {
    "F_cr": "tail clamped at the end of the arc",
    "F_cr_mid_leaf": "tail clamped at mid-leaf",
    "column_F": "Haringx's column",
}
NO_FORCE = "no working force F is given: neither stress nor deflection is checked"


def free_stage(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of the free stage: bending stress and deflection.

    The design value is the stiffness.
    """
    leaf = (q.L1 + 2 * q.R * math.cos(q.alpha)) / math.sin(q.alpha)
    f = float(width_factor(q.h, leaf, nu=q.nu))
    k = f * v["k"]
    part.design = Quantity(
        key="stiffness", symbol="k", value=k, unit="N/mm",
        what=f"stiffness: true centre line, widened strip (factor {f:.4g}), head free",
    )  # fmt: skip
    if q.F is None:
        part.unknowns.append(NO_FORCE)
        return
    bending_stress(q, q.F, part)
    _deflection(q.F / k, v["L0"], part)
    _guide(q, part)


def stages(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of both stages: bending stress, and the deflection at which leaves first touch."""
    if q.F is None:
        part.unknowns.append(NO_FORCE)
        return
    bending_stress(q, q.F, part)
    part.at_most("deflection", "deflection under F", v["U_w"], v["U_A"], "mm",
                 "the leaves touch beyond it (linear theory)")  # fmt: skip


def curve(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of the curve: bending stress at the stroke, and the largest stroke by Eq. 12.

    The design value is the force at the stroke, by two straight lines.
    """
    U_A = v.get("U_A", math.inf)
    U = min(q.stroke, U_A)
    force = v["k1"] * U + (v["k2"] * (q.stroke - U) if "k2" in v else 0.0)
    part.design = Quantity(
        key="force_at_stroke", symbol="F(U_max)", value=force, unit="N",
        what="force at the stroke by two straight lines (k_1, then k_2); `check --fem --out "
        "FOLDER` draws the curve",
    )  # fmt: skip
    if "stroke" in part.assumed:
        part.unknowns.append(
            "no stroke is given: the force is computed at 0.6 L_0, the largest stroke of Eq. 12"
        )
        return
    bending_stress(q, force, part)
    L0 = float(frame.free_length(n=q.n, b=q.b, r=q.r, L1=q.L1, alpha=q.alpha))
    part.at_most("stroke", "stroke", q.stroke, LARGEST_STROKE * L0, "mm", "0.6 L_0 (Eq. 12)")


def compared(_q: Any, _v: Values, part: Assessment) -> None:
    """Adds no criterion, because a comparison of formulas has no working force."""
    part.unknowns.append(
        "this case compares formulas and has no working force: spring-accordion checks stress and "
        "deflection"
    )


def buckling(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of buckling: the working force must not exceed the smallest critical force.

    The critical force is that of a spring with a free head.
    """
    if q.F is None:
        part.unknowns.append("no working force F is given: it is not compared with F_cr")
        return
    estimates = {key: v[key] for key in CRITICAL if key in v}
    if not estimates:
        part.remarks.append("the spring is too short to buckle")
        return
    key = min(estimates, key=estimates.__getitem__)
    part.at_most("force", "working force", q.F, estimates[key], "N",
                 f"buckling with a free head, the smallest estimate: {CRITICAL[key]}")  # fmt: skip


def bending_stress(q: Any, F: float, part: Assessment) -> None:
    """Add the criterion for the largest bending stress in the loops under the force `F` [N]."""
    stress = float(energy.bending_stress(F=F, b=q.b, h=q.h, r=q.r, L1=q.L1))
    strength = strip_strength(getattr(q, "R_p", None), q.E)
    option = "give R_p" if hasattr(q, "R_p") else "case spring-accordion accepts R_p"
    part.stress("bending_stress", f"bending stress under {F:.4g} N", stress, strength, option)


def _guide(q: Any, part: Assessment) -> None:
    """Add a remark if the spring, with a free head, buckles below its working force."""
    strip = {"b": q.b, "h": q.h, "E": q.E, "nu": q.nu}
    F = float(column.critical_force("free", **q.path, **strip))
    if q.F >= F:  # nan where it never buckles
        part.remarks.append(
            f"the head needs a guide: with a free head the spring buckles at {F:.3g} N "
            "(Haringx's column; case spring-buckling)"
        )


def _deflection(U: float, L0: float, part: Assessment) -> None:
    part.at_most("deflection", "deflection under F", U, LARGEST_STROKE * L0, "mm",
                 "0.6 L_0 (Eq. 12)")  # fmt: skip
    if FREE_STAGE * L0 < U <= LARGEST_STROKE * L0:
        part.unknowns.append(
            f"a deflection of {100 * U / L0:.0f} % of L_0 may be beyond the free stage, which "
            f"ended at {100 * FREE_STAGE:.0f} % for the paper's spring: case spring-curve computes "
            "the whole curve"
        )
