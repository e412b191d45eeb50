"""Functions that write the keywords of a calculix deck; nodes and elements count from 1."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TextIO

import numpy as np
from numpy.typing import NDArray

from fem.plane.material import Elastic

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Term = tuple[int, int, float]  # node, component from 1, factor
Side = tuple[int, int]  # element and its side, both from 1
A_LINE = 14  # numbers of nodes in a line of *ELEMENT, of the 16 that are read


def nodes(deck: TextIO, number: Indices, x: Array, name: str = "") -> None:
    """Write nodes at `x` (nodes, 2 or 3).

    calculix reads 20 characters of a number, including the exponent.
    """
    deck.write("*NODE" + (f", NSET={name}" if name else "") + "\n")
    space = np.column_stack([x, np.zeros((len(x), 3 - x.shape[1]))])
    np.savetxt(deck, np.column_stack([number, space]), fmt="%d,%.12e,%.12e,%.12e")


def elements(deck: TextIO, kind: str, name: str, cells: Indices, number: Indices) -> None:
    """Write `cells` (elements, nodes) of one kind as an element set, with the numbers `number`."""
    deck.write(f"*ELEMENT, TYPE={kind}, ELSET={name}\n")
    for label, cell in zip(number.tolist(), cells.astype(str).tolist(), strict=True):
        rows = [cell[i : i + A_LINE] for i in range(0, len(cell), A_LINE)]
        deck.write(f"{label}," + ",\n".join(",".join(row) for row in rows) + "\n")


def solid(deck: TextIO, name: str, material: Elastic, thickness: float = 1.0) -> None:
    """Write the material and the section of a set of solid elements."""
    _elastic(deck, name, material)
    deck.write(f"*SOLID SECTION, ELSET={name}, MATERIAL={name}\n{thickness:.12e}\n")


def dense(deck: TextIO, name: str, material: Elastic, rho: float, thickness: float = 1.0) -> None:
    """Write the material with a density, and the section of a set of solid elements."""
    _elastic(deck, name, material)
    deck.write(f"*DENSITY\n{rho:.12e}\n")
    deck.write(f"*SOLID SECTION, ELSET={name}, MATERIAL={name}\n{thickness:.12e}\n")


def shell(deck: TextIO, name: str, material: Elastic, thickness: float) -> None:
    """Write the material and the section of a set of shell elements."""
    _elastic(deck, name, material)
    deck.write(f"*SHELL SECTION, ELSET={name}, MATERIAL={name}\n{thickness:.12e}\n")


def _elastic(deck: TextIO, name: str, material: Elastic) -> None:
    deck.write(f"*MATERIAL, NAME={name}\n*ELASTIC\n{material.E:.12e},{material.nu:.12e}\n")


def node_set(deck: TextIO, name: str, number: Iterable[int]) -> None:
    deck.write(f"*NSET, NSET={name}\n" + "".join(f"{i},\n" for i in number))


def boundary(deck: TextIO, held: Iterable[Term]) -> None:
    """Write prescribed displacements, each as node, component and value."""
    rows = [f"{node},{i},{i},{value:.12e}\n" for node, i, value in held]
    if rows:
        deck.write("*BOUNDARY\n" + "".join(rows))


def equation(deck: TextIO, terms: Sequence[Term]) -> None:
    """Write an equation: the sum of `terms` is zero.

    calculix eliminates the first term, and reads four terms per line.
    """
    entries = [f"{node},{component},{factor:.12e}" for node, component, factor in terms]
    rows = [",".join(entries[i : i + 4]) for i in range(0, len(entries), 4)]
    deck.write("*EQUATION\n" + "\n".join([str(len(terms)), *rows, ""]))


def forces(deck: TextIO, loads: Iterable[Term]) -> None:
    """Write forces of constant direction on nodes."""
    rows = [f"{node},{i},{value:.12e}\n" for node, i, value in loads]
    if rows:
        deck.write("*CLOAD\n" + "".join(rows))


def pressures(deck: TextIO, sides: Iterable[Side], pressure: float) -> None:
    """Write the same pressure on sides of elements; calculix integrates it."""
    deck.write("*DLOAD\n" + "".join(f"{cell},P{side},{pressure:.12e}\n" for cell, side in sides))


def surfaces(deck: TextIO, sides: Mapping[str, Iterable[Side]]) -> None:
    for name, own in sides.items():
        deck.write(f"*SURFACE, NAME={name}\n")
        deck.writelines(f"{cell},S{side}\n" for cell, side in own)


def interaction(deck: TextIO, name: str, slope: float, mu: float = 0.0, stick: float = 0.0) -> None:
    """Write a contact law: pressure is `slope` times overlap, friction has the slope `stick`."""
    deck.write(f"*SURFACE INTERACTION, NAME={name}\n*SURFACE BEHAVIOR, ")
    deck.write(f"PRESSURE-OVERCLOSURE=LINEAR\n{slope:.12e}\n")
    if mu:
        deck.write(f"*FRICTION\n{mu!r},{stick:.12e}\n")


def contact_pair(
    deck: TextIO, slave: str, master: str, name: str, pairing: str = "SURFACE TO SURFACE"
) -> None:
    deck.write(f"*CONTACT PAIR, INTERACTION={name}, TYPE={pairing}\n{slave},{master}\n")
