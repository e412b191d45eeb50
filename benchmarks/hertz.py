"""The contact of the benchmark: two equal discs, a quarter of each, pressed by a given load.

The load is distributed over the mid-plane of the upper disc as in a disc under two opposite forces
(Timoshenko and Goodier, art. 41). The mid-plane then remains plane, and p_0, the half-width a and
the approach of the centres have closed-form values. At a/R = 0.01, the values of Hertz differ from
those of the disc by 3e-5.
"""

from functools import partial

import numpy as np
from numpy.typing import NDArray
from skfem.mesh import Mesh2D

from analytic.contact.disc import disc_under_load
from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.contact.solution import ContactSolution
from fem.plane.material import Assumption, Elastic
from meshes.contact.disc import half_disc, quarter_disc
from meshes.join import join

Array = NDArray[np.float64]

R = 10e-3  # m
A = 0.01 * R  # Hertz's half-width
ZONE = 1.5 * A
CELLS = (24, 20)  # in the fine zones of both discs: a/h = 16 and 13, non-matching meshes
STEEL = Elastic(E=210e9, nu=0.3)
ASSUMPTION: Assumption = "plane strain"
E_PLANE = STEEL.E / (1 - STEEL.nu**2)
LOAD = np.pi * (E_PLANE / 2) * A**2 / (4 * R / 2)  # N/m of the whole discs, by Hertz
EXACT = disc_under_load(P=LOAD, R=R, E_plane=E_PLANE)
MU = 0.3


def discs(cells: tuple[int, int] = CELLS, refine: int = 1, *, whole: bool = False) -> Mesh2D:
    """Mesh of the upper disc on the lower disc; quarters, or halves if `whole`."""
    shape = half_disc if whole else quarter_disc
    return join({
        "upper": shape(R=R, zone=ZONE, cells=cells[0], refine=refine),
        "lower": shape(R=R, zone=ZONE, cells=cells[1], refine=refine, below=True),
    })  # fmt: skip


def contact(friction: float = 0.0) -> Pair:
    """The contact of both arcs as exact circles: parabolic cell sides do not affect the gap."""
    return Pair(
        slave="upper.surface", master="lower.surface", friction=friction,
        slave_shape=Circle((0.0, R), R), master_shape=Circle((0.0, -R), R),
    )  # fmt: skip


def pressed(mesh: Mesh2D) -> ContactProblem:
    """Problem of the quarters; the upper is free to approach."""
    return ContactProblem(
        mesh, materials=STEEL, assumption=ASSUMPTION, contacts=[contact()],
        supports={"upper.axis": "x", "lower.axis": "x", "lower.middle": "y"},
    )  # fmt: skip


def sheared(mesh: Mesh2D) -> ContactProblem:
    """Problem of the halves with friction, both supported along their mid-planes."""
    return ContactProblem(
        mesh, materials=STEEL, assumption=ASSUMPTION, contacts=[contact(MU)],
        supports={"upper.middle": "xy", "lower.middle": "xy"},
    )  # fmt: skip


def on_middle(x: Array, share: float = 1.0) -> Array:
    """Pressure on the mid-plane y = R of the upper disc at `x` (2, ...) for a share of the load."""
    return np.asarray(share * LOAD / (np.pi * R) * (4 / (1 + (x[0] / R) ** 2) ** 2 - 1))


def solve_pressed(problem: ContactProblem, share: float = 1.0) -> ContactSolution:
    """The quarters under the load."""
    return problem.solve(pressures={"upper.middle": partial(on_middle, share=share)})


def errors(*, peak: float, moment: float, force: float, approach: float) -> dict[str, float]:
    """Relative errors of p_0, a, the load and the approach of both centres.

    `force` and `moment` are those of the pressure on half the contact, about the middle of the
    contact: for an elliptic pressure, a = 3 pi/4 moment/force.
    """
    return {
        "p_0": peak / EXACT.p_0 - 1,
        "a": 3 * np.pi / 4 * moment / force / _first_moment_width() - 1,
        "load": 2 * force / LOAD - 1,
        "approach": approach / (2 * EXACT.approach) - 1,
    }


def own_errors(solution: ContactSolution) -> dict[str, float]:
    """Relative errors of the solution of this project."""
    touch = solution.touches[0]
    middle = int(np.argmin(np.abs(touch.x[0])))
    return errors(
        peak=float(touch.pressure[middle]),
        moment=abs(touch.moment()),
        force=abs(touch.force[1]),
        approach=-solution.plane.displacement_at((0.0, R))[1],
    )


def _first_moment_width() -> float:
    """The half-width from force and moment of the exact pressure of the disc."""
    g, w = np.polynomial.legendre.leggauss(200)
    x = EXACT.a * (1 + g) / 2
    q = w * EXACT.pressure(x)
    return float(3 * np.pi / 4 * (q @ x) / q.sum())
