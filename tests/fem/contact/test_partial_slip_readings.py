"""Readings of partial slip: stick zone by moments, smoothing, the loop of a cycle."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.partial_slip import beyond_chord, loop_area, order_in_steps, smoothed, stick_share


def touching(a, c, mu_p=1.0, shift=0.0):
    """Two ellipses of traction, and of pressure, at many points."""
    x = np.linspace(-a, a, 200_001)
    lens, stuck = (np.sqrt(np.maximum(w**2 - x**2, 0.0)) for w in (a, c))
    return SimpleNamespace(
        along=lambda _: x + shift, q=mu_p * (lens - stuck), weight=np.full(x.size, x[1] - x[0]),
        half_width=lambda _: a,
    )  # fmt: skip


@pytest.mark.parametrize("c", [0.05, 0.3, 0.9])
@pytest.mark.parametrize("shift", [0.0, 0.2])
def test_the_stick_zone_follows_from_moments_wherever_the_traction_sits(c, shift):
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


def loop(n):
    """A loop of even steps in x, Q = x ± (1 - x²): area 2 * 4/3."""
    down = np.linspace(1.0, -1.0, n + 1)
    x = np.concatenate([down, -down[1:]])
    swing = np.where(np.arange(x.size) <= n, -1.0, 1.0)
    return x, x + swing * (1 - x**2)


def test_the_area_of_a_loop_is_positive_and_exact_for_parabolas():
    assert loop_area(*loop(8)) == pytest.approx(8 / 3, rel=1e-14)


def test_a_loop_is_shown_beyond_the_line_between_its_reversals():
    x = np.concatenate([np.linspace(1, -1, 33), np.linspace(-1, 1, 33)[1:]])
    bend = np.where(np.arange(x.size) <= 32, 1.0, -1.0) * (1 - x**2)
    at = np.linspace(-1.0, 1.0, 17)
    found = beyond_chord(2 * x + 0.1 * bend, x, at)
    down, up = np.split(found, 2)
    assert down == pytest.approx(0.1 * (1 - at**2), abs=1e-4)
    assert up == pytest.approx(-0.1 * (1 - at**2), abs=1e-4)


def test_straight_lines_between_the_steps_of_a_smooth_loop_err_with_their_square():
    x, Q = loop(64)
    order, error = order_in_steps(x, Q, 8 / 3)
    assert order == pytest.approx(2, abs=1e-3)
    assert error == pytest.approx(8 / 3 - abs(np.trapezoid(Q[::2], x[::2])), rel=1e-12)
