"""Best crowns: nothing that is known or drawn at random is better, and scales don't matter."""

from dataclasses import astuple

import numpy as np
import pytest

from analytic.contact import crown, strips
from analytic.contact.best_crown import HIGH, LOW, best_crown

ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 113.2e9}  # huang2018 Table 1, steel
LOADS = (50.0, 3407.0, 20000.0)  # N: b/l = 0.0015, 0.0125, 0.03
STRIPS = 60
BETTER = 1e-3  # by which the lattice may miss the best
DESIGNS = ((1, 0.7, 10e-6), (5, 0.7, 15e-6), (1, 0.4, 10e-6), (3, 0.4, 10e-6), (1, 0.5, 8e-6),
           (5, 0.5, 15e-6), (2.1507, 0.6763, 12.1e-6), (2.80, 0.7, 11.8e-6))  # fmt: skip
Y = crown.slice_centres(length=ROLLER["length"], slices=STRIPS)


def unit(load, length=ROLLER["length"], E_star=ROLLER["E_star"]):
    return load / (np.pi * length * E_star)


def logarithmic(y, K_1, K_2, z_m, load):
    scale = {"load": load, "length": ROLLER["length"], "E_star": ROLLER["E_star"]}
    return crown.logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m, **scale)


def peak(gap, load):
    return strips.press(gap, load=load, tolerance=1e-8, **ROLLER).peak


def drawn(load, count, tilt=0.0):
    """Peaks of crowns drawn from the whole range, and about the best one found."""
    rng = np.random.default_rng(7)
    low, high = np.log(LOW), np.log(HIGH)
    best = best_crown(load=load, tilt=(-tilt, tilt), **ROLLER)
    about = np.log([best.K_1, best.K_2, best.z_m / unit(load)])
    anywhere = low + (high - low) * rng.random((count, 3))
    near = about + 0.15 * rng.standard_normal((count, 3))
    K_1, K_2, m = np.exp(np.clip(np.vstack([anywhere, near]), low, high)).T[:, :, None]
    gap = logarithmic(Y, K_1, K_2, m * unit(load), load)
    return best, np.maximum(peak(gap - tilt * Y, load), peak(gap + tilt * Y, load))


@pytest.mark.parametrize("load", LOADS)
def test_no_crown_that_has_a_name_is_better(load):
    best = best_crown(load=load, **ROLLER).peak
    scale = {"load": load, "length": ROLLER["length"], "E_star": ROLLER["E_star"]}
    b = np.sqrt(4 * load * ROLLER["R"] / (np.pi * ROLLER["E_star"] * ROLLER["length"]))
    gaps = [crown.lundberg(Y, **scale), crown.johns_gohar(Y, half_width=b, **scale)]
    gaps += [logarithmic(Y, *design, load) for design in DESIGNS]
    assert best <= (1 + BETTER) * peak(np.array(gaps), load).min()


@pytest.mark.parametrize("load", LOADS)
def test_no_crown_drawn_at_random_is_better(load):
    best, peaks = drawn(load, 400)
    assert best.peak <= (1 + BETTER) * peaks.min()


@pytest.mark.parametrize(("load", "tilt"), [(50.0, 5e-4), (340.0, 3e-3), (3407.0, 1e-3)])
def test_no_crown_drawn_at_random_is_better_under_tilt(load, tilt):
    best, peaks = drawn(load, 300, tilt)
    assert best.peak <= (1 + BETTER) * peaks.min()


def test_the_peak_told_is_that_of_the_crown_told():
    best = best_crown(load=3407.0, **ROLLER)
    assert peak(logarithmic(Y, best.K_1, best.K_2, best.z_m, 3407.0), 3407.0) == pytest.approx(
        best.peak, rel=1e-6
    )


@pytest.mark.parametrize(
    ("load", "length", "E_star"),
    [
        pytest.param(2.0, 1.0, 1.0, id="load and radius"),
        pytest.param(1.0, 3.0, 1.0, id="length and radius"),
        pytest.param(1.0, 1.0, 7.3, id="modulus and radius"),
        pytest.param(1.0, 1e3, 1e-6, id="mm and MPa"),
    ],
)
def test_contacts_of_the_same_b_over_l_have_the_same_best_crown(load, length, E_star):
    """b²/l² = 4 W R/(π E* l³) stays, and with it K_1, K_2, z_m/A_1 and p/p_0."""

    def scaled(load, length, E_star):
        R = ROLLER["R"] * E_star / ROLLER["E_star"] * (length / 9e-3) ** 3 / (load / 3407.0)
        found = best_crown(load=load, length=length, R=R, E_star=E_star)
        p_0 = np.sqrt(load / length * E_star / (np.pi * R))
        return found.K_1, found.K_2, found.z_m / unit(load, length, E_star), found.peak / p_0

    there = scaled(load * 3407.0, length * 9e-3, E_star * ROLLER["E_star"])
    assert there == pytest.approx(scaled(3407.0, 9e-3, ROLLER["E_star"]), rel=1e-9)


def test_a_tilt_calls_for_more_crown_and_costs_pressure():
    found = [best_crown(load=3407.0, tilt=(-t, t), **ROLLER) for t in (0.0, 2e-4, 6e-4, 2e-3)]
    drops = [float(logarithmic(0.95 * 4.5e-3, b.K_1, b.K_2, b.z_m, 3407.0)) for b in found]
    assert np.all(np.diff(drops) > 0)
    assert np.all(np.diff([b.peak for b in found]) > 0)


def test_the_highest_peak_of_several_tilts_counts():
    one, both = (best_crown(load=3407.0, tilt=t, **ROLLER) for t in (1e-3, (-1e-3, 0.0, 1e-3)))
    assert both.peak == pytest.approx(one.peak, rel=1e-6)  # the crown is the same at both ends
    assert best_crown(load=3407.0, tilt=(0.0, 1e-3), **ROLLER).peak >= one.peak * (1 - 1e-9)


@pytest.mark.parametrize("load", [340.0, 3407.0])
def test_best_crowns_stay_a_few_per_cent_above_hertz(load):
    """An even pressure is the least that a load can have; the ends must fall off."""
    p_0 = np.sqrt(load / 9e-3 * ROLLER["E_star"] / (np.pi * ROLLER["R"]))
    assert 1.0 < best_crown(load=load, **ROLLER).peak / p_0 < 1.01


@pytest.mark.parametrize("R", [5e-3, 20e-3])
def test_wide_contacts_and_contacts_on_a_strip_or_two_have_a_best_crown(R):
    wide = best_crown(load=20000.0, **ROLLER | {"R": R})
    narrow = best_crown(load=50.0, tilt=(-0.017, 0.0, 0.017), **ROLLER | {"R": R})
    assert np.all(np.isfinite([*astuple(wide), *astuple(narrow)]))


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"load": 0.0}, "load must be positive and finite"),
        ({"load": np.nan}, "load must be positive and finite"),
        ({"length": -1.0}, "length must be positive and finite"),
        ({"R": np.inf}, "relative radius must be positive and finite"),
        ({"E_star": 0.0}, "contact modulus must be positive and finite"),
        ({"tilt": np.nan}, "tilt must be finite, got nan rad"),
        ({"tilt": []}, "tilt must be an angle or several"),
        ({"n": 0}, "slices must be at least 1"),
        ({"load": 1e9}, "a line contact must be longer than wide"),
    ],
)
def test_what_makes_no_sense_is_refused_in_one_line(wrong, message):
    with pytest.raises(ValueError, match=message) as caught:
        best_crown(**{"load": 3407.0, **ROLLER} | wrong)
    assert "\n" not in str(caught.value)
