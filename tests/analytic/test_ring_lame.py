"""Lamé's formulas against facts that owe nothing to this code."""

import numpy as np
import pytest

from analytic.ring import lame

WALL = {"r_i": 1.0, "r_o": 2.0}


@pytest.mark.parametrize(
    ("r", "expected"),
    [
        pytest.param(1.0, 5 / 3, id="bore: (r_o²+r_i²)/(r_o²-r_i²), by hand"),
        pytest.param(2.0, 2 / 3, id="rim: 2 r_i²/(r_o²-r_i²), by hand"),
    ],
)
def test_hoop_stress_of_a_ring_twice_as_wide_as_its_bore(r, expected):
    _, hoop = lame.stresses(r, **WALL, p_i=1.0)
    assert float(hoop) == pytest.approx(expected, rel=1e-14)


def test_walls_carry_the_pressures():
    radial, _ = lame.stresses([1.0, 2.0], **WALL, p_i=7.0, p_o=3.0)
    np.testing.assert_allclose(radial, [-7.0, -3.0], rtol=1e-14)


def test_equal_pressures_inside_and_outside_are_hydrostatic():
    radial, hoop = lame.stresses([1.0, 1.5, 2.0], **WALL, p_i=4.0, p_o=4.0)
    np.testing.assert_allclose([radial, hoop], -4.0, rtol=1e-14)


def test_mean_hoop_stress_balances_the_pressures_on_half_a_ring():
    r, w = np.polynomial.legendre.leggauss(40)
    _, hoop = lame.stresses(1.5 + r / 2, **WALL, p_i=3.0, p_o=0.5)
    assert w @ hoop / 2 == pytest.approx(3.0 * 1.0 - 0.5 * 2.0, rel=1e-13)


@pytest.mark.parametrize("ends", ["plane stress", "plane strain", "closed ends"])
def test_displacement_obeys_hooke_s_law(ends):
    """u/r is the hoop strain of the stresses, du/dr the radial one (central difference)."""
    E, nu, load = 3.0, 0.3, {**WALL, "p_i": 2.0, "p_o": 0.7}
    r, step = np.array([1.2, 1.5, 1.8]), 1e-5
    radial, hoop = lame.stresses(r, **load)
    axial = lame.axial_stress(nu=nu, ends=ends, **load)

    def u(r):
        return lame.radial_displacement(r, E=E, nu=nu, ends=ends, **load)

    np.testing.assert_allclose(u(r) / r, (hoop - nu * (radial + axial)) / E, rtol=1e-13)
    slope = (u(r + step) - u(r - step)) / (2 * step)  # error of order step^2 = 1e-10
    np.testing.assert_allclose(slope, (radial - nu * (hoop + axial)) / E, rtol=1e-8)


def test_axial_stress_of_each_end_condition():
    load = {**WALL, "p_i": 3.0, "p_o": 0.0}
    axial = {e: float(lame.axial_stress(nu=0.25, ends=e, **load)) for e in lame.Ends.__args__}
    assert axial["plane stress"] == 0
    # closed ends carry p_i pi r_i^2 on the wall's area: 3 * 1 / (4 - 1)
    assert axial["closed ends"] == pytest.approx(1.0, rel=1e-15)
    # no axial strain: nu (sigma_r + sigma_t) = 2 nu A
    assert axial["plane strain"] == pytest.approx(0.5, rel=1e-15)


def test_a_thin_ring_approaches_the_boiler_formula():
    """The boiler formula is u = p r²/(E t) (1 + O(t/r)): half the wall, half of what is left."""
    left = []
    for t in (1e-3, 5e-4):
        u = lame.radial_displacement(
            1.0, r_i=1.0, r_o=1.0 + t, p_i=1.0, E=1.0, nu=0.3, ends="plane stress"
        )
        left.append(float(u) * t - 1)
    assert left[0] / left[1] == pytest.approx(2.0, rel=1e-3)


@pytest.mark.parametrize("ends", ["plane stress", "plane strain"])
def test_strain_energy_is_half_the_work_of_both_pressures(ends):
    material, load = {"E": 2.0, "nu": 0.3, "ends": ends}, {**WALL, "p_i": 3.0, "p_o": 1.0}
    u_i, u_o = lame.radial_displacement([1.0, 2.0], **load, **material)
    work = 2 * np.pi * (3.0 * 1.0 * u_i - 1.0 * 2.0 * u_o) / 2
    assert lame.strain_energy(**load, **material) == pytest.approx(work, rel=1e-13)


def test_parameters_may_be_arrays():
    radial, _ = lame.stresses(1.0, r_i=1.0, r_o=np.array([2.0, 3.0]), p_i=1.0)
    np.testing.assert_allclose(radial, [-1.0, -1.0], rtol=1e-14)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"r": 1.0, "r_i": 2.0, "r_o": 1.0, "p_i": 1.0}, "0 < r_i < r_o"),
        ({"r": 1.0, "r_i": 0.0, "r_o": 1.0, "p_i": 1.0}, "0 < r_i < r_o"),
        ({"r": 1.0, "r_i": np.nan, "r_o": 1.0, "p_i": 1.0}, "0 < r_i < r_o"),
        ({"r": 2.5, "r_i": 1.0, "r_o": 2.0, "p_i": 1.0}, r"wall \[1.0, 2.0\] m, got 2.5 m"),
        ({"r": 1.5, "r_i": 1.0, "r_o": 2.0, "p_i": np.inf}, "pressures must be finite"),
    ],
)
def test_input_that_makes_no_sense_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        lame.stresses(**arguments)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"E": -1.0}, "Young's modulus"),
        ({"nu": 0.5}, "Poisson's ratio"),
        ({"ends": "open"}, "ends"),
    ],
)
def test_a_material_that_makes_no_sense_is_refused(change, message):
    sound = {**WALL, "p_i": 1.0, "E": 1.0, "nu": 0.3, "ends": "plane stress"}
    with pytest.raises(ValueError, match=message):
        lame.radial_displacement(1.0, **sound | change)
