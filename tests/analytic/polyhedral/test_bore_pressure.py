"""The polyhedral ring under pressure: Lamé in the limits, and two truncations that agree."""

import numpy as np
import pytest

from analytic.polyhedral import free_rim
from analytic.polyhedral.bore_pressure import (
    mean_rim_displacement,
    pressed,
    rim_displacement,
    stiffness_factors,
)
from analytic.polyhedral.sector import Sector
from analytic.ring import lame

RING = {"d_e": 80.0, "d_i": 72.0, "rho": 2.0}
STEEL = {"E": 210e3, "nu": 0.3}


@pytest.mark.parametrize("z", [3, 6, 48])
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_a_round_bore_is_lames(z, assumption):
    ring = Sector(z=z, d_e=80.0, d_i=60.0, rho=30 * (1 - 1e-10))
    u = rim_displacement([0, 0.5 * np.pi / z], sector=ring, p=7.0, **STEEL, assumption=assumption)
    exact = lame.radial_displacement(40.0, r_i=30.0, r_o=40.0, p_i=7.0, **STEEL, ends=assumption)
    np.testing.assert_allclose(u, exact, rtol=1e-8, atol=1e-8 * exact)


def test_many_corners_come_down_to_the_round_ring():
    limit = 76**2 / (72 * 80)  # d_m²/(d_i d_e)
    above = [
        stiffness_factors(sector=Sector(z=z, **RING), nu=0.3, assumption="plane stress")
        for z in (12, 24, 48, 96, 192)
    ]
    excess = np.array([[K.mid, K.mean, K.corner] for K in above]) / limit - 1
    assert np.all(np.diff(excess, axis=0) < 0)
    assert np.all(excess[-1] > 0)
    np.testing.assert_allclose(excess[-2] / excess[-1], 4, rtol=0.05)  # falls as 1/z²


@pytest.mark.parametrize("z", [3, 4, 6, 12, 48])
@pytest.mark.parametrize(("d_i", "rho"), [(72.0, 2.0), (78.4, 10.0), (78.4, 0.25), (40.0, 0.25)])
def test_two_truncations_agree_and_the_residual_says_so(z, d_i, rho, monkeypatch):
    ring = Sector(z=z, d_e=80.0, d_i=d_i, rho=rho)
    theta = np.array([0, np.pi / z])
    fine = pressed(ring)
    u = fine.rim_displacement(theta).real
    monkeypatch.setattr(free_rim, "DENSITIES", (4.0,))
    pressed.cache_clear()
    coarse = pressed(ring)
    pressed.cache_clear()
    assert coarse.basis.powers < fine.basis.powers
    assert fine.residual < coarse.residual < 1e-4
    error = np.abs(coarse.rim_displacement(theta).real - u) / np.abs(u).max()
    assert error.max() < coarse.residual
    assert error.max() < 1e-6


def test_the_error_falls_exponentially_with_the_number_of_poles():
    ring = Sector(z=6, **RING)
    residuals = []
    for density in (1.5, 2.5, 3.5, 4.5):
        fit = free_rim._fit(ring, density)
        c = fit.coefficients(-np.ones(fit.zeta[fit.used].shape, dtype=complex))
        residuals.append(np.abs(fit.rows @ c + 1).max())
    assert np.all(np.diff(np.log10(residuals)) < -0.8)


def test_the_mean_lies_between_flat_and_corner_and_is_that_of_the_points():
    ring = Sector(z=6, **RING)
    theta = np.linspace(0, np.pi / 3, 2000, endpoint=False)
    u = pressed(ring).rim_displacement(theta).real
    assert mean_rim_displacement(pressed(ring)) == pytest.approx(u.mean(), rel=1e-12)


def test_plane_strain_is_stiffer_by_its_modulus():
    flat, deep = (
        stiffness_factors(sector=Sector(z=6, **RING), nu=0.3, assumption=assumption)
        for assumption in ("plane stress", "plane strain")
    )
    for name in ("mid", "mean", "corner"):
        assert getattr(deep, name) * 0.91 == pytest.approx(getattr(flat, name), rel=1e-12)


def test_the_corner_of_a_triangle_draws_in():
    K = stiffness_factors(sector=Sector(z=3, **RING), nu=0.3, assumption="plane stress")
    assert K.corner < 0 < K.mid < K.mean


def test_it_does_not_notice_units():
    metres = {name: value / 1e3 for name, value in RING.items()}
    K, K_m = (
        stiffness_factors(sector=Sector(z=6, **ring), nu=0.3, assumption="plane stress")
        for ring in (RING, metres)
    )
    assert K_m.mid == pytest.approx(K.mid, rel=1e-9)
    si = {"p": 5e6, "E": 210e9, "nu": 0.3, "assumption": "plane stress"}
    u = rim_displacement(0.2, sector=Sector(z=6, **RING), **si | {"p": 5.0, "E": 210e3})
    u_m = rim_displacement(0.2, sector=Sector(z=6, **metres), **si)
    np.testing.assert_allclose(1e3 * u_m, u, rtol=1e-9)


def test_what_the_series_cannot_do_is_refused_with_its_residual():
    membrane = Sector(z=3, d_e=80.0, d_i=79.6, rho=30.0)
    with pytest.raises(ArithmeticError, match=r"of the load on the bore, allowed is 0\.0001: z=3"):
        pressed(membrane)
    with pytest.raises(ArithmeticError, match="so many corners in so thick a ring"):
        pressed(Sector(z=400, d_e=80.0, d_i=8.0, rho=1.0))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"E": 0.0}, "Young's modulus must be positive"),
        ({"nu": 0.5}, "Poisson's ratio must lie in"),
        ({"p": np.nan}, "the pressure p must be finite"),
        ({"assumption": "thin"}, "assumption is one of"),
        ({"theta": np.inf}, "angle must be finite"),
    ],
)
def test_wrong_input_is_named(change, message):
    given = {"theta": 0.0, "p": 1.0, **STEEL, "assumption": "plane stress"} | change
    with pytest.raises(ValueError, match=message):
        rim_displacement(given.pop("theta"), sector=Sector(z=6, **RING), **given)
