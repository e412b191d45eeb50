"""Contact of nearly incompressible bodies: their own stresses agree with the contact pressure."""

import numpy as np
import pytest

from fem.contact.nitsche import solve_nitsche
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.disc import quarter_disc
from meshes.contact.round import full_ring
from meshes.join import join
from tests.fem.contact.models import tower

every_ratio = pytest.mark.parametrize("nu", [0.3, 0.49, 0.4999])
RUBBER = Elastic(E=1.0, nu=0.4999)


@every_ratio
def test_a_sphere_on_a_flat_meets_hertz(nu):
    R, E = 10e-3, 2e6
    a = 0.02 * R
    load = 4 / 3 * a**3 / R * E / (1 - nu**2)
    s = ContactProblem(
        quarter_disc(R=R, zone=1.4 * a, refine=2), materials=Elastic(E=E, nu=nu),
        assumption="axisymmetric", obstacles={"flat": Obstacle(Flat())},
        contacts=[Pair(slave="surface", slave_shape=Circle((0, R), R), master="flat")],
    ).solve(forces={"middle": (0, -load)})  # fmt: skip
    touch, peak = s.touches[0], 1.5 * load / (np.pi * a**2)
    inner = touch.x[0] < a / 2
    hertz = np.sqrt(1 - (touch.x[0] / a) ** 2, where=inner, out=np.zeros(inner.size))
    np.testing.assert_allclose(touch.pressure[inner] / peak, hertz[inner], rtol=3e-3)
    assert touch.half_width((0, 0)) == pytest.approx(a, rel=5e-3)
    # under the centre (Johnson, Contact Mechanics, eq. 3.45), down to the depth a
    z = np.linspace(0.1, 1, 10)
    radial = -(1 + nu) * (1 - z * np.arctan(1 / z)) + 1 / (2 * (1 + z**2))
    xx, yy, _, zz = s.plane.at(np.array([0 * z, a * z])).stress / peak
    np.testing.assert_allclose(yy, -1 / (1 + z**2), atol=0.03)
    np.testing.assert_allclose(xx, radial, atol=0.03)
    np.testing.assert_allclose(zz, radial, atol=0.03)


@every_ratio
def test_a_sleeve_on_a_hub_meets_lame(nu):
    i, r_i, r, r_o = 1e-4, 0.5, 1.0, 2.0
    mesh = join({"in": full_ring(r_i=r_i, r_o=r, around=40, across=6),
                 "out": full_ring(r_i=r, r_o=r_o, around=32, across=8)})  # fmt: skip
    anchors = {(x, 0): "y" for x in (r_i, -r_i, r_o, -r_o)} | {(0, x): "x" for x in (r_i, r_o)}
    hub = Elastic(E=10.0, nu=0.3)
    s = ContactProblem(
        mesh, materials={"in": hub, "out": Elastic(E=1.0, nu=nu)},
        assumption="plane strain", anchors=anchors,
        contacts=[Pair(slave="in.rim", master="out.bore", interference=i, friction=0.2,
                       slave_shape=Circle((0, 0), r),
                       master_shape=Circle((0, 0), r, hollow=True))],
    ).solve()  # fmt: skip
    inner = ((r**2 + r_i**2) / (r**2 - r_i**2) - 0.3 / 0.7) * (1 - 0.3**2) / hub.E
    outer = ((r_o**2 + r**2) / (r_o**2 - r**2) + nu / (1 - nu)) * (1 - nu**2)
    p = i / (r * (inner + outer))
    touch = s.touches[0]
    assert touch.normal_force / (2 * np.pi * r) == pytest.approx(p, rel=1e-3)
    for body in ("out.bore", "in.rim"):
        side = s.plane.on_boundary(body)
        assert side.mean(side.polar()[1]) == pytest.approx(-p, rel=0.02)


@pytest.mark.parametrize("cells", ["quad", "tri"])
def test_a_uniform_pressure_passes_a_contact_of_rubber_and_steel(cells):
    p, nu = 0.01, {"up": RUBBER.nu, "low": 0.2}
    mesh = join({"up": block(x=(0, 1), y=(1, 2), nx=6, ny=3, cells=cells),
                 "low": block(x=(0, 1), y=(0, 1), nx=5, ny=3, cells=cells)})  # fmt: skip
    s = ContactProblem(
        mesh, materials={"up": RUBBER, "low": Elastic(E=4.0, nu=0.2)}, assumption="plane strain",
        supports={"low.bottom": "y", "low.left": "x", "up.left": "x"},
        contacts=[Pair(slave="up.bottom", master="low.top")],
    ).solve(pressures={"up.top": p})  # fmt: skip
    np.testing.assert_allclose(s.touches[0].pressure, p, rtol=1e-8)
    for body in nu:
        stress = s.plane.in_body(body).stress.T
        np.testing.assert_allclose(stress - [0, -p, 0, -nu[body] * p], 0.0, atol=1e-8 * p)


def test_nitsches_method_refuses_them():
    problem = tower(0.0, materials={"up": RUBBER, "low": RUBBER},
                    supports={"low.bottom": "xy", "up.left": "x"})  # fmt: skip
    with pytest.raises(ValueError, match=r"Nitsche.*: nu <= 0.45 is required, got nu=0.4999 in "):
        solve_nitsche(problem, pressures={"up.top": 0.01})
