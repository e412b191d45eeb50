"""Shells of the literature, and plates by their series."""

from math import pi, radians

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.panel import rectangle
from tests.fem.shell.grids import over

SYMMETRY = {"x": "xbc", "y": "yac", "z": "zab"}  # of planes across these axes


def test_the_pinched_hemisphere_yields_as_published():
    """0.0935 (Simo, Fox, Rifai 1989) with a hole of 18 deg; its rigid turns cost nothing."""

    def sphere(u, v):
        phi, lift = pi / 2 * u, radians(72) * v
        return 10 * np.cos(lift) * np.cos(phi), 10 * np.cos(lift) * np.sin(phi), 10 * np.sin(lift)

    grid = over(16, 16, sphere)
    pulled, pushed = int(grid.number[0, 0]), int(grid.number[-1, 0])
    s = solve_shell(
        grid.points, grid.cells, thickness=0.04, materials=Elastic(E=6.825e7, nu=0.3),
        boundaries=grid.boundaries,
        supports={"u=0": SYMMETRY["y"], "u=1": SYMMETRY["x"], pulled: "z"},
        loads={pulled: (1, 0, 0, 0, 0, 0), pushed: (0, -1, 0, 0, 0, 0)},
    )  # fmt: skip
    assert s.u[pulled, 0] == pytest.approx(0.0935, rel=2e-3)
    assert s.u[pushed, 1] == pytest.approx(-s.u[pulled, 0], rel=1e-9)


def plate(t, held, count=8):
    """Deflection of a quarter of a square plate in units of q a^4 / D; corner at the origin."""
    mesh = rectangle(length=0.5, width=0.5, along=count, across=count)
    steel = Elastic(E=1e9, nu=0.3)
    s = solve_shell(
        mesh.points, mesh.cells, thickness=t, materials=steel, boundaries=mesh.boundaries,
        pressures=-1.0,
        supports={"head": held["head"], "edge": held["edge"], "tail": "xbc", "middle": "zab"},
    )  # fmt: skip
    return s.u[mesh.nodes["tail"], 1] * steel.E * t**3 / (12 * (1 - steel.nu**2))


@pytest.mark.parametrize("t", [1e-2, 1e-4])
def test_a_clamped_square_plate_deflects_as_in_the_handbook_however_thin(t):
    """0.00126532 q a^4 / D (Timoshenko and Woinowsky-Krieger give 0.00126; series, thin)."""
    clamped = {"head": "xyzabc", "edge": "xyzabc"}
    # shear adds some 0.07 q a^2 / (5/6 G t) (the membrane's sag), that is 20 (t / a)^2 of it
    assert plate(t, clamped) == pytest.approx(0.00126532, rel=1e-4 + 30 * t**2)
