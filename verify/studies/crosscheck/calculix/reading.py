"""Readers of calculix results: fields at nodes from the .frd file, tables from the .dat file."""

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def displacements(frd: Path) -> Array:
    """Displacements (nodes, 2) in the order of the node numbers, with six digits."""
    return nodal(frd, "DISP")[:, :2]


def nodal(frd: Path, name: str) -> Array:
    """Components (nodes, n) of a field in the last increment, in the order of the node numbers."""
    return fields(frd, name)[-1]


def fields(frd: Path, name: str) -> list[Array]:
    """Components (nodes, n) of a field in each increment.

    Raises LookupError if the file does not contain the field.
    """
    found: list[list[list[float]]] = []
    inside = False
    for line in frd.read_text("ascii").splitlines():
        if line.startswith(" -4"):
            inside = line.split()[1] == name
            if inside:
                found.append([])
        elif inside and line.startswith(" -1"):
            found[-1].append([float(line[i : i + 12]) for i in range(13, len(line.rstrip()), 12)])
        elif line.startswith(" -3"):
            inside = False
    if not found:
        raise LookupError(f"{frd.name} has no field {name}")
    return [np.array(rows) for rows in found]


def blocks(dat: Path, title: str) -> list[Array]:
    """Tables (rows, columns) of numbers under each heading that begins with `title`.

    Raises LookupError if the file contains no such table.
    """
    text = dat.read_text("ascii")
    heads = re.findall(rf" {title}[^\n]*\n\s*\n((?:[ ]+[-+.\dE]+[^\n]*\n)+)", text)
    if not heads:
        raise LookupError(f"{dat.name} has no table of {title}")
    return [np.array([[float(x) for x in row.split()] for row in h.splitlines()]) for h in heads]


def contact_totals(dat: Path, pairs: int = 1) -> Array:
    """Contact forces x, y, z and moments x, y, z about the origin (pairs, 6), last increment.

    They act on the slave surfaces.
    """
    return np.array([rows[0] for rows in blocks(dat, "total surface force")[-pairs:]])


def contact_areas(dat: Path, pairs: int = 1) -> Array:
    """Contact areas (pairs,) in the last increment."""
    return np.array([rows[0, 0] for rows in _headed(dat, "area,")[-pairs:]])


def strain_energy(dat: Path) -> float:
    """Strain energy of all elements in the last increment."""
    return float(blocks(dat, "total internal energy")[-1][0, 0])


def buckling_factors(dat: Path) -> Array:
    """Factors on the loads of a buckling step, in ascending order.

    Raises LookupError if the file contains no factors.
    """
    found = re.findall(r"BUCKLING\s+FACTOR\s*\n\s*\n((?:\s+\d+\s+\S+\n)+)", dat.read_text("ascii"))
    if not found:
        raise LookupError(f"{dat.name} has no buckling factors")
    return np.array([float(row.split()[1]) for row in found[-1].splitlines()])


def iterations(sta: Path) -> int:
    """Total number of iterations in all increments."""
    rows = (row.split() for row in sta.read_text("ascii").splitlines())
    return sum(int(row[3]) for row in rows if len(row) > 6 and row[0].isdigit())


def _headed(dat: Path, title: str) -> list[Array]:
    """The row of numbers under each heading that contains `title`."""
    found = re.findall(rf"{title}[^\n]*\n\s*\n\s*([^\n]*)", dat.read_text("ascii"))
    return [np.array([[float(word) for word in row.split()]]) for row in found]
