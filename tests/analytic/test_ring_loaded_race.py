"""Rings under waves and Hertz patches: equilibrium, energies, sections, uniformly loaded ring."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.ring import loaded_race, smeared
from analytic.ring.fourier_ring import FourierRing
from analytic.ring.loaded_race import LoadedRace
from analytic.ring.race_work import cut_force, strain_energy
from analytic.ring.windup import compliances, ratios

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


def test_the_smeared_race_is_too_soft_from_12_sprags_on_and_too_stiff_with_6():
    """Walls of the paper's races, the local indentation to the wall's depth subtracted."""
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


UNIT = {"E": 1.0, "nu": 0.3, "assumption": "plane strain"}
WAVES = np.array([1.0, -0.4, 0.7, 0.2, -0.1])


def waves(n, theta):
    return WAVES @ np.cos(np.outer(np.arange(WAVES.size), n * np.asarray(theta)))


@WALLS
@pytest.mark.parametrize("ratio", [1.02, 1e3])
@pytest.mark.parametrize("n", [2, 100_000])
def test_walls_carry_the_pressure_and_nothing_else(loaded, ratio, n):
    ring = FourierRing(r_i=1.0, r_o=ratio, loaded=loaded, n=n, p=WAVES, **UNIT)
    theta = np.linspace(0, 2.2 / n, 9)
    bore, rim = ring.at(1.0, theta), ring.at(ratio, theta)
    near, far = (bore, rim) if loaded == "bore" else (rim, bore)
    size = np.abs(bore.sigma_theta).max() + np.abs(rim.sigma_theta).max()
    exact = {"rtol": 0, "atol": 1e-13 * size * (ratio / (ratio - 1)) ** 1.5}
    np.testing.assert_allclose(near.sigma_r, -waves(n, theta), **exact)
    np.testing.assert_allclose([near.tau, far.sigma_r, far.tau], 0.0, **exact)


@WALLS
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_the_field_is_in_equilibrium_and_obeys_hooke(loaded, assumption):
    ring = FourierRing(
        r_i=1.0, r_o=1.5, loaded=loaded, n=3, p=WAVES, E=1.0, nu=0.3, assumption=assumption
    )
    r, t, h = 1.2, 0.37, 1e-5
    E, nu = (1.0, 0.3) if assumption == "plane stress" else (1 / 0.91, 0.3 / 0.7)
    here = ring.at(r, t)

    def across(name, radial=h, turned=0.0):
        high, low = (getattr(ring.at(r + k * radial, t + k * turned), name) for k in (1, -1))
        return float(high - low) / (2 * h)

    def along(name):
        return across(name, radial=0.0, turned=h) / r

    size, near = float(abs(here.sigma_theta) + abs(here.tau)), {"abs": 1e-8}
    balance = (
        across("sigma_r") + along("tau") + float(here.sigma_r - here.sigma_theta) / r,
        across("tau") + along("sigma_theta") + 2 * float(here.tau) / r,
    )
    assert balance == pytest.approx((0, 0), abs=1e-7 * size)
    strains = (
        across("u_r"),
        float(here.u_r) / r + along("u_theta"),
        along("u_r") + across("u_theta") - float(here.u_theta) / r,
    )
    hooke = (
        float(here.sigma_r - nu * here.sigma_theta) / E,
        float(here.sigma_theta - nu * here.sigma_r) / E,
        float(here.tau) * 2 * 1.3,
    )
    assert strains == pytest.approx(hooke, **near)


F, L, R = 3407.0, 9e-3, 4.02e-3
WINDUP_RACE = LoadedRace(r_i=19.44e-3, r_o=26.23e-3, E=206e9, nu=0.3, assumption="plane stress",
                  loaded="bore", n=12, P=F / L, a=0.154e-3)  # fmt: skip


@WALLS
def test_the_cut_carries_the_hoop_stress_between_two_loads(loaded):
    race = replace(WINDUP_RACE, loaded=loaded)
    carried, _ = quad(lambda r: float(race.at(r, np.pi / race.n).sigma_theta), race.r_i, race.r_o)
    assert cut_force(race) == pytest.approx(carried, rel=1e-6)


def test_the_energy_is_the_integral_of_stress_and_strain():
    """In the wall beyond some half-widths from the patches, and of the mean where they are many."""
    race = replace(WINDUP_RACE, n=200, P=WINDUP_RACE.P / 10, a=WINDUP_RACE.a / 2)
    mean = race.ring.mean_displacement(race.r) * race.n * race.P / 2
    assert strain_energy(race) > mean
    assert strain_energy(race) == pytest.approx(mean, rel=0.2)


def test_the_peak_force_is_that_of_equal_energies():
    """Energies by summing N d delta in steps, of both models, at the forces of the table."""
    parts = compliances(WINDUP_RACE, R=R, F=F, L=L)
    smeared_c, fourier_c, g = parts
    _, peak = ratios([parts])

    def energy(c, N):
        forces = np.linspace(1e-6 * N, N, 200_001)
        delta = forces * (c + g * np.log(F / forces))
        return float(((forces[1:] + forces[:-1]) / 2) @ np.diff(delta))

    assert energy(smeared_c, F) == pytest.approx(energy(fourier_c, F / peak), rel=1e-7)


def test_the_displacement_is_even_and_periodic():
    race = LoadedRace(loaded="bore", **RACE)
    one, other = race.at(race.r, [0.1, 0.003]), race.at(race.r, [-0.1, np.pi / 6 + 0.003])
    np.testing.assert_allclose(one.u_r, other.u_r, rtol=1e-12)
    assert float(one.u_theta[0]) == pytest.approx(-float(other.u_theta[0]), rel=1e-9)
