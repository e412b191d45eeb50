"""Normal, then tangential load: stick zone of Cattaneo and Mindlin in the plane and along z.

All bodies are of one material, so that normal and tangential problem do not mix.
"""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.partial_slip import smoothed
from fem.plane.material import Elastic
from tests.fem.contact.models import rollers

R, MU = 10e-3, 0.3
E, NU = 210e9, 0.3
A = 0.01 * R  # about the half-width
DOWN, SHIFTS = -5.323e-6, (0.0, 4.532e-7, 1.8714e-6, 1.1929e-6, 4.356e-8)  # [m]


@pytest.fixture(scope="module")
def steps():
    """Pressed, pushed by about 0.2 and 0.8 of what makes it slide, and back by 0.3 and by all."""
    problem, found, s = rollers(MU), [], None
    for x in SHIFTS:
        s = problem.solve(displacements={"upper.middle": {"x": x, "y": DOWN}}, after=s)
        found.append(s)
    return found


@pytest.mark.parametrize("step", [1, 2])
def test_the_stick_zone_shrinks_as_cattaneo_has_it(steps, step):
    pressed, touch = steps[0].touches[0], steps[step].touches[0]
    # pressing alone makes no friction between equal bodies
    assert np.abs(pressed.traction).max() < 1e-3 * pressed.peak
    hertz = np.sqrt(4 * R * pressed.normal_force * (1 - NU**2) / (np.pi * E))
    assert pressed.half_width() == pytest.approx(hertz, rel=2e-3)
    load, a = touch.normal_force, touch.half_width()
    c = a * np.sqrt(1 - abs(touch.friction_force) / (MU * load))
    cell = A * 1.2 / 12 / 2  # between two vertices that carry the traction
    assert np.ptp(touch.x[0, touch.sticks]) / 2 == pytest.approx(c, abs=1.5 * cell)
    # q = mu p less what a pressure on |x| < c alone would give
    x = touch.x[0] - touch.x[0, touch.closed].mean()
    p_0 = 2 * load / (np.pi * a)
    full, less = (np.sqrt(np.maximum(1 - (x / w) ** 2, 0.0)) for w in (a, c))
    expected = MU * p_0 * (full - c / a * less)
    inner = (np.abs(x) < 0.9 * a) & (np.abs(np.abs(x) - c) > 2 * cell)
    sign = np.sign(touch.friction_force)
    np.testing.assert_allclose(sign * touch.traction[inner], expected[inner], atol=0.05 * MU * p_0)


def test_the_edges_turn_back_at_twice_the_change_of_load(steps):
    # Mindlin and Deresiewicz: unloading is half as strong a loading of twice the friction
    turned = steps[3].touches[0]
    load, a = turned.normal_force, turned.half_width()
    change = abs(steps[2].touches[0].friction_force - turned.friction_force)
    c = a * np.sqrt(1 - change / (2 * MU * load))
    assert np.ptp(turned.x[0, turned.sticks]) / 2 == pytest.approx(c, abs=0.1 * A)
    assert turned.traction[np.argmin(np.abs(turned.x[0]))] * turned.friction_force > 0
    back = steps[4].touches[0]  # taken back altogether: friction stays locked in
    assert abs(back.friction_force) < 5e-3 * MU * back.normal_force
    assert np.abs(back.traction).max() > 0.1 * MU * back.peak


def stick_half_width(touch, q):
    """C of the traction `q` (points,): int (mu p - q) x^2 is that of an ellipse over |x| < c."""
    x, P = touch.along(), touch.normal_force
    left = (MU * touch.p - q) @ touch.weight
    # the ellipse left has the moment left c^2/4, and left = mu P c^2/a^2
    moment = ((MU * touch.p - q) * x**2) @ touch.weight
    assert left > 0
    assert P > 0
    return 2 * np.sqrt(moment / left)


@pytest.mark.parametrize("angle", [30.0, 120.0])
def test_without_poissons_ratio_every_direction_is_cattaneos(angle):
    """A force in the surface moves it equally along and across z: c = a sqrt(1 - Q/(mu P))."""
    # moved: what is pushed above would tilt
    problem = rollers(
        MU, materials=Elastic(E=E, nu=0.0),
        along=Along(supports={"lower.middle": 0.0, "upper.middle": 0.0}),
    )  # fmt: skip
    pressed = problem.solve(displacements={"upper.middle": {"x": 0.0, "y": -5e-6}})
    x, z = 7e-7 * np.cos(np.radians(angle)), 7e-7 * np.sin(np.radians(angle))
    moved = {"upper.middle": {"x": x, "y": -5e-6}}
    s = problem.solve(displacements=moved, axial_displacements={"upper.middle": z}, after=pressed)
    touch = s.touches[0]
    F = np.array([touch.friction_force, touch.force_z])
    Q, P = np.hypot(*F), touch.normal_force
    d = F / Q
    assert 0.3 < Q / (MU * P) < 0.9
    own, across = d[0] * touch.q + d[1] * touch.q_z, d[0] * touch.q_z - d[1] * touch.q
    scale = MU * touch.p.max()
    assert np.abs(across).max() < 0.02 * scale  # pressing alone leaves 0.01, for discs are round
    c = touch.half_width() * np.sqrt(1 - Q / (MU * P))
    assert stick_half_width(touch, own) == pytest.approx(c, rel=2e-3)
    nodal = np.hypot(touch.traction, touch.traction_z)
    slips = touch.closed & ~touch.sticks
    assert np.count_nonzero(slips) > 4
    np.testing.assert_allclose(nodal[slips], MU * touch.pressure[slips], rtol=1e-9)
    assert np.all(nodal <= MU * touch.pressure + 1e-9 * scale)
    # friction opposes the slip, in both of its components
    along = (touch.traction * touch.slip + touch.traction_z * touch.slip_z)[slips]
    size = nodal[slips] * np.hypot(touch.slip, touch.slip_z)[slips]
    np.testing.assert_allclose(along, -size, atol=1e-8 * size.max())


def test_the_scatter_about_a_cubic_has_four_degrees_of_freedom_less_than_samples():
    k = np.linspace(0.0, 1.0, 11)
    at, window = 0.5, 1.0
    cubic = 2 - 3 * (k - at) + (k - at) ** 2 - 4 * (k - at) ** 3
    quartic = np.polynomial.legendre.Legendre.basis(4)(2 * k - 1)
    # what a cubic cannot follow, of the norm 1e-3
    fitted = np.polyval(np.polyfit(k, quartic, 3), k)
    beyond = 1e-3 * (quartic - fitted) / np.linalg.norm(quartic - fitted)
    value, u, scatter = smoothed(k, cubic + beyond, at, window)
    assert value == pytest.approx(2.0, abs=1e-12)
    assert scatter == pytest.approx(1e-3 / np.sqrt(11 - 4), rel=1e-9)
    # by hand, of an even cubic fit: sum t^4/(n sum t^4 - (sum t^2)^2)
    t = k - at
    share = (t**4).sum() / (11 * (t**4).sum() - (t**2).sum() ** 2)
    assert u == pytest.approx(scatter * np.sqrt(share), rel=1e-9)
