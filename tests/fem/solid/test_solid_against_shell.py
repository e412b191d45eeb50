"""A folded strip as a solid and as a shell: two elements that share no kinematics.

Each over its own plane stress, so that what the shell leaves out, (b/R)^2 on the arcs, divides out
but for a few 1e-4.
"""

from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from fem.solid.solve import solve_solid
from meshes.shell.strip import swept_path
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

E, NU, B, R = 206e3, 0.3, 0.1, 0.5  # the paper's spring [N/mm^2, mm]
LOOP = (
    Piece("leaf", 0.0, 0.0, pi / 2, 5.0, 0.0, 1),
    Piece("arc", 0.0, 5.0, pi / 2, R * pi / 2, -pi / 2, 1),
    Piece("arc", R, 5.0 + R, 0.0, R * pi / 2, -pi / 2, 1),
    Piece("leaf", 2 * R, 5.0, -pi / 2, 5.0, 0.0, 1),
)
CELLS = {"per_arc": 6, "per_leaf": 16}
PLANE_STRESS = Elastic(E=E * (1 + 2 * NU) / (1 + NU) ** 2, nu=NU / (1 + NU))  # in plane strain


def as_solid(path, width, material, *, held, across):
    """Stiffness along x of the strip, its head guided and moved as one, its tail clamped."""
    x, y = path[-1].end
    mesh = solid_strip(path, b=B, width=width, through=1, across=across, grading=100.0, **CELLS)

    def shear(centre, force):
        def traction(p):
            t = force / (B * width) * 1.5 * (1 - (2 * (p[0] - centre) / B) ** 2)
            return np.array([t, 0 * t, 0 * t])

        return traction

    edge = {"edge": "z"} if held else {}
    solved = solve_solid(
        mesh, materials=material, points=(2, 3, 3), uniform={(0.0, 0.0, None): "x"},
        supports={
            "middle": "z", "head": "y", "tail": "y", (x, y, None): "x" if held else "xz", **edge
        },
        tractions={"head": shear(0.0, 1.0), "tail": shear(x, -1.0)},
    )  # fmt: skip
    return -1 / (2 * solved.potential_energy)


def as_shell(path, width, material, *, held, across):
    mesh = swept_path(path, width=width, across=across, finest=0.05, **CELLS)
    edge = {"edge": "zab"} if held else {}
    solved = solve_shell(
        mesh.points, mesh.cells, thickness=B, materials=material, boundaries=mesh.boundaries,
        supports={"middle": "zab", "head": "yac", "tail": "xyzabc", **edge}, ties={"head": "x"},
        edge_loads={"head": (1 / width, 0.0, 0.0)},
    )  # fmt: skip
    return -1 / (2 * solved.potential_energy)


def test_width_stiffens_solid_and_shell_alike():
    path, within, half = LOOP, 1e-3, 5.0
    factors = []
    for stiffness in (as_solid, as_shell):
        flat = stiffness(path, 1.0, PLANE_STRESS, held=True, across=1)
        wide = stiffness(path, half, Elastic(E=E, nu=NU), held=False, across=12)
        factors.append(wide / half / flat)
    assert factors[0] > 1.02
    assert factors[0] == pytest.approx(factors[1], rel=within)
