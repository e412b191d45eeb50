"""Tables and the JSON of a sweep, made up and solved."""

import csv
import io
import json

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Here, Plate, chosen, course, outcome
from verify.cases import registry
from verify.studies.sweep import outcome as outcomes
from verify.studies.sweep import point, tables
from verify.studies.sweep.plan import grid, sample
from verify.studies.sweep.records import record
from verify.studies.sweep.run import solve

REFUSED, FAILED = "refused: inputs.a = -1 mm: must be greater than 0 mm", "level 2: ValueError: no"
NAN = np.nan


def planned(*vary, only=("stiffness",), **more):
    return grid(CASE, "plate", Plate(), chosen(*only), vary, **more)


def read(text):
    return list(csv.DictReader(io.StringIO(text)))


def as_json(of):
    text = json.dumps(record(of, "freewheel sweep plate.toml"), allow_nan=False)
    return json.loads(text)


def test_tables_and_json_have_each_point_in_its_units_with_its_reason():
    plan = planned("a=1:4mm:4", only=("stiffness", "stress"))
    whys = ("", REFUSED, FAILED)
    first = course(plan, [0.03, NAN, NAN, NAN], 0.002, problems=(*whys, "does not converge"))
    second = course(plan, [-0.5, NAN, NAN, 0.07], 0.002, pair=1, fe=[-1e6, NAN, NAN, 3e6],
                    problems=(*whys, ""))  # fmt: skip
    three = outcome(plan, first, second, problems={1: REFUSED, 2: FAILED})
    reasons = REFUSED.removeprefix("refused: "), FAILED, "does not converge in 1 of 2 rows"
    assert tables.statuses(three) == ("solved", "refused", "failed", "solved")
    assert tables.reasons(three) == ("", *reasons)
    lines = read(tables.points_csv(three))
    assert lines[0] == {
        "a [mm]": "1", "status": "solved", "reason": "",
        "stiffness: formula [N/mm]": "2.06", "stiffness: FE [N/mm]": "2",
        "stiffness: U [N/mm]": "0.004", "stiffness: error [%]": "3",
        "stiffness: U_error [%]": "0.2", "stress: formula [MPa]": "-0.5", "stress: FE [MPa]": "-1",
        "stress: U [MPa]": "-0.002", "stress: error [%]": "-50", "stress: U_error [%]": "0.2",
    }  # fmt: skip
    assert lines[1]["stiffness: error [%]"] == lines[1]["stress: FE [MPa]"] == ""
    assert lines[3]["stress: error [%]"] == "7"
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


@pytest.mark.parametrize(
    ("error", "at"),
    [
        ([0.1, NAN, -0.2], 2),
        ([0.05, 0.2, -0.2 * (1 + 1e-13)], 1),  # alike: the first
        ([NAN] * 3, None),
    ],
)
def test_the_largest_error_is_of_either_sign_and_of_solved_points_alone(error, at):
    assert tables.largest(course(planned("a=1:3mm:3"), error)) == at


def test_validity_has_region_and_break_for_each_row_and_limit():
    plan = planned("a=1:8mm:8", "n=2:3:2")
    a = np.round(plan.points[:, 0] * 1e3)
    of = outcome(plan, course(plan, 0.01 * a, 0.002))
    lines = read(tables.validity_csv(of))
    assert [line["limit [%]"] for line in lines] == ["2", "5", "10"]
    assert lines[1] == {
        "row": "stiffness", "largest error [%]": "8", "its U_error [%]": "0.2", "limit [%]": "5",
        "points": "16", "inside": "8", "outside": "6", "undecided": "2", "unsolved": "0",
        "points of the box": "8", "a from [mm]": "1", "a to [mm]": "4", "n from": "2", "n to": "3",
        "broken first by": "a", "unit": "mm", "last inside": "4", "first that isn't": "5",
        "verdict there": "undecided", "error bar passes at": "4.8", "why": "",
    }  # fmt: skip
    assert lines[2]["broken first by"] == ""
    found = as_json(of)["rows"][0]["validity"][1]
    assert found["box"]["n"] == {"low": 2, "high": 3, "whole": True}
    assert found["base"] == {"a": 4, "n": 3}
    assert found["breaks"] == {
        "input": "a", "last": 4, "first": 5, "at": pytest.approx(4.8), "verdict": "undecided",
        "why": "",
    }  # fmt: skip


def test_sensitivity_has_scatter_and_indices_for_each_row_quantity_and_input():
    plan = sample(CASE, "plate", Plate(), chosen(), "sobol:256", ["a=±1mm", "b=±0.5mm"])
    a = (plan.points[:, 0] - 4e-3) / 1e-3
    of = outcome(plan, course(plan, 0.05 + 0.03 * a, 0.001))
    lines = read(tables.sensitivity_csv(of))
    assert [(line["quantity"], line["unit"], line["input"]) for line in lines] == [
        (what, unit, name)
        for what, unit in (("formula", "N/mm"), ("FE", "N/mm"), ("error", "%"))
        for name in ("a", "b")
    ]
    of_error = lines[4]
    assert float(of_error["mean"]) == pytest.approx(5, abs=0.01)
    assert float(of_error["standard deviation"]) == pytest.approx(3 / np.sqrt(3), rel=0.01)
    assert float(of_error["97.5 %"]) == pytest.approx(5 + 3 * 0.95, abs=0.02)
    assert float(of_error["S1 low"]) < 1 < float(of_error["S1 high"])
    assert float(lines[5]["ST"]) == 0
    assert lines[0]["mean"] == "2.1"  # 2 N/mm and 5 %
    assert (lines[2]["S1"], lines[2]["why none"]) == ("", "does not vary")
    found = as_json(of)
    assert found["plan"]["base"] == 256
    scatter = found["rows"][0]["sensitivity"]["scatter"]
    assert scatter["fe"]["mean"] == 2  # N/mm
    assert scatter["error"]["mean"] == pytest.approx(0.05, abs=2e-3)
    assert list(scatter["error"]["indices"]) == ["a", "b"]
    assert set(scatter["error"]) == {
        "n", "mean", "sd", "q025", "q500", "q975", "noise", "why", "indices",
    }  # fmt: skip


def test_a_grid_that_was_solved_holds_what_formulas_and_finite_elements_gave(tmp_path, monkeypatch):
    monkeypatch.setattr(registry, "CASES", (*registry.CASES, CASE))
    point._known.cache_clear()
    plan = planned("a=4,8mm", "n=0,3,9")
    of = outcomes.outcome(solve(plan, Here(), folder=tmp_path))
    assert tables.statuses(of) == ("refused", "solved", "failed") * 2
    assert tables.reasons(of)[0] == "inputs.n = 0: must be at least 1"
    assert tables.reasons(of)[2] == "level 1: ValueError: 9 holes do not fit"
    lines = read(tables.points_csv(of))
    # k = a/b N/mm over 1 + 10 (a / 40 mm)², which the finest level has to 1e-4/16
    assert [lines[k]["stiffness: formula [N/mm]"] for k in (1, 4)] == ["2", "4"]
    assert float(lines[1]["stiffness: FE [N/mm]"]) == pytest.approx(2 / 1.1, rel=1e-5)
    assert float(lines[4]["stiffness: error [%]"]) == pytest.approx(40, abs=2e-3)
    assert 0 < float(lines[4]["stiffness: U_error [%]"]) < 0.01
    again = outcomes.outcome(solve(plan, Here(), folder=tmp_path))
    assert again.solved.timing.known > 0
    assert tables.points_csv(again) == tables.points_csv(of)
