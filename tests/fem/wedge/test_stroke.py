"""Energy, work and widths of contacts over a stroke, of states without finite elements."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.wedge.stroke import Stroke, half_width

z, LEVER = 12, 11e-3  # struts, m


@pytest.fixture
def stroke():
    """Five states: H as N^0.95, T as N, U = int N dH."""
    made = object.__new__(Stroke)
    made.z = z
    N = np.geomspace(100.0, 6000.0, 5)
    H = 2e-8 * N**0.95
    T = z * LEVER * 0.055 * N
    made.at_states = {"N": N, "H": H, "T": T, "U": N * H * 0.95 / 1.95, "tan nu": 0.055 + 0 * N}
    return made


def test_work_on_the_yields_is_the_energy_of_a_power(stroke):
    N = stroke.at_states["N"][[1, 4]]
    assert stroke.work(N) == pytest.approx(stroke.at_states["U"][[1, 4]], rel=1e-9)


def test_the_races_turn_as_far_as_the_energy_over_the_torque_says(stroke):
    N, T = (stroke.at_states[k][[1, 4]] for k in ("N", "T"))
    exact = z * 2e-8 * N**0.95 * N / T  # n_s int N dH / T, T in proportion to N
    assert stroke.turn_by_energy(T) == pytest.approx(exact, rel=1e-9)


def test_a_stroke_hits_its_states_and_says_nothing_beyond_them(stroke):
    for name in ("H", "tan nu"):
        for N, value in zip(stroke.at_states["N"][1:-1], stroke.at_states[name][1:-1], strict=True):
            assert stroke.at(name, N) == pytest.approx(value, rel=1e-12)
    for N in (99.0, 6001.0):
        with pytest.raises(ArithmeticError, match="lies beyond the states"):
            stroke.at("H", N)


def test_an_elliptic_pressure_has_its_half_width():
    x = np.linspace(-1, 1, 20_001) * 50e-6
    p = np.sqrt(1 - (x / 50e-6) ** 2)
    touch = SimpleNamespace(p=p, weight=np.full_like(x, x[1] - x[0]), along=lambda: x)
    assert half_width(touch) == pytest.approx(50e-6, rel=1e-4)
