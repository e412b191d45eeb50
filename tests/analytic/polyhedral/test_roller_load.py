"""The ring under its rollers: a round one by Michell, any by reciprocity with the pressure."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.special import j1

from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.ring import lame

UNIT = {"E": 1.0, "nu": 0.3, "assumption": "plane stress"}


def round_ring(z, d_i):
    return Sector(z=z, d_e=80.0, d_i=d_i, rho=d_i / 2 * (1 - 1e-10))


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
        up, down = r**n, (t / r) ** n
        radial = [
            -(n + 1) * (n - 2) * up,
            -(n + 2) * (n - 1) * down,
            -n * (n - 1) * up / r**2,
            -n * (n + 1) * down / r**2,
        ]
        shear = [
            n * (n + 1) * up,
            -n * (n - 1) * down,
            n * (n - 1) * up / r**2,
            -n * (n + 1) * down / r**2,
        ]
        move = [(kappa - n - 1) * up * r, (kappa + n - 1) * down * r, -n * up / r, n * down / r]
        return radial, shear, move

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


@pytest.mark.parametrize("z", [3, 6, 12, 48])
def test_the_mean_over_the_rim_is_the_mean_of_its_points(z):
    ring = Sector(z=z, d_e=80.0, d_i=72.0, rho=2.0)
    load = roller_load(sector=ring, a=0.4)
    nodes, w = np.polynomial.legendre.leggauss(100)
    ends = np.array([0, 0.4 / 40, np.pi / z])
    total = 0.0
    for low, high in pairwise(ends):
        theta = (low + high) / 2 + (high - low) / 2 * nodes
        total += (high - low) / 2 * float(w @ load.rim_displacement(theta, **UNIT))
    assert total * z / np.pi == pytest.approx(load.mean_rim_displacement(**UNIT), rel=1e-5)


def bore_work(ring, field, nu):
    """Work of a unit pressure on the bore's displacement under `field`, one sector; E = 1."""
    kappa = (3 - nu) / (1 + nu)
    nodes, w = np.polynomial.legendre.leggauss(200)
    work = 0.0
    for low, high in ((0, ring.straight), (ring.straight, ring.half_bore)):
        s = (low + high) / 2 + (high - low) / 2 * nodes
        zeta = ring.bore(s)
        phi, dphi, psi = field(zeta)
        move = (1 + nu) * (kappa * phi - zeta * dphi.conj() - psi.conj())
        work += (high - low) * float(w @ (move * ring.normal(s).conj()).real)
    return work


@pytest.mark.parametrize("nu", [0.0, 0.3])
@pytest.mark.parametrize(("z", "d_i", "rho"), [(3, 72, 2), (6, 72, 2), (6, 40, 0.5), (12, 78, 5)])
def test_the_pressures_work_under_the_rollers_is_the_rollers_work_under_the_pressure(
    z, d_i, rho, nu
):
    ring = Sector(z=z, d_e=80.0, d_i=d_i, rho=rho)
    a = 0.3
    turn = np.arange(1, 41) * np.pi / 41
    share = np.sin(turn) ** 2 * 2 / 41  # of N, at the abscissae a cos(turn) of the semi-ellipse
    u = pressed(ring).rim_displacement(a * np.cos(turn) / 40).real
    rollers = -float(share @ u)
    assert bore_work(ring, roller_load(sector=ring, a=a), nu) == pytest.approx(rollers, rel=1e-8)


@pytest.mark.parametrize("z", [3, 6, 24])
def test_the_bore_stays_free_of_the_rollers_forces(z):
    ring = Sector(z=z, d_e=80.0, d_i=72.0, rho=2.0)
    zeta = ring.bore(np.linspace(0, ring.half_bore, 777))
    load = roller_load(sector=ring, a=0.1)
    force = load(zeta).force(zeta)
    assert np.abs(force).max() < 2e-8  # N = 1
    assert load.correction.residual < 1e-7


def test_under_a_point_the_dent_grows_with_the_logarithm_of_the_width():
    ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    wide, narrow = (
        float(roller_load(sector=ring, a=a).rim_displacement(0.0, **UNIT)[0]) for a in (0.01, 0.001)
    )
    assert wide - narrow == pytest.approx(2 / np.pi * np.log(10), rel=1e-4)  # a half plane's


def test_patches_that_overlap_and_angles_of_other_sectors_are_refused():
    ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    with pytest.raises(ValueError, match="the patches overlap: a must be below"):
        roller_load(sector=ring, a=21.0)
    with pytest.raises(ValueError, match="angles reach from 0 to pi/z, got theta="):
        roller_load(sector=ring, a=0.1).rim_displacement(1.0, **UNIT)
