"""A first push and a swing of two bodies whose law is known: Masing's rule and Cattaneo's zone."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.slip_course import Push, swing

k = np.linspace(0.01, 0.9, 90)
PUSH = Push(k, 1 - k, 1 - np.sqrt(1 - k))  # c/a = sqrt(1 - k), and a displacement that bends


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_the_stick_zone_is_read_off_between_steps(share):
    c, u = PUSH.stick_half_width(share, 2.0)
    assert c == pytest.approx(2 * np.sqrt(1 - share), rel=1e-12)
    assert u < 1e-12
    assert PUSH.growth(np.array([share]))[0] == pytest.approx(c / 2, rel=1e-12)


def test_displacements_beyond_the_chord_vanish_at_its_ends_and_bend_below_it():
    at_end, _ = PUSH.beyond_chord(0.8, 0.8)
    between, u = PUSH.beyond_chord(0.4, 0.8)
    assert abs(at_end) < 1e-15
    exact = 1 - np.sqrt(0.6) - (1 - np.sqrt(0.2)) / 2
    assert between == pytest.approx(exact, abs=1e-5)
    assert 0 <= u < 1e-4


def test_a_smooth_push_leaves_no_jitter_in_the_loop_and_a_rough_one_does():
    rough = Push(k, PUSH.stick, PUSH.x + 1e-4 * (-1.0) ** np.arange(k.size))
    assert PUSH.loop_jitter(0.6) < 1e-5 < rough.loop_jitter(0.6)


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
