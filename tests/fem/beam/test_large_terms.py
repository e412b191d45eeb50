"""Terms in addition to elements: springs, sliders with history, and steps that are withdrawn."""

import numpy as np
import pytest
from scipy.sparse import csc_array

from fem.beam.large import LargeFrame
from fem.beam.section import Section
from fem.beam.terms import Term

SECTION = Section(EA=100.0, EI=1.0, GA=100.0)


class Spring(Term):
    """Of stiffness k between a node and the ground, in x."""

    def __init__(self, node, k, size):
        self.node, self.k, self.size = 3 * node, k, size

    def start(self, x):
        self.rest = x.ravel()[self.node]

    def evaluate(self, x):
        stretch = x.ravel()[self.node] - self.rest
        f = np.zeros(self.size)
        f[self.node] = self.k * stretch
        K = csc_array(([self.k], ([self.node], [self.node])), shape=(self.size, self.size))
        return self.k * stretch**2 / 2, f, K


class Slider(Spring):
    """A spring that slips at a force (Jenkins), whose stretch is its history."""

    def __init__(self, node, k, slip, size):
        super().__init__(node, k, size)
        self.slip, self.accepted, self.rejected = slip, 0, 0

    def start(self, x):
        super().start(x)
        self.dissipated = 0.0

    def _stretch(self, x):
        trial = x.ravel()[self.node] - self.rest
        return np.clip(trial, -self.slip / self.k, self.slip / self.k), trial

    def evaluate(self, x):
        held, trial = self._stretch(x)
        f = np.zeros(self.size)
        f[self.node] = self.k * held
        k = self.k if held == trial else 0.0
        K = csc_array(([k], ([self.node], [self.node])), shape=(self.size, self.size))
        return self.k * held**2 / 2, f, K

    def accept(self, x):
        held, trial = self._stretch(x)
        self.dissipated += self.slip * abs(trial - held)
        self.rest += trial - held
        self.accepted += 1

    def reject(self):
        self.rejected += 1


def bar(*terms):
    """Of length 2 along x: EA / L = 50."""
    return LargeFrame(
        [(0, 0), (2, 0)], [(0, 1)], sections=SECTION, supports={0: "xyr", 1: "yr"}, terms=terms
    )


def test_a_spring_shares_the_load_with_a_bar():
    path = bar(Spring(1, 30.0, 6)).under_loads({1: (8.0, 0, 0)}, [0.5, 1.0])
    np.testing.assert_allclose(path.u[:, 1, 0], [0.05, 0.1], rtol=1e-10)
    np.testing.assert_allclose(path.term_energy, 15 * path.u[:, 1, 0] ** 2, rtol=1e-10)
    np.testing.assert_allclose(path.work, path.strain_energy + path.term_energy, rtol=1e-10)
    assert path.dissipated.tolist() == [0, 0]
    assert path.potential_energy[-1] == pytest.approx(-0.4, rel=1e-10)


def test_a_slider_loses_the_area_of_its_loop():
    """Elastic to slip / k = 0.02, then slip: 4 slip (amplitude - slip / k) a cycle."""
    slider, amplitude = Slider(1, 100.0, 2.0, 6), 0.1
    cycle = np.concatenate([np.arange(0, 5), np.arange(5, -5, -1), np.arange(-5, 6)])[1:] / 5
    path = bar(slider).displaced({1: {"x": amplitude}}, cycle)
    loss = 2.0 * (amplitude - 0.02) + 4 * 2.0 * (amplitude - 0.02)
    assert path.dissipated[-1] == pytest.approx(loss, rel=1e-9)
    x = path.reactions[:, 1, 0]
    assert x[4] == pytest.approx(50 * amplitude + 2, rel=1e-9)
    assert x[14] == pytest.approx(-50 * amplitude - 2, rel=1e-9)
    stored = path.strain_energy + path.term_energy + path.dissipated
    assert path.work[9] == pytest.approx(stored[9], rel=0.15)  # kinks within steps of 0.02
    again = bar(slider).displaced({1: {"x": amplitude}}, [0.1])
    assert again.dissipated[0] == 0  # a path from rest starts a new history


def test_a_state_that_the_terms_have_forgotten_is_refused():
    frame = bar(Slider(1, 100.0, 2.0, 6))
    path = frame.displaced({1: {"x": 0.1}}, [0.5, 1.0])
    with pytest.raises(ValueError, match="store the history of one load path only: continue from"):
        frame.under_loads({1: (1.0, 0, 0)}, [1.0], since=path.states[0])


def test_steps_that_are_taken_back_leave_no_history():
    """A strip rolled up in one step, too much for Newton's method, slips as in small steps."""
    x = np.linspace(0, 1, 21)
    k = 2 * np.arange(10)

    def roll(factors):
        slider = Slider(20, 5.0, 0.3, 63)
        frame = LargeFrame(
            np.column_stack([x, 0 * x]), np.column_stack([k, k + 2, k + 1]),
            sections=Section(EA=1e4, EI=1.0, GA=1e4), supports={0: "xyr"}, terms=(slider,),
        )  # fmt: skip
        return frame.under_loads({20: (0, 0, 4.0)}, factors).last, slider

    coarse, slider = roll([1.0])
    fine, _ = roll(np.linspace(0, 1, 41)[1:])
    assert slider.rejected > 0
    assert slider.accepted == coarse.steps
    np.testing.assert_allclose(coarse.u, fine.u, atol=1e-9)
    assert coarse.dissipated == pytest.approx(fine.dissipated, rel=1e-9)
