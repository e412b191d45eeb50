"""What Hertz's line contact neglects: series of two discs, axis stresses, the clamped race."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from analytic.contact import clamped_race, disc_series, disc_stress, pair_series, shear_series
from analytic.contact.disc import disc_in_contact
from analytic.ring import lame

LIKE = {"E_1": 2.0, "nu_1": 0.3, "E_2": 2.0, "nu_2": 0.3, "assumption": "plane strain"}
UNLIKE = LIKE | {"E_2": 5.0, "nu_2": 0.2}
STEEL = {"E": 2.0, "nu": 0.3, "assumption": "plane strain"}


def test_equal_discs_meet_on_a_flat():
    p, w = pair_series.excess(a=0.2, R_1=2.0, R_2=2.0, **LIKE)
    assert p.total == pytest.approx(float(disc_series.pressure_excess(a=0.2, R=2.0)), rel=1e-12)
    assert w.total == pytest.approx(float(disc_series.moment_width_excess(a=0.2, R=2.0)), rel=1e-12)


def test_a_disc_on_a_rigid_flat_is_the_same():
    rigid = LIKE | {"E_2": np.inf}
    p, w = pair_series.excess(a=0.2, R_1=2.0, R_2=np.inf, **rigid)
    assert p.total == pytest.approx(3 / 16 * 0.01, rel=1e-12)
    assert w.total == pytest.approx(-1 / 4 * 0.01, rel=1e-12)


def test_it_does_not_matter_which_disc_is_the_first():
    swapped = {"E_1": 5.0, "nu_1": 0.2, "E_2": 2.0, "nu_2": 0.3, "assumption": "plane strain"}
    one = pair_series.excess(a=0.1, R_1=1.0, R_2=3.0, **UNLIKE)
    other = pair_series.excess(a=0.1, R_1=3.0, R_2=1.0, **swapped)
    for x, y in zip(one, other, strict=True):
        assert (x.first, x.second) == pytest.approx((y.first, y.second), rel=1e-12)


def test_excesses_have_no_unit():
    one = pair_series.excess(a=0.1, R_1=1.0, R_2=3.0, **UNLIKE)
    mm = pair_series.excess(a=100.0, R_1=1e3, R_2=3e3, **UNLIKE | {"E_1": 2e-6, "E_2": 5e-6})
    for x, y in zip(one, mm, strict=True):
        assert (x.first, x.second) == pytest.approx((y.first, y.second), rel=1e-12)


def test_the_moments_width_of_the_disc_tends_to_its_series():
    for a in (0.02, 0.04):
        disc = disc_in_contact(a=a, R=1.0, E_plane=1.0)
        hertz = np.sqrt(4 * disc.P / np.pi)
        excess = float(disc_series.moment_width_excess(a=a, R=1.0))
        assert disc.moment_width / hertz - 1 == pytest.approx(excess, abs=a**4)


@pytest.mark.parametrize("a", [1e-4, 1e-3, 1e-2])
def test_the_largest_shear_tends_to_its_series(a):
    disc = disc_in_contact(a=a, R=1.0, E_plane=1.0)
    hertz = 0.300283106000874 * disc.p_0  # g^(-5/2)
    shear, depth = disc_stress.largest_shear_stress(disc=disc)
    assert shear / hertz - 1 == pytest.approx(
        float(shear_series.shear_excess(a=a, R=1.0)), abs=a**2
    )
    assert depth / a == pytest.approx(0.7861513777574233, abs=0.3 * a)


def test_forces_on_a_section_through_the_centre_balance_the_load():
    """On the axis at the centre of a slender contact: 3 P/(pi R) along, P/(pi R) across."""
    disc = disc_in_contact(a=1e-3, R=1.0, E_plane=1.0)
    across, along = disc_stress.axis_stresses(1.0, disc=disc)
    assert float(along / across) == pytest.approx(-3, abs=1e-5)


@pytest.mark.parametrize("z", [0.0, -1.0, 1.5, 1e-3])
def test_depths_near_the_surface_or_beyond_the_centre_are_refused(z):
    with pytest.raises(ValueError, match="depth"):
        disc_stress.axis_stresses(z, disc=disc_in_contact(a=0.1, R=1.0, E_plane=1.0))


@pytest.mark.parametrize("ratio", [1.1, 1.35, 5.0])
def test_the_race_under_uniform_pressure_is_lame_s(ratio):
    """The rim's pressure that keeps it in place, from Lamé's own displacements."""
    load = {"r_i": 1.0, "r_o": ratio, "E": 2.0, "nu": 0.3, "ends": "plane strain"}
    inner = lame.radial_displacement([1.0, ratio], p_i=1.0, p_o=0.0, **load)
    outer = lame.radial_displacement([1.0, ratio], p_i=0.0, p_o=1.0, **load)
    held = inner[0] - inner[1] / outer[1] * outer[0]
    E_plane, nu_plane = 2.0 / 0.91, 0.3 / 0.7
    assert clamped_race._uniform(ratio, nu_plane) == pytest.approx(E_plane * held / 2, rel=1e-12)


def test_harmonics_of_a_thick_race_are_those_of_the_half_plane():
    n = np.array([400.0, 4000.0])
    assert n * clamped_race._higher(n, 1.5, 0.4) == pytest.approx([1, 1], abs=3e-3)


def bore_under_a_wave(n: int, ratio: float, nu: float) -> float:
    """E U_n/2 at r = 1 under sigma_r = -cos(n theta), rim clamped: Runge-Kutta through the wall.

    The state is U, V, sigma_r, tau of u = U cos(n theta), v = V sin(n theta); E = 1, plane stress.
    """

    def slope(r, state):
        U, V, S, T = state
        hoop = nu * S + (U + n * V) / r
        dU = (1 - nu**2) * S - nu * (U + n * V) / r
        dV = 2 * (1 + nu) * T + (n * U + V) / r
        return [dU, dV, -(n * T + S - hoop) / r, (n * hoop - 2 * T) / r]

    def rim(start):
        return solve_ivp(slope, (1.0, ratio), start, rtol=1e-11, atol=1e-12).y[:2, -1]

    free = rim([0.0, 0.0, -1.0, 0.0])
    moved = (
        np.column_stack([rim([1.0, 0.0, -1.0, 0.0]), rim([0.0, 1.0, -1.0, 0.0])]) - free[:, None]
    )
    return float(np.linalg.solve(moved, -free)[0]) / 2


@pytest.mark.parametrize(("ratio", "nu"), [(1.2, 0.3), (1.5, 0.4), (2.5, 0.0)])
def test_every_harmonic_of_the_clamped_race_is_what_its_differential_equations_give(ratio, nu):
    assert clamped_race._first(ratio, nu) == pytest.approx(
        bore_under_a_wave(1, ratio, nu), rel=1e-8
    )
    n = np.array([2.0, 5.0])
    expected = [bore_under_a_wave(int(k), ratio, nu) for k in n]
    assert clamped_race._higher(n, ratio, nu) == pytest.approx(expected, rel=1e-7)


def test_a_thicker_race_gives_way_more():
    more = [
        clamped_race.approach_to_rim(P=1.0, a=0.01, r_i=1.0, r_o=r_o, **STEEL)
        for r_o in (1.1, 1.5, 3.0, 10.0)
    ]
    assert np.all(np.diff(more) > 0)


def test_the_race_s_approach_is_a_length():
    one = clamped_race.approach_to_rim(P=1.0, a=0.01, r_i=1.0, r_o=1.5, **STEEL)
    mm = clamped_race.approach_to_rim(P=1e-3, a=10.0, r_i=1e3, r_o=1.5e3, **STEEL | {"E": 2e-6})
    assert mm == pytest.approx(1e3 * one, rel=1e-12)


@pytest.mark.parametrize(
    "wrong", [{"r_o": 0.9}, {"a": 0.6}, {"P": -1.0}, {"a": 0.0}, {"E": np.nan}, {"nu": 0.5}]
)
def test_a_race_without_sense_is_refused(wrong):
    given = {"P": 1.0, "a": 0.01, "r_i": 1.0, "r_o": 1.5, **STEEL}
    with pytest.raises(ValueError, match=r"race|half-width|load|modulus|Poisson"):
        clamped_race.approach_to_rim(**given | wrong)
