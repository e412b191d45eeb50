"""The problem of the benchmark: a quarter of a thick ring under internal pressure, plane strain."""

from dataclasses import replace
from typing import Literal

import numpy as np
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2
from skfem.mesh import Mesh2D

from fem.plane.material import Assumption, Elastic
from fem.plane.solution import PlaneSolution
from fem.plane.solve import solve_plane

Kind = Literal["triangles", "quadrilaterals"]
R_I, R_O = 0.02, 0.06  # m
PRESSURE = 100e6  # Pa
STEEL = Elastic(E=210e9, nu=0.3)
ASSUMPTION: Assumption = "plane strain"
RIM = (R_O, 0.0)
# Lamé: u(r_o) = 2 (1 - nu^2) p r_i^2 r_o / (E (r_o^2 - r_i^2)) in plane strain
RIM_MOVES = 2 * (1 - STEEL.nu**2) * PRESSURE * R_I**2 * R_O / (STEEL.E * (R_O**2 - R_I**2))


def ring_mesh(kind: Kind, around: int) -> Mesh2D:
    """Quadratic cells with curved edges, `around` along the quarter, nearly square."""
    straight, curved = (
        (MeshTri1, MeshTri2) if kind == "triangles" else (MeshQuad1, MeshQuad2)
    )  # fmt: skip
    across = max(1, round(around * np.log(R_O / R_I) / (np.pi / 2)))
    grid = straight.init_tensor(np.linspace(0, 1, across + 1), np.linspace(0, 1, around + 1))
    mesh = curved.from_mesh(grid)
    depth, turn = mesh.doflocs
    r, phi = R_I * (R_O / R_I) ** depth, np.pi / 2 * turn
    middle = grid.p[:, grid.facets].mean(axis=1)
    sides = {"bore": (0, 0), "rim": (0, 1), "y=0": (1, 0), "x=0": (1, 1)}
    named = {name: np.flatnonzero(middle[axis] == at) for name, (axis, at) in sides.items()}
    places = np.array([r * np.cos(phi), r * np.sin(phi)])
    return replace(mesh, doflocs=places).with_boundaries(named)


def solve_ring(mesh: Mesh2D) -> PlaneSolution:
    """Solution of the ring on `mesh`."""
    return solve_plane(
        mesh, materials=STEEL, assumption=ASSUMPTION, supports={"x=0": "x", "y=0": "y"},
        pressures={"bore": PRESSURE},
    )  # fmt: skip
