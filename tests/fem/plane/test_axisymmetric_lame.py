"""Bodies of revolution against closed forms: cylinders, and spheres up to the axis.

An error counts as one of the solver as soon as it stops falling at the element's own rate.
"""

from functools import cache

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import degree, mapped, order

R_I, R_O, LENGTH = 0.04, 0.06, 0.03  # [m], the radii of the spheres, too
P_I, P_O = 90e6, 20e6  # [Pa]
STEEL = Elastic(E=210e9, nu=0.3)
E, NU = STEEL.E, STEEL.nu
SPREAD = 0.25  # of an observed order over two halvings
NAMES = ("bore", "rim", "bottom", "top")


def waved(kind, through, along, place):
    """Cells over (0, 1) x (0, 1), waved inside and put in their `place`."""

    def put(s, t):
        inside = np.sin(np.pi * s) * np.sin(np.pi * t)
        return place(s + 0.05 * inside, t - 0.1 * inside)

    unit = [np.linspace(0, 1, n + 1) for n in (through, along)]
    return mapped(kind, *unit, put, NAMES)


def rms(samples, *off):
    return np.sqrt(samples.mean(sum(d**2 for d in off)))


def of_cylinder(r, ends):
    """Displacement, radial, hoop and axial stress, axial strain (Timoshenko & Goodier, art. 28)."""
    a = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
    b = (P_I - P_O) * R_I**2 * R_O**2 / (R_O**2 - R_I**2)
    radial, hoop = a - b / r**2, a + b / r**2
    axial = {"held": 2 * NU * a, "closed": a}[ends] + 0 * r
    return r * (hoop - NU * (radial + axial)) / E, radial, hoop, axial, (axial - 2 * NU * a) / E


@pytest.mark.parametrize(
    ("kind", "ends"),
    [("tri3", "held"), ("tri6", "closed"), ("quad4", "closed"), ("quad9", "held"),
     ("quad9, straight", "closed")],
)  # fmt: skip
def test_a_cylinder_under_pressure_converges_to_lame(kind, ends):
    @cache
    def cylinder(through):
        mesh = waved(kind, through, 2 * through, lambda s, t: (R_I + (R_O - R_I) * s, LENGTH * t))
        axial = (P_I * R_I**2 - P_O * R_O**2) / (R_O**2 - R_I**2)
        return solve_plane(
            mesh, materials=STEEL, assumption="axisymmetric", degree=degree(kind),
            supports={"bottom": "y"} | ({"top": "y"} if ends == "held" else {}),
            pressures={"bore": P_I, "rim": P_O},
            tractions={"top": (0.0, axial)} if ends == "closed" else {},
        )  # fmt: skip

    (u_i, *_), (u_o, *_, axial, strain) = of_cylinder(R_I, ends), of_cylinder(R_O, ends)
    work = 2 * np.pi * LENGTH * (P_I * R_I * u_i - P_O * R_O * u_o)
    if ends == "closed":
        work += np.pi * (R_O**2 - R_I**2) * LENGTH * axial * strain

    def moved(s):
        inside = s.in_body()
        u, *_, strain = of_cylinder(inside.x[0], ends)
        return rms(inside, inside.u[0] - u, inside.u[1] - strain * inside.x[1])

    def stressed(s):
        inside = s.in_body()
        _, radial, hoop, axial, _ = of_cylinder(inside.x[0], ends)
        xx, yy, xy, zz = inside.stress
        return rms(inside, xx - radial, yy - axial, xy, zz - hoop)

    k, meshes = degree(kind), (4, 8, 16)
    energy = order(lambda s: 2 * s.strain_energy / work - 1, cylinder, meshes)
    assert energy == pytest.approx(2 * k, abs=SPREAD)
    assert order(moved, cylinder, meshes) == pytest.approx(k + 1, abs=SPREAD)
    assert order(stressed, cylinder, meshes) == pytest.approx(k, abs=SPREAD)


def of_sphere(R):
    """Displacement, radial and tangential stress (Timoshenko & Goodier, art. 136)."""
    a = (P_I * R_I**3 - P_O * R_O**3) / (R_O**3 - R_I**3)
    b = (P_I - P_O) * R_I**3 * R_O**3 / (R_O**3 - R_I**3)
    radial, tangential = a - b / R**3, a + b / (2 * R**3)
    return R * ((1 - NU) * tangential - NU * radial) / E, radial, tangential


@pytest.mark.parametrize("kind", ["tri3", "quad9"])
def test_a_sphere_under_pressure_converges_to_lame_up_to_the_axis(kind):
    def place(s, t):
        R, polar = R_I + (R_O - R_I) * s, np.pi / 2 * (1 - t)
        return R * np.sin(polar), R * np.cos(polar)

    @cache
    def sphere(through):
        """The upper half, from the pole on the axis down to the equator."""
        return solve_plane(
            waved(kind, through, 4 * through, place), materials=STEEL, assumption="axisymmetric",
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
