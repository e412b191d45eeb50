"""Cards with the range of validity of each formula, by subject, each with its figure."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from markupsafe import Markup

from reports.formats import MINUS, decimal
from reports.measured import Measured
from reports.validity_map import validity_map
from verify.core.results import Validity, ValidityAxis, ValidityLimit, ValidityRegion

DRAWN_LIMIT = 1  # whose region is outlined
LEAST = 1e-6  # per cent, below which a number adds nothing


def subjects(known: Sequence[Validity]) -> list[tuple[str, list[Validity]]]:
    """Cases grouped by subject, in their order."""
    found: dict[str, list[Validity]] = {}
    for one in known:
        found.setdefault(one.subject, []).append(one)
    return list(found.items())


def figure(region: ValidityRegion, title: str) -> Markup:
    """Figure of the error over the varied inputs.

    Empty if each limit holds for all points or for none.
    """
    shape = [len(axis.values) for axis in region.axes]
    if not shape or not _left(region):
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


def _left(region: ValidityRegion) -> bool:
    """Whether a limit is met at some points and not at others."""
    mixed = any(max(one.inside, one.outside) < region.points for one in region.limits)
    return mixed and region.unsolved < region.points


def mapped(known: Sequence[Validity]) -> bool:
    """Whether one of the cards has a map, whose colours need a key."""
    return any(
        len(region.axes) > 1 and _left(region)
        for one in known for card in one.cards for region in card.regions
    )  # fmt: skip


def common(one: Validity) -> str:
    """Range that all cards of a case share; empty if ranges differ or there is only one card."""
    over = {region.over for card in one.cards for region in card.regions}
    alike = len(one.cards) > 1 and len(over) == 1
    return over.pop() if alike else ""


def limits(region: ValidityRegion) -> list[tuple[str, ValidityLimit]]:
    """Pairs of the name of a limit and the limit.

    Limits that are met at the same points share a name such as "2, 5".
    """
    found: list[tuple[str, ValidityLimit]] = []
    for one in region.limits:
        name = f"{100 * one.limit:g}"
        if found and replace(found[-1][1], limit=one.limit) == one:
            name = f"{found.pop()[0]}, {name}"
        found.append((name, one))
    return found


def signed(error: float | None, U: float | None) -> str:
    """Text of a relative error in per cent with its bar, such as "−1.2 ± 0.02 %"; a dash for None.

    A bar below a hundredth of the first digit of the error is printed with "<". If error and bar
    are below LEAST, only one "<" is printed.
    """
    if error is None:
        return "–"
    size = abs(100 * error)
    floor = max(LEAST, 10.0 ** (math.floor(math.log10(size)) - 2) if size else 0.0)
    sign = {True: MINUS, False: "+"}[error < 0] if error else ""
    text = f"<{decimal(LEAST, 2)}" if 0 < size < LEAST else f"{sign}{decimal(size, 2)}"
    if U is None or (size < LEAST and 100 * U < LEAST):
        return f"{text} %"
    bar = decimal(100 * U, 2) if floor <= 100 * U else f"<{decimal(floor, 2)}"
    return f"{text} ± {bar} %"


def _label(axis: ValidityAxis) -> str:
    return axis.symbol if axis.unit == "1" else f"{axis.symbol} [{axis.unit}]"
