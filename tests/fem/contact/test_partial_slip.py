"""Pressed and then pushed: Cattaneo's and Mindlin's stick zone, and what a cycle of pushes leaves.

Both bodies are of one material, so that normal and tangential problem do not mix.
"""

import numpy as np
import pytest

from tests.fem.contact.models import rollers

R, MU = 10e-3, 0.3
E, NU = 210e9, 0.3
A = 0.01 * R
LOAD = np.pi * E / (1 - NU**2) * A**2 / (4 * R)  # two discs: half the modulus, half the radius
PUSHES = (0.2, 0.8, 0.5, 0.0)  # over the friction of full sliding


@pytest.fixture(scope="module")
def steps():
    problem = rollers(MU)

    def moved(x, y, after):
        return problem.solve(displacements={"upper.middle": {"x": x, "y": y}}, after=after)

    # as far down as gives about the load, and then sideways as gives about each push
    y = -1e-6
    for _ in range(8):
        y *= (LOAD / moved(0.0, y, None).touches[0].normal_force) ** 0.9
    s = moved(0.0, y, None)
    found, x = [s], 0.0
    stiff = MU * LOAD / 1e-6
    for push in PUSHES:
        for _ in range(12):
            new = moved(x, y, s)
            miss = push * MU * LOAD - new.touches[0].force[0]
            x += miss / stiff
            if abs(miss) < 1e-3 * MU * LOAD:
                break
            slope = (moved(x, y, s).touches[0].force[0] - new.touches[0].force[0]) / (miss / stiff)
            stiff = slope if slope > 0 else stiff
        s = moved(x, y, s)
        found.append(s)
    return found


@pytest.mark.parametrize("step", [1, 2])
def test_the_stick_zone_shrinks_as_cattaneo_has_it(steps, step):
    pressed, touch = steps[0].touches[0], steps[step].touches[0]
    # pressing alone makes no friction between bodies alike
    assert np.abs(pressed.traction).max() < 1e-3 * pressed.peak
    assert pressed.half_width() == pytest.approx(A, rel=2e-3)
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
