"""Contact of two bodies of revolution against Hertz, Lamé, a half-space and symmetries."""

from functools import cache

import numpy as np
import pytest
from skfem import MeshQuad1

from fem.fourier.compliance import harmonics, surface_compliance
from fem.fourier.contact import PatchContact, patch_contact
from fem.fourier.shrunk import edge_slope, shrink_pressure
from fem.fourier.solid import FourierSolid
from fem.fourier.unilateral import push_together
from fem.plane.material import Elastic
from meshes.revolution.cylinder import half_cylinder
from meshes.revolution.section import stations

STEEL = Elastic(E=206.0, nu=0.3)
GUIDED = {"start": "z", "end": "z"}
HALF = {"start": "z"}


def modulus(*materials):
    return 1 / sum((1 - m.nu**2) / m.E for m in materials)


def body(mesh, z, cell, material=STEEL, supports=HALF, boundary="rim", growth=1.5):
    """Compliance of a surface whose pressures vary over cells of the arc length `cell`."""
    R = mesh.p[0].max()
    return surface_compliance(
        FourierSolid(mesh, material, supports, degree=2), boundary, stations=z,
        orders=harmonics(places=2, highest=2 * np.pi * R / cell, growth=growth),
    )  # fmt: skip


def hertz(bodies, q):
    """Half width and pressure under the line load q."""
    E = 1 / sum(b.softness for b in bodies)
    a = np.sqrt(4 * q / (np.pi * E * sum(b.curvature for b in bodies)))
    return a, 2 * q / (np.pi * a)


def test_guided_slices_have_hertz_pressure():
    z = np.array([0.0, 0.2, 0.5])
    across = np.linspace(0, 0.04, 33)
    bodies = tuple(
        body(half_cylinder(R=R, contact=z, first=across[1]), z, across[1], supports=GUIDED)
        for R in (1.0, 2.8)
    )
    q = np.pi * 0.03**2 * sum(b.curvature for b in bodies) / 4 * modulus(STEEL, STEEL)
    c, (a, p_0) = patch_contact(bodies, across=across, load=0.5 * q), hertz(bodies, q)
    assert a == pytest.approx(0.03)
    assert np.ptp(c.line_load) < 1e-6 * c.line_load[0]
    assert c.ridge == pytest.approx(p_0, rel=1e-3)
    assert c.half_width == pytest.approx(a, rel=1e-3)
    s = (c.across[1:] + c.across[:-1]) / 2
    inside = s < 0.9 * a
    shape = p_0 * np.sqrt(1 - (s[inside] / a) ** 2)
    np.testing.assert_allclose(c.p[inside, 0], shape, rtol=0, atol=5e-3 * p_0)


def test_a_roller_in_a_bore_presses_on_a_wider_strip():
    z, ratio = np.array([0.0, 0.5]), 0.05
    cell = 4 / 3 * ratio / 32
    r = stations(start=2.0, end=5.0, first=cell, growth=1.6)
    ring = MeshQuad1.init_tensor(r, z).with_boundaries({
        "bore": lambda x: x[0] == 2, "start": lambda x: x[1] == 0, "end": lambda x: x[1] == 0.5,
    })  # fmt: skip
    inner = half_cylinder(R=1.0, contact=z, first=cell)
    bodies = (
        body(inner, z, cell, supports=GUIDED),
        body(ring, z, cell, supports=GUIDED, boundary="bore"),
    )
    assert bodies[1].curvature == -0.5
    q = np.pi * ratio**2 * 0.5 / 4 * modulus(STEEL, STEEL)
    c = patch_contact(bodies, across=np.linspace(0, 4 / 3 * ratio, 33), load=0.5 * q)
    a, p_0 = hertz(bodies, q)
    assert a == pytest.approx(ratio)
    assert c.ridge == pytest.approx(p_0, rel=3e-3)
    assert c.half_width == pytest.approx(a, rel=3e-3)
    with pytest.raises(ValueError, match=r"must curve away from each other, got .* -2 m and -2 m"):
        patch_contact((bodies[1], bodies[1]), across=np.linspace(0, 0.1, 9), load=1.0)


@cache
def roller(overhang=0.0, R=1.0, nu=0.3, E=206.0, refine=1, length=1.0):
    """Half of a roller of the half `length`, touched all along it, and its stations."""
    z = stations(start=length, end=0.0, first=0.02, growth=1.6, refine=refine)
    mesh = half_cylinder(R=R, contact=z, overhang=overhang, first=0.01, refine=refine)
    return body(mesh, z, 0.06 / 12, material=Elastic(E=E, nu=nu))


ACROSS = np.linspace(0, 0.06, 13)


def test_a_crown_takes_load_from_the_end_to_the_middle():
    pair = roller(), roller(0.5)
    flat = patch_contact(pair, across=ACROSS, load=0.1)
    crowned = patch_contact(pair, across=ACROSS, load=0.1, crown=lambda z: 2e-4 * z**4)
    assert crowned.load_between(0.9, 1.0) < flat.load_between(0.9, 1.0)
    assert crowned.ridge_at(0.0) > flat.ridge_at(0.0)
    cut = patch_contact(pair, across=ACROSS, load=0.1, crown=lambda z: np.where(z > 0.8, 1.0, 0.0))
    assert cut.load_between(0.8, 1.0) < 0.1 * flat.load_between(0.8, 1.0)
    assert np.all(cut.line_load[cut.z > 0.85] == 0)
    assert np.all(cut.half_width[cut.z > 0.85] == 0)


def test_figures_of_an_elliptic_pressure_are_those_it_was_made_of():
    a, p_0 = 0.8, 3.0
    across, z = np.linspace(0, 1, 2001), np.array([0.0, 1.0, 3.0])
    x = np.clip(across / a, 0, 1)
    area = a / 2 * (x * np.sqrt(1 - x**2) + np.arcsin(x))  # under sqrt(1 - x^2/a^2)
    p = p_0 * np.outer(np.diff(area) / np.diff(across), [1.0, 2.0])
    c = PatchContact(across, z, p, 0.0, 0.0)
    q = np.pi * a * p_0 / 2
    assert c.line_load == pytest.approx([q, 2 * q], rel=1e-6)
    assert c.half_width == pytest.approx(a, rel=1e-6)
    assert c.ridge == pytest.approx([p_0, 2 * p_0], rel=1e-6)
    assert c.load_between(0.5, 2.0) == pytest.approx(0.5 * q + 2 * q, rel=1e-6)
    assert c.ridge_at(0.5) == pytest.approx(p_0, rel=1e-6)
    assert c.ridge_at(1.25) == pytest.approx(1.5 * p_0, rel=1e-6)


@pytest.mark.parametrize("seed", range(4))
def test_cells_press_where_they_touch_and_nowhere_else(seed):
    random, n = np.random.default_rng(seed), 12
    x = np.sort(random.uniform(0, 1, n))
    A = np.exp(-abs(x[:, None] - x) / 0.3) + 1e-3 * np.eye(n)  # springs that pull each other
    gap, area = random.uniform(0, 2, n), random.uniform(0.5, 1.5, n)
    p, d = push_together(A, gap, area, load=0.5)
    opening = A @ p + area * (gap - d)
    assert p.min() >= 0
    assert opening.min() > -1e-9
    assert abs(p @ opening) < 1e-9
    assert area @ p == pytest.approx(0.5)


def test_the_slope_at_the_edge_is_extrapolated_over_the_distance():
    r = np.geomspace(1e-5, 0.1, 60)
    p = r**-0.226 * np.exp(3 * r)  # a slope of -0.226 + 3 r
    assert edge_slope(r[::-1], p[::-1], 1e-3) == pytest.approx(-0.226, abs=1e-6)


def test_a_ring_as_long_as_its_shaft_presses_evenly_as_lame_s_does():
    fine = {"first": 0.2, "growth": 1.2, "refine": 2}
    nodes = stations(start=1.0, end=0.0, **fine)
    shaft = half_cylinder(R=1.0, contact=nodes, overhang=0.0, first=0.2, refine=2)
    ring = MeshQuad1.init_tensor(stations(start=1.0, end=2.0, **fine), nodes)
    ring = ring.with_boundaries({"bore": lambda x: x[0] == 1, "start": lambda x: x[1] == 0})
    bodies = [
        (FourierSolid(mesh, Elastic(E=3.0, nu=0.3), {"start": "z"}, degree=2), name)
        for mesh, name in ((shaft, "rim"), (ring, "bore"))
    ]
    pressure = shrink_pressure(bodies, nodes[::2])
    # E / ((r_o² + r_f²)/(r_o² - r_f²) + 1), both free to change their length
    assert pressure == pytest.approx(3.0 / (5 / 3 + 1), rel=1e-3)
