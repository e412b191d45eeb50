"""Evaluation of contacts whose pressures, tractions and load paths have a closed form."""

from types import SimpleNamespace

import numpy as np
import pytest

from analytic.contact import hertz_point
from fem.contact.partial_slip import beyond_chord, loop_area, order_in_steps, smoothed, stick_share
from fem.contact.point_contact import largest_axis_shear, middle_pressure
from fem.contact.round_fit import mean_and_scatter, means_on, pressure_at
from fem.contact.slip_course import Push, swing
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.ring.quarter import quarter_ring


def test_the_peak_of_an_ellipse_is_found_from_its_nodes():
    r = np.linspace(0, 1, 40)
    p = 3.0 * np.sqrt(1 - r**2)
    assert middle_pressure(r, p, 1.01) == pytest.approx(3.0, rel=1e-4)


def test_the_largest_shear_stress_of_exact_stresses_is_hertz_s():
    z = np.linspace(0.1, 0.9, 81)
    radial, axial = hertz_point.axis_stresses(z, a=1.0, p_0=1.0, nu=0.3)
    x = np.array([np.repeat([0.0, 0.1, 0.2], 81), np.tile(z, 3)])
    stress = np.tile([radial, axial], 3)
    found = largest_axis_shear(x, stress, 1.0)
    assert found == pytest.approx((0.310, 0.481), abs=6e-4)


def touching(a, c, mu_p=1.0, shift=0.0):
    """Two ellipses of traction, and of pressure, at many points."""
    x = np.linspace(-a, a, 200_001)
    lens, stuck = (np.sqrt(np.maximum(w**2 - x**2, 0.0)) for w in (a, c))
    return SimpleNamespace(
        along=lambda _: x + shift, q=mu_p * (lens - stuck), weight=np.full(x.size, x[1] - x[0]),
        half_width=lambda _: a,
    )  # fmt: skip


@pytest.mark.parametrize(("c", "shift"), [(0.05, 0.0), (0.9, 0.2)])
def test_the_stick_zone_follows_from_moments_for_any_place_of_the_traction(c, shift):
    found = stick_share(touching(2.0, 2.0 * c, mu_p=7.0, shift=shift))
    assert found == pytest.approx(c**2, abs=1e-5)


def test_a_cubic_passes_smoothing_unchanged_and_jitter_is_stated():
    k = np.linspace(0.0, 1.0, 101)
    cubic = 3 - k + 2 * k**2 - 5 * k**3
    value, u, scatter = smoothed(k, cubic, 0.4)
    assert value == pytest.approx(3 - 0.4 + 0.32 - 0.32, rel=1e-12)
    assert max(u, scatter) < 1e-12
    jitter = 1e-3 * (-1.0) ** np.arange(k.size)
    value, u, scatter = smoothed(k, cubic + jitter, 0.4)
    assert abs(value - 2.6) < 2 * u
    assert 0.5e-3 < scatter < 2e-3


def test_pressures_of_a_ring_are_read_by_weight_and_by_angle():
    uneven = SimpleNamespace(p=np.array([4.0, 4.0, 6.0]), weight=np.array([1.0, 1.0, 2.0]))
    assert mean_and_scatter(uneven) == (5.0, 1.0)
    turn = np.radians([50.0, 10.0, 30.0])  # in any order
    touch = SimpleNamespace(x=2 * np.array([np.cos(turn), np.sin(turn)]), pressure=10 * turn)
    at = np.radians([20.0, 45.0])
    assert pressure_at(touch, at) == pytest.approx(10 * at)
    ring = solve_plane(
        quarter_ring(r_i=1.0, r_o=2.0, refine=8), materials=Elastic(E=3.0, nu=0.3),
        assumption="plane stress", supports={"x=0": "x", "y=0": "y"}, pressures={"bore": 0.6},
    )  # fmt: skip
    moved, hoop = means_on(ring, "bore")  # Lamé's
    assert hoop == pytest.approx(0.6 * 5 / 3, rel=1e-3)
    assert moved == pytest.approx(0.6 / 3 * (5 / 3 + 0.3), rel=1e-4)


def loop(n):
    """A loop of even steps in x, Q = x ± (1 - x²): area 2 * 4/3."""
    down = np.linspace(1.0, -1.0, n + 1)
    x = np.concatenate([down, -down[1:]])
    swing = np.where(np.arange(x.size) <= n, -1.0, 1.0)
    return x, x + swing * (1 - x**2)


def test_a_loop_of_parabolas_has_its_area_its_order_in_steps_and_its_bend():
    assert loop_area(*loop(8)) == pytest.approx(8 / 3, rel=1e-14)
    x, Q = loop(64)
    order, error = order_in_steps(x, Q, 8 / 3)
    assert order == pytest.approx(2, abs=1e-3)
    assert error == pytest.approx(8 / 3 - abs(np.trapezoid(Q[::2], x[::2])), rel=1e-12)
    at = np.linspace(-1.0, 1.0, 17)
    down, up = np.split(beyond_chord(2 * x + 0.1 * (x - Q), x, at), 2)
    assert down == pytest.approx(0.1 * (1 - at**2), abs=1e-4)
    assert up == pytest.approx(-0.1 * (1 - at**2), abs=1e-4)


def test_a_push_is_read_off_between_its_steps():
    k = np.linspace(0.01, 0.9, 90)
    push = Push(k, 1 - k, 1 - np.sqrt(1 - k))  # c/a = sqrt(1 - k), and a displacement that bends
    for share in (0.2, 0.5, 0.8):
        c, u = push.stick_half_width(share, 2.0)
        assert c == pytest.approx(2 * np.sqrt(1 - share), rel=1e-12)
        assert u < 1e-12
        assert push.growth(np.array([share]))[0] == pytest.approx(c / 2, rel=1e-12)
    at_end, _ = push.beyond_chord(0.8, 0.8)
    between, u = push.beyond_chord(0.4, 0.8)
    assert abs(at_end) < 1e-15
    assert between == pytest.approx(1 - np.sqrt(0.6) - (1 - np.sqrt(0.2)) / 2, abs=1e-5)
    assert 0 <= u < 1e-4
    rough = Push(k, push.stick, push.x + 1e-4 * (-1.0) ** np.arange(k.size))
    assert push.loop_jitter(0.6) < 1e-5 < rough.loop_jitter(0.6)


class Sliding:
    """Two bodies that slide with the force F wherever they move, and stick nowhere."""

    def at(self, cut, after):
        moved = cut[0] - after.x
        touch = SimpleNamespace(
            friction_force=3.0 * np.sign(moved), traction=np.array([3.0]), slip=np.array([moved]),
            mortar=SimpleNamespace(size=np.array([1.0])),
        )  # fmt: skip
        return SimpleNamespace(x=cut[0], touches=[touch])


def test_a_swing_does_the_work_of_its_friction_and_comes_back():
    first = SimpleNamespace(x=0.5, touches=[])
    found = swing(Sliding(), first, np.array([0.5, -1.0]), 3.0, 8)
    assert found.work == pytest.approx(3.0 * 2.0)  # to -0.5 and back
    assert (found.opposite.x, found.last.x) == (-0.5, 0.5)
    x, Q = found.half
    assert x[-1] == -0.5
    assert set(Q[1:]) == {-3.0}
    assert found.x.size == 17
