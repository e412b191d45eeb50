"""A hollow sphere under pressure against its closed form, up to the axis.

An error counts as one of the solver as soon as it stops falling at the element's own rate.
"""

from functools import cache

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import degree, mapped, order

R_I, R_O = 0.04, 0.06  # [m]
P_I, P_O = 90e6, 20e6  # [Pa]
STEEL = Elastic(E=210e9, nu=0.3)
E, NU = STEEL.E, STEEL.nu
SPREAD = 0.25  # of an observed order over two halvings


def rms(samples, *off):
    return np.sqrt(samples.mean(sum(d**2 for d in off)))


def of_sphere(R):
    """Displacement, radial and tangential stress (Timoshenko & Goodier, art. 136)."""
    a = (P_I * R_I**3 - P_O * R_O**3) / (R_O**3 - R_I**3)
    b = (P_I - P_O) * R_I**3 * R_O**3 / (R_O**3 - R_I**3)
    radial, tangential = a - b / R**3, a + b / (2 * R**3)
    return R * ((1 - NU) * tangential - NU * radial) / E, radial, tangential


@pytest.mark.parametrize("kind", ["tri3", "quad9"])
def test_a_sphere_under_pressure_converges_to_lame_up_to_the_axis(kind):
    def place(s, t):  # waved inside
        inside = np.sin(np.pi * s) * np.sin(np.pi * t)
        R, polar = R_I + (R_O - R_I) * (s + 0.05 * inside), np.pi / 2 * (1 - t + 0.1 * inside)
        return R * np.sin(polar), R * np.cos(polar)

    @cache
    def sphere(through):
        """The upper half, from the pole on the axis down to the equator."""
        grid = [np.linspace(0, 1, n + 1) for n in (through, 4 * through)]
        return solve_plane(
            mapped(kind, *grid, place, ("bore", "rim", "bottom", "top")),
            materials=STEEL, assumption="axisymmetric",
            supports={"bottom": "y"}, pressures={"bore": P_I, "rim": P_O},
        )  # fmt: skip

    (u_i, *_), (u_o, *_) = of_sphere(R_I), of_sphere(R_O)
    work = np.pi * (P_I * R_I**2 * u_i - P_O * R_O**2 * u_o)

    def stressed(s):
        inside = s.in_body()
        _, radial, meridional, shear = inside.polar()
        _, expected, tangential = of_sphere(np.hypot(*inside.x))
        hoop = inside.stress[3] - tangential
        return rms(inside, radial - expected, meridional - tangential, shear, hoop)

    def on_axis(s):
        axis = s.on_boundary("top")
        _, radial, tangential = of_sphere(axis.x[1])
        xx, yy, _, zz = axis.stress
        return rms(axis, xx - tangential, zz - tangential, yy - radial)

    k, meshes = degree(kind), (4, 8, 16)
    energy = order(lambda s: s.strain_energy / work - 1, sphere, meshes)
    assert energy == pytest.approx(2 * k, abs=SPREAD)
    assert order(stressed, sphere, meshes) == pytest.approx(k, abs=SPREAD)
    assert order(on_axis, sphere, meshes) == pytest.approx(k, abs=SPREAD)
