"""Struts of a sprag clutch between two rigid hubs, compared with springs of calculix."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.rotor.clutch.case import CLUTCH
from verify.cases.rotor.clutch.reference import struts_fem
from verify.core.figures import Array
from verify.studies.crosscheck.clock import timed
from verify.studies.crosscheck.statement import CALCULIX, Cross, Posed, Quantity

if TYPE_CHECKING:
    from fem.rotor.struts import Joint

SLICES = 8  # of a sprag
TABLE = 200  # points of the law, straight in between
WIDE = 0.9  # of the shortening under T, up to which the law is tabulated on either side
BACK = -4e-3  # rad, the twist of the last step: a tenth of the torque less
CENTRE, TURN = 1, 2  # nodes of the inner hub: its position, and its rotation
LAW = (
    "calculix contains the same force law as a table; differences are due to the table, to six "
    "printed digits and to the residuals of Newton's method"
)
ALIKE = 1e-5


def struts() -> Posed:
    """Inner hub of a clutch, displaced and tilted, then rotated by an angle that reduces torque."""
    q: Any = CLUTCH.inputs()
    rest = struts_fem(q).pinned(SLICES)
    moves = np.zeros((2, 6))
    moves[:, [0, 4]], moves[1, 5] = (q.e, 2 * q.e / q.L), BACK

    def solve() -> Array:
        return np.array([rest.moved(move).loads()[[0, 4, 5]] for move in moves])

    loads, seconds = timed(solve)
    return Posed(
        ours=named(loads), seconds=seconds, unknowns=6,
        write=lambda folder: written(rest, moves, folder / "deck.inp"),
        read=lambda deck: named(holding(deck)),
    )  # fmt: skip


def named(loads: Array) -> dict[str, float]:
    """Numbers of a comparison (name: value) from F_x, M_y and M_z of both steps, (2, 3)."""
    return {
        f"{name}{words}": float(value)
        for row, words in zip(loads, ("", ", back"), strict=True)
        for name, value in zip(("F_x", "M_y", "M_z"), row, strict=True)
    }


def written(rest: "Joint", moves: Array, path: Path) -> Path:
    """Write the deck: a nonlinear spring for each strut between fixed nodes and the inner hub.

    The force law of the springs is a table. An additional spring on a separate node gives calculix
    an unknown, because all displacements of the hub are prescribed.
    """
    from fem.rotor.struts_kinds import Pinned
    from verify.studies.crosscheck.calculix import keywords

    ends = rest.struts
    assert isinstance(ends, Pinned)
    count, s_0 = len(ends.a), float(np.max(ends.s_0))
    inner, outer = np.arange(count) + TURN + 1, np.arange(count) + TURN + 1 + count
    shortened = s_0 * np.linspace(1 + WIDE, 1 - WIDE, TABLE)
    with path.open("w", encoding="ascii") as deck:
        keywords.nodes(deck, np.array([CENTRE, TURN]), np.zeros((2, 3)))
        keywords.nodes(deck, inner, ends.a, "INNER")
        keywords.nodes(deck, outer, ends.b)
        cells = np.column_stack([inner, outer])
        keywords.elements(deck, "SPRINGA", "STRUTS", cells, np.arange(1, count + 1))
        deck.write("*SPRING, ELSET=STRUTS, NONLINEAR\n\n")
        for s, force in zip(shortened, rest.law(shortened)[0], strict=True):
            deck.write(f"{-force:.12e},{s_0 - s:.12e}\n")
        deck.write(f"*RIGID BODY, NSET=INNER, REF NODE={CENTRE}, ROT NODE={TURN}\n")
        loose = int(outer[-1]) + 1
        keywords.nodes(deck, np.array([loose]), np.zeros((1, 3)))
        deck.write(f"*ELEMENT, TYPE=SPRING1, ELSET=LOOSE\n{count + 1},{loose}\n")
        deck.write("*SPRING, ELSET=LOOSE\n1\n1.\n")
        held = [(int(i), k, 0.0) for i in outer for k in (1, 2, 3)]
        keywords.boundary(deck, [*held, (loose, 2, 0.0), (loose, 3, 0.0)])
        for name, node in (("CENTRE", CENTRE), ("TURN", TURN)):
            keywords.node_set(deck, name, [node])
        for move in moves:
            deck.write("*STEP, NLGEOM, INC=1000\n*STATIC\n1.,1.\n")
            keywords.boundary(deck, [
                (node, k + 1, move[first + k])
                for node, first in ((CENTRE, 0), (TURN, 3)) for k in range(3)
            ])  # fmt: skip
            keywords.forces(deck, [(loose, 1, 1.0)])
            deck.writelines(
                f"*NODE PRINT, NSET={name}, FREQUENCY=1000\nRF\n" for name in ("CENTRE", "TURN")
            )
            deck.write("*END STEP\n")
    return path


def holding(deck: Path) -> Array:
    """Lateral force, tilting moment and torque (2, 3) of both steps, from calculix's tables."""
    from verify.studies.crosscheck.calculix.reading import blocks

    centre, turn = (
        np.array(blocks(deck.with_suffix(".dat"), "forces")).reshape(2, 2, 4).swapaxes(0, 1)
    )
    return np.column_stack([centre[:, 1], turn[:, 2:]])


def quantity(name: str, symbol: str, unit: str, row: str = "") -> Quantity:
    return Quantity(name=name, symbol=symbol, unit=unit, allowed=ALIKE, why=LAW, row=row,
                    beside=bool(row))  # fmt: skip


STRUTS = (
    Cross(
        id="rotor-clutch", case="rotor-clutch", solver=CALCULIX,
        what="struts between two rigid hubs; the outer hub is fixed; the inner hub is displaced "
        "and tilted, and then rotated about the axis by a small angle that reduces the torque",
        pose=struts,
        quantities=(
            quantity("F_x", "F_x", "N", "stiffness along x, sprags pinned to both races"),
            quantity("M_y", "M_y", "N m"),
            quantity("M_z", "M_z", "N m", "balance of torque, sprags pinned to both races"),
            quantity("F_x, back", "F_x", "N"),
            quantity("M_y, back", "M_y", "N m"),
            quantity("M_z, back", "M_z", "N m",
                     "torsional stiffness, sprags pinned to both races"),
        ),
    ),
)  # fmt: skip
