"""The cards that say where each formula may be used: grouped by subject, each with its figure."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from markupsafe import Markup

from reports.formats import MINUS
from reports.measured import Measured
from reports.validity_map import validity_map
from verify.results import Validity, ValidityAxis, ValidityLimit, ValidityRegion

DRAWN_LIMIT = 1  # whose region is outlined


def subjects(known: Sequence[Validity]) -> list[tuple[str, list[Validity]]]:
    """The cases under the name of their subject, in their order."""
    found: dict[str, list[Validity]] = {}
    for one in known:
        found.setdefault(one.subject, []).append(one)
    return list(found.items())


def figure(region: ValidityRegion, title: str) -> Markup:
    """The error over what was measured; nothing where each limit holds for all points or none."""
    shape = [len(axis.values) for axis in region.axes]
    mixed = any(max(one.inside, one.outside) < region.points for one in region.limits)
    if not shape or not mixed or region.unsolved == region.points:
        return Markup("")
    x, *rest = region.axes
    y = rest[0] if rest else None
    limit = region.limits[DRAWN_LIMIT]
    box = {name: (low, high) for name, low, high in limit.box}
    nominal = tuple(axis.nominal for axis in region.axes if axis.nominal is not None)
    return validity_map(Measured(
        title=title, x=np.array(x.values), x_label=_label(x),
        y=None if y is None else np.array(y.values), y_label="" if y is None else _label(y),
        error=np.array(region.error).reshape(shape), U=np.array(region.U).reshape(shape),
        limits=tuple(one.limit for one in region.limits),
        nominal=nominal if len(nominal) == len(region.axes) else None,
        box=None if y is None or len(box) < 2 else (box[x.name], box[y.name]),
        log=tuple(axis.log for axis in region.axes) + (False,) * (2 - len(shape)),
    ))  # fmt: skip


def limits(region: ValidityRegion) -> list[tuple[str, ValidityLimit]]:
    """The limits as one reads them, "2, 5", those that hold the same points together."""
    found: list[tuple[str, ValidityLimit]] = []
    for one in region.limits:
        name = f"{100 * one.limit:g}"
        if found and replace(found[-1][1], limit=one.limit) == one:
            name = f"{found.pop()[0]}, {name}"
        found.append((name, one))
    return found


def signed(error: float | None, U: float | None) -> str:
    """A relative error in per cent with its bar: "−1.23 ± 0.02 %"; a dash where there is none."""
    if error is None:
        return "–"
    if U is None:
        return f"{_percent(error)} %"
    return f"{_percent(error)} ± {_digits(100 * U)} %"


def _percent(error: float) -> str:
    text = _digits(100 * error)
    return text if text.startswith(MINUS) else f"+{text}"


def _digits(value: float) -> str:
    """Two significant digits, all of a larger number's."""
    text = f"{value:.0f}" if abs(value) >= 10 else np.format_float_positional(
        value, precision=2, fractional=False, trim="-"
    )  # fmt: skip
    return text.replace("-", MINUS)


def _label(axis: ValidityAxis) -> str:
    return axis.symbol if axis.unit == "1" else f"{axis.symbol} [{axis.unit}]"
