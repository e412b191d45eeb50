"""Windup and shock of clutches with smeared races; force in the cuts and energy of one race."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.ring.loaded_race import LoadedRace
from analytic.ring.race_work import cut_force, strain_energy
from analytic.ring.windup import compliances, ratios

F, L, R = 3407.0, 9e-3, 4.02e-3
RACE = LoadedRace(r_i=19.44e-3, r_o=26.23e-3, E=206e9, nu=0.3, assumption="plane stress",
                  loaded="bore", n=12, P=F / L, a=0.154e-3)  # fmt: skip


def test_the_peak_force_is_that_of_equal_energies():
    """Energies by summing N d delta in steps, of both models, at the forces of the table."""
    parts = compliances(RACE, R=R, F=F, L=L)
    smeared_c, fourier_c, g = parts
    _, peak = ratios([parts])

    def energy(c, N):
        forces = np.linspace(1e-6 * N, N, 200_001)
        delta = forces * (c + g * np.log(F / forces))
        return float(((forces[1:] + forces[:-1]) / 2) @ np.diff(delta))

    assert energy(smeared_c, F) == pytest.approx(energy(fourier_c, F / peak), rel=1e-7)


def test_a_dent_grows_with_the_force_as_the_table_has_it():
    _, c, g = compliances(RACE, R=R, F=F, L=L)
    light = replace(RACE, P=RACE.P / 2, a=RACE.a / np.sqrt(2))
    _, c_half, _ = compliances(light, R=R, F=F / 2, L=L)
    assert c_half == pytest.approx(c + g * np.log(2), rel=1e-5)


@pytest.mark.parametrize("loaded", ["bore", "rim"])
def test_the_cut_carries_the_hoop_stress_between_two_loads(loaded):
    race = replace(RACE, loaded=loaded)
    carried, _ = quad(lambda r: float(race.at(r, np.pi / race.n).sigma_theta), race.r_i, race.r_o)
    assert cut_force(race) == pytest.approx(carried, rel=1e-6)


def test_the_energy_is_the_integral_of_stress_and_strain():
    """In the wall beyond some half-widths from the patches, and of the mean where they are many."""
    race = replace(RACE, n=200, P=RACE.P / 10, a=RACE.a / 2)
    mean = race.ring.mean_displacement(race.r) * race.n * race.P / 2
    assert strain_energy(race) > mean
    assert strain_energy(race) == pytest.approx(mean, rel=0.2)
