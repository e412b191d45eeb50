"""Sweeps over the torque, load paths of the test rig, and intervals derived beforehand."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.freewheel import compliance
from analytic.freewheel.state import at_normal_force, loaded
from tests.conftest import solved
from verify.cases.freewheel.bounds import of_star
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.cup.case import CUP, FreewheelCup
from verify.cases.freewheel.cup.sweep import ONWARD, SHARES, CupSweep, through
from verify.cases.freewheel.paths.case import PATHS, LoadPaths
from verify.cases.freewheel.sweep import given_angle, rigid_force, sweep
from verify.cases.freewheel.torque.case import TORQUE, FreewheelTorque
from verify.core.case import Context
from verify.core.results import Kind

STAR, Q = FreewheelTorque(), FreewheelCup()


@pytest.fixture(scope="module")
def cup():
    """The states of the formulas at the states of a sweep of the cup."""
    whole, v = Q.clutch, CUP.analytic(Q)
    wanted = [share * (v["d_i"] + v["d_o"]) for share in SHARES]
    wanted += [d * through(Q) for d in ONWARD if d > 0.4]
    many = at_normal_force(whole, 1.5 * v["N_max"] * np.linspace(0, 1, 20001)[1:] ** 2)
    N = np.interp(wanted, many.d_i + many.d_o, many.N)
    states = at_normal_force(whole, N)
    P = np.linspace(0, 1, 20001)[:, None] ** 2 * N
    d = compliance.compliance(whole).approaches(P / Q.L)
    U = Q.z * np.trapezoid(P, d.d_i + d.d_o, axis=0)
    made = object.__new__(CupSweep)
    made.q, made.psi = Q, states.psi
    made.at_states = {"T": states.T, "N": N, "d_i": states.d_i, "d_o": states.d_o, "U": U}
    return made


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
        with pytest.raises(ArithmeticError, match="outside the range of the states"):
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


def test_approaches_are_those_of_an_elastic_solution_without_contact():
    """Plane strain: separate finite elements of star, roller and ring under Hertz's pressures."""
    for key, d in {"d_i_rigid": 7.7807e-6, "d_o_rigid": 16.7671e-6}.items():
        assert TORQUE.analytic(STAR)[key] == pytest.approx(d, rel=6e-3)
        assert solved(TORQUE, STAR)[-1].result.values[key] == pytest.approx(d, rel=2e-3)


def test_all_three_paths_slip_at_the_load_of_eq_9_an_alternating_one_no_sooner():
    q = LoadPaths()
    v = PATHS.analytic(q)
    steady = q.rise + v["F_lim"] / q.F_ax * (q.duration - q.rise)
    assert v["slip_1"] == pytest.approx(steady, abs=3e-4)
    assert v["slip_2"] >= v["slip_1"]
    for case in (2, 3):
        along = q.courses[case]
        at = np.searchsorted(along.t, along.slips_at)
        assert abs(along.mu_req[at]) > q.mu > abs(along.mu_req[at - 1])


def test_a_path_that_ends_below_the_limit_holds_and_is_green():
    q = LoadPaths(F_ax=900.0)
    v = PATHS.analytic(q)
    assert not any(key.startswith("slip") for key in v)
    assert all("holds to the end" in x and "green" in x for x in PATHS.findings(q, v)[1:4])


def test_round_off_of_the_frequency_moves_no_time_of_a_course():
    """Cycles of the defaults are whole: one time more would move every time of slip."""
    q = LoadPaths()
    for off in (-1e-13, 1e-13):
        for case, along in q.model_copy(update={"f": q.f * (1 + off)}).courses.items():
            assert np.array_equal(along.t, q.courses[case].t)


def test_reference_values_of_order_2_have_the_uncertainty_of_that_order():
    levels = [level.result for level in solved(CUP, Q)]
    exact = levels[-1].values
    made = [
        replace(one, u_it={}, values={key: v * (1 + 0.2 * one.h**2) for key, v in exact.items()})
        for one in levels
    ]
    of = Context(CUP.id, Q, CUP.analytic(Q), made, is_paper=True)
    found = [
        row for check in CUP.checks for row in check.rows(of)
        if row.kind is Kind.APPROXIMATION and row.formal_order is not None and row.grid
    ]  # fmt: skip
    assert len(found) > 10
    for row in found:
        assert row.grid.used == pytest.approx(2, abs=0.02), row.quantity
        assert row.grid.factor == pytest.approx(1.25), row.quantity
