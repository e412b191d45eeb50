"""Results of the sprag clutch case for Huang 2018: errata of the ledger and fitted inputs."""

import pytest

from tests.verify.cases.rows import context, rows
from verify.cases.sprag.clutch import paper_fem
from verify.cases.sprag.clutch.case import CLUTCH, SpragClutch
from verify.cases.sprag.clutch.model import spring_force
from verify.cases.sprag.clutch.paper_fem import BEST, PRINTED, designed
from verify.cases.sprag.clutch.paper_statements import corners, rectangle
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.inputs import ASSUMED, IDENTIFIED, EngagementInputs
from verify.cases.sprag.optimum import reference as optimum
from verify.cases.sprag.optimum.case import SpragOptimum
from verify.cases.sprag.statements import FITTED, UNFITTED
from verify.core.results import Status
from verify.papers.ledger import published

Q = SpragClutch()


def test_the_papers_figures_are_those_of_the_ledger():
    for T, values in PRINTED.items():
        for name, value in zip(("unmodified", "optimised"), values, strict=True):
            assert published(f"huang2018:stress-{T:.0f}nm-{name}").value * 1e6 == value
        for value, key in zip(BEST[T], ("k1", "k2", "zm"), strict=True):
            entry = published(f"huang2018:optimum-{T:.0f}nm-{key}")
            assert value == pytest.approx(entry.value * (1e-3 if key == "zm" else 1), rel=1e-12)


def test_the_profile_load_is_the_static_load_at_25_newton_metres():
    assert pytest.approx(Q.Q, rel=1e-3) == designed(None, 25.0).Q


def test_a_spring_s_stiffness_and_angle_enter_the_start_as_their_product_alone():
    """Erratum sec-2-3-spring-stiffness: the equilibrium at alpha = 0 gives K_r alpha_max."""
    soft = spring_force(SpragClutch(K_r=0.001, alpha_max=1.0))
    hard = spring_force(SpragClutch(K_r=0.002, alpha_max=0.5))
    assert soft == pytest.approx(hard, rel=0.01)


def test_the_torque_acts_on_the_inner_race():
    """Erratum eq-16-torque-symbol: with C_bi = T the sprags carry T on the inner race at rest."""
    e = run_fem(SpragClutch(C_rl=3.0)).engagement
    M = 12 * e.T_i[-1] * float(e.table.at(e.alpha[-1])["OA"])
    assert pytest.approx(25.0, rel=0.01) == M


def test_a_rectangle_with_table_1_s_mass_and_inertia_is_about_9_mm_long_and_3_mm_wide():
    w, l = rectangle(Q)  # noqa: E741
    assert w * 1e3 == pytest.approx(3.05, abs=0.01)  # sqrt(12 1.18e-8/1.8e-3 - 8.33²e-6)
    assert l * 1e3 == pytest.approx(9.04, abs=0.01)
    assert [round(x * 1e3, 1) for pair in corners(Q) for x in pair] == [3.4, 7.8, 2.6, 10.8]


def test_from_25_to_40_newton_metres_only_k_1_of_the_printed_optima_grows_freely():
    """Erratum sec-4-2-z-m-trend: z_m falls, K_2 reaches its bound."""
    low, high = BEST[25.0], BEST[40.0]
    assert high[0] > low[0]
    assert high[1] == published("huang2018:k2-upper-bound").value
    assert high[2] < low[2]


def test_one_of_the_two_printed_reductions_is_wrong():
    """Erratum sec-4-2-2-percentage."""
    for T, holds in ((25.0, True), (40.0, False)):
        flat, best = PRINTED[T]
        entry = published(f"huang2018:stress-{T:.0f}nm-reduction")
        assert (abs(100 * (1 - best / flat) - entry.value) < 0.005) is holds


def test_inputs_that_table_1_does_not_give_have_no_claim():
    """Erratum missing-inputs: no result follows from the paper alone."""
    fields = EngagementInputs.model_fields
    without = {name for name, field in fields.items() if not field.json_schema_extra["claims"]}
    assert {"l", "b", "nu_0", "E", "nu", "mu_s", "mu_c", "gamma_b", "k_out", "Q", "alpha_max",
            "slices", "n", "density", *IDENTIFIED} <= without  # fmt: skip
    assert not set(IDENTIFIED) & set(ASSUMED)
    assert f"does not print {len(IDENTIFIED)} inputs, which are identified" in CLUTCH.lead


def test_rows_that_rest_on_fitted_inputs_are_calibrated_and_predictions_are_not_judged():
    of_optima = [row for row in rows(CLUTCH) if "fitted" in row.quantity]
    assert {row.status for row in of_optima} == {Status.CALIBRATED}
    assert all(FITTED in row.reason for row in of_optima)
    predicted = [row.status for row in rows(CLUTCH) if "predicted" in row.quantity]
    assert predicted == [Status.SHOWN] * 2


def test_a_failed_calibration_fails_its_rows_and_no_other(monkeypatch):
    monkeypatch.setattr(paper_fem, "peak_fem", lambda *_, **__: 1e9)
    of = context(CLUTCH, arrays=paper_fem.calibrated_fem())
    red = [row for row in rows(CLUTCH, of=of) if row.status is Status.FAIL]
    assert [row.reason for row in red] == [UNFITTED] * 6


def test_a_wedge_angle_is_fitted_only_between_pressures_on_both_sides(monkeypatch):
    low, high = map(float, paper_fem.ANGLES)

    def fitted(zero):
        """The angle found where the printed pressure is that of the angle `zero`."""
        monkeypatch.setattr(
            paper_fem, "peak_fem",
            lambda _crown, _T, *, nu_0: PRINTED[25.0][1] + 1e11 * (zero - nu_0),
        )  # fmt: skip
        return paper_fem.fitted_angle_fem()

    assert fitted(low - 1e-4) is None
    assert fitted(high + 1e-4) is None
    assert fitted(low + 1e-4) == pytest.approx(low + 1e-4, abs=2e-5)


def test_an_engagement_that_is_not_solved_is_no_failed_calibration(monkeypatch):
    def fails(*_, **__):
        raise ArithmeticError("the engagement is not followed")

    monkeypatch.setattr(paper_fem, "peak_fem", fails)
    with pytest.raises(ArithmeticError, match="not followed"):
        paper_fem.calibrated_fem()
    with pytest.raises(ArithmeticError, match="not followed"):
        optimum.calibrated_fem(SpragOptimum(), {})
