"""References of contacts: independence of the formulas, and uncertainties that they state."""

import numpy as np
import pytest

from verify.cases.contact.line.flat import FLAT
from verify.cases.contact.line.reference import disc_fem
from verify.cases.contact.roller import profiles
from verify.cases.contact.roller.half_space import pressed
from verify.cases.contact.roller.inputs import Crown, Design, Roller, Tilt
from verify.cases.contact.roller.profiles import even_crowns
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.sphere import reference
from verify.cases.contact.sphere.case import Spheres

LEVEL = 20
SHARP = 1e-4  # of the value, that a row of the acceptance's 0.3 % can use


def along(q, count=4001):
    return np.linspace(-q.L / 2, q.L / 2, count)


def test_crowns_of_an_even_pressure_are_made_for_the_load():
    q, more = Roller(), Roller(F=2 * 3407.0)
    y = along(q)[1:-1]
    one, other = even_crowns(q), even_crowns(more)
    assert other["Lundberg"](y) == pytest.approx(2 * one["Lundberg"](y), rel=1e-12)
    low, high = (crowns["Johns"](np.array([q.L / 2]))[0] for crowns in (one, other))
    assert 1.5 < high / low < 2  # the wider contact needs less of a drop at its end


def test_the_peak_of_a_narrow_contact_is_rounded_as_stated():
    """Lengths times 1.03 round everywhere else: a/R = 1e-3, and the largest coordinate is R."""
    q, e, found = FLAT.inputs(), 1e-3, []
    for size in (1.0, 1.03):
        one = q.model_copy(update={"R": size * q.R})
        found.append(disc_fem(one, one.at_ratio(e).P, e * one.R, 3))
    difference = abs(found[1].peak - found[0].peak)
    stated = found[0].rounding("p_0", found[0].peak)
    assert 1e-10 * found[0].peak < difference < stated < 1e-6 * found[0].peak
    width = found[0].half_width
    assert abs(found[1].half_width / 1.03 - width) < found[0].rounding("a", width) < 1e-8 * width


def test_pressures_next_to_the_axis_of_a_sphere_are_even_however_small_the_contact():
    """Rows there weigh less than those at the equator by many orders of magnitude."""
    q = Spheres(P=1e-5).of("flat")
    a = q.width
    spheres = reference.problem(q, 2)
    down = {"upper.middle": {"y": -(a**2) / q.R_1}}
    touch = spheres.solve(displacements=down).touches[0]
    near = touch.x[0] < a / 3
    p = touch.pressure[near] / np.sqrt(1 - (touch.x[0][near] / a) ** 2)
    assert np.ptp(p) < 2e-3 * p.mean()


def test_the_reference_s_crown_and_tilt_are_those_of_the_inputs_as_small_angles_are():
    q = Crown()
    A = q.K_1 * q.Q / (np.pi * q.L * q.E_star)
    y = along(q)
    for made in (profiles.gap(q), profiles.gap(Roller(F=q.Q), Design(q.K_1, q.K_2, q.z_m))):
        assert np.abs(made(y) - q.gap(y)).max() <= 1e-9 * A
    assert not profiles.gap(Roller())(y).any()
    theta = np.pi / 180
    q = Tilt(theta=theta)
    lean = Crown.gap(q, y) - q.gap(y)
    straight = profiles.gap(Roller(F=q.Q), Design(q.K_1, q.K_2, q.z_m))(y)
    assert np.abs(straight - profiles.gap(q)(y) - lean).max() <= theta**3 / 2 * q.L / 2 + 1e-15
    assert np.all(np.diff(lean) >= 0)
    assert lean[0] == -lean[-1] == pytest.approx(-theta * q.L / 2, abs=1e-15)


def test_the_half_space_states_what_neighbouring_grids_differ_by():
    q = TILTED.inputs()
    found = TILTED.reference(q, LEVEL)
    beside = [pressed(q, LEVEL + step).values for step in (-1, 1)]
    for key in ("p_max", "p_mid", "delta", "F_low", "F_high", "F_d", "M"):
        apart = max(abs(values[key] - found.values[key]) for values in beside)
        assert found.u_it[key] >= apart, key
        sharp = key in ("p_max", "p_mid", "delta")
        assert not sharp or found.u_it[key] < SHARP * found.values[key], key
    assert 0 < found.u_it["p_best"] < 1e-3 * found.values["p_best"]
