"""Expected errors of clutches between shafts and of beam theories."""

import math

import numpy as np
import pytest

from analytic.bounds.rotor import clutch as bounds
from analytic.bounds.rotor import shaft
from analytic.bounds.rotor.clutch_tilted import SHARE, left_out, summed
from analytic.rotor.clutch import SpragCoupling, even_angles
from analytic.rotor.clutch_tilted import aside, couplings
from analytic.rotor.shafts import UniformShaft, hutchinson

SPRAGS = {"Z": 12, "nu": math.radians(3.15), "n_s": 41}
T = 15.0


def clutch(Z, nu, n_s):
    return SpragCoupling(psi=even_angles(Z=Z), R_i=11.11e-3, nu=nu, L=9e-3, k_n=5e9, n_s=n_s)


def held(of, torque, offset):
    """Displaced and tilted up to the deflection under the torque."""
    delta_0 = (torque / (of.Z * of.d_t * of.k_n)) ** (1 / of.n)
    dx, tilt = aside(offset, of.L, delta_0)
    return {"T": torque, "dx": dx, "tilt": tilt}


@pytest.mark.parametrize("change", [{}, {"Z": 5}, {"n_s": 2}, {"nu": math.radians(10)}])
@pytest.mark.parametrize(("torque", "offset"), [(T, 1e-6), (T, 5e-6), (1000.0, 1e-6)])
def test_couplings_are_those_of_eqs_3_to_11(change, torque, offset):
    of = clutch(**SPRAGS | change)
    at = held(of, torque, offset)
    by_formula = couplings(of, **at)
    for entry, value in summed(of, n_s=of.n_s, **at).items():
        assert value == pytest.approx(by_formula[entry], rel=1e-7), entry


def test_intervals_without_offset_or_yield_are_those_of_an_even_clutch():
    low, high = bounds.first_order(0.05, 1e-9, 12)
    assert (low + high) / 2 == pytest.approx(-(math.tan(0.05) ** 2))
    low, high = bounds.held_ends(0.05, 1e-12, 8e-3)
    assert low < bounds.leading(0.05)[0] < high
    # cos² psi for cos² psi + tan² nu sin² psi, summed over the sprags.
    nu, psi = 0.1, 2 * np.pi * np.arange(12) / 12
    struts = (np.cos(psi) ** 2 + np.tan(nu) ** 2 * np.sin(psi) ** 2).sum()
    low, high = bounds.leading(nu)
    assert (np.cos(psi) ** 2).sum() / struts - 1 == pytest.approx((low + high) / 2, rel=2e-4)
    assert low < high < 0


STEEL = {"E": 206e9, "nu": 0.3, "rho": 7850.0}


@pytest.mark.parametrize("j", [1, 2, 3])
@pytest.mark.parametrize("size", [(0.6, 0.06, 0.03), (0.6, 0.06, 0.0), (0.2, 0.06, 0.05)])
def test_frequencies_are_timoshenko_s(j, size):
    shape = dict(zip(("L", "d_o", "d_i"), size, strict=True)) | STEEL
    kappa = hutchinson(nu=0.3, m=shape["d_i"] / shape["d_o"])
    exact = UniformShaft(**shape, kappa=kappa).whirl(j, theory="timoshenko")[0]
    assert shaft.frequency(j, **shape) == pytest.approx(exact, rel=1e-11)


@pytest.mark.parametrize("theory", ["euler", "rayleigh"])
def test_the_interval_has_what_timoshenko_s_equation_adds_to_a_slender_shaft(theory):
    shape = {"L": 0.6, "d_o": 0.06, "d_i": 0.03} | STEEL
    own = UniformShaft(**shape, kappa=hutchinson(nu=0.3, m=0.5))
    e = (math.pi / 0.6) ** 2 * own.I / own.A
    low, high = shaft.neglected(theory, e, own.E * own.A / own.S)
    exact = own.whirl(1, theory=theory)[0] / shaft.frequency(1, **shape) - 1
    assert low < exact < high


@pytest.mark.parametrize("entry", ["K_y_tilt_x", "K_x_tilt_y"])
def test_less_is_left_out_of_flatter_wedges(entry):
    """A quarter of the angle under the same normal forces leaves a sixteenth of tan^2 nu."""
    middles = []
    for nu in (0.2, 0.05):
        of = clutch(**SPRAGS | {"nu": nu, "n_s": 401})
        low, high = left_out(entry, of, n_s=401, **held(of, T * math.tan(nu), 1e-8))
        middles.append((low + high) / 2)
    assert middles[0] / middles[1] == pytest.approx(16, rel=0.1)


@pytest.mark.parametrize("entry", ["K_y_tilt_x", "K_x_tilt_y"])
def test_the_width_for_a_long_slender_clutch_is_its_share_of_tan_squared(entry):
    """At a radius of 1e-6 of the length, points of the race do not move with the tilt."""
    slim = SpragCoupling(psi=even_angles(Z=12), R_i=9e-9, nu=0.3, L=9e-3, k_n=5e9, n_s=41)
    low, high = left_out(entry, slim, n_s=41, **held(slim, T * slim.d_t, 1e-7))
    assert (high - low) / 2 == pytest.approx(SHARE * math.tan(0.3) ** 2, rel=1e-3)
