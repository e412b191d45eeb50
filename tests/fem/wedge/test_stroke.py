"""States, work and widths over a stroke, and steps to rest, without finite elements."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.errors import NotFoundError
from fem.wedge.course import Course
from fem.wedge.rest import STILL, Unrest, at_rest, core_motion
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


def test_work_on_the_yields_is_the_energy_of_a_power_and_turns_the_races(stroke):
    N, T = (stroke.at_states[k][[1, 4]] for k in ("N", "T"))
    exact = z * 2e-8 * N**0.95 * N / T  # n_s int N dH / T, T in proportion to N
    assert stroke.turn_by_energy(T) == pytest.approx(exact, rel=1e-9)
    assert stroke.work(N) == pytest.approx(stroke.at_states["U"][[1, 4]], rel=1e-9)


def test_a_stroke_meets_its_states_and_has_no_values_beyond_them(stroke):
    for name in ("H", "tan nu"):
        for N, value in zip(stroke.at_states["N"][1:-1], stroke.at_states[name][1:-1], strict=True):
            assert stroke.at(name, N) == pytest.approx(value, rel=1e-12)
    for N in (99.0, 6001.0):
        with pytest.raises(ArithmeticError, match="outside the range of the states"):
            stroke.at("H", N)


def test_an_elliptic_pressure_has_its_half_width():
    x = np.linspace(-1, 1, 20_001) * 50e-6
    p = np.sqrt(1 - (x / 50e-6) ** 2)
    touch = SimpleNamespace(p=p, weight=np.full_like(x, x[1] - x[0]), along=lambda: x)
    assert half_width(touch) == pytest.approx(50e-6, rel=1e-4)


def course(**powers):
    """Ten states whose quantities are powers of N."""
    made = Course()
    N = np.geomspace(2.0, 800.0, 10)
    made.at_states = {"N": N} | {name: 3.0 * N**power for name, power in powers.items()}
    return made


def test_powers_and_what_hardly_changes_are_met_between_the_states_and_nothing_beyond():
    one = course(T=1.2, d=0.9)
    one.at_states["tan"] = 0.05 - 1e-3 * np.log(one.at_states["N"])
    for N in (2.0, 31.0, 799.0):
        assert one.at("T", N) == pytest.approx(3 * N**1.2, rel=1e-12)
        assert one.at("d", 3 * N**1.2, "T") == pytest.approx(3 * N**0.9, rel=1e-12)
        assert one.at("tan", N) == pytest.approx(0.05 - 1e-3 * np.log(N), rel=1e-12)
    for N in (1.99, 801.0):
        with pytest.raises(ArithmeticError, match="range of the states, whose lowest value is 2"):
            one.at("T", N)


def test_an_integral_of_a_power_begins_without_load():
    N = np.array([5.0, 700.0])
    found = course().integral(lambda t: 4 * np.exp(1.9 * t), "N", np.log(N))
    assert found == pytest.approx(4 / 1.9 * N**1.9, rel=1e-12)


@dataclass
class Turned:
    """A body that moves by a share of how far both surfaces are off 3 and -2 mm."""

    drags: tuple[float, float]
    slides: bool = False

    @property
    def solution(self):
        return SimpleNamespace(slides=self.slides)

    def unrest(self, undone=0.9):
        off = self.drags[0] - 3e-3, self.drags[1] + 2e-3
        drags = tuple(d - undone * o for d, o in zip(self.drags, off, strict=True))
        return Unrest(max(map(abs, off)), 1e-3, drags)


def test_drags_are_improved_until_the_body_moves_by_next_to_nothing():
    state = at_rest(Turned, (0.0, 0.0), Turned.unrest, body="roller", most=12)
    assert state.drags == pytest.approx((3e-3, -2e-3), abs=STILL * 1e-3)


@pytest.mark.parametrize(
    ("slides", "most", "words"),
    [
        (False, 4, r"the roller still moves by 3\.0e-03 m after 4 steps$"),
        (True, 1, "every node of a contact slips"),
    ],
)
def test_a_body_that_never_rests_has_no_state(slides, most, words):
    with pytest.raises(NotFoundError, match=words):
        at_rest(lambda d: Turned(d, slides), (0.0, 0.0), lambda s: s.unrest(0.0), body="roller",
                most=most)  # fmt: skip


def test_the_core_of_a_rigid_motion_gives_its_shift_and_turn():
    def at(x):
        return SimpleNamespace(u=np.array([[1e-6], [-2e-6]]) + 1e-4 * np.array([-x[1], x[0]]))

    solution = SimpleNamespace(plane=SimpleNamespace(at=at))
    u, turn = core_motion(solution, (0.02, 0.01), 5e-3)
    assert turn == pytest.approx(1e-4, rel=1e-9)
    assert u.mean(axis=1) == pytest.approx([1e-6 - 1e-6, -2e-6 + 2e-6], abs=1e-18)
