"""Sweeps over the torque, and the intervals that are derived for a formula beforehand."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.bounds.freewheel.cup import Course
from analytic.bounds.freewheel.cup_bracket import expected_approach
from analytic.freewheel import compliance
from analytic.freewheel.state import at_normal_force, loaded
from fem.wedge.flat_course import FlatCourse
from tests.conftest import solved
from verify.cases.freewheel.bounds import of_star, parts
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.cup.case import CUP, FreewheelCup
from verify.cases.freewheel.cup.sweep import ONWARD, SHARES, CupSweep, through
from verify.cases.freewheel.sweep import given_angle, rigid_force, sweep
from verify.cases.freewheel.torque.case import TORQUE, FreewheelTorque

STAR, Q = FreewheelTorque(), FreewheelCup()


def synthetic(kind, q, states, psi=None):
    """A sweep whose states are given, without finite elements."""
    made = object.__new__(kind)
    made.q, made.at_states = q, states
    if psi is not None:
        made.psi = psi
    return made


def along_powers():
    """Approaches c N^0.95, at which T dphi = z N (dd_i + dd_o) of rolling and nothing else."""
    N = np.geomspace(20.0, 4000.0, 9)
    d_i, d_o = 3e-9 * N**0.95, 7e-9 * N**0.95
    T = STAR.z * STAR.R * N * np.tan(STAR.cam.alpha(d_i=d_i, d_o=d_o))
    U = STAR.z * N * (d_i + d_o) * 0.95 / 1.95
    return synthetic(FlatCourse, STAR, {"T": T, "N": N, "d_i": d_i, "d_o": d_o, "U": U})


@pytest.fixture(scope="module")
def cup():
    """The formulas' states where a sweep of the cup has its own."""
    whole, v = Q.clutch, CUP.analytic(Q)
    wanted = [share * (v["d_i"] + v["d_o"]) for share in SHARES]
    wanted += [d * through(Q) for d in ONWARD if d > 0.4]
    many = at_normal_force(whole, 1.5 * v["N_max"] * np.linspace(0, 1, 20001)[1:] ** 2)
    N = np.interp(wanted, many.d_i + many.d_o, many.N)
    states = at_normal_force(whole, N)
    P = np.linspace(0, 1, 20001)[:, None] ** 2 * N
    d = compliance.compliance(whole).approaches(P / Q.L)
    U = Q.z * np.trapezoid(P, d.d_i + d.d_o, axis=0)
    found = {"T": states.T, "N": N, "d_i": states.d_i, "d_o": states.d_o, "U": U}
    return synthetic(CupSweep, Q, found, states.psi)


def test_torsion_by_energy_is_that_of_rollers_that_roll():
    sweep = along_powers()
    T = sweep.at_states["T"][[3, 6, -1]]
    assert sweep.torsion_by_energy(T) == pytest.approx(sweep.torsion_by_rolling(T), rel=2e-5)


def test_splines_over_so_few_states_have_the_course_and_its_summit(cup):
    v, T = CUP.analytic(Q), np.array([0.3, 0.7, 1.0]) * Q.T
    assert cup.at("N", Q.T) == pytest.approx(v["N"], rel=2e-5)
    assert cup.place(Q.T).psi / 2 == pytest.approx(v["alpha"], rel=2e-5)
    assert cup.summit[1] == pytest.approx(v["T_max"], rel=2e-5)
    phi = loaded(Q.clutch, T).phi
    assert cup.torsion_by_rolling(T) == pytest.approx(phi, rel=4e-4)
    assert cup.torsion_by_energy(T) == pytest.approx(phi, rel=4e-4)


def test_a_sweep_has_no_values_beyond_its_summit_or_below_its_states(cup):
    for T in (1.01 * cup.summit[1], 0.5 * cup.at_states["T"][0]):
        with pytest.raises(ArithmeticError, match="beyond the states"):
            cup.at("N", T)


def test_the_interval_holds_finite_elements_of_another_clutch():
    q = FreewheelTorque(z=12, T=35.0)
    states, v = sweep(q, 5), TORQUE.analytic(q)
    T, N = q.T, rigid_force(q)
    torque, force = of_star(q, q.state), of_star(q, q.loaded_by("N_0").state)
    for formula, fem, (low, high) in (
        (v["alpha"], states.place(T).psi / 2, torque.angle()),
        (v["N"], states.at("N", T), torque.force()),
        (v["phi"], states.torsion_by_energy(np.array([T]))[0], torque.torsion()),
        (v["d_i_rigid"], states.at("d_i", N, "N"), force.approach("d_i")),
        (v["d_o_rigid"], states.at("d_o", N, "N"), force.approach("d_o")),
        (v["a_i_rigid"], states.at("a_i", N, "N"), force.contact()),
        (v["torque_rigid"], states.at("T", N, "N"), force.slope(tilted=True)),
        (v["N_angle"], states.force_at_angle(given_angle(q)), force.force_at_angle()),
    ):
        assert low < formula / fem - 1 < high
    assert sweep(ClutchInputs(z=12, T=35.0).as_star, 5) is states


def test_intervals_of_a_cup_hold_the_formulas_and_widen_towards_the_summit():
    e, v = Q.within(Q.state), CUP.analytic(Q)
    found = [e.under_torque(k) for k in ("N", "alpha", "s")] + [
        e.slope(), e.approach("d_i"), e.approach("d_o"),
        Q.within(Q.loaded_by("N_0").state).torque(), Q.within(Q.at_summit).summit(),
    ]  # fmt: skip
    assert all(low < 0 < high for low, high in found)
    far, near = (Q.at(T=T).within(Q.at(T=T).state).under_torque("N") for T in (5.0, 26.0))
    assert near[1] - near[0] > 3 * (far[1] - far[0])
    low, _, high = expected_approach(parts(Q), v["N"] / Q.L)
    assert low < v["d_o"] < high < 1.06 * low
    own = Course(parts(Q), e.approaches, (1.0, 1.0, 1.0)).at(Q.T)
    assert {k: own[k] for k in ("N", "alpha", "s", "phi")} == pytest.approx(
        {k: v[k] for k in ("N", "alpha", "s", "phi")}, rel=1e-6
    )


def test_a_formula_beyond_its_bounds_does_not_carry_them_along(broken):
    def softer(right):
        return lambda clutch: replace(right(clutch), E=right(clutch).E / 1.2)

    low, high = of_star(STAR, STAR.loaded_by("N_0").state).approach("d_i")
    broken(compliance, "_star", softer)
    again = of_star(STAR, STAR.loaded_by("N_0").state).approach("d_i")
    assert again[1] - again[0] == pytest.approx(high - low, abs=0.01)
    assert again[1] < 0.04


def test_approaches_are_those_of_an_elastic_solution_without_contact():
    """In plane strain: finite elements of star, roller and ring apart, Hertz's pressures given."""
    for key, d in {"d_i_rigid": 7.7807e-6, "d_o_rigid": 16.7671e-6}.items():
        assert TORQUE.analytic(STAR)[key] == pytest.approx(d, rel=6e-3)
        assert solved(TORQUE, STAR)[-1].result.values[key] == pytest.approx(d, rel=2e-3)
