"""What a sweep prints, on outcomes that are written down here."""

import re
from dataclasses import replace

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Plate, chosen, course, outcome
from verify.studies.sweep.console import told as printed
from verify.studies.sweep.plan import grid, sample

NAN = np.nan


def planned(*vary, **more):
    return grid(CASE, "plate", Plate(), chosen(), vary, **more)


def sampled(count=64):
    return sample(CASE, "plate", Plate(), chosen(), f"sobol:{count}", ["a=±1mm", "b=±0.5mm"])


def share(plan):
    """How far off the first input is, -1 to 1."""
    one = plan.tolerances[0]
    return (plan.points[:, 0] - one.nominal) / one.off


def one_line(lines):
    return re.sub(r"\s+", " ", " ".join(lines))


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


@pytest.mark.parametrize(
    ("vary", "error", "U", "last"),
    [
        (("a=1:4mm:4",), 1e-6, 0, "  within 2, 5 and 10 %: all 4 points: a 1..4 mm"),
        (("a=1:4mm:4",), 0.3, 0, "  within 2, 5 and 10 %: nowhere"),
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


def test_points_that_are_refused_or_failed_are_counted_with_their_reasons():
    plan = planned("a=1:8mm:8")
    whys = [
        "", "", "", "", "refused: inputs: b must be at most 2 mm, got 5 mm",
        "refused: inputs: b must be at most 3 mm, got 6 mm", "level 2: no",
        "refused: inputs.a = 8: no",
    ]  # fmt: skip
    error = [0.01 if not why else NAN for why in whys]
    lines = printed(
        outcome(plan, course(plan, error, problems=tuple(whys)),
                problems={n: why for n, why in enumerate(whys) if why})
    )  # fmt: skip
    assert lines[:4] == [
        "4 of 8 points solved, 3 refused, 1 failed",
        "  2 points: such as: b must be at most 2 mm, got 5 mm",
        "  1 point: level 2: no",
        "  1 point: a = 8: no",
    ]
    assert lines[7] == "  within 2, 5 and 10 %: all 4 points that are solved: a 1..4 mm"
    assert "5 mm is refused (b must be at most 2 mm, got 5 mm)" in one_line(lines)


def test_a_sample_has_its_scatter_and_its_indices_the_largest_first():
    plan = sampled(1024)
    x = share(plan)
    y = (plan.points[:, 1] - 2e-3) / 0.5e-3
    lines = printed(outcome(plan, course(plan, 0.05 + 0.01 * x + 0.03 * y, 0.002)))
    assert lines[0] == "4,096 of 4,096 points solved"
    assert lines[4].startswith("  FE 2 ± 0 N/mm; 2.5 % 2, 50 % 2, 97.5 % 2")
    assert lines[5] == "    no indices: does not vary"
    assert lines[6].startswith("  error 5.0 ± 1.8 %; 2.5 % 1.8, 50 % 5.0, 97.5 % 8.2")
    assert lines[7].startswith("    b  S1 0.90 (0.8")
    assert lines[8].startswith("    a  S1 0.10 (0.0")
    assert len(lines) == 12


def test_a_sample_says_what_its_indices_do_not_show():
    plan = sampled(8)
    y = share(plan) * (plan.points[:, 1] - 2e-3) / 0.5e-3
    text = one_line(printed(outcome(plan, course(plan, 0.05 + 0.01 * y, 0.0001))))
    assert re.search(r"the sample is small: intervals are up to ±\d\.\d\d wide; sobol:32 ", text)
    plan = sampled()
    lines = printed(outcome(plan, course(plan, 0.01 * share(plan), 0.006)))
    # (0.6 %/2)² of 1 %²/3
    doubt = "    doubtful: 27 % of the variance may be the finite elements' own uncertainty"
    assert doubt in lines
    lines = printed(outcome(plan, course(plan, 0.01 * share(plan), 0.02)))
    assert lines[-1] == "    no indices: varies no more than the finite elements are uncertain"
    error = 0.01 * share(plan)
    error[[1, 18]] = NAN
    lines = printed(outcome(plan, course(plan, error)))
    assert "stiffness (2 rows of the sample left out: not solved)" in lines


@pytest.mark.parametrize("error", [0.3, NAN])
def test_many_rows_are_the_worst_ten_and_a_pointer_to_the_table(error):
    plan = planned("a=1:8mm:8", "n=2:3:2")
    names = [f"row {k}, with a rather long name of its own" for k in range(43)]
    plan = replace(plan, chosen=tuple(replace(plan.chosen[0], name=name) for name in names))
    courses = [
        replace(course(plan, error * (1 + 0.1 * k), 1e-4), pair=pair)
        for k, pair in enumerate(plan.chosen)
    ]
    lines = printed(outcome(plan, *courses))
    assert len(lines) <= 30
    assert max(map(len, lines)) <= 80
    what = "smaller errors" if np.isfinite(error) else "no error"
    assert f"(33 more rows with {what} in points.csv)" in lines
    assert lines[-1].endswith("more rows in validity.csv)")
    assert "row 42" in lines[2] or not np.isfinite(error)
