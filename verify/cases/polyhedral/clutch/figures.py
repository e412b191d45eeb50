"""Figure of the whole clutch: torques by formulas and finite elements."""

from collections.abc import Iterator
from math import isfinite

from verify.cases.polyhedral.clutch.comparisons import ClutchFormulas
from verify.core.case import Context
from verify.core.figures import Dots

FORMULAS = {
    "M_21": "Eq. 21, first design", "M_20": "Eq. 20",
    "M_rigid": "elastic ring, rigid rollers, series", "M_el": "elastic ring and rollers, series",
}  # fmt: skip
SOLVED = {"M_rigid": "elastic ring, rigid rollers, FE", "M_el": "elastic ring and rollers, FE"}


def torques(q: ClutchFormulas, context: Context) -> Iterator[Dots]:
    """Figure of torques by formulas and finite elements; none if pressure does not limit them."""
    values = {key: getattr(q, key) for key in FORMULAS}
    items: list[tuple[str, float, float | None, str]] = [
        (FORMULAS[key], value, None, "formula") for key, value in values.items() if isfinite(value)
    ]
    found = context.fem[-1].values if items and context.fem else {}
    items += [(name, found[key], None, "fe") for key, name in SOLVED.items() if key in found]
    if items:
        yield Dots(
            title="Torque under the pressure p_t", label="M_t [N m]", items=tuple(items),
            note="Eqs. 20 and 21 assign the whole blocking pressure to the rollers. In fact, the "
            "hoop force of the ring balances a part of this pressure, and the rollers deform.",
        )  # fmt: skip
