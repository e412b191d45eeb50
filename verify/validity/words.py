"""Numbers, ranges and axes of a measurement in words."""

from verify.sweep.axes import Axis
from verify.sweep.plan import Plan


def quantity(axis: Axis, value: float) -> str:
    """A value [SI] of the axis with its unit: "3.2 mm"."""
    return f"{number(axis.shown(value))}{_unit(axis)}"


def number(value: float) -> str:
    """Four significant digits, no exponent before six figures."""
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:,.6g}".replace(",", "")


def span(axis: Axis, low: float, high: float) -> str:
    """From one value [SI] to another: "δ_1 3 to 8 mm", "z = 12" for one alone."""
    if low == high:
        return f"{axis.symbol} = {quantity(axis, low)}"
    ends = (number(axis.shown(v)) for v in (low, high))
    return f"{axis.symbol} {' to '.join(ends)}{_unit(axis)}"


def over(plan: Plan) -> str:
    """What was varied, over which ranges and with how many values each, and what was held where."""
    parts = [f"{span(a, a.values[0], a.values[-1])} ({len(a.values)} values)" for a in plan.axes]
    own, varied = plan.case.inputs(), {axis.name for axis in plan.axes}
    held = [
        f"{shown.symbol or shown.name} = {number(float(shown.value))} {shown.unit}".removesuffix(
            " 1"
        )
        for shown, usual in zip(plan.inputs.display(), own.display(), strict=True)
        if shown.value != usual.value and shown.name not in varied
    ]
    return (
        ", ".join(parts) + ", one at a time" * (plan.star and len(parts) > 1)
        + f", at {', '.join(held)}" * bool(held)
    )  # fmt: skip


def _unit(axis: Axis) -> str:
    return "" if axis.unit == "1" else f" {axis.unit}"
