"""What crowns do: formulas by hand, rows that faults turn red, words that follow from numbers."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import crown_mean, slices
from tests.conftest import solved
from verify.answers.template import template
from verify.app.cli import run
from verify.cases.contact.roller.inputs import DESIGNS
from verify.cases.sprag.crown import comparisons, formulas, table2
from verify.cases.sprag.crown.advice import verdict
from verify.cases.sprag.crown.box_fem import forces
from verify.cases.sprag.crown.case import CROWN, SpragCrown
from verify.cases.sprag.crown.formulas import (
    box,
    even,
    factorial,
    unit,
)
from verify.cases.sprag.crown.measured_figures import ordered
from verify.cases.sprag.crown.paper_fem import FIG_12, FIG_14
from verify.cases.sprag.crown.table2 import MEDIAN, cell, relative_error, standardised
from verify.core.case import Context
from verify.core.figures import Curves
from verify.core.results import Status

pytestmark = pytest.mark.xdist_group("sprag-crown")


def own(**changes):
    return SpragCrown(**changes)


def context(**arrays):
    """The paper's clutch with some of what was measured replaced."""
    q = own()
    levels = solved(CROWN, q)
    last = levels[-1].result
    return Context(CROWN.id, q, CROWN.analytic(q), [*(s.result for s in levels[:-1]),
                   replace(last, arrays={**last.arrays, **arrays})], is_paper=True)  # fmt: skip


def measured(name):
    return solved(CROWN, own())[-1].result.arrays[name].copy()


def statuses(of):
    return {row.quantity: row.status for check in CROWN.checks for row in check.rows(of)}


@pytest.fixture
def faulty(monkeypatch, judged, red):
    """Break one function; what of the case's rows turns red, the other side staying right."""

    def broken(module, name, wrapper):
        right = getattr(module, name)
        judged(CROWN)
        monkeypatch.setattr(module, name, lambda *a, **k: wrapper(right, *a, **k))
        return {row.quantity for row in red(judged(CROWN))}

    yield broken
    monkeypatch.undo()


MEAN, SHARE = "mean drop of the crown", "share of z_m in the mean drop"
MID = "pressure at mid-length under the largest force"
DEEP = "largest pressure of (5, 0.7, 15 µm) under that force"


# The box.
def test_the_paper_s_box_is_eq_19_and_another_load_scales_its_drop_alone():
    low, high = box(own())
    assert low.tolist() == [1, 0.4, 5e-6]
    assert high.tolist() == [5, 0.7, 25e-6]
    assert (box(own(Q=2 * 3407.0))[1] / high).tolist() == pytest.approx([1, 1, 2])
    assert len(factorial(own(), 5)) == 125
    assert unit(own()) == pytest.approx(2 * 3407 / (math.pi * 9e-3 * 206e9 / 0.91))  # 2 Q/(π l E')


def test_an_even_load_s_pressure_is_hertz_s():
    q = own()
    R = 1 / (1 / 4.02e-3 + 1 / 11.11e-3)  # unloaded: the spiral grows by 1 % till the first peak
    p = math.sqrt(6292 * 206e9 / (2 * 0.91) / (math.pi * 9e-3 * R))
    assert even(q, 6292.0) == pytest.approx(p, rel=0.01)


# Rows that faults turn red.
@pytest.mark.parametrize(
    ("module", "name", "wrapper", "rows"),
    [
        (crown_mean, "mean_drop", lambda f, A, K_2, z: f(A / 2, K_2, z), {MEAN, SHARE}),
        (crown_mean, "mean_drop", lambda f, A, K_2, z: f(A, 1 - K_2, z), {MEAN}),
        (crown_mean, "_around", lambda f, c, m: f(c, m) * (1 - 1e-3), {MEAN, SHARE}),
        (formulas, "gap", lambda f, q: f(q) * 0.2, {DEEP}),
        (slices, "press", lambda f, *a, **k: f(*a, **k | {"load": np.multiply(k["load"], 0.9)}),
         {MID, DEEP}),
        (formulas, "radius", lambda f, q, N: f(q, N) * 1.1, {MID, DEEP}),
        (formulas, "factorial",
         lambda f, q, n: f(q, n) * [1, 1, 40], set()),
    ],
    ids=["A without 2", "K_2 swapped", "artanh", "a fifth of the crown", "force", "radius", "box"],
)  # fmt: skip
def test_a_fault_of_the_formulas_turns_its_rows_red(faulty, module, name, wrapper, rows):
    assert rows <= faulty(module, name, wrapper)


def test_a_profile_that_is_not_clipped_is_not_straight(monkeypatch):
    right = comparisons.crowned
    monkeypatch.setattr(comparisons, "crowned", lambda q, n: right(q, n) + 1e-9)
    assert statuses_of("Fig. 11: (1 - K_2) l", context()) == [Status.FAIL]
    monkeypatch.setattr(comparisons, "crowned", lambda q, n: right(q, n) * 1.01)
    assert statuses_of("Fig. 11: (1 - K_2) l", context()) == [Status.FAIL]


def statuses_of(start, of):
    return [row.status for check in CROWN.checks if check.name.startswith(start)
            for row in check.rows(of)]  # fmt: skip


def swapped(name, columns=None):
    """What was measured with Fig. 12's (or other) two crowns exchanged."""
    a, b = (DESIGNS.index(c) for c in (columns or FIG_12))
    p = measured(name)
    p[[a, b]] = p[[b, a]]
    return {name: p}


@pytest.mark.parametrize(
    ("start", "changed"),
    [
        ("Fig. 12: best and worst", lambda: swapped("swept, slices")),
        ("Fig. 12: best and worst", lambda: swapped("swept, strips")),
        ("Fig. 12: the other way", lambda: swapped("named p")),
        ("Fig. 13: high", lambda: {"Fig. 13": measured("Fig. 13")[:, ::-1]}),
        ("Fig. 13: K_1 = 3", lambda: {"Fig. 13": measured("Fig. 13")[::-1]}),
        ("Fig. 14: (1, 0.5", lambda: swapped("named p", FIG_14)),
        ("Fig. 14: (5, 0.5", lambda: swapped("named p", FIG_14)),
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
)  # fmt: skip
def test_other_measurements_turn_what_was_said_of_them_red(start, changed):
    assert Status.FAIL not in statuses_of(start, context())
    assert statuses_of(start, context(**changed())) == [Status.FAIL]


def test_fig_12_s_order_holds_about_the_static_load_and_not_at_the_first_peak():
    found, v = context().fem[-1].arrays, CROWN.analytic(own())
    N = found["swept"]
    for by in ("slices", "strips"):
        holds = N[ordered(found, by)]
        assert holds.min() < v["N"] < holds.max() < v["N_max"]
    (row,) = (row for check in CROWN.checks if check.name.startswith("Fig. 12: best")
              for row in check.rows(context()))  # fmt: skip
    assert "first peak under 8 to 17 N m" in row.reason  # 2.0 and 4.25 kN over 0.252 kN/(N m)


def test_no_curve_of_crowns_runs_off_its_figure():
    for figure in CROWN.figures(context()):
        if not isinstance(figure, Curves):
            continue
        every = np.concatenate([c.y[np.isfinite(c.y)] for c in figure.curves])
        assert figure.y_top is None or every.max() <= figure.y_top
        assert figure.y_bottom is None or every.min() >= figure.y_bottom


# Table 2.
def test_table_2_s_errors_are_of_the_predicted_value_and_no_other_base():
    for k in range(1, 10):
        printed = cell(k, "error")
        digits = 1 if k == 7 else 2
        assert round(100 * relative_error(k), digits) == printed
    of_actual = [100 * abs(cell(k, "actual") / cell(k, "predicted") - 1)
                 * cell(k, "predicted") / cell(k, "actual") for k in (1, 2)]  # fmt: skip
    assert [round(e, 2) for e in of_actual] == [1.40, 1.67]  # printed 1.38, 1.64


def test_an_error_of_the_actual_value_turns_two_rows_red(monkeypatch):
    right = relative_error
    monkeypatch.setattr(table2, "relative_error",
                        lambda k: right(k) * cell(k, "predicted") / cell(k, "actual"))  # fmt: skip
    failed = {name for name, status in statuses(context()).items() if status is Status.FAIL}
    assert failed == {f"Table 2, row {k}: error of the printed pair" for k in (1, 2)}


def test_an_error_of_zero_is_no_scale_and_its_row_tells_of_a_point_fitted(monkeypatch):
    assert not statuses_of("Table 2, row 4", context())
    assert statuses_of("Table 2: row 4", context()) == [Status.NOTE]
    monkeypatch.setattr(table2, "relative_error", lambda k: 1e-4)
    assert statuses_of("Table 2: row 4", context()) == [Status.FAIL]


def test_what_the_printed_digits_hide_is_a_few_per_cent_of_all_errors_but_one():
    rows = [row for check in CROWN.checks if check.name.startswith("Table 2, row") and "10" not in
            check.name for row in check.rows(context())]  # fmt: skip
    assert len(rows) == 8
    printed = [1.38, 1.64, 0.45, 0.33, 0.14, 0.3, 0.57, 0.19]  # per cent
    assert [row.scale for row in rows] == pytest.approx(printed)
    *others, coarsest = sorted(row.detects for row in rows)
    assert others[-1] < 0.07
    assert 0.1 < coarsest < 0.27  # of "0.3"
    assert max(row.demand * row.scale for row in rows) < 0.05 * 1.64


def test_the_last_error_s_row_is_a_note_while_it_does_not_round_to_what_is_printed(monkeypatch):
    right = relative_error
    start = "Table 2, row 10"
    assert statuses_of(start, context()) == [Status.NOTE]
    monkeypatch.setattr(table2, "relative_error", lambda k: right(k) * 0.99)
    assert statuses_of(start, context()) == [Status.FAIL]


def test_differences_over_the_root_of_mse_are_those_of_the_ledger():
    assert [round(standardised(k), 1) for k in (1, 2, 3, 5, 6, 7, 8, 9, 10)] == [
        11.6, 15.2, 11.6, 5.3, 1.9, 4.1, 4.4, 3.3, 3.1,
    ]  # fmt: skip
    assert math.isnan(standardised(4))


def test_the_median_is_table_2_s():
    assert np.median([cell(k, "actual") for k in range(1, 11)]) * 1e6 == pytest.approx(MEDIAN)


# Forces of crowns that were not engaged.
def test_a_quadratic_through_27_engagements_has_the_forces_of_the_printed_crowns():
    q, found = own(), context().fem[-1].arrays
    inside = [k for k, c in enumerate(DESIGNS) if c != (1, 0.5, 8e-6)]
    engaged = found["named N"][inside]
    few = replace_peaks(q, found)
    fitted = forces(q, few, np.array(DESIGNS)[inside])
    assert np.abs(fitted / engaged - 1).max() < 2e-3


def replace_peaks(q, found):
    """Forces at the nodes of the 27, from those of the 125 that were fitted through them."""
    from analytic.sprag.peaks import Peaks

    coarse = [
        k
        for k, c in enumerate(found["box"])
        if all(np.isclose(c, r).any() for c, r in zip(c, factorial(q, 3).T, strict=True))
    ]
    N = found["many N"][coarse]
    return Peaks(found["box"][coarse], found["torques"], N, np.empty((*N.shape, 1)))  # fmt: skip


# Words.
@pytest.mark.parametrize(
    ("changes", "state"),
    [
        ({}, "too shallow"), ({"K_1": 2.1507, "K_2": 0.6763, "z_m": 12.1e-6}, "suits"),
        ({"K_1": 30.0, "z_m": 25e-6}, "uneven"), ({"z_m": 0.0}, "no crown"),
        ({"T": 500.0, "alpha_max": 3.0}, "no state"), ({"T": 80.0}, "rolls over"),
    ],
)  # fmt: skip
def test_the_verdict_says_what_the_crown_is(changes, state):
    q = own(**changes)
    assert verdict(q) == state
    assert CROWN.findings(q, CROWN.analytic(q))[0].startswith(state)


def test_a_crown_for_the_first_peak_suits_it():
    q = own(K_1=own().K_1_suits)
    assert verdict(q) == "suits"


@pytest.mark.parametrize(
    ("changes", "words"),
    [({"z_m": 0.0}, "without a crown"), ({"T": 80.0}, "roll over"), ({"slices": 81}, "81 slices"),
     ({}, "")],
)  # fmt: skip
def test_inputs_that_cannot_be_compared_are_refused_with_a_reason(changes, words):
    said = CROWN.too_large(own(**changes))
    assert words in said
    assert bool(said) == bool(words)


def test_check_answers_in_words_and_json(tmp_path, capsys):
    file = tmp_path / "my.toml"
    file.write_text(template(CROWN).replace("# K_1 = 1.0", "K_1 = 3.0"), encoding="utf-8")
    assert run(["check", str(file)]) == 0
    assert "K_1 Q" in capsys.readouterr().out
    assert run(["check", str(file), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["details"]["verdict"] in ("suits", "uneven")


def test_every_row_on_the_paper_s_numbers_holds_or_is_told(judged, red):
    result = judged(CROWN)
    assert not red(result)
    assert not result.errors
    noted = {row.quantity for row in result.rows if row.status is Status.NOTE}
    assert len(noted) == 6
