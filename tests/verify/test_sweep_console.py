"""What a sweep prints, on outcomes that are written down here."""

from dataclasses import replace

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Plate, chosen, course, outcome
from verify.studies.sweep.console import told as printed
from verify.studies.sweep.plan import grid, sample

NAN = np.nan


def planned(*vary):
    return grid(CASE, "plate", Plate(), chosen(), vary)


def sampled(count=64):
    """A sample, and how far off each of its two inputs is, -1 to 1."""
    plan = sample(CASE, "plate", Plate(), chosen(), f"sobol:{count}", ["a=±1mm", "b=±0.5mm"])
    x = [(p - t.nominal) / t.off for p, t in zip(plan.points.T, plan.tolerances, strict=True)]
    return plan, *x


def test_a_grid_says_where_the_formula_holds_and_what_breaks_it():
    plan = planned("a=1:8mm:8", "n=2:3:2")
    a = np.round(plan.points[:, 0] * 1e3)
    assert printed(outcome(plan, course(plan, 0.01 * a, 0.002))) == [
        "16 of 16 points solved",
        "           largest error   ≤2 %  ≤5 %  ≤10 %  at a/mm, n",
        "stiffness  +8.00 ± 0.20 %  12 %  50 %  100 %  8, 2",
        "stiffness",
        "  within 2 %: a 1 mm, n 2..3 (all); 2 of 16 points",
        "    not at the inputs' own values; from a 1 mm, n 2, first broken by a above 1.8",
        "        mm (between 1 and 2 mm), where the error bar reaches beyond",
        "  within 5 %: a 1..4 mm, n 2..3 (all); 8 of 16 points",
        "    first broken by a above 4.8 mm (between 4 and 5 mm), where the error bar",
        "        reaches beyond",
        "  within 10 %: all 16 points: a 1..8 mm, n 2..3",
    ]


def test_points_that_are_refused_or_failed_are_counted_with_their_reasons():
    plan = planned("a=1:7mm:7")
    whys = ("", "", "", "", "refused: inputs: b must be at most 2 mm, got 5 mm",
            "refused: inputs: b must be at most 3 mm, got 6 mm", "level 2: no")  # fmt: skip
    error = [NAN if why else 0.01 for why in whys]
    problems = {n: why for n, why in enumerate(whys) if why}
    lines = printed(outcome(plan, course(plan, error, problems=whys), problems=problems))
    assert lines[:3] == [
        "4 of 7 points solved, 2 refused, 1 failed",
        "  2 points: such as: b must be at most 2 mm, got 5 mm",
        "  1 point: level 2: no",
    ]
    assert lines[6] == "  within 2, 5 and 10 %: all 4 points that are solved: a 1..4 mm"


def test_a_sample_has_its_scatter_and_its_indices_the_largest_first():
    plan, x, y = sampled(1024)
    lines = printed(outcome(plan, course(plan, 0.05 + 0.01 * x + 0.03 * y, 0.002)))
    assert lines[0] == "4,096 of 4,096 points solved"
    assert lines[4].startswith("  FE 2 ± 0 N/mm; 2.5 % 2, 50 % 2, 97.5 % 2")
    assert lines[5] == "    no indices: does not vary"
    assert lines[6].startswith("  error 5.0 ± 1.8 %; 2.5 % 1.8, 50 % 5.0, 97.5 % 8.2")
    assert lines[7].startswith("    b  S1 0.90 (0.8")
    assert lines[8].startswith("    a  S1 0.10 (0.0")
    assert len(lines) == 12


def test_a_sample_says_what_its_indices_do_not_show():
    plan, x, y = sampled(8)
    text = " ".join(printed(outcome(plan, course(plan, 0.05 + 0.01 * x * y, 0.0001))))
    assert "the sample is small: intervals are up to ±" in text
    plan, x, _ = sampled()
    lines = printed(outcome(plan, course(plan, 0.01 * x, 0.006)))
    # (0.6 %/2)² of 1 %²/3
    doubt = "    doubtful: 27 % of the variance may be the finite elements' own uncertainty"
    assert doubt in lines
    lines = printed(outcome(plan, course(plan, 0.01 * x, 0.02)))
    assert lines[-1] == "    no indices: varies no more than the finite elements are uncertain"
    x[[1, 18]] = NAN
    lines = printed(outcome(plan, course(plan, 0.01 * x)))
    assert "stiffness (2 rows of the sample left out: not solved)" in lines


@pytest.mark.parametrize(("error", "what"), [(0.3, "smaller errors"), (NAN, "no error")])
def test_many_rows_are_the_worst_ten_and_a_pointer_to_the_table(error, what):
    plan = planned("a=1:8mm:8")
    rows = tuple(
        replace(plan.chosen[0], name=f"row {k}, with a rather long name of its own")
        for k in range(43)
    )
    courses = [
        replace(course(plan, error * (1 + 0.1 * k), 1e-4), pair=pair) for k, pair in enumerate(rows)
    ]
    lines = printed(outcome(replace(plan, chosen=rows), *courses))
    assert len(lines) <= 30
    assert max(map(len, lines)) <= 80
    assert f"(33 more rows with {what} in points.csv)" in lines
    assert lines[-1].endswith("more rows in validity.csv)")
    assert "row 42" in lines[2] or what == "no error"


@pytest.mark.parametrize(
    ("vary", "error", "U", "last"),
    [
        (("a=1:4mm:4",), 1e-6, 0, "  within 2, 5 and 10 %: all 4 points: a 1..4 mm"),
        (("a=1:4mm:4",), 0.3, 0.3, "  within 2, 5 and 10 %: nowhere, 4 undecided"),
        (("a=1:4mm:4",), NAN, 0, "  within 2, 5 and 10 %: nothing is solved"),
        (("a=1:4mm:4",), [NAN, NAN, 0, 0], 0,
         "    no answer beyond a = 3 mm: 2 mm is not solved (does not converge)"),
        (("a=4:5mm:2", "b=2:3mm:2"), [0, 0, 0, 0.3], 0,
         "    nothing breaks it along one axis, several inputs together do"),
    ],
)  # fmt: skip
def test_limits_alike_are_one_line(vary, error, U, last):
    plan = planned(*vary)
    assert printed(outcome(plan, course(plan, error, U)))[-1] == last
