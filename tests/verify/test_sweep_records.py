"""Tables and the JSON of a sweep, made up and solved."""

import csv
import io
import json

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Here, Plate, chosen, course, outcome
from verify.cases import registry
from verify.studies.sweep import outcome as outcomes
from verify.studies.sweep import point
from verify.studies.sweep.plan import grid, sample
from verify.studies.sweep.records import record
from verify.studies.sweep.run import solve
from verify.studies.sweep.tables import (
    largest,
    points_csv,
    reasons,
    sensitivity_csv,
    statuses,
    validity_csv,
)

REFUSED = "refused: inputs.a = -1 mm: must be greater than 0 mm"


def planned(*vary, only=("stiffness",), **more):
    return grid(CASE, "plate", Plate(), chosen(*only), vary, **more)


def sampled(count=16):
    return sample(CASE, "plate", Plate(), chosen(), f"sobol:{count}", ["a=±1mm", "b=±0.5mm"])


def read(text):
    return list(csv.DictReader(io.StringIO(text)))


@pytest.fixture
def three():
    """Solved, refused, failed, and without an answer in one row alone."""
    plan = planned("a=1:4mm:4", only=("stiffness", "stress"))
    nan, failed = np.nan, "level 2: ValueError: no"
    first = course(
        plan, [0.03, nan, nan, nan], 0.002, fe=[2000, nan, nan, nan],
        problems=("", REFUSED, failed, "does not converge"),
    )  # fmt: skip
    second = course(
        plan, [-0.5, nan, nan, 0.07], 0.002, pair=1, fe=[-1e6, nan, nan, 3e6],
        problems=("", REFUSED, failed, ""),
    )  # fmt: skip
    return outcome(plan, first, second, problems={1: REFUSED, 2: failed})


# Points


def test_a_point_is_solved_refused_or_failed_and_says_why(three):
    assert statuses(three) == ("solved", "refused", "failed", "solved")
    assert reasons(three) == (
        "", "inputs.a = -1 mm: must be greater than 0 mm", "level 2: ValueError: no",
        "does not converge in 1 of 2 rows",
    )  # fmt: skip


def test_points_are_in_their_units(three):
    lines = read(points_csv(three))
    assert list(lines[0]) == [
        "a [mm]", "status", "reason",
        "stiffness: formula [N/mm]", "stiffness: FE [N/mm]", "stiffness: U [N/mm]",
        "stiffness: error [%]", "stiffness: U_error [%]",
        "stress: formula [MPa]", "stress: FE [MPa]", "stress: U [MPa]", "stress: error [%]",
        "stress: U_error [%]",
    ]  # fmt: skip
    assert list(lines[0].values()) == [
        "1", "solved", "", "2.06", "2", "0.004", "3", "0.2", "-0.5", "-1", "-0.002", "-50", "0.2",
    ]  # fmt: skip
    assert [line["a [mm]"] for line in lines] == ["1", "2", "3", "4"]
    assert lines[1]["stiffness: error [%]"] == lines[1]["stress: FE [MPa]"] == ""
    assert lines[3]["stress: error [%]"] == "7"


def test_the_largest_error_is_of_either_sign_and_of_solved_points_alone(three):
    assert [largest(of) for of in three.courses] == [0, 0]
    plan = planned("a=1:3mm:3")
    assert largest(course(plan, [0.1, np.nan, -0.2])) == 2
    assert largest(course(plan, [0.05, 0.2, -0.2 * (1 + 1e-13)])) == 1  # alike: the first
    assert largest(course(plan, np.nan)) is None


# Regions and indices


def test_validity_has_region_and_break_for_each_row_and_limit():
    plan = planned("a=1:8mm:8", "n=2:3:2")
    a = np.round(plan.points[:, 0] * 1e3)
    lines = read(validity_csv(outcome(plan, course(plan, 0.01 * a, 0.002))))
    assert [line["limit [%]"] for line in lines] == ["2", "5", "10"]
    assert lines[1] == {
        "row": "stiffness", "largest error [%]": "8", "its U_error [%]": "0.2", "limit [%]": "5",
        "points": "16", "inside": "8", "outside": "6", "undecided": "2", "unsolved": "0",
        "points of the box": "8", "a from [mm]": "1", "a to [mm]": "4", "n from": "2", "n to": "3",
        "broken first by": "a", "unit": "mm", "last inside": "4", "first that isn't": "5",
        "verdict there": "undecided", "error bar passes at": "4.8", "why": "",
    }  # fmt: skip
    assert lines[2]["broken first by"] == ""
    # nothing but the point next to zero is inside 2 %
    assert (lines[0]["inside"], lines[0]["a to [mm]"]) == ("2", "1")


def test_sensitivity_has_scatter_and_indices_for_each_row_quantity_and_input():
    plan = sampled(256)
    a = (plan.points[:, 0] - 4e-3) / 1e-3
    lines = read(sensitivity_csv(outcome(plan, course(plan, 0.05 + 0.03 * a, 0.001))))
    names = [(line["quantity"], line["unit"], line["input"]) for line in lines]
    assert names == [
        (what, unit, name)
        for what, unit in (("formula", "N/mm"), ("FE", "N/mm"), ("error", "%"))
        for name in ("a", "b")
    ]
    of_error = lines[4]
    assert float(of_error["mean"]) == pytest.approx(5, abs=0.01)
    assert float(of_error["standard deviation"]) == pytest.approx(3 / np.sqrt(3), rel=0.01)
    assert float(of_error["97.5 %"]) == pytest.approx(5 + 3 * 0.95, abs=0.02)
    assert float(of_error["S1"]) == pytest.approx(1, abs=0.01)
    assert float(of_error["S1 low"]) < 1 < float(of_error["S1 high"])
    assert float(lines[5]["ST"]) == 0
    assert lines[0]["mean"] == "2.1"  # 2 N/mm and 5 %
    assert (lines[2]["S1"], lines[2]["why none"]) == ("", "does not vary")


# JSON


def as_json(of):
    text = json.dumps(record(of, "freewheel sweep plate.toml"), allow_nan=False)
    return json.loads(text)


def test_the_record_of_a_grid_is_as_described(three):
    found = as_json(three)
    assert found["counts"] == {
        "solved": 2, "refused": 1, "failed": 1,
        "reasons": [{"reason": reason, "points": 1} for reason in reasons(three)[1:]],
    }  # fmt: skip
    assert found["points"]["inputs"] == {"a": [1, 2, 3, 4]}
    assert found["rows"][1]["fe"] == [-1, None, None, 3]
    assert found["rows"][1]["error"] == [-0.5, None, None, 0.07]
    assert found["inputs"]["b"] == {"value": 2, "unit": "mm"}
    assert found["timing"]["overhead"] == 0.25  # 3 s busy of 2 s in two processes
    assert {name: list(found[name]) for name in ("plan", "points", "counts", "solved_by")} == {
        "plan": ["kind", "points", "varied"], "points": ["inputs", "status", "reason"],
        "counts": ["solved", "refused", "failed", "reasons"],
        "solved_by": ["portion", "levels", "code", "versions"],
    }  # fmt: skip
    assert list(found["rows"][0]) == [
        "name", "symbol", "unit", "kind", "by", "formula", "fe", "U", "error", "U_error",
        "problem", "validity",
    ]  # fmt: skip


def test_the_record_of_a_star_has_its_regions():
    plan = planned("a=1:8mm:8", "b=1:3mm:3", star=True)
    a = np.round(plan.points[:, 0] * 1e3)
    of = as_json(outcome(plan, course(plan, 0.01 * a, 0.002)))["rows"][0]["validity"][1]
    assert of["box"] == {
        "a": {"low": 1, "high": 4, "whole": False}, "b": {"low": 1, "high": 3, "whole": True}
    }  # fmt: skip
    assert of["base"] == {"a": 4, "b": 2}
    assert of["breaks"] == {
        "input": "a", "last": 4, "first": 5, "at": pytest.approx(4.8), "verdict": "undecided",
        "why": "",
    }  # fmt: skip


def test_the_record_of_a_sample_is_as_described():
    plan = sampled()
    a = (plan.points[:, 0] - 4e-3) / 1e-3
    found = as_json(outcome(plan, course(plan, 0.05 + 0.03 * a, 0.001)))
    assert found["plan"]["base"] == 16
    of = found["rows"][0]["sensitivity"]["scatter"]
    assert of["fe"]["mean"] == 2  # N/mm
    assert of["error"]["mean"] == pytest.approx(0.05, abs=2e-3)
    assert list(of["error"]["indices"]) == ["a", "b"]
    assert set(of["error"]) == {
        "n", "mean", "sd", "q025", "q500", "q975", "noise", "why", "indices",
    }  # fmt: skip


# Solved


def test_a_grid_that_was_solved_holds_what_formulas_and_finite_elements_gave(tmp_path, monkeypatch):
    monkeypatch.setattr(registry, "CASES", (*registry.CASES, CASE))
    point._known.cache_clear()
    plan = planned("a=4,8mm", "n=0,3,9")
    of = outcomes.outcome(solve(plan, Here(), folder=tmp_path))
    assert statuses(of) == ("refused", "solved", "failed") * 2
    assert reasons(of)[0] == "inputs.n = 0: must be at least 1"
    assert reasons(of)[2] == "level 1: ValueError: 9 holes do not fit"
    lines = read(points_csv(of))
    # k = a/b N/mm over 1 + 10 (a / 40 mm)², which the finest level has to 1e-4/16
    assert [lines[k]["stiffness: formula [N/mm]"] for k in (1, 4)] == ["2", "4"]
    assert float(lines[1]["stiffness: FE [N/mm]"]) == pytest.approx(2 / 1.1, rel=1e-5)
    assert float(lines[4]["stiffness: error [%]"]) == pytest.approx(40, abs=2e-3)
    assert 0 < float(lines[4]["stiffness: U_error [%]"]) < 0.01
    again = outcomes.outcome(solve(plan, Here(), folder=tmp_path))
    assert again.solved.timing.known > 0
    assert points_csv(again) == points_csv(of)
