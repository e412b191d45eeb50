"""Peaks, chords and damping ratios of responses."""

import numpy as np
import pytest

from fem.rotor.peaks import above_chord, peaks, spread_ratios


def test_what_is_above_a_chord_counts_the_spacing_of_unbalances():
    u = np.array([1.0, 2.0, 5.0])
    line = (3 + 2 * u)[:, None, None]  # f = 3 + 2u: 5, 7, 13
    assert above_chord(line, u) == pytest.approx(0, abs=1e-15)
    assert above_chord(line * [[[1]], [[1.1]], [[1]]], u) == pytest.approx(0.1, rel=1e-12)
    assert above_chord(u[:, None, None] ** 2, u) < -0.4  # 4 against a chord of 7


def test_a_flank_at_an_end_is_no_peak():
    assert np.isnan(peaks(np.array([3.0, 2.0, 1.0, 2.0])))
    assert peaks(np.array([9.0, 2.0, 5.0, 2.0, 7.0])) == 5.0


def test_ratios_are_no_further_apart_than_rayleigh_damping_has_them():
    zeta = spread_ratios(0.005, 0.03, 2.0, 200)
    apart = zeta[:, 1] / zeta[:, 0]
    assert np.all((apart < 2) & (apart > 0.5))
    assert np.median(zeta[:, 0]) == pytest.approx(np.sqrt(0.005 * 0.03), rel=0.02)
