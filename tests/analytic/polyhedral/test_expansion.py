"""Expansion of the ring against Lamé and the equilibrium of its sections."""

import numpy as np
import pytest

from analytic.polyhedral import expansion
from analytic.ring import lame

RING = {"d_i": 0.072, "d_e": 0.08}


def test_the_ratio_of_the_hoop_stresses_is_k_not_its_square():
    K = 1.25
    p_1r = expansion.touching_pressure(j_D=6e-5, **RING, E=210e9, K=K)
    round_ring = expansion.hoop_stress(j_D=6e-5, d_m=0.076, E=210e9)
    # a hexagon's side is d_i/2, and the cuts through its ends make 60 deg: p d_i/2 in each
    by_statics = p_1r * 0.036 / 0.004
    ratio = float(by_statics / round_ring)
    assert ratio == pytest.approx(K, rel=1e-12)
    of_ours = float(expansion.mean_hoop_stress(p=p_1r, **RING) / round_ring)
    assert of_ours == pytest.approx(ratio, rel=1e-12)
    p_1 = expansion.touching_pressure(j_D=6e-5, **RING, E=210e9)
    printed = K * float(p_1r / p_1)
    assert printed == pytest.approx(K**2)
    assert printed > 1.2 * ratio


@pytest.mark.parametrize("delta_1", [0.5e-3, 4e-3, 10e-3])
def test_k_of_many_corners_is_lames(delta_1):
    d_e, j_D, E = 0.08, 6e-5, 210e9
    d_i = d_e - 2 * delta_1
    unit = {"r_i": d_i / 2, "r_o": d_e / 2, "p_i": 1.0, "E": E, "nu": 0.3, "ends": "plane stress"}
    p_1r = j_D / 2 / float(lame.radial_displacement(d_e / 2, **unit))
    p_1 = 2 * delta_1 * (E * j_D / ((d_i + d_e) / 2)) / d_i
    factor = float(expansion.many_corners_factor(d_i=d_i, d_e=d_e))
    assert p_1r / p_1 == pytest.approx(factor, rel=1e-12)
    left_out = delta_1**2 / (d_i * d_e)  # by K = 1
    assert factor - 1 == pytest.approx(left_out, rel=1e-9)


def test_p_1_takes_the_clearance_up_and_does_not_create_it():
    d_i, d_e, D_i, d = 0.072, 0.08, 0.10006, 0.01
    j_D, K = D_i - d_e - 2 * d, float(expansion.many_corners_factor(d_i=d_i, d_e=d_e))
    p = float(expansion.touching_pressure(j_D=j_D, d_i=d_i, d_e=d_e, E=210e9, K=K))
    grown = 2 * float(
        lame.radial_displacement(
            d_e / 2, r_i=d_i / 2, r_o=d_e / 2, p_i=p, E=210e9, nu=0.3, ends="plane stress"
        )
    )
    assert d_e + 2 * d < D_i * (1 - 5e-4)  # free without pressure
    assert d_e + grown + 2 * d == pytest.approx(D_i, rel=1e-12)


@pytest.mark.parametrize("z", [3, 4, 6, 12])
def test_pressure_from_corner_to_corner_is_in_balance_with_the_mean_hoop_stress(z):
    end = np.pi / z
    sigma = float(expansion.mean_hoop_stress(p=5e6, **RING))
    cuts = 2 * sigma * 0.004 * np.sin(end)  # hoop forces along their tangents
    assert cuts == pytest.approx(5e6 * 2 * 0.036 * np.sin(end), rel=1e-12)


def test_hoop_stress_of_the_clearance_lets_the_mean_diameter_grow_by_it():
    d_m = float(expansion.mean_diameter(**RING))
    j_D = float(expansion.clearance(D_i=0.10006, d_e=0.08, d=0.01))
    assert (d_m, j_D) == pytest.approx((0.076, 6e-5))
    sigma_t = expansion.hoop_stress(j_D=j_D, d_m=d_m, E=210e9)
    assert float(expansion.growth(sigma_t=sigma_t, d_m=d_m, E=210e9)) == pytest.approx(6e-5)


@pytest.mark.parametrize("ends", ["plane stress", "plane strain"])
def test_under_lames_pressure_a_round_ring_takes_the_clearance_up(ends):
    steel = {"E": 210e9, "nu": 0.3, "ends": ends}
    p = float(expansion.round_ring_pressure(j_D=6e-5, **RING, **steel))
    u = lame.radial_displacement(0.04, r_i=0.036, r_o=0.04, p_i=p, **steel)
    assert 2 * float(u) == pytest.approx(6e-5, rel=1e-12)
    p_1 = float(expansion.touching_pressure(j_D=6e-5, **RING, E=210e9))
    factor = float(expansion.many_corners_factor(**RING))
    assert factor == pytest.approx(1.0028, abs=5e-5)
    in_plane_stress = p == pytest.approx(factor * p_1, rel=1e-12)
    assert in_plane_stress == (ends == "plane stress")
