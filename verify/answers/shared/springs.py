"""Assumptions that formula and reference share: accordion spring."""

import math
from collections.abc import Mapping
from typing import Any

from analytic.spring import frame
from analytic.spring.wide_leaf import width_factor
from verify.answers.shared.record import Function, SharedReading, Values, ratio

SAME = 1e-3  # of the bending stiffness

SMALL = SharedReading(
    assumption="displacements are small",
    part="the spring works at displacements of up to half its free length",
    quantity="the force at such a displacement",
    source="not quantified here; force k_1 U is +4.9 % too large at 30 % of the length "
    "(case spring-map, paper's inputs)",
)  # fmt: skip


HEAD = SharedReading(
    assumption="the head is guided without friction",
    part="its roller has friction in the slot",
    quantity="the force",
    source="not quantified; the force on loading is too small",
)


def leaf_length(q: Any) -> float:
    """Straight length [m] of a middle leaf between its arcs."""
    R = q.r + q.b / 2
    return float((q.L1 + 2 * R * math.cos(q.alpha)) / math.sin(q.alpha))


def wide(q: Any, quantity: str, given: float = 1.0) -> tuple[SharedReading, ...]:
    """Shared assumption about the bending stiffness of a strip of width h.

    `given` is the factor of the bending stiffness in formula and reference. The result is empty if
    this factor agrees with that of a plate of width h within `SAME`.
    """
    factor = float(width_factor(q.h, leaf_length(q), nu=q.nu))
    if abs(given / factor - 1) < SAME:
        return ()
    taken = "E I, as for a narrow strip" if given == 1 else f"{given:.5g} E I"
    return (
        SharedReading(
            assumption=f"the bending stiffness is {taken}",
            part=f"the strip is {q.h / q.b:.3g} times as wide as thick, which suppresses "
            "anticlastic bending",
            quantity=quantity, effect=given / factor - 1, source="theory of a leaf as a plate",
        ),
    )  # fmt: skip


def _radius(q: Any, quantity: str, effect: float | None) -> SharedReading:
    return SharedReading(
        assumption=f"the arcs' centre line has the radius r = {q.r * 1e3:.4g} mm",
        part="r is the inner radius: the centre line has "
        f"r + b/2 = {(q.r + q.b / 2) * 1e3:.4g} mm",
        quantity=quantity, effect=effect, source="the same frame with r + b/2",
    )  # fmt: skip


def _accordion(q: Any, v: Values) -> tuple[SharedReading, ...]:
    quantity = "k_1 (the design value k is corrected for it)"
    return (_radius(q, quantity, ratio(v, "k1", "k")), *wide(q, quantity), SMALL)


def _continuum(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (*wide(q, "k of the rows in plane stress"), SMALL)


def _stages(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        *wide(q, "k_1", q.factor), SMALL,
        SharedReading(
            assumption="leaves touch without friction", part="friction acts between the leaves",
            quantity="k_2",
        ),
        HEAD,
    )  # fmt: skip


def _width(_q: Any, _v: Values) -> tuple[SharedReading, ...]:
    return (
        SMALL,
        SharedReading(
            assumption="the tail is clamped rigidly over its whole width",
            part="clamp and roller deflect", quantity="k_1",
            source="not quantified; k_1 is too large",
        ),
    )  # fmt: skip


def _curve(q: Any, v: Values) -> tuple[SharedReading, ...]:
    found = [*wide(q, "k_1", q.factor), HEAD]
    if q.arcs == "r":
        section = {"b": q.b, "h": q.h, "E": q.E, "nu": q.nu}
        part = frame.stiffness(
            n=q.n, L1=q.L1, radius=q.r + q.b / 2, alpha=q.alpha, **section, head=q.head,
            tail=q.tail, theory="shear",
        )  # fmt: skip
        found.insert(0, _radius(q, "k_1", float(v["k1"] / (q.factor * part) - 1)))
    return tuple(found)


def _buckling(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        *wide(q, "the buckling force F_cr"),
        SharedReading(
            assumption="the spring has no imperfections", quantity="the buckling force F_cr",
            part="leaves and load deviate from their nominal positions by some hundredths of a "
                 "millimetre",
            source="not quantified; F_cr is too large",
        ),
    )  # fmt: skip


def _map(q: Any, _: Values) -> tuple[SharedReading, ...]:
    return (
        *wide(q, "all forces"),
        SharedReading(
            assumption="leaves do not touch", quantity="the force at 60 % of the length",
            part="the leaves of the paper's spring touch from about 55 % of the length on",
        ),
    )  # fmt: skip


SPRINGS: Mapping[str, Function] = {
    "spring-accordion": _accordion,
    "spring-continuum": _continuum,
    "spring-stages": _stages,
    "spring-width": _width,
    "spring-curve": _curve,
    "spring-buckling": _buckling,
    "spring-map": _map,
}
