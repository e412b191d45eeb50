"""What line contacts have of one level: values of the contact under its load, profiles, field."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from verify.case import Level
from verify.cases.contact.window import field
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.pressed_line import PressedLine

VIEW = 4.0  # half-widths about the contact whose cells are displayed
# x/a of the profile; the slope at the edge is infinite, and the last coarse cell errs most
STATIONS = np.linspace(0.0, 0.85, 18)


def result(
    found: "PressedLine", level: int, supports: tuple[str, ...],
    others: "Mapping[str, PressedLine] | None" = None,
) -> Level:  # fmt: skip
    """All of it, with the values of `others` by what follows their names, and profiles."""
    shear, depth = found.shear()
    values = found.values() | found.balance(supports) | {"tau_max": shear, "z": depth}
    u_it = {key: found.rounding(key, value) for key, value in values.items()}
    for where, other in (others or {}).items():
        for key, value in other.values().items():
            values[f"{key}{where}"] = value
            u_it[f"{key}{where}"] = other.rounding(key, value)
    touch, (x, _) = found.touch, found.load
    order, nodes = np.argsort(x), np.argsort(touch.x[0])
    profile = np.interp(STATIONS * found.guess, touch.x[0, nodes], touch.pressure[nodes])
    arrays = {"x": x[order], "p": touch.p[order], "weight": touch.weight[order],
              "profile": profile}  # fmt: skip
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=(near(found),))


def near(found: "PressedLine") -> Field:
    """Cells near the contact with their largest shear stress over the peak pressure."""
    from fem.plane.cell_fields import cut_out, largest_shear

    cells = cut_out(
        found.solution.plane.cells(),
        lambda centre: np.asarray(np.abs(centre).max(axis=1) < VIEW * found.a),
    )
    return field("contact", cells, {
        "shear": (largest_shear(cells["stress"]) / found.peak, "1"),
        "von_mises": (cells["von_mises"], "Pa"),
    })  # fmt: skip
