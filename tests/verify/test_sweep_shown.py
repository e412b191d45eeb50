"""Output, tables and JSON of a sweep, for outcomes defined here."""

import csv
import io
import json
from dataclasses import replace

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Here, Plate, chosen, course, outcome
from verify.cases import registry
from verify.studies.sweep import outcome as outcomes
from verify.studies.sweep import point, tables
from verify.studies.sweep.console import lines_of as printed
from verify.studies.sweep.plan import grid, sample
from verify.studies.sweep.records import record
from verify.studies.sweep.run import solve

REFUSED, FAILED = "refused: inputs.a = -1 mm: must be greater than 0 mm", "level 2: ValueError: no"
NAN = np.nan


def planned(*vary, only=("stiffness",)):
    return grid(CASE, "plate", Plate(), chosen(*only), vary)


def sampled(count=64):
    """A sample, and how far off each of its two inputs is, -1 to 1."""
    plan = sample(CASE, "plate", Plate(), chosen(), f"sobol:{count}", ["a=±1mm", "b=±0.5mm"])
    x = [(p - t.nominal) / t.off for p, t in zip(plan.points.T, plan.tolerances, strict=True)]
    return plan, *x


def read(text):
    return list(csv.DictReader(io.StringIO(text)))


def as_json(of):
    return json.loads(json.dumps(record(of, "freewheel sweep plate.toml"), allow_nan=False))


def test_a_grid_states_where_the_formula_holds_and_what_breaks_it():
    plan = planned("a=1:8mm:8", "n=2:3:2")
    of = outcome(plan, course(plan, 0.01 * np.round(plan.points[:, 0] * 1e3), 0.002))
    assert printed(of) == [
        "16 of 16 points solved",
        "           largest error   ≤2 %  ≤5 %  ≤10 %  at a/mm, n",
        "stiffness  +8.00 ± 0.20 %  12 %  50 %  100 %  8, 2",
        "stiffness",
        "  within 2 %: a 1 mm, n 2..3 (all); 2 of 16 points",
        "    not met at the file values; from a 1 mm, n 2, first exceeded for a above 1.8",
        "        mm (between 1 and 2 mm), where the error bar crosses the limit",
        "  within 5 %: a 1..4 mm, n 2..3 (all); 8 of 16 points",
        "    first exceeded for a above 4.8 mm (between 4 and 5 mm), where the error bar",
        "        crosses the limit",
        "  within 10 %: all 16 points: a 1..8 mm, n 2..3",
    ]
    lines = read(tables.validity_csv(of))
    assert lines[1] == {
        "row": "stiffness", "largest error [%]": "8",
        "U_error of largest error [%]": "0.2", "limit [%]": "5",
        "points": "16", "inside": "8", "outside": "6", "undecided": "2", "unsolved": "0",
        "points in the box": "8", "a from [mm]": "1", "a to [mm]": "4", "n from": "2", "n to": "3",
        "limit first exceeded by": "a", "unit": "mm", "last inside": "4", "first not inside": "5",
        "verdict at first not inside": "undecided",
        "error bar reaches limit at": "4.8", "reason if unsolved": "",
    }  # fmt: skip
    assert [line["limit first exceeded by"] for line in lines] == ["a", "a", ""]
    found = as_json(of)["rows"][0]["validity"][1]
    assert found["box"]["n"] == {"low": 2, "high": 3, "whole": True}
    assert found["base"] == {"a": 4, "n": 3}
    assert found["breaks"] == {
        "input": "a", "last": 4, "first": 5, "at": pytest.approx(4.8), "verdict": "undecided",
        "why": "",
    }  # fmt: skip


def test_points_are_in_their_units_and_counted_with_their_reasons():
    plan = planned("a=1:4mm:4", only=("stiffness", "stress"))
    whys = ("", REFUSED, FAILED)
    first = course(plan, [0.03, NAN, NAN, NAN], 0.002, problems=(*whys, "does not converge"))
    second = course(plan, [-0.5, NAN, NAN, 0.07], 0.002, pair=1, fe=[-1e6, NAN, NAN, 3e6],
                    problems=(*whys, ""))  # fmt: skip
    three = outcome(plan, first, second, problems={1: REFUSED, 2: FAILED})
    reasons = REFUSED.removeprefix("refused: "), FAILED, "does not converge in 1 of 2 rows"
    assert tables.statuses(three) == ("solved", "refused", "failed", "solved")
    assert tables.reasons(three) == ("", *reasons)
    assert printed(three)[:3] == [
        "2 of 4 points solved, 1 refused, 1 failed, 1 solved points lack some rows",
        "  1 point: a = -1 mm: must be greater than 0 mm",
        f"  1 point: {FAILED}",
    ]
    lines = read(tables.points_csv(three))
    assert lines[0] == {
        "a [mm]": "1", "status": "solved", "reason": "",
        "stiffness: formula [N/mm]": "2.06", "stiffness: FE [N/mm]": "2",
        "stiffness: U [N/mm]": "0.004", "stiffness: error [%]": "3",
        "stiffness: U_error [%]": "0.2", "stress: formula [MPa]": "-0.5", "stress: FE [MPa]": "-1",
        "stress: U [MPa]": "-0.002", "stress: error [%]": "-50", "stress: U_error [%]": "0.2",
    }  # fmt: skip
    assert lines[1]["stiffness: error [%]"] == lines[1]["stress: FE [MPa]"] == ""
    found = as_json(three)
    assert found["counts"] == {
        "solved": 2, "refused": 1, "failed": 1,
        "reasons": [{"reason": reason, "points": 1} for reason in reasons],
    }  # fmt: skip
    assert found["points"]["inputs"] == {"a": [1, 2, 3, 4]}
    assert found["rows"][1]["fe"] == [-1, None, None, 3]
    assert found["rows"][1]["error"] == [-0.5, None, None, 0.07]
    assert found["inputs"]["b"] == {"value": 2, "unit": "mm"}
    assert found["timing"]["overhead"] == 0.25  # 3 s busy of 2 s in two processes


def test_refusals_of_one_rule_are_one_line_with_an_example():
    plan = planned("a=1:7mm:7")
    whys = ("",) * 5 + tuple(
        f"refused: inputs: b must be at most {n} mm, got {m} mm" for n, m in ((2, 5), (3, 6))
    )
    error = [NAN if why else 0.01 for why in whys]
    problems = {n: why for n, why in enumerate(whys) if why}
    lines = printed(outcome(plan, course(plan, error, problems=whys), problems=problems))
    assert lines[1] == "  2 points: such as: b must be at most 2 mm, got 5 mm"
    assert lines[5] == "  within 2, 5 and 10 %: all 5 points that are solved: a 1..5 mm"


def test_a_sample_has_its_scatter_and_its_indices_the_largest_first():
    plan, x, y = sampled(1024)
    of = outcome(plan, course(plan, 0.05 + 0.01 * x + 0.03 * y, 0.002))
    lines = printed(of)
    assert lines[0] == "4,096 of 4,096 points solved"
    assert lines[4].startswith("  FE 2 ± 0 N/mm; 2.5 % 2, 50 % 2, 97.5 % 2")
    assert lines[5] == "    no indices: the quantity does not vary"
    assert lines[6].startswith("  error 5.0 ± 1.8 %; 2.5 % 1.8, 50 % 5.0, 97.5 % 8.2")
    assert lines[7].startswith("    b  S1 0.90 (0.8")
    assert lines[8].startswith("    a  S1 0.10 (0.0")
    assert len(lines) == 12
    lines = read(tables.sensitivity_csv(of))
    assert [(line["quantity"], line["unit"], line["input"]) for line in lines] == [
        (what, unit, name)
        for what, unit in (("formula", "N/mm"), ("FE", "N/mm"), ("error", "%"))
        for name in ("a", "b")
    ]
    assert float(lines[0]["mean"]) == pytest.approx(2.1, rel=1e-5)  # 2 N/mm and 5 %
    assert (lines[2]["S1"], lines[2]["reason without indices"]) == (
        "",
        "the quantity does not vary",
    )
    of_a = lines[4]
    assert float(of_a["mean"]) == pytest.approx(5, abs=0.01)
    assert float(of_a["standard deviation"]) == pytest.approx(np.sqrt(10 / 3), rel=0.01)
    assert float(of_a["97.5 %"]) == pytest.approx(8.2, abs=0.05)
    assert float(of_a["S1 low"]) < 0.1 < float(of_a["S1 high"])
    found = as_json(of)
    assert found["plan"]["base"] == 1024
    scatter = found["rows"][0]["sensitivity"]["scatter"]
    assert scatter["fe"]["mean"] == 2  # N/mm
    assert scatter["error"]["mean"] == pytest.approx(0.05, abs=2e-3)
    assert list(scatter["error"]["indices"]) == ["a", "b"]


def test_a_sample_states_what_its_indices_leave_out():
    plan, x, y = sampled(8)
    text = " ".join(printed(outcome(plan, course(plan, 0.05 + 0.01 * x * y, 0.0001))))
    assert "the sample is small: intervals are up to ±" in text
    plan, x, _ = sampled()
    lines = printed(outcome(plan, course(plan, 0.01 * x, 0.006)))
    # (0.6 %/2)² of 1 %²/3
    doubt = "    doubtful: 27 % of the variance may be the uncertainty of the finite elements"
    assert doubt in lines
    lines = printed(outcome(plan, course(plan, 0.01 * x, 0.02)))
    assert lines[-1] == "    no indices: the variation is within the uncertainty of finite elements"
    x[[1, 18]] = NAN
    lines = printed(outcome(plan, course(plan, 0.01 * x)))
    assert "stiffness (2 rows of the sample left out: not solved)" in lines


@pytest.mark.parametrize(("error", "what"), [(0.3, "smaller errors"), (NAN, "no error")])
def test_many_rows_are_the_worst_ten_and_a_pointer_to_the_table(error, what):
    plan = planned("a=1:8mm:8")
    rows = tuple(
        replace(plan.chosen[0], name=f"row {k}, with a rather long name, longer than others")
        for k in range(43)
    )
    courses = [
        replace(course(plan, error * (1 + 0.1 * k), 1e-4), pair=pair) for k, pair in enumerate(rows)
    ]
    lines = printed(outcome(replace(plan, chosen=rows), *courses))
    assert len(lines) <= 30
    assert max(map(len, lines)) <= 80
    assert f"(33 more rows with {what} in points.csv)" in lines
    assert "row 42" in lines[2] or what == "no error"


def test_equal_limits_are_one_line():
    for vary, error, U, last in (
        ("a=1:4mm:4", 0.3, 0.3, "  within 2, 5 and 10 %: nowhere, 4 undecided"),
        ("a=1:4mm:4", NAN, 0, "  within 2, 5 and 10 %: no point is solved"),
        ("a=1:4mm:4", [NAN, NAN, 0, 0], 0,
         "    no result beyond a = 3 mm: 2 mm is not solved (does not converge)"),
        ("a=4:5mm:2 b=2:3mm:2", [0, 0, 0, 0.3], 0,
         "    no single input exceeds the limit, only several inputs together do"),
    ):  # fmt: skip
        plan = planned(*vary.split())
        assert printed(outcome(plan, course(plan, error, U)))[-1] == last


def test_the_largest_error_is_of_either_sign_and_of_solved_points_alone():
    plan = planned("a=1:3mm:3")
    alike = [0.05, 0.2, -0.2 * (1 + 1e-13)]  # the first
    for error, at in (([0.1, NAN, -0.2], 2), (alike, 1), ([NAN] * 3, None)):
        assert tables.largest(course(plan, error)) == at


def test_a_grid_that_was_solved_holds_what_formulas_and_finite_elements_gave(tmp_path, monkeypatch):
    monkeypatch.setattr(registry, "CASES", (*registry.CASES, CASE))
    point._known.cache_clear()
    of = outcomes.outcome(solve(planned("a=4,8mm", "n=0,3,9"), Here(), folder=tmp_path))
    assert tables.statuses(of) == ("refused", "solved", "failed") * 2
    assert tables.reasons(of)[0] == "inputs.n = 0: must be at least 1"
    assert tables.reasons(of)[2] == "level 1: ValueError: 9 holes do not fit"
    lines = read(tables.points_csv(of))
    # k = a/b N/mm over 1 + 10 (a / 40 mm)², which the finest level has to 1e-4/16
    assert [lines[k]["stiffness: formula [N/mm]"] for k in (1, 4)] == ["2", "4"]
    assert float(lines[1]["stiffness: FE [N/mm]"]) == pytest.approx(2 / 1.1, rel=1e-5)
    assert float(lines[4]["stiffness: error [%]"]) == pytest.approx(40, abs=2e-3)
    assert 0 < float(lines[4]["stiffness: U_error [%]"]) < 0.01
