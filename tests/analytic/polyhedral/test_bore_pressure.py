"""The polyhedral ring under pressure and rollers against Lamé and Michell, and its residual."""

import numpy as np
import pytest
from scipy.special import j1

from analytic.polyhedral import free_rim
from analytic.polyhedral.bore_pressure import pressed, rim_displacement
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.ring import lame

STEEL = {"E": 210e3, "nu": 0.3}
UNIT = {"E": 1.0, "nu": 0.3, "assumption": "plane stress"}


def round_ring(z, d_i):
    return Sector(z=z, d_e=80.0, d_i=d_i, rho=d_i / 2 * (1 - 1e-10))


@pytest.mark.parametrize("z", [3, 6, 48])
@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_a_round_bore_is_lames(z, assumption):
    ring = round_ring(z, 60.0)
    u = rim_displacement([0, 0.5 * np.pi / z], sector=ring, p=7.0, **STEEL, assumption=assumption)
    exact = lame.radial_displacement(40.0, r_i=30.0, r_o=40.0, p_i=7.0, **STEEL, ends=assumption)
    np.testing.assert_allclose(u, exact, rtol=1e-8, atol=1e-8 * exact)


@pytest.mark.parametrize("z", [3, 4, 6, 12, 48])
@pytest.mark.parametrize(("d_i", "rho"), [(72.0, 2.0), (78.4, 10.0), (78.4, 0.25), (40.0, 0.25)])
def test_two_truncations_agree_within_the_residual(z, d_i, rho, monkeypatch):
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


def test_what_the_series_cannot_do_is_refused_with_its_residual():
    membrane = Sector(z=3, d_e=80.0, d_i=79.6, rho=30.0)
    with pytest.raises(ArithmeticError, match=r"permissible 0\.0001, got z=3"):
        pressed(membrane)
    with pytest.raises(ArithmeticError, match="cannot be evaluated for this number of corners"):
        pressed(Sector(z=400, d_e=80.0, d_i=8.0, rho=1.0))


def michell(theta, *, z, r_i, r_e, alpha, nu, harmonics):
    """u_r of a round ring's outside under unit forces on patches, harmonic by harmonic.

    J. R. Barber, Elasticity, Tables 8.1 and 9.1: r^(n+2), r^(2-n), r^n and r^-n times cos(n theta).
    Plane stress, E = 1; inside free.
    """
    mean = z / (2 * np.pi * r_e)
    u = float(
        lame.radial_displacement(
            r_e, r_i=r_i, r_o=r_e, p_i=0.0, p_o=mean, E=1.0, nu=nu, ends="plane stress"
        )
    )
    for n in z * np.arange(1, harmonics + 1):
        q = -2 * mean * 2 * j1(n * alpha) / (n * alpha)
        u += q * _harmonic(n, r_i / r_e, r_e, nu) * np.cos(n * theta)
    return u


def _harmonic(n, t, r_e, nu):
    """u_r at r = 1 times r_e for sigma_r = cos(n theta) there; decaying terms scaled at r = t."""
    kappa = (3 - nu) / (1 + nu)

    def columns(r):
        size = np.array([r**n, (t / r) ** n, r ** (n - 2), (t / r) ** n / r**2])
        radial = -size * [(n + 1) * (n - 2), (n + 2) * (n - 1), n * (n - 1), n * (n + 1)]
        shear = size * [n * (n + 1), -n * (n - 1), n * (n - 1), -n * (n + 1)]
        return radial, shear, size * r * [kappa - n - 1, kappa + n - 1, -n, n]

    radial, shear, move = columns(1.0)
    inner_radial, inner_shear, _ = columns(t)
    rows = np.array([radial, shear, inner_radial, inner_shear]) / n**2
    constants = np.linalg.solve(rows, np.array([1.0, 0, 0, 0]) / n**2)
    return (1 + nu) * r_e * float(np.dot(move, constants))


@pytest.mark.parametrize(("z", "a"), [(3, 2.0), (6, 1.0), (12, 1.0)])
def test_a_round_ring_moves_as_michells_harmonics_do(z, a):
    load = roller_load(sector=round_ring(z, 60.0), a=a)
    theta = np.array([0.0, 0.3, 1.0]) * np.pi / z
    partner = [
        michell(t, z=z, r_i=30.0, r_e=40.0, alpha=a / 40, nu=0.3, harmonics=2000) for t in theta
    ]
    # 2000 harmonics leave 1e-7 in the patch's middle
    np.testing.assert_allclose(load.rim_displacement(theta, **UNIT), partner, rtol=3e-7)


def test_the_mean_is_lames_in_a_round_ring():
    mean = roller_load(sector=round_ring(6, 72.0), a=0.1).mean_rim_displacement(**UNIT)
    exact = lame.radial_displacement(
        40.0, r_i=36.0, r_o=40.0, p_i=0.0, p_o=6 / (2 * np.pi * 40), E=1.0, nu=0.3,
        ends="plane stress")  # fmt: skip
    assert mean == pytest.approx(float(exact), rel=1e-8)
