"""The clutch with all its values: in balance, with its remarks, and what is refused."""

from dataclasses import replace
from math import atan, inf, radians, tan

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from analytic.contact import hertz_line
from analytic.polyhedral import forces, torque
from analytic.polyhedral.design import Clutch
from analytic.polyhedral.parts import Parts

PARTS = Parts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)
LOADS = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": atan(0.05)}


@pytest.mark.parametrize("lever", ["exact", "d_i/2"])
@pytest.mark.parametrize("gamma", ["normal", "radius"])
@pytest.mark.parametrize("alpha", [None, radians(6.0)])
def test_the_normal_force_carries_the_torque_that_it_came_from(lever, gamma, alpha):
    clutch = Clutch(PARTS, **LOADS, K=1.3, alpha=alpha, lever=lever, gamma=gamma, M_wanted=150.0)
    grip = 0.08 if alpha is None else tan(radians(3.0))
    assert clutch.grip * clutch.N * 6 * PARTS.D_i / 2 == pytest.approx(clutch.M_t, rel=1e-12)
    assert clutch.grip == grip
    assert 6 * clutch.T * clutch.arm == pytest.approx(clutch.M_t, rel=1e-12)  # on the hub's lever
    by_pressure = (1 - clutch.hub_share) * clutch.N
    assert by_pressure == pytest.approx(clutch.F, rel=1e-12)
    assert clutch.sigma_tr == pytest.approx(1.3 * clutch.sigma_t, rel=1e-12)
    assert clutch.p_1r + clutch.p_2 == pytest.approx(30e6, rel=1e-15)
    assert clutch.remarks == ()
    reached = replace(clutch, p_t=clutch.p_required)
    assert (reached.M_t, reached.margin) == pytest.approx((150.0, 1.0))


def test_a_first_design_is_eq_21():
    clutch = Clutch(PARTS, **LOADS, lever="d_i/2", gamma="radius")
    named = {name: getattr(PARTS, name) for name in ("z", "d_i", "d_e", "D_i", "b", "j_D", "psi")}
    M_t = torque.first_torque(p_t=30e6, **named, E=210e9, mu=0.08, phi_1=atan(0.05))
    assert clutch.M_t == pytest.approx(float(M_t), rel=1e-12)


def test_rollers_press_the_ring_harder_than_the_race():
    """Hertz on two steel cylinders of lengths b; the race is hollow."""
    clutch = Clutch(PARTS, **LOADS)
    for R, p_0 in ((1 / (2 / 0.01 + 2 / 0.08), clutch.p_0_ring),
                   (1 / (2 / 0.01 - 2 / 0.10006), clutch.p_0_race)):  # fmt: skip
        a = hertz_line.half_width(P=clutch.N / 0.03, R=R, E_star=210e9 / (2 * 0.91))
        assert p_0 == pytest.approx(2 * clutch.N / 0.03 / (np.pi * float(a)), rel=1e-12)
    assert clutch.p_0_ring > clutch.p_0_race


def test_rollers_that_are_not_touched_carry_nothing_and_the_clutch_says_so():
    clutch = Clutch(PARTS, **LOADS | {"p_t": 18e6}, M_wanted=100.0)
    assert (clutch.p_2, clutch.M_t, clutch.N, clutch.p_0_ring, clutch.margin) == (0, 0, 0, 0, 0)
    assert "p_t=1.8e+07 Pa is not above p_1r=1.84211e+07 Pa, no torque" in clutch.remarks[0]
    assert replace(clutch, p_t=clutch.p_required).M_t == pytest.approx(100.0)


def test_expelled_rollers_carry_no_torque_and_the_clutch_says_so():
    clutch = Clutch(PARTS, **LOADS, alpha=radians(10.0), M_wanted=100.0)
    assert (clutch.wedges, clutch.M_t, clutch.p_required) == (False, 0.0, inf)
    assert clutch.N == clutch.F
    assert clutch.remarks == ("free rollers are expelled: tan(alpha/2) is not below mu=0.08",)


def test_a_hub_that_wedges_by_itself_leaves_the_torque_without_a_limit_and_says_so():
    clutch = Clutch(replace(PARTS, e=1.7e-3), **LOADS, M_wanted=100.0)
    assert (clutch.M_t, clutch.N, clutch.p_0_ring, clutch.margin) == (inf,) * 4
    assert clutch.p_required == clutch.p_1r
    assert clutch.remarks[0].startswith("the hub brings 1.22816 of N by itself")


def test_a_fillet_changes_the_torque_by_the_contact_s_place_alone():
    sharp, filleted = (Clutch(replace(PARTS, rho=rho), **LOADS) for rho in (0.0, 2e-3))
    assert (sharp.F, sharp.p_1r) == (filleted.F, filleted.p_1r)
    at = np.array([0.036 * np.cos(np.pi / 6) + 2e-3 * (1 - np.cos(np.pi / 6)), 0.009])
    assert filleted.arm == pytest.approx(np.hypot(*at), rel=1e-12)
    assert filleted.M_t < sharp.M_t


@given(
    z=st.integers(3, 12), wall=st.floats(1e-3, 0.03), e=st.floats(0.05, 1), mu=st.floats(0.01, 0.3)
)
def test_any_clutch_that_can_be_built_is_in_balance(z, wall, e, mu):
    flat = float(forces.half_flat(d_i=0.08 - 2 * wall, z=z))
    parts = replace(PARTS, z=z, d_i=0.08 - 2 * wall, e=e * flat)
    assume(parts.psi > 0.06)
    clutch = Clutch(parts, **LOADS | {"mu": mu, "p_t": 5e9})
    assume(abs(clutch.hub_share - 1) > 1e-6)
    if clutch.hub_share < 1:
        assert mu * clutch.N * z * parts.D_i / 2 == pytest.approx(clutch.M_t, rel=1e-9)
    else:
        assert (clutch.M_t, clutch.N) == (inf, inf)


# What is refused.


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"z": 2}, "3 or more, got z=2"),
        ({"d_i": 0.08}, "a ring needs 0 < d_i < d_e, got d_i=0.08 m"),
        ({"rho": 0.036}, "fillet leaves no flat"),
        ({"d": 0.01003}, r"rollers do not fit: d must be below \(D_i - d_e\)/2=0.01003 m, got"),
        ({"z": 29}, r"overlap: d must be below \(D_i - d\) sin\(pi/z\)=0.0097\d* m with z=29"),
        ({"e": 0.0181}, "hub must touch the flat: e must be at most 0.018 m, half its length, got"),
        ({"e": 0.0}, "distance e of the hub's contact .* must be positive .* got 0.0 m"),
        ({"rho": 2e-3, "e": 0.018}, "e must be at most 0.017 m"),
        ({"b": 0.0}, "width b of the ring must be positive and finite, got 0.0 m"),
        ({"D": 0.1}, "race needs D above D_i=0.10006 m, got D=0.1 m"),
    ],
)
def test_parts_that_cannot_be_built_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        replace(PARTS, **change)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"p_t": -1.0}, "total pressure p_t must be finite and not negative, got -1.0 Pa"),
        ({"mu": 0.0}, "coefficient of friction must lie in"),
        ({"E": np.nan}, "Young's modulus must be positive and finite, got nan Pa"),
        ({"nu": 0.5}, "Poisson's ratio must lie in"),
        ({"K": -1.0}, "correction K must be positive and finite, got -1.0"),
        (
            {"phi_1": 0.29},
            "hub locks: psi must exceed the angle of friction, got psi=16.10.. deg, ",
        ),
        ({"phi_1": -0.1}, "phi_1 >= 0"),
        ({"alpha": 0.0}, "wedge angle must lie in"),
        ({"M_wanted": 0.0}, "torque wanted must be positive and finite, got 0.0 N m"),
        ({"lever": "long"}, "lever is one of exact, d_i/2, got 'long'"),
        ({"gamma": "up"}, "gamma is one of normal, radius, got 'up'"),
    ],
)
def test_a_clutch_that_makes_no_sense_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        Clutch(PARTS, **{**LOADS, **change})


def test_between_two_rollers_is_a_z_th_of_a_turn():
    """F by the chord of that angle."""
    assert PARTS.z * PARTS.beta == pytest.approx(2 * np.pi)
    chord = 2 * 0.036 * np.sin(PARTS.beta / 2)
    F = forces.pressure_force(p_2=1e7, b=0.03, d_i=0.072, z=6)
    assert float(F) == pytest.approx(1e7 * 0.03 * chord, rel=1e-12)


def test_the_race_s_mean_diameter_is_known_with_its_outside():
    assert PARTS.D_m is None
    assert replace(PARTS, D=0.12).D_m == pytest.approx(0.11003)
