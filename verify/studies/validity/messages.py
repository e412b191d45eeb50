"""Texts for the numbers, ranges and axes of a measurement."""

from verify.core.figures import InputValue
from verify.studies.sweep.axes import Axis
from verify.studies.sweep.plan import Plan


def quantity(axis: Axis, value: float) -> str:
    """`value` [SI] as text in the unit of the axis: "3.2 mm"."""
    return f"{number(axis.in_unit(value))}{_unit(axis)}"


def number(value: float) -> str:
    """`value` as text with four significant digits; six for large numbers, without an exponent."""
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:,.6g}".replace(",", "")


def span(axis: Axis, low: float, high: float) -> str:
    """Text of the range from `low` to `high` [SI]: "δ_1 3 to 8 mm"; "z = 12" for a single value."""
    if low == high:
        return f"{axis.symbol} = {quantity(axis, low)}"
    return f"{axis.symbol} {_ends(axis, low, high)}"


def alone(axis: Axis, low: float, high: float) -> str:
    """Text of the range [SI] of one varied input: "T 5 to 15 N m (other inputs constant)"."""
    if low == high:
        return f"only {axis.symbol} = {quantity(axis, low)} (other inputs constant)"
    return f"{axis.symbol} {_ends(axis, low, high)} (other inputs constant)"


def between(axis: Axis, last: float, first: float) -> str:
    """Two neighbouring values [SI] as text, the smaller value first: "15 and 40 N m"."""
    low, high = sorted((last, first))
    return f"{number(axis.in_unit(low))} and {quantity(axis, high)}"


def near(axis: Axis, last: float, first: float, at: float) -> str:
    """Text of `at` [SI], rounded to two digits; empty if the rounded value is out of range."""
    low, high = sorted(axis.in_unit(v) for v in (last, first))
    about = float(f"{axis.in_unit(at):.2g}")
    return f" (at about {number(about)})" if low < about < high else ""


def over(plan: Plan) -> str:
    """Text of the varied inputs with ranges and numbers of values, and of the constant inputs."""
    parts = [f"{span(a, a.values[0], a.values[-1])} ({len(a.values)} values)" for a in plan.axes]
    constant = held(plan)
    return (
        ", ".join(parts) + ", one input varied at a time" * (plan.star and len(parts) > 1)
        + f", at {constant}" * bool(constant)
    )  # fmt: skip


def held(plan: Plan) -> str:
    """Text of the constant inputs that differ from the default: "e = 2 mm"."""
    return ", ".join(map(_value, constant(plan)))


def held_with_meaning(plan: Plan) -> str:
    """Text of the same inputs as `held`, with meanings: "e = 2 mm, distance of the contact ..."."""
    return "; ".join(f"{_value(one)}, {one.what}" for one in constant(plan))


def constant(plan: Plan) -> tuple[InputValue, ...]:
    """Constant inputs of a plan whose values differ from the default."""
    default, varied = plan.case.inputs(), {axis.name for axis in plan.axes}
    return tuple(
        one for one, usual in zip(plan.inputs.display(), default.display(), strict=True)
        if one.value != usual.value and one.name not in varied
    )  # fmt: skip


def _value(one: InputValue) -> str:
    return f"{one.symbol or one.name} = {number(float(one.value))} {one.unit}".removesuffix(" 1")


def _ends(axis: Axis, low: float, high: float) -> str:
    return f"{number(axis.in_unit(low))} to {quantity(axis, high)}"


def _unit(axis: Axis) -> str:
    return "" if axis.unit == "1" else f" {axis.unit}"
