"""Peaks and chords of responses; sets of two springs' stiffness with one given speed."""

import numpy as np
import pytest

from fem.rotor.ensemble import Ranges, elasticities, ensemble
from fem.rotor.parts import Element, Material
from fem.rotor.peaks import above_chord, peaks, spread_ratios
from fem.rotor.whirl_systems import Discs, Springs, WhirlSystems


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
    # even over the square of logarithms: each of 16 parts has about a sixteenth of the ratios
    place = np.log(spread_ratios(0.005, 0.03, 1e9, 1024) / 0.005) / np.log(6)
    counts, *_ = np.histogram2d(*place.T, bins=4, range=[[0, 1]] * 2)
    assert np.all(abs(counts - 64) <= 6)
    assert np.median(zeta[:, 0]) == pytest.approx(np.sqrt(0.005 * 0.03), rel=0.02)


STEEL = Material(210e9, 0.3, 7850.0)
RANGES = Ranges(np.array([1e6, 1e6]), np.array([1e8, 1e8]))


def systems(k):
    """A shaft with a disc on two bearings of the stiffness k (m, 2) [N/m]."""
    one = np.ones((len(k), 2))
    return WhirlSystems(
        nodes=3, first=(0, 1), length=0.1 * one, d_o=0.03 * one, d_i=0.0 * one, material=STEEL,
        kappa=np.full(2, Element(1.0, 1.0, 0.0, STEEL).kappa),
        springs=(Springs(0, None, k[:, 0]), Springs(4, None, k[:, 1])),
        discs=(Discs(1, one[:, 0], 1e-3 * one[:, 0], 5e-4 * one[:, 0]),),
    )  # fmt: skip


def test_every_member_has_the_speed_and_lies_in_the_ranges():
    wanted = float(systems(np.array([[8e6, 2e7]])).critical_speeds(1)[0][0, 0])
    found = ensemble(RANGES, (wanted,), systems, 5, seed=1)
    assert len(found.members) == found.kept.sum() >= 5
    assert systems(found.members).critical_speeds(1)[0] == pytest.approx(wanted, rel=2e-8)
    assert ((found.members >= RANGES.low) & (found.members <= RANGES.high)).all()
    assert not (found.kept & ~found.met).any()
    x = np.array([[0.0, 0.25], [0.5, 1.0]])
    assert RANGES.parameters(x)[1] == pytest.approx([1e7, 1e8])
    assert RANGES.places(RANGES.parameters(x)) == pytest.approx(x)
    k = np.array([[8e6, 2e7]])
    before, after = (systems(one).critical_speeds(1)[0][0, 0] for one in (k, k * [1.001, 1.0]))
    slope = np.log(after / before) / np.log(1.001)
    assert elasticities(RANGES, k, systems, 1)[0, 0, 0] == pytest.approx(slope, rel=1e-3)
