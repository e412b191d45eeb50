"""The barrel roof against a series of its own: Fourier along the axis, polynomials around it."""

from math import pi, radians

import numpy as np
import pytest
from numpy.polynomial import legendre

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from tests.fem.shell.grids import over

R, LENGTH, T, ANGLE = 25.0, 50.0, 0.25, radians(40)
Q = 90.0
HARMONICS, DEGREE = 12, 60  # 6 digits


def part(E, nu, k):
    """Energy, and sinking of the free edge in the middle, of the k-th cosine of the load.

    Displacements w (outwards), v (around), u (along the axis) and the rotations a, b of the normal
    towards v and u: w, v, a go with cos(λz), u and b with sin(λz). Strains of a cylinder with
    shear, after Sanders: the surface's rotation about its normal is part of the twist.
    """
    x, weight = legendre.leggauss(2 * DEGREE)
    s, ds = x * R * ANGLE, weight * R * ANGLE
    values = legendre.legvander(x, DEGREE)
    slopes = np.stack(
        [legendre.legval(x, legendre.legder(row)) for row in np.eye(DEGREE + 1)], axis=-1
    ) / (R * ANGLE)
    even, odd = np.arange(0, DEGREE + 1, 2), np.arange(1, DEGREE + 1, 2)
    degrees = {"w": even, "v": odd, "u": even, "a": odd, "b": even}
    ends = np.cumsum([0, *map(len, degrees.values())])
    place = {name: slice(*ends[i : i + 2]) for i, name in enumerate(degrees)}

    def strain(**terms):
        """Of factors of the unknowns, those of their slopes around being called w_, v_ ..."""
        row = np.zeros((len(x), ends[-1]))
        for term, factor in terms.items():
            name = term[0]
            row[:, place[name]] += factor * (slopes if term[1:] else values)[:, degrees[name]]
        return row

    def energy(one, other):
        return (one * ds[:, None]).T @ other

    def plate(one, other, shear):
        cross = energy(one, other)
        both = energy(one, one) + energy(other, other) + nu * (cross + cross.T)
        return E / (1 - nu**2) * both + G * energy(shear, shear)

    L, G = k * pi / LENGTH, E / (2 * (1 + nu))
    membrane = plate(strain(v_=1, w=1 / R), strain(u=L), strain(u_=1, v=-L))
    twist = strain(a=-L, b_=1, u_=-1 / (2 * R), v=-L / (2 * R))
    bending = plate(strain(a_=1), strain(b=L), twist)
    around, along = strain(w_=1, v=-1 / R, a=1), strain(w=-L, b=1)
    shear = 5 / 6 * G * (energy(around, around) + energy(along, along))
    amplitude = 4 / (k * pi) * (-1) ** (k // 2) * Q
    down = -strain(w=1) * np.cos(s / R)[:, None] + strain(v=1) * np.sin(s / R)[:, None]
    load = amplitude * down.T @ ds
    moved = np.linalg.solve(T * (membrane + shear) + T**3 / 12 * bending, load)
    edge = np.zeros(ends[-1])  # every Legendre polynomial is 1 there
    edge[place["w"]], edge[place["v"]] = -np.cos(ANGLE), np.sin(ANGLE)
    return -load @ moved / 2 * LENGTH / 8, edge @ moved  # of a quarter, where cos^2 means 1/2


def solve_roof(E, nu, count):
    """A quarter, with cells that shrink to the free edge and the diaphragm."""

    def surface(u, v):
        phi, z = ANGLE * (1 - (1 - u) ** 2), LENGTH / 2 * (1 - (1 - v) ** 2)
        return R * np.sin(phi), R * np.cos(phi), z

    grid = over(count, count, surface)
    s = solve_shell(
        grid.points, grid.cells, thickness=T, materials=Elastic(E=E, nu=nu),
        boundaries=grid.boundaries, surface_loads=(0, -Q, 0),
        supports={"v=1": "xyc", "u=0": "xbc", "v=0": "zab"},
    )  # fmt: skip
    return s.potential_energy, -s.u[grid.number[-1, 0], 1]


@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_the_barrel_roof_sinks_as_its_series(nu):
    E = 4.32e8
    series = np.sum([part(E, nu, k) for k in range(1, 2 * HARMONICS, 2)], axis=0)
    np.testing.assert_allclose(solve_roof(E, nu, 16), series, rtol=2e-4)
