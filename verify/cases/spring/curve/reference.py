"""Solutions of case spring-curve: curve, variants of contact and friction, readings, limits."""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from verify.case import Level
from verify.cases.spring.curve.fem import Spring, fem_compress
from verify.cases.spring.curve.inputs import CurveInputs
from verify.core.figures import Array

LEVELS = (4, 6, 8)  # cells of an arc and of a leaf
COARSE, READINGS, FINE = LEVELS
GRID = 68  # states over the stroke on the finest mesh
HALF, QUARTER = GRID // 2, GRID // 4  # on the coarse mesh, and of its variants and the readings
FIRST = 1e-6  # over the stroke, for the initial stiffness
TIMES = (0.1, 10.0)  # the contact's usual stiffness
BACK = (14, 10, 6)  # indices of the variants' states, unloading
BEYOND = np.arange(1, 41) * 0.006  # steps beyond the stroke, over the stroke
ROUND_OFF = 1e-9
THIN = (0.01, 0.005, 0.002, 0.001)  # r over L_1, towards parallel leaves
THIN_UNITS, THIN_SLOPE, THIN_CELLS = 10, 1.5, (2, 3)
THIN_GRID = (10.0, 14.0, 15.6, 16.0)  # displacements over the radius of the loops


def spring_of(q: CurveInputs, **changed: Any) -> Spring:
    """Model of the spring of the inputs; keyword arguments replace values for a reading."""
    own: dict[str, Any] = {
        "line": q.path, "b": q.b, "h": q.h, "E": q.E, "nu": q.nu, "factor": q.width_factor,
        "head": q.head, "tail": q.tail, "mu": q.mu,
    }  # fmt: skip
    return Spring(**own | changed)


def readings(q: CurveInputs) -> Iterator[tuple[str, Spring]]:
    """Names and models of all readings of tail, head and arcs, without friction or width factor."""
    arcs = {"r": q.r, "r + b/2": q.r + q.b / 2}
    for tail, head, (name, radius) in product(
        ("arc", "mid-leaf"), ("free", "guided"), arcs.items()
    ):
        changed = {"line": q.path | {"radius": radius}, "head": head, "tail": tail}
        yield f"{tail}, {head}, {name}", spring_of(q, factor=1.0, mu=0.0, **changed)


def grid(q: CurveInputs, states: int) -> Array:
    """Equidistant displacements [m] up to the stroke, shape (states,)."""
    return np.linspace(0, q.stroke, states + 1)[1:]


def solve(q: CurveInputs, level: int) -> Level:
    """Initial stiffness on a level.

    Level COARSE also has the coarse curve and its variants, level READINGS the readings of the
    paper, and level FINE the fine curve.
    """
    own = spring_of(q)
    rest = fem_compress(own, [FIRST * q.stroke, 2 * FIRST * q.stroke], per_arc=level)
    once, twice = rest.F / rest.U
    k0 = float(2 * once - twice)  # secants tend to it evenly
    arrays: dict[str, Any] = {}
    if level == COARSE:
        curve = fem_compress(own, grid(q, HALF), per_arc=level)
        arrays = curve.arrays(f"curve {level}") | _variants(q)
    if level == READINGS and q.is_paper:
        arrays = _read(q)
    if level == FINE:
        beyond = (q.stroke * (1 + BEYOND)).tolist()
        curve = fem_compress(own, grid(q, GRID), per_arc=level, beyond=beyond)
        arrays = curve.arrays(f"curve {level}") | {"rest": rest.shapes[0, rest.nodes]}
    return Level(h=1 / level, values={"k1": k0}, u_it={"k1": ROUND_OFF * k0}, arrays=arrays)


def _variants(q: CurveInputs) -> dict[str, Any]:
    """Curves on the coarse mesh: other contact stiffnesses, and unloading without friction."""
    there, found = grid(q, QUARTER), {}
    for times in TIMES:
        varied = fem_compress(spring_of(q), there, per_arc=COARSE, times=times)
        found[f"contact {times:g}"] = varied.forces
    both_ways = np.append(there, there[np.array(BACK) - 1])
    slippery = fem_compress(spring_of(q, mu=0.0), both_ways, per_arc=COARSE)
    return found | {"there and back": slippery.forces}


def _read(q: CurveInputs) -> dict[str, Any]:
    """Curves of the readings, and first contacts for increasingly slender leaves."""
    held, found = grid(q, QUARTER), {}
    for name, spring in readings(q):
        within = held if spring.head != "free" else held[:1]  # it buckles soon after
        found[f"reading {name}"] = fem_compress(spring, within, per_arc=COARSE).forces
    limit = [[thin_fem(q, share, cells) for share in THIN] for cells in THIN_CELLS]
    return found | {"thin": np.array(limit)}


def thin(q: CurveInputs, share: float) -> Spring:
    """Guided spring with loops of radius `share` L_1 and leaf slopes proportional to `share`.

    For small `share` all angles are of this order, and linear theory becomes exact.
    """
    radius = share * q.L1
    line = {"n": THIN_UNITS, "L1": q.L1, "radius": radius, "alpha": np.pi / 2 - THIN_SLOPE * share}
    return Spring(line=line, b=0.2 * radius, h=q.h, E=q.E, nu=q.nu, factor=1.0, head="guided",
                  tail="mid-leaf")  # fmt: skip


def thin_fem(q: CurveInputs, share: float, cells: int) -> tuple[float, float, float]:
    """First contact of the tips: displacement [m], force [N], and the stiffness beyond it [N/m]."""
    from fem.beam.two_lines import onset

    spring = thin(q, share)
    curve = fem_compress(spring, spring.line["radius"] * np.array(THIN_GRID), per_arc=cells)
    return onset(*curve.forces[:, -2:])
