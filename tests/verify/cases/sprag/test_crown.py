"""What crowns do: the box by hand, what is said of measurements, and the paper's Table 2."""

import json
import math

import pytest

from tests.verify.cases.rows import context, rows
from verify.answers.template import template
from verify.app.cli import run
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.crown import comparisons, table2
from verify.cases.sprag.crown.advice import verdict
from verify.cases.sprag.crown.case import CROWN, SpragCrown
from verify.cases.sprag.crown.formulas import box, factorial, unit
from verify.cases.sprag.crown.paper_fem import FIG_12, FIG_14
from verify.cases.sprag.crown.table2 import cell, relative_error, standardised
from verify.core.results import Status

Q = SpragCrown()
FAIL = [Status.FAIL]


def statuses(start, **arrays):
    return [row.status for row in rows(CROWN, start, context(CROWN, arrays=arrays))]


def measured(name):
    return context(CROWN).fem[-1].arrays[name].copy()


def exchanged(name, columns=FIG_12):
    """What was measured of two crowns, of the other one each."""
    a, b = (DESIGNS.index(c) for c in columns)
    p = measured(name)
    p[[a, b]] = p[[b, a]]
    return {name: p}


def test_the_box_is_eq_19_and_another_load_scales_its_drop_alone():
    low, high = box(Q)
    assert low.tolist() == [1, 0.4, 5e-6]
    assert high.tolist() == [5, 0.7, 25e-6]
    assert (box(SpragCrown(Q=2 * 3407.0))[1] / high).tolist() == pytest.approx([1, 1, 2])
    assert len(factorial(Q, 5)) == 125
    assert unit(Q) == pytest.approx(2 * 3407 / (math.pi * 9e-3 * 206e9 / 0.91))  # 2 Q/(π l E')


@pytest.mark.parametrize(
    ("start", "changed"),
    [
        ("Fig. 12: best and worst", lambda: exchanged("swept, slices")),
        ("Fig. 12: the other way", lambda: exchanged("named p")),
        ("Fig. 13: high", lambda: {"Fig. 13": measured("Fig. 13")[:, ::-1]}),
        ("Fig. 13: K_1 = 3", lambda: {"Fig. 13": measured("Fig. 13")[::-1]}),
        ("Fig. 14: (1, 0.5", lambda: exchanged("named p", FIG_14)),
        ("Fig. 14: (5, 0.5", lambda: exchanged("named p", FIG_14)),
        ("Fig. 14: its crown", lambda: {"many p": 0.99 * measured("many p")}),
        ("Fig. 14: K_1 = 5", lambda: {"many p": 1.05 * measured("many p")}),
        ("Fig. 14: K_1 of", lambda: {"many p": measured("many p")[:, ::-1]}),
        ("Eq. 21's crown", lambda: {"counted, slices": measured("counted, strips")}),
        ("the lowest of", lambda: {"box p": 1.2 * measured("box p")}),
        ("inner contact", lambda: {"inner/outer": 0.7 * measured("inner/outer")}),
        ("Table 2: its actual", lambda: {"random p": 1.1 * measured("random p")}),
        ("Table 2: its predictive", lambda: {"random p": 0.9 * measured("random p")}),
        ("Table 2: median", lambda: {"random p": 1.05 * measured("random p")}),
    ],
)
def test_other_measurements_fail_what_is_said_of_them(start, changed):
    assert Status.FAIL not in statuses(start)
    assert statuses(start, **changed()) == FAIL


@pytest.mark.parametrize("fault", [lambda z: z + 1e-9, lambda z: 1.01 * z], ids=["raised", "deep"])
def test_a_profile_that_is_not_clipped_fails_fig_11(fault, monkeypatch):
    right = comparisons.crowned
    monkeypatch.setattr(comparisons, "crowned", lambda q, n: fault(right(q, n)))
    assert statuses("Fig. 11: (1 - K_2) l") == FAIL


def test_table_2_s_errors_are_of_the_predicted_value(monkeypatch):
    for k in range(1, 10):
        assert round(100 * relative_error(k), 1 if k == 7 else 2) == cell(k, "error")
    right = relative_error
    monkeypatch.setattr(
        table2, "relative_error", lambda k: right(k) * cell(k, "predicted") / cell(k, "actual")
    )
    of = context(CROWN)
    failed = [k for k in range(1, 10) if any(
        row.status is Status.FAIL for row in rows(CROWN, f"Table 2, row {k}:", of))]  # fmt: skip
    assert failed == [1, 2]


@pytest.mark.parametrize(
    ("start", "wrong"),
    [("Table 2: row 4", lambda _k: 1e-4), ("Table 2, row 10", lambda k: 0.99 * relative_error(k))],
)
def test_a_row_of_table_2_that_contradicts_itself_is_a_note_while_it_does(
    start, wrong, monkeypatch
):
    assert statuses(start) == [Status.NOTE]
    monkeypatch.setattr(table2, "relative_error", wrong)
    assert statuses(start) == FAIL


def test_differences_over_the_root_of_mse_are_those_of_the_ledger():
    assert [round(standardised(k), 1) for k in (1, 2, 3, 5, 6, 7, 8, 9, 10)] == [
        11.6, 15.2, 11.6, 5.3, 1.9, 4.1, 4.4, 3.3, 3.1,
    ]  # fmt: skip
    assert math.isnan(standardised(4))


@pytest.mark.parametrize(
    ("changes", "state"),
    [
        ({}, "too shallow"), ({"K_1": Q.K_1_suits}, "suits"), ({"z_m": 0.0}, "no crown"),
        ({"K_1": 30.0, "z_m": 25e-6}, "uneven"), ({"T": 80.0}, "rolls over"),
        ({"T": 500.0, "alpha_max": 3.0}, "no state"),
    ],
)  # fmt: skip
def test_the_verdict_is_that_of_the_crown(changes, state):
    q = SpragCrown(**changes)
    assert verdict(q) == state
    assert CROWN.findings(q, CROWN.analytic(q))[0].startswith(state)


def test_check_answers_in_words_and_json(tmp_path, capsys):
    file = tmp_path / "my.toml"
    file.write_text(template(CROWN).replace("# K_1 = 1.0", "K_1 = 3.0"), encoding="utf-8")
    assert run(["check", str(file)]) == 0
    assert "K_1 Q" in capsys.readouterr().out
    assert run(["check", str(file), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["details"]["verdict"] in ("suits", "uneven")
