"""What the terminal says of a sweep."""

import re
from dataclasses import replace

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Plate, chosen, course, outcome
from verify.studies.sweep.console import told
from verify.studies.sweep.console_table import shortened
from verify.studies.sweep.messages import error_with_bar
from verify.studies.sweep.plan import grid, sample

NAN = np.nan


def planned(*vary, only=("stiffness",), **more):
    return grid(CASE, "plate", Plate(), chosen(*only), vary, **more)


def sampled(count=64, tolerances=("a=±1mm", "b=±0.5mm")):
    return sample(CASE, "plate", Plate(), chosen(), f"sobol:{count}", tolerances)


def share(plan):
    """How far off the first input is, -1 to 1."""
    one = plan.tolerances[0]
    return (plan.points[:, 0] - one.nominal) / one.off


def test_a_grid_says_where_the_formula_holds_and_what_breaks_it():
    plan = planned("a=1:8mm:8", "n=2:3:2")
    a = np.round(plan.points[:, 0] * 1e3)
    assert told(outcome(plan, course(plan, 0.01 * a, 0.002))) == [
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


def test_limits_alike_are_told_together():
    plan = planned("a=1:4mm:4")
    lines = told(outcome(plan, course(plan, 1e-6, 0)))
    assert lines[-1] == "  within 2, 5 and 10 %: all 4 points: a 1..4 mm"
    assert told(outcome(plan, course(plan, 0.3, 0)))[-1] == "  within 2, 5 and 10 %: nowhere"
    assert told(outcome(plan, course(plan, 0.3, 0.3)))[-1].endswith("nowhere, 4 undecided")
    assert told(outcome(plan, course(plan, NAN)))[-1].endswith("nothing is solved")


def test_points_that_are_refused_or_failed_are_counted_with_their_reasons():
    plan = planned("a=1:8mm:8")
    whys = [
        "", "", "", "", "refused: inputs: b must be at most 2 mm, got 5 mm",
        "refused: inputs: b must be at most 3 mm, got 6 mm", "level 2: no",
        "refused: inputs.a = 8: no",
    ]  # fmt: skip
    error = [0.01 if not why else NAN for why in whys]
    lines = told(
        outcome(plan, course(plan, error, problems=tuple(whys)),
                problems={n: why for n, why in enumerate(whys) if why})
    )  # fmt: skip
    assert lines[:4] == [
        "4 of 8 points solved, 3 refused, 1 failed",
        "  2 points: such as: b must be at most 2 mm, got 5 mm",
        "  1 point: level 2: no",
        "  1 point: a = 8: no",
    ]
    assert lines[5] == "stiffness  +1 %           100 %  100 %  100 %  1"
    assert lines[7:] == [
        "  within 2, 5 and 10 %: all 4 points that are solved: a 1..4 mm",
        "    no answer beyond a = 4 mm: 5 mm is refused (b must be at most 2 mm, got 5",
        "        mm)",
    ]


def test_what_is_beyond_three_reasons_is_counted():
    plan = planned("a=1:5mm:5")
    whys = tuple(f"level 1: {word}" for word in ("red", "green", "blue", "grey", "black"))
    lines = told(outcome(plan, course(plan, NAN, problems=whys), problems=dict(enumerate(whys))))
    assert lines[0] == "0 of 5 points solved, 5 failed"
    assert lines[4] == "  and 2 more reasons in points.csv"


def test_a_star_says_that_inputs_vary_one_at_a_time():
    plan = planned("a=1:7mm:4", "b=1:4mm:4", star=True)
    a = np.round(plan.points[:, 0] * 1e3)
    lines = told(outcome(plan, course(plan, np.where(a > 4, 0.08, 0.0))))
    assert "  within 2 and 5 %" not in "\n".join(lines)
    at = lines.index("  within 5 %: a 1..4 mm, b 1..4 mm (all), one input at a time; 6 of 8 points")
    assert lines[at + 1].startswith("    first broken by a above 4.625 mm (between 4 and 5 mm)")


def test_a_formula_that_only_both_inputs_together_break():
    plan = planned("a=4:5mm:2", "b=2:3mm:2")
    lines = told(outcome(plan, course(plan, [0.0, 0.0, 0.0, 0.3])))
    assert lines[-1] == "    nothing breaks it along one axis, several inputs together do"


def test_a_box_that_is_not_all_that_is_inside_says_how_many_points_it_holds():
    plan = planned("a=3:5mm:3", "b=1:3mm:3")
    lines = told(outcome(plan, course(plan, [0, 0, 0, 0, 0, 0, 0, 0.3, 0])))
    text = re.sub(r"\s+", " ", "\n".join(lines))
    assert "10 %: a box of 6 points, a 3..4 mm, b 1..3 mm (all); 8 of 9 points in all" in text
    star = planned("a=1:7mm:4", "b=1:4mm:4", star=True)
    lines = told(outcome(star, course(star, [0, 0, 0, 0.3, 0, 0, 0, 0])))
    text = re.sub(r"\s+", " ", "\n".join(lines))
    assert "ranges of 6 points, a 1..4 mm, b 1..4 mm (all), one input at a time; 7 of 8" in text


def test_no_answer_below_a_value_is_told_like_one_above():
    plan = planned("a=1:4mm:4")
    lines = told(outcome(plan, course(plan, [NAN, NAN, 0, 0])))
    assert lines[-1] == ("    no answer beyond a = 3 mm: 2 mm is not solved (does not converge)")


def test_a_file_whose_own_value_is_not_swept_is_told_so():
    said = "the file's own a 4 mm lies outside of 5..8 mm"
    for vary, expected in (("a=5:8mm:4", True), ("a=4:8mm:5", False), ("a=1:4mm:4", False)):
        plan = planned(vary)
        assert (said in told(outcome(plan, course(plan, 0.0)))) is expected
    plan = planned("n=1:2:2")
    assert "the file's own n 3 lies outside of 1..2" in told(outcome(plan, course(plan, 0.0)))


@pytest.mark.parametrize(
    ("error", "bar", "said"),
    [
        (-25.754, 0.034, "-25.754 ± 0.034 %"),
        (16.8560, 0.0013, "+16.86 ± < 0.01 %"),
        (0.017, 4.2e-8, "+0.0170 ± < 0.0001 %"),
        (-0.0000002, 1e-6, "< 0.0001 %"),
        (8.0, 0.2, "+8.00 ± 0.20 %"),
        (0.0003, 0.0021, "+0.0003 ± 0.0021 %"),
        (1234.0, 0.3, "+1234 ± < 1 %"),
        (1234.0, 25.0, "+1234 ± 25 %"),
        (0.5, 0.0, "+0.5 %"),
    ],
)
def test_a_bar_is_told_to_what_matters_beside_the_error(error, bar, said):
    plan = planned("a=1:2mm:2")
    assert error_with_bar(course(plan, error / 100, bar / 100), 0) == said


def test_a_sample_says_scatter_and_ranked_indices():
    plan = sampled(1024)
    x = share(plan)
    y = (plan.points[:, 1] - 2e-3) / 0.5e-3
    lines = told(outcome(plan, course(plan, 0.05 + 0.01 * x + 0.03 * y, 0.002)))
    assert lines[0] == "4,096 of 4,096 points solved"
    assert lines[1].endswith("at a/mm, b/mm")
    assert lines[4].startswith("  FE 2 ± 0 N/mm; 2.5 % 2, 50 % 2, 97.5 % 2")
    assert lines[5] == "    no indices: does not vary"
    assert lines[6].startswith("  error 5.0 ± 1.8 %; 2.5 % 1.8, 50 % 5.0, 97.5 % 8.2")
    assert lines[7].startswith("    b  S1 0.90 (0.8")
    assert lines[8].startswith("    a  S1 0.10 (0.0")
    assert "ST 0.90" in lines[7]
    assert lines[9].startswith("S1 is the share of the variance that an input causes alone, ST")
    assert len(lines) == 12
    assert "the sample is small" not in "\n".join(lines)


def test_a_small_sample_is_called_so_with_what_would_halve_its_intervals():
    plan = sampled(8)
    y = share(plan) * (plan.points[:, 1] - 2e-3) / 0.5e-3
    lines = told(outcome(plan, course(plan, 0.05 + 0.01 * y, 0.0001)))
    last = re.sub(r"\s+", " ", " ".join(lines)).partition("the sample is small: ")[2]
    assert re.fullmatch(r"intervals are up to ±\d\.\d\d wide; sobol:32 would halve them", last)


def test_indices_that_may_be_of_noise_are_doubtful():
    plan = sampled()
    lines = told(outcome(plan, course(plan, 0.01 * share(plan), 0.006)))
    # (0.6 %/2)² of 1 %²/3
    assert (
        "    doubtful: 27 % of the variance may be the finite elements' own uncertainty"
    ) in lines
    lines = told(outcome(plan, course(plan, 0.01 * share(plan), 0.02)))
    assert lines[-1] == "    no indices: varies no more than the finite elements are uncertain"


def test_rows_of_a_sample_that_are_left_out_are_counted():
    plan = sampled(16)
    error = 0.01 * share(plan)
    error[[1, 18]] = NAN
    lines = told(outcome(plan, course(plan, error)))
    assert "stiffness (2 rows of the sample left out: not solved)" in lines
    assert any(line.startswith("  error of the solved points ") for line in lines)
    assert "of the solved" not in "\n".join(told(outcome(plan, course(plan, 0.01 * share(plan)))))


@pytest.mark.parametrize("error", [1e-9, 0.01, 0.3, NAN])
def test_many_rows_are_the_worst_ten_and_a_pointer_to_the_table(error):
    plan = planned("a=1:8mm:8", "n=2:3:2")
    names = [f"row {k}, with a rather long name of its own" for k in range(43)]
    plan = replace(plan, chosen=tuple(replace(plan.chosen[0], name=name) for name in names))
    rng = np.random.default_rng(1)
    courses = [
        replace(course(plan, error * (1 + 0.1 * k) * rng.uniform(0.5, 1, 16), 1e-4), pair=pair)
        for k, pair in enumerate(plan.chosen)
    ]
    lines = told(outcome(plan, *courses))
    assert len(lines) <= 30
    assert max(map(len, lines)) <= 80
    what = "smaller errors" if np.isfinite(error) else "no error"
    assert f"(33 more rows with {what} in points.csv)" in lines
    assert lines[-1].endswith("more rows in validity.csv)")
    if np.isfinite(error):
        assert "row 42" in lines[2]


def test_a_table_without_room_for_the_place_tells_it_with_the_row():
    plan = planned("a=1.125:8.125mm:3", "b=1:2mm:2", "c=0.125:2.125mm:2", "n=2:3:2")
    name = "stiffness of a rather long name"
    plan = replace(plan, chosen=(replace(plan.chosen[0], name=name),))
    lines = told(outcome(plan, course(plan, 12.34 * plan.points[:, 0], 0.0123)))
    assert lines[1].endswith("≤10 %")
    assert max(map(len, lines)) <= 80
    assert lines[3] == f"{name}, furthest off at a 8.125 mm, b 1 mm, c 0.125 mm,"
    assert lines[4] == "    n 2"


HEADS = [
    f"stiffness, head {head}: {elements} elements"
    for head in ("guided by the roller", "free") for elements in ("straight", "curved")
]  # fmt: skip


def test_names_lose_the_words_that_most_of_them_have():
    for room in (28, 34, 40):
        short = shortened(HEADS, room)
        assert len(set(short)) == len(HEADS)
        assert max(map(len, short)) <= room
    assert shortened(HEADS, 99) == HEADS
    assert shortened(["stiffness against the rather curved beam"], 28) == [
        "stiffness … curved beam"
    ]
    assert shortened(["one-word-that-is-too-long"], 10) == ["one-word-…"]


def test_names_are_whole_where_a_line_has_room():
    plan = planned("a=1:8mm:8")
    name = "stiffness, a name of 32 letters"
    plan = replace(plan, chosen=(replace(plan.chosen[0], name=name),))
    line = told(outcome(plan, course(plan, 0.01, 0.001)))[2]
    assert line.startswith(f"{name}  +1.00 ± 0.10 %")
    assert len(line) <= 80


def test_rows_left_out_of_the_table_are_not_all_said_to_have_an_error():
    plan = planned("a=1:2mm:2")
    plan = replace(plan, chosen=tuple(replace(plan.chosen[0], name=f"{k}") for k in range(12)))
    courses = [course(plan, 0.01 if k < 11 else NAN, pair=k) for k in range(12)]
    assert "(2 more rows with smaller errors or none in points.csv)" in told(
        outcome(plan, *courses)
    )
