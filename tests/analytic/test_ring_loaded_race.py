"""Races under Hertz patches: the series' rest, the load borne, and Eq. 6 beside it."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.ring import loaded_race, smeared
from analytic.ring.loaded_race import LoadedRace

RACE = {"r_i": 19.44e-3, "r_o": 26.23e-3, "E": 206e9, "nu": 0.3, "assumption": "plane stress",
        "n": 12, "P": 378.6e3, "a": 0.154e-3}  # fmt: skip
WALLS = pytest.mark.parametrize("loaded", ["bore", "rim"])
ANGLES = np.concatenate([np.linspace(0, 0.02, 33), np.linspace(0.03, np.pi / 12, 9)])


@WALLS
@pytest.mark.parametrize("a", [1.9e-5, 0.154e-3, 1.5e-3])
def test_more_waves_change_nothing_on_the_loaded_wall(loaded, a, monkeypatch):
    few = LoadedRace(loaded=loaded, **RACE | {"a": a})
    found = few.at(few.r, ANGLES)
    monkeypatch.setattr(loaded_race, "WAVES", 8 * loaded_race.WAVES)
    many = LoadedRace(loaded=loaded, **RACE | {"a": a})
    assert many.ring.p.size > 4 * few.ring.p.size
    exact = many.at(many.r, ANGLES)
    scale = np.abs(exact.u_r).max()
    rest = 1e-6 * few.alpha + 1e-9  # the remainder that the module states, over the whole
    np.testing.assert_allclose(found.u_r, exact.u_r, rtol=0, atol=rest * scale)
    np.testing.assert_allclose(found.u_theta, exact.u_theta, rtol=0, atol=rest * scale)
    stress = np.abs(exact.sigma_theta).max()
    np.testing.assert_allclose(found.sigma_theta, exact.sigma_theta, rtol=0, atol=1e-12 * stress)


@WALLS
def test_the_closed_sums_are_those_of_the_waves(loaded):
    """Without them the wall's displacement would still miss 1e-4 of itself."""
    race = LoadedRace(loaded=loaded, **RACE)
    closed, summed = race.at(race.r, ANGLES), race.ring.at(race.r, ANGLES)
    missed = np.abs(closed.u_r - summed.u_r).max() / np.abs(closed.u_r).max()
    assert 1e-7 < missed < 1e-3


@WALLS
def test_the_loaded_wall_bears_hertz_s_pressure_and_the_other_nothing(loaded):
    race = LoadedRace(loaded=loaded, **RACE)
    near = race.at(race.r, ANGLES)
    far = race.at(race.r_o if loaded == "bore" else race.r_i, ANGLES)
    peak = 2 * race.P / (np.pi * race.a)
    s = race.r * ANGLES / race.a
    ellipse = peak * np.sqrt(np.maximum(1 - s**2, 0))
    np.testing.assert_allclose(near.sigma_r, -ellipse, rtol=0, atol=1e-10 * peak)
    np.testing.assert_allclose([near.tau, far.tau, far.sigma_r], 0, atol=1e-10 * peak)


@WALLS
def test_the_cut_between_loads_carries_what_statics_says(loaded):
    race = LoadedRace(loaded=loaded, **RACE)
    r, w = np.polynomial.legendre.leggauss(40)
    half = (race.r_o - race.r_i) / 2
    hoop = race.at(race.r_i + half * (1 + r), np.pi / 12).sigma_theta
    along, _ = quad(lambda t: 2 / np.pi * np.sqrt(1 - t**2) * np.cos(race.alpha * t), -1, 1)
    push = race.P * along / (2 * np.sin(np.pi / 12))
    assert half * (w @ hoop) == pytest.approx(
        push if loaded == "bore" else -push,
        rel=1e-6,  # points of the rule nearer to the wall than a
    )


def test_the_displacement_is_even_and_periodic():
    race = LoadedRace(loaded="bore", **RACE)
    one, other = race.at(race.r, [0.1, 0.003]), race.at(race.r, [-0.1, np.pi / 6 + 0.003])
    np.testing.assert_allclose(one.u_r, other.u_r, rtol=1e-12)
    assert float(one.u_theta[0]) == pytest.approx(-float(other.u_theta[0]), rel=1e-9)


def test_betti_s_theorem_links_a_load_with_the_far_wall():
    """Loads on the bore move the rim as loads on the rim move the bore, patch over patch."""
    wide = RACE | {"a": 2e-3}
    bore = LoadedRace(loaded="bore", **wide)
    rim = LoadedRace(loaded="rim", **wide)
    s, w = np.polynomial.legendre.leggauss(60)

    def work(race, other):
        theta = other.alpha * s
        u = race.at(other.r, theta).u_r
        return other.a * (w @ (u * other.pressure(theta)))

    assert work(bore, rim) == pytest.approx(-work(rim, bore), rel=1e-4)  # of the root's end


@pytest.mark.parametrize(
    ("loaded", "radii", "printed"),
    [("bore", (19.44, 26.23), 13.117), ("rim", (7.21, 11.11), 7.564)],
)
def test_eq_6_by_hand(loaded, radii, printed):
    """Huang 2018, Eq. 6, with 3407 N on 9 mm, E = 206 GPa, nu = 0.3 [µm]."""
    low, high = radii
    bracket = (high**2 + low**2) / (high**2 - low**2) + (0.3 if loaded == "bore" else -0.3)
    by_hand = 3407 * 12 / (2 * np.pi * 9e-3 * 206e9) * bracket
    given = smeared.race_deflection(
        P=3407 / 9e-3, n=12, r_i=low * 1e-3, r_o=high * 1e-3, E=206e9, nu=0.3, loaded=loaded
    )
    assert float(given) == pytest.approx(by_hand, rel=1e-13)
    assert float(given) * 1e6 == pytest.approx(printed, abs=1e-3)


@WALLS
def test_the_smeared_ring_is_the_mean_of_the_loaded_one(loaded):
    race = LoadedRace(loaded=loaded, **RACE | {"a": 1e-3})
    x, w = np.polynomial.legendre.leggauss(400)
    u = race.at(race.r, np.pi / 24 * (1 + x)).u_r
    given = smeared.race_deflection(
        loaded=loaded, **{k: RACE[k] for k in ("P", "n", "r_i", "r_o", "E", "nu")}
    )
    assert abs(w @ u) / 2 == pytest.approx(float(given), rel=1e-7)


def test_the_smeared_race_is_too_soft_from_12_sprags_on_and_too_stiff_with_6():
    """Walls of the paper's races, the dent to the wall's depth taken out."""
    for loaded, ratio in (("bore", 26.23 / 19.44), ("rim", 11.11 / 7.21)):
        error = {
            n: smeared.smeared_error(n=n, ratio=ratio, a_r=0.0079, loaded=loaded)
            for n in (6, 12, 24)
        }
        assert error[6].load < 0
        assert 0.06 < error[12].load < 0.15
        assert 0.06 < error[24].load < 0.15
        assert 0 < error[12].total < error[12].load
        assert error[12].between > 0


@pytest.mark.parametrize(
    ("wrong", "said"),
    [({"P": 0.0}, "load per length"), ({"n": -1}, "number of loads"),
     ({"loaded": "side"}, "'bore' or 'rim'")],
)  # fmt: skip
def test_a_race_without_sense_is_refused(wrong, said):
    right = {"P": 1.0, "n": 12, "r_i": 1.0, "r_o": 2.0, "E": 1.0, "nu": 0.3, "loaded": "bore"}
    with pytest.raises(ValueError, match=said):
        smeared.race_deflection(**right | wrong)
