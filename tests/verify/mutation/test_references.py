"""References changed on purpose: rows that fail, survivors by name, and the exit status.

Rows are made by hand on the levels v = v0 (1 + a h²), h = 1/2, 1/4, 1/8: the finest is off by
a/64, U = 1.25 a/64 of v0.
"""

import pytest

from tests.verify.test_checks import context, identity, power_law
from verify.audit.mutation import gate
from verify.audit.mutation.references import both_ways, measured, score
from verify.audit.mutation.references_moved import PERTURBATIONS, moved, tried
from verify.cases.registry import CASES, find
from verify.core.results import Status
from verify.jobs.cache import default_folder
from verify.jobs.level import solve_level
from verify.judging import judge
from verify.judging.checks import Approximation, Exact, Limit

ALL = frozenset(PERTURBATIONS)
SERIES = power_law(2.0, 1e-3)


def made(series=SERIES):
    return context(series, analytic={"g": 2.0, "zero": 0.0, "one": 1.0})


def approximation(interval):
    return Approximation(name="formula", symbol="g", unit="1", analytic="g", fem="v", formal=2,
                         interval=interval, source="made up")  # fmt: skip


def balance(bound=1e-9, **more):
    return Exact(name="balance", symbol="F", unit="1", fem="v", scale="one", bound=bound,
                 bound_reason="solver", **more)  # fmt: skip


def limit():
    eps = (0.4, 0.2, 0.1, 0.05, 0.04)
    points = (list(eps), [1e-2 * e**2 for e in eps], [1e-6] * len(eps))
    return Limit(name="limit", symbol="d_0", unit="1", points=lambda _c: points, exponent=2.0)


@pytest.mark.parametrize(
    ("check", "series", "green"),
    [
        (identity(), SERIES, set()),
        # off by +0.4 %, U = 0.5 %: a reference 0.5 % higher is nearer, one 0.5 % lower too far
        (identity(), power_law(2.0, 0.256), {0.005}),
        (approximation(lambda _q, _v: (-0.004, 0.004)), SERIES, set()),
        (balance(), [0.0, 0.0, 1e-12], set()),
        (balance(6e-3, demand=0.02), [0.0, 0.0, 0.0], {0.005, -0.005}),
    ],
    ids=["identity", "nearer", "approximation", "balance", "wide balance"],
)
def test_a_changed_reference_fails_a_row_and_an_unchanged_one_does_not(check, series, green):
    where = made(series)
    with moved(0.0):
        again = check.rows(where)
    assert again == check.rows(where)
    (found,) = [one for one in tried(check, where) if one.compared]
    assert found.red == ALL - green


def test_of_a_limit_the_formula_is_moved_at_all_its_points():
    (found,) = [one for one in tried(limit(), made()) if one.compared]
    assert found.red == ALL
    with moved(0.01):
        fit = judge.fit_limit([0.4, 0.2, 0.1, 0.04], [0.5, 0.5, 0.5, 0.5 + 1e-9], [1e-6] * 4)
    assert fit.d0 == pytest.approx(1.5 * 1.01 - 1, abs=1e-6)


def test_an_interval_that_moves_with_its_formula_hides_errors():
    def along(_q, v):
        m = v["g"] / 2.001 - 1  # another model, whose ratio knows of no slip in the formula
        return m - 0.002, m + 0.002

    (both, _) = both_ways([approximation(along)], made())
    assert both.moved.red == ALL
    assert both.by_formula == frozenset()
    assert both.hidden == [0.005, 0.01, 0.05]
    found = score([both])
    assert found["by formula"]["hidden"] == [["ring-made-up/formula", [0.005, 0.01, 0.05]]]
    assert found["gate"]["failures"] == [
        "1 row does not reveal an error of the formula, first ring-made-up/formula"
    ]


def test_the_gate_fails_where_the_tolerance_of_one_row_is_widened(monkeypatch):
    """One row of 21 with U of 6 %, where judging no longer requires a sensitivity."""
    blunt = identity(name="blunt")
    where = made(power_law(2.0, 3.0))  # off by 4.7 %, U = 5.9 %
    assert blunt.rows(where)[0].status is Status.FAIL  # as judging is, it is not sharp
    monkeypatch.setattr(judge, "_sharp", lambda verdict, demand: verdict)
    many = [one for k in range(20) for one in tried(identity(name=f"gap {k}"), made())]
    rows = [*many, *tried(blunt, where)]
    assert rows[-2].row.status is Status.PASS
    found = gate.failures(rows)
    assert any(text.startswith("+5% makes 95.24% of 21 rows fail") for text in found)


def test_a_case_of_the_suite_passes_the_gate_but_for_what_is_listed():
    case = find("polyhedral-ring", CASES)
    for level in case.levels:
        solve_level(case, case.inputs(), level, default_folder())
    seen = []
    found = measured([case], show=lambda *state: seen.append(state))
    assert seen == [(0, 1, case.id), (1, 1, "")]
    held = found["gate"]
    assert held["rows"] >= 10
    for p in ("+1 %", "-1 %", "+5 %", "-5 %", "-9 %"):
        assert held["red"][p] == held["rows"]


def test_rows_are_listed_by_the_reason_and_convergence_is_neither():
    wide = identity(name="wide", demand=0.02, demand_reason="made up")
    shown = approximation(lambda _q, _v: None)
    found = score(both_ways([identity(), wide, shown], made()))
    assert found["convergence"] == 3
    assert found["gate"]["rows"] == 1
    assert found["listed"]["rows"] == 2
    names = {why: [name for name, _ in rows] for why, rows in found["listed"]["because"].items()}
    assert names["the smallest change that must be detected exceeds 1 %: made up"] == [
        "ring-made-up/wide"
    ]
    assert found["listed"]["share"] == pytest.approx(2 / 6, rel=1e-3)
    assert found["listed"]["share without convergence"] == pytest.approx(2 / 3, rel=1e-3)
