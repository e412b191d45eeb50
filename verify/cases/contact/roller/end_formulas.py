"""What a half-space says of the ends of a roller, and how sharp the edge of a face is."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from analytic.contact.edge import edge_exponent
from analytic.contact.half_space_roller import press_roller
from verify.cases.contact.roller.end_fem import CROWNS, EndInputs
from verify.core.case import Values
from verify.core.figures import Array

HALF_SPACE = (64, 512)


def profile(q: EndInputs, crown: str) -> Callable[[Array], Array]:
    """The gap along the roller, with its crown or none."""
    return q.gap if crown == "crowned" else np.zeros_like


def analytic(q: EndInputs) -> Values:
    found: dict[str, float] = {
        "F": q.F, "edge": edge_exponent(np.pi / 2), "less sharp": -edge_exponent(np.pi / 2),
        "one": 1.0, "R": q.R, "E*": q.E_star,
        "Hertz p0": math.sqrt(q.F / q.L * q.E_star / (np.pi * q.R)), "Hertz b": q.b,
    }  # fmt: skip
    for crown in CROWNS:
        contact = on_half_space(q, crown)
        line = contact.line_load
        found |= {
            f"{crown} mid": contact.mid_pressure,
            f"{crown} q mid": float((line[(len(line) - 1) // 2] + line[len(line) // 2]) / 2),
            f"{crown} ends": sum(contact.end_load(q.d)),
            f"{crown} share": sum(contact.end_load(q.d)) / q.F,
        }
    return found


def on_half_space(q: EndInputs, crown: str) -> Any:
    """The roller on a half-space, which knows no end face."""
    return press_roller(
        profile(q, crown), R=q.R, length=q.L, E_star=q.E_star, load=q.F, cells=HALF_SPACE
    )
