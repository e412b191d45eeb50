"""One pitch of the roller freewheel of the benchmark: star, roller, ring; friction at both races.

In the mesh, the roller overlaps both races. The rotations of star and ring are such that the
solved centre of the roller coincides with that of the mesh. Forces, torque, half-widths, pressures
and the centre of the roller are compared with those of a mesh six times as fine.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from skfem.mesh import Mesh2D

from fem.contact.problem import ContactProblem
from fem.contact.solution import ContactSolution
from fem.wedge.flat import flat_problem
from verify.cases.freewheel.fem import fem_mesh, overlapping
from verify.cases.freewheel.star import Star

Array = NDArray[np.float64]
Point = tuple[float, float]

CLUTCH = Star()
OVERLAP = 20e-6  # m, overlap of each contact: 51 N m for a length of 10 mm
PLACE = overlapping(CLUTCH, OVERLAP, OVERLAP)
CENTRE = (PLACE.x, PLACE.y)
WIDTHS = (0.1235e-3, 0.1341e-3)  # m, computed half-widths
TURNED = (1.2536e-6, 0.6598e-6)  # m, displacements of the surfaces of star and ring: no rolling
TILT, ROTATION = TURNED[0] / CLUTCH.X, TURNED[1] / CLUTCH.R  # rad, clockwise
CELLS = 6  # number of cells in 1.5 half-widths
FINE = 6 * CELLS  # number of cells of the reference
MU = 0.15
JUDGED = {  # names of the values in tables
    "T": "torque [N m]", "N_i": "N, star [N/m]", "N_o": "N, ring [N/m]",
    "F_i": "F_t, star [N/m]", "F_o": "F_t, ring [N/m]", "a_i": "half-width, star [m]",
    "a_o": "half-width, ring [m]", "p_i": "peak, star [Pa]", "p_o": "peak, ring [Pa]",
    "centre": "roller's centre",
}  # fmt: skip


def pitch(cells: int = CELLS) -> Mesh2D:
    """Mesh of star, roller and ring with `cells` cells on each half of the fine zones."""
    return fem_mesh(PLACE, WIDTHS, cells)


def posed(mesh: Mesh2D) -> ContactProblem:
    return flat_problem(PLACE, mesh, MU)


def turned(problem: ContactProblem) -> ContactSolution:
    """Solution with prescribed rotation of the bore and mean rotation of the rim."""
    moved: Any = {
        "ring.rim": {"r": -ROTATION},
        "star.bore": {"x": lambda x: TILT * x[1], "y": lambda x: -TILT * x[0]},
    }
    return problem.solve(displacements=moved)


def found(solution: ContactSolution) -> dict[str, float]:
    """Compared quantities of the solution of this project."""
    inner, outer = solution.touches
    return values(
        torque=-solution.plane.mean_reaction("ring.rim")["r"],
        forces=(inner.force, outer.force),
        centre=solution.plane.displacement_at(CENTRE),
        widths=(inner.half_width(), outer.half_width()),
        peaks=(inner.peak, outer.peak),
    )


def values(
    *, torque: float, forces: tuple[Point, Point], centre: Point, widths: Point, peaks: Point
) -> dict[str, float]:
    """Quantities of one pitch: forces (x, y) on star and ring, displacement of the centre."""
    (x, y), (x_o, y_o) = forces
    psi = math.atan2(CENTRE[0] + centre[0], CENTRE[1] + centre[1])
    c, s = math.cos(TILT), math.sin(TILT)
    c_o, s_o = math.cos(psi), math.sin(psi)
    return {
        "T": CLUTCH.z * CLUTCH.L * torque,
        "N_i": -s * x - c * y, "F_i": -c * x + s * y,
        "N_o": s_o * x_o + c_o * y_o, "F_o": s_o * y_o - c_o * x_o,
        "a_i": widths[0], "a_o": widths[1], "p_i": peaks[0], "p_o": peaks[1],
        "u_x": centre[0], "u_y": centre[1],
    }  # fmt: skip


def errors(one: dict[str, float], other: dict[str, float]) -> dict[str, float]:
    """Relative differences of the compared quantities; of the centre, relative to both overlaps."""
    apart = math.hypot(one["u_x"] - other["u_x"], one["u_y"] - other["u_y"])
    same = {name: one[name] / other[name] - 1 for name in JUDGED if name != "centre"}
    return same | {"centre": apart / (2 * OVERLAP)}


def worst(found: dict[str, float]) -> float:
    return max(map(abs, found.values()))
