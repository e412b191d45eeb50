"""Required friction, Eqs. 8 to 10, and the couple that they leave out."""

import numpy as np
import pytest

from analytic.freewheel import criterion, tilt

ALPHA = np.radians(3.5)
CLUTCH = {"alpha": ALPHA, "R": 16.5e-3}


def forces(T, F_ax, z=8):
    """Of one contact: F_t from the torque, F_n from the clamping angle, F_ax shared."""
    F_t = T / (z * CLUTCH["R"])
    return {"F_t": F_t, "F_n": F_t / np.tan(ALPHA), "F_a": F_ax / z}


def test_the_clamping_angle_is_not_the_quotient_of_the_forces_but_its_arctangent():
    """Text after Eq. 1."""
    quotient = forces(20.0, 0.0)["F_t"] / forces(20.0, 0.0)["F_n"]
    assert quotient == pytest.approx(0.06116, abs=5e-6)
    assert np.arctan(quotient) == pytest.approx(ALPHA, rel=1e-12)
    assert quotient != pytest.approx(ALPHA, rel=1e-3)


def test_without_axial_load_the_old_criterion_is_left():
    assert float(criterion.required_friction(T=20.0, F_ax=0.0, **CLUTCH)) == pytest.approx(
        np.tan(ALPHA), rel=1e-15
    )


def test_eq_8_with_a_symbol_of_its_own_agrees_with_eq_9():
    """As printed its left side is tan(alpha), which the axial load does not change."""
    told = float(criterion.required_friction_of_contact(**forces(20.0, 600.0)))
    assert told == pytest.approx(
        float(criterion.required_friction(T=20.0, F_ax=600.0, **CLUTCH)), rel=1e-13
    )
    assert told > 1.1 * np.tan(ALPHA)


def test_eq_8_is_of_one_roller_and_eq_9_of_the_whole_clutch():
    """600 N on the clutch need 0.0682, on each roller 0.250: one symbol cannot be both."""
    whole = float(criterion.required_friction(T=20.0, F_ax=600.0, **CLUTCH))
    each = float(criterion.required_friction(T=20.0, F_ax=8 * 600.0, **CLUTCH))
    printed = forces(20.0, 600.0) | {"F_a": 600.0}
    assert whole == pytest.approx(0.0682, abs=5e-5)
    assert each == pytest.approx(0.250, abs=5e-4)
    assert float(criterion.required_friction_of_contact(**printed)) == pytest.approx(each)


def test_at_the_largest_axial_load_the_required_friction_is_the_available():
    F = criterion.largest_axial_load(T=[5.0, 20.0], mu=0.1, **CLUTCH)
    asked = criterion.required_friction(T=[5.0, 20.0], F_ax=F, **CLUTCH)
    np.testing.assert_allclose(asked, 0.1, rtol=1e-13)
    assert np.isnan(criterion.largest_axial_load(T=5.0, mu=0.06, **CLUTCH))


def test_at_equality_the_clutch_holds_and_is_green():
    """Eq. 10 as printed, mu_req < mu, would have it slip."""
    mu = float(criterion.required_friction(T=20.0, F_ax=600.0, **CLUTCH))
    assert criterion.safety(mu=mu, mu_req=mu) == 1
    assert criterion.traffic_light(1.0) == "green"
    assert not criterion.self_releasing(alpha=np.arctan(0.1), mu=np.tan(np.arctan(0.1)))


def test_an_axial_load_changes_eq_8_and_not_eq_1():
    """At slip under a growing axial load it is Eq. 8 that is no longer fulfilled."""
    mu, F_ax = 0.1, np.array([0.0, 3000.0])
    asked = criterion.required_friction(T=20.0, F_ax=F_ax, **CLUTCH)
    assert (asked <= mu).tolist() == [True, False]
    assert not criterion.self_releasing(alpha=ALPHA, mu=mu)  # Eq. 1, at either load


@pytest.mark.parametrize(
    ("T", "F_ax", "expected"),
    [(0.0, 0.0, np.tan(ALPHA)), (0.0, 5.0, np.inf), (-3.0, 5.0, np.nan), (-3.0, 0.0, np.nan)],
)
def test_without_locking_torque_the_criterion_is_infinite_or_silent(T, F_ax, expected):
    found = float(criterion.required_friction(T=T, F_ax=F_ax, **CLUTCH))
    assert found == pytest.approx(expected, nan_ok=True)


def test_classes_have_the_paper_s_limits_unless_others_are_given():
    ratios = [np.nan, 0.0, 0.7999, 0.8, 0.9999, 1.0, np.inf]
    told = ["free", "red", "red", "yellow", "yellow", "green", "green"]
    assert criterion.traffic_light(ratios).tolist() == told
    assert criterion.traffic_light(1.1, red=1.0, green=1.2) == "yellow"
    with pytest.raises(ValueError, match="red <= green"):
        criterion.traffic_light(1.0, red=1.2, green=1.0)


def test_the_offset_balances_the_couple_of_the_axial_forces():
    """Both resultants along the chord, 2 e apart, against F_a at both ends of the chord."""
    r, F_a, F_n = 2.5e-3, 40.0, 900.0
    e = float(tilt.offset(F_a=F_a, F_n=F_n, r=r, alpha=ALPHA))
    resultant, chord = F_n / np.cos(ALPHA), 2 * r * np.cos(ALPHA)
    assert resultant * 2 * e == pytest.approx(F_a * chord, rel=1e-13)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.6, 2.0, 4.0])
def test_the_linear_line_load_carries_force_and_moment(e):
    L = 10.0
    peak = float(tilt.peak_factor(e=e, L=L))  # of the mean load 1
    z = np.linspace(-L / 2, L / 2, 200001)
    length = L if e <= L / 6 else 3 * (L / 2 - e)
    low = 2 - peak if e <= L / 6 else 0.0
    q = np.where(z > L / 2 - length, low + (peak - low) * (z - L / 2 + length) / length, 0.0)
    assert np.trapezoid(q, z) == pytest.approx(L, rel=1e-4)
    assert np.trapezoid(q * z, z) == pytest.approx(e * L, abs=1e-3)


def test_hertz_s_pressure_rises_with_the_root_of_the_line_load():
    assert float(tilt.pressure_factor(e=0.5, L=10.0)) == pytest.approx(np.sqrt(1.3), rel=1e-14)


def test_one_end_lifts_off_at_a_sixth_of_the_length():
    F_a = tilt.axial_force_at_lift_off(F_n=900.0, r=2.5, alpha=ALPHA, L=10.0)
    e = tilt.offset(F_a=F_a, F_n=900.0, r=2.5, alpha=ALPHA)
    assert float(e) == pytest.approx(10 / 6, rel=1e-14)
    assert float(tilt.peak_factor(e=5.0, L=10.0)) == np.inf


def test_within_the_friction_cone_the_offset_stays_below_mu_r():
    mu, F_n = 0.1, 900.0
    F_a = F_n * np.sqrt(mu**2 - np.tan(ALPHA) ** 2)
    assert float(tilt.offset(F_a=F_a, F_n=F_n, r=2.5, alpha=ALPHA)) < mu * 2.5
