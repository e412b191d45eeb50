"""Rollers and a sphere on a half-space, compared with tamaas on the same grids."""

import json
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.half_space import pressed
from verify.cases.contact.roller.inputs import EVEN
from verify.cases.contact.roller.profiles import even_crowns, gap
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.sphere.case import Spheres
from verify.core.figures import Array
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.statement import TAMAAS, Cross, Numbers, Posed, Quantity

LEVEL = 4  # of the cases' grids
CELLS, REACH = 128, 1.3  # of a sphere's grid, across and over the contact's radius
TOLERANCE, LIMIT = 1e-12, 20_000  # of tamaas
ALIKE = 1e-6
AT_MIDDLE, TOP = "pressure at mid-length", "largest pressure outside the end zones d"
END = (
    "Hertz's pressure for the line load averaged over the more loaded end zone d: strips and "
    "half-space agree within 3%"
)
READ = {"mid": "p_mid", "peak": "p_max", "end pressure": "p_d", "q mid": "q_mid",
        "largest": "p_largest"}  # fmt: skip
GRID = (
    "same grid and same influence coefficients (Love); the differences are due to the tolerances "
    "at which the iterations of both solvers stop"
)


def roller(case: Any, crown: Callable[[Any], Callable[[Array], Array]] = gap) -> Posed:
    """Problem of a roller on the half-space; `crown` is by default the crown of the case."""
    q: Any = case.inputs()
    found, _ = timed(lambda: pressed(q, LEVEL, crown=crown(q)))
    own = found.contact.contact
    shape = own.x[:, None] ** 2 / (2 * q.R) + np.asarray(crown(q)(own.y))
    _, seconds = timed(lambda: press(shape, own.cell, q.E_star, q.F))

    def read(pressure: Array) -> Numbers:
        there = replace(found.contact, contact=replace(own, pressure=pressure))
        values = replace(found, contact=there).values
        return {name: values[key] for name, key in READ.items()}

    question = asked(shape, own.cell, q.E_star, q.F)
    return posed(question, read(own.pressure), seconds, read)


def even(name: str) -> Callable[[Any], Callable[[Array], Array]]:
    """Function of a roller's inputs that returns the crown `name`, designed for even pressure."""
    return lambda q: even_crowns(q)[name]


def sphere() -> Posed:
    """A sphere on a half-space, with the materials of the case."""
    q = Spheres()
    R, a = q.hertz["R"], q.width
    E_star = 3 * q.P * R / (4 * a**3)
    side = 2 * REACH * a / CELLS
    x = (np.arange(CELLS) + 0.5 - CELLS / 2) * side
    shape = (x[:, None] ** 2 + x**2) / (2 * R)
    own, seconds = timed(lambda: press(shape, (side, side), E_star, q.P))

    def read(pressure: Array) -> Numbers:
        r2 = x[:, None] ** 2 + x**2
        return {
            "largest": float(pressure.max()),
            "a": float(np.sqrt(2.5 * (pressure * r2).sum() / pressure.sum())),
        }

    question = asked(shape, (side, side), E_star, q.P)
    return posed(question, read(own.pressure), seconds, read)


def press(shape: Array, cell: tuple[float, float], E_star: float, load: float) -> Any:
    from analytic.contact import half_space

    return half_space.press_half_space(
        shape, cell=cell, E_star=E_star, load=load, tolerance=TOLERANCE
    )


def asked(
    shape: Array, cell: tuple[float, float], E_star: float, load: float
) -> dict[str, Any]:  # fmt: skip
    """Input data for the script that runs tamaas."""
    return {
        "gap": shape.tolist(), "cell": list(cell), "E_star": E_star, "load": load,
        "tolerance": TOLERANCE, "limit": LIMIT,
    }  # fmt: skip


def posed(
    question: Mapping[str, Any], ours: Numbers, seconds: float, read: Callable[[Array], Numbers]
) -> Posed:
    def write(folder: Path) -> Path:
        path = folder / "deck.json"
        path.write_text(json.dumps(question), "utf-8")
        return path

    def answered(deck: Path) -> Numbers:
        there = json.loads(deck.with_suffix(".answer.json").read_text("utf-8"))
        return read(np.array(there["pressure"]))

    size = int(np.size(question["gap"]))
    return Posed(ours=ours, seconds=seconds, unknowns=size, write=write, read=answered)


def quantity(name: str, symbol: str, unit: str, row: str = "") -> Quantity:
    return Quantity(name=name, symbol=symbol, unit=unit, row=row, allowed=ALIKE, why=GRID)


HALF_SPACES = (
    *(
        Cross(
            id=case.id, case=case.id, solver=TAMAAS,
            what=f"{case.title}, as a contact of half-spaces",
            pose=partial(roller, case),
            quantities=(
                quantity("mid", "p", "MPa", mid), quantity("largest", "p", "MPa", top),
                quantity("end pressure", "p_d", "MPa", END), quantity("q mid", "q", "N/mm"),
            ),
        )
        for case, mid, top in (
            (ROLLER, f"{AT_MIDDLE}, strips", f"{TOP}, strips"), (TILTED, "", f"{TOP}, strips"),
            (UNCROWNED, f"{AT_MIDDLE}, slices", ""),
        )
    ),
    *(
        Cross(
            id=f"contact-roller-crowns, {name}", case="contact-roller-crowns", solver=TAMAAS,
            what=f"a roller with {EVEN[name]} on a half-space",
            pose=partial(roller, CROWNS, even(name)),
            quantities=(
                quantity("mid", "p", "MPa", f"{AT_MIDDLE}, {EVEN[name]}"),
                quantity("largest", "p", "MPa"), quantity("q mid", "q", "N/mm"),
            ),
        )
        for name in EVEN
    ),
    Cross(
        id="contact-sphere, half-space", case="contact-sphere", solver=TAMAAS,
        what="a sphere on a half-space, with the contact modulus of the case", pose=sphere,
        quantities=(
            quantity("largest", "p_0", "MPa", "peak pressure, contact on a sphere"),
            quantity("a", "a", "mm", "contact radius, contact on a sphere"),
        ),
    ),
)  # fmt: skip
