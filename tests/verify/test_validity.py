"""Where formulas hold: what is measured, kept while its code stands, and told on cards."""

import json
from dataclasses import replace
from itertools import combinations, product

import numpy as np
import pytest

from tests.verify.sweep_made import CASE, Dying, Here, course
from verify.cases import registry
from verify.core import source_code
from verify.core.case import Scan
from verify.core.figures import Equation
from verify.core.inputs import quantity
from verify.core.results import CaseResult, Kind, Partner, Row, Status
from verify.jobs import records
from verify.judging.checks import Identity
from verify.studies.sweep import point
from verify.studies.sweep.outcome import outcome
from verify.studies.sweep.pairs import pairs, signature
from verify.studies.sweep.run import solve
from verify.studies.validity import messages as words
from verify.studies.validity import store as kept
from verify.studies.validity.cards import of_case, validity
from verify.studies.validity.equations import numbers, place, tex
from verify.studies.validity.left_out import LEFT_OUT, MAPS
from verify.studies.validity.measuring import VALIDITY
from verify.studies.validity.regions import region

GRID = Scan(vary=("a=1mm,2mm,3mm,4mm", "n=3,6,9"), only=("stiffness",))
STAR = Scan(vary=("a=1mm,2mm,4mm,5mm", "b=1mm,2mm"), only=("stiffness",), star=True)
HELD = Scan(vary=("b=1mm,2mm",), only=("stiffness",), at=("a=1mm",))
PLATE = replace(CASE, paper="wang2023", place="Sec. 1", scans=(GRID, STAR, HELD))
# 10 (a / 40 mm)² and 1e-4/16 more, by hand: the made-up case's own error
ERROR = {a: 10 * (a / 40) ** 2 for a in (1, 2, 3, 4, 5)}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    monkeypatch.setattr(registry, "CASES", (PLATE,))
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    point._known.cache_clear()
    yield tmp_path / "validity"
    point._known.cache_clear()


@pytest.fixture
def known(folder):
    VALIDITY.measure_missing([PLATE], Here())
    return of_case(PLATE, result())


def result(*rows):
    return CaseResult(
        id=PLATE.id, title="", paper="wang2023", place="", lead="", inputs=(), equations=(),
        assumptions=(), readings=(), rows=rows,
    )  # fmt: skip


def test_a_record_stays_where_processes_die(folder, known, capsys):
    before = kept.RECORDS.stored(PLATE.id)
    for file in (folder.parent / "cache").glob("store.sqlite*"):
        file.unlink()
    assert not VALIDITY.measure_missing([PLATE], Dying(), again=True)
    assert "points have no answer" in capsys.readouterr().out
    assert kept.RECORDS.stored(PLATE.id) == before


def test_a_record_is_that_of_its_arithmetic(folder, known, monkeypatch):
    assert kept.measured(PLATE) is not None
    monkeypatch.setattr(kept, "_arithmetic", lambda: "another")
    assert kept.measured(PLATE) is None


def test_a_claim_that_derives_its_values_counts_with_its_code():
    case = next(one for one in registry.CASES if one.id == "polyhedral-locking")
    derived = [pair for pair in pairs(case) if not pair.plain]
    assert derived
    for pair in derived:
        assert signature(pair)[-1] == source_code.source_of(type(pair.claim))


def limits(region):
    return [(one.limit, one.inside, one.outside, one.undecided, one.words) for one in region.limits]


def test_a_card_says_where_the_error_stays_within_each_limit(known):
    (card,) = known.cards
    grid = card.regions[0]
    assert grid.over == "a 1 to 4 mm (4 values), n 3 to 9 (3 values)"
    assert (grid.points, grid.unsolved) == (12, 4)
    # 0.6, 2.5, 5.6 and just below 10 %: nothing is solved with 9 holes
    assert limits(grid) == [
        (0.02, 2, 6, 0, "a = 1 mm, n 3 to 6"),
        (0.05, 4, 4, 0, "a 1 to 2 mm, n 3 to 6"),
        (0.10, 8, 0, 0, "all a, n 3 to 6"),
    ]
    assert grid.problems == ("4 × level 1: ValueError: 9 holes do not fit",)
    assert [(a.name, a.values, a.nominal) for a in grid.axes] == [
        ("a", (1.0, 2.0, 3.0, 4.0), 4.0), ("n", (3.0, 6.0, 9.0), 3.0),
    ]  # fmt: skip
    assert grid.error[0] == pytest.approx(ERROR[1], abs=1e-5)
    assert grid.error[3 * 3] == pytest.approx(ERROR[4], abs=1e-4)  # a = 4 mm, n = 3
    assert all(np.isnan(grid.error[k]) for k in (2, 5, 8, 11))


def test_a_card_says_what_breaks_the_formula_first(known):
    grid, star, held = known.cards[0].regions
    assert grid.breaks == (
        "beyond 5 % at the case's own inputs already; from the middle of the box, "
        "larger a takes it beyond 5 % between 2 and 3 mm (about 2.8)"
    )
    assert star.over == "a 1 to 5 mm (4 values), b 1 to 2 mm (2 values), one at a time"
    assert star.breaks == "beyond 5 % at the case's own inputs already"
    assert limits(star)[1] == (0.05, 2, 3, 0, "a alone 1 to 2 mm")
    assert held.over == "b 1 to 2 mm (2 values), at a = 1 mm"
    assert limits(held) == [
        (limit, 2, 0, 0, "all that was measured") for limit in (0.02, 0.05, 0.1)
    ]
    assert held.breaks == "nothing in what was measured takes it beyond 5 %"


@pytest.mark.parametrize(
    ("error", "U", "counts", "said"),
    [
        (0.04, 0.02, (1, 0, 1, 0),
         "smaller b: within 5 % to 2 mm, undecided at 1 mm: the error bar reaches across"),
        (0.08, 0.01, (1, 1, 0, 0), "smaller b takes it beyond 5 % between 1 and 2 mm (about 1.5)"),
        (np.nan, np.nan, (1, 0, 0, 1),
         "nothing that was solved takes it beyond 5 %; no answer at b = 1 mm"),
    ],
)  # fmt: skip
def test_a_point_that_is_not_surely_inside_is_told_for_what_it_is(error, U, counts, said):
    plan = kept.plans(PLATE)[2]  # b = 1 mm and 2 mm, where the case has it
    found = region(plan, course(plan, [error, 0.01], [U, 0.001]))
    middle = found.limits[1]
    assert (middle.inside, middle.outside, middle.undecided, found.unsolved) == counts
    assert middle.words == "b = 2 mm"
    assert found.breaks == said


@pytest.mark.parametrize(
    ("errors", "said"),
    [
        ((0.01, 0.01, 0.03, 0.2, 0.2), "a alone 1 to 4 mm; b alone at 2 mm"),
        ((0.01, 0.2, 0.01, 0.2, 0.01), "a alone 2 to 4 mm; b alone throughout"),
    ],
)
def test_inputs_varied_one_at_a_time_are_no_box(errors, said):
    plan = kept.plans(PLATE)[1]  # the case's own a = 4 mm and b = 2 mm, then a = 1, 2, 5 and b = 1
    rows = [(v[0], v[1]) for v in plan.points.tolist()]
    of = dict(zip([(4e-3, 2e-3), (1e-3, 2e-3), (2e-3, 2e-3), (5e-3, 2e-3), (4e-3, 1e-3)], errors,
                  strict=True))  # fmt: skip
    found = region(plan, course(plan, [of[row] for row in rows], [1e-4] * 5))
    assert found.limits[1].words == said


def test_a_break_that_starts_beside_the_largest_box_says_from_where():
    plan = kept.plans(PLATE)[0]  # the case's own a = 4 mm and n = 3
    errors = [0.2 if v[0] > 2.5e-3 and (v[0], v[1]) != (4e-3, 3) else 0.01 for v in plan.points]
    found = region(plan, course(plan, errors, [1e-4] * 12))
    assert found.limits[1].words == "a 1 to 2 mm, all n"
    assert found.breaks.startswith("from the case's own inputs, which are not in that box, ")


def test_an_answer_that_is_missing_does_not_hide_a_formula_that_breaks():
    plan = kept.plans(PLATE)[1]
    errors = [0.2 if v[0] == 1e-3 else np.nan if v[0] == 5e-3 else 0.01 for v in plan.points]
    found = region(plan, course(plan, errors, [1e-4] * 5))
    assert found.breaks == "smaller a takes it beyond 5 % between 1 and 2 mm (about 1.8)"
    plan = kept.plans(PLATE)[0]  # from a = 4 mm and n = 3
    special = {(1e-3, 9): 0.2, (4e-3, 6): np.nan}
    errors = [special.get((v[0], v[1]), 0.01) for v in plan.points]
    assert region(plan, course(plan, errors, [1e-4] * 12)).breaks == (
        "from the case's own inputs, which are not in that box, larger n: within 5 % to 3, "
        "no answer at n = 6; elsewhere 1 point is not within it"
    )


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (np.nan, "nothing that was solved takes it beyond 5 %"),
        (0.2, "no input alone takes it beyond 5 %, several together do"),
    ],
)
def test_two_inputs_at_once_that_break_it_or_have_no_answer(error, said):
    plan = kept.plans(PLATE)[0]  # the case's own a = 4 mm and n = 3
    errors = [error if v[0] < 1.5e-3 and v[1] > 8 else 0.01 for v in plan.points]
    found = region(plan, course(plan, errors, [1e-4] * 12))
    assert found.breaks.endswith(said)


def test_a_value_between_two_is_told_where_two_digits_still_lie_between():
    a = kept.plans(PLATE)[0].axes[0]
    assert words.near(a, 15e-3, 40e-3, 31.97e-3) == " (about 32)"
    assert words.near(a, 40e-3, 15e-3, 31.97e-3) == " (about 32)"
    assert words.near(a, 0.1e-3, 0.2e-3, 0.1034e-3) == ""
    assert words.between(a, 40e-3, 15e-3) == "15 and 40 mm"


def test_advice_for_a_single_point_is_no_reason_on_a_card():
    plan = kept.plans(PLATE)[2]
    made = course(plan, [np.nan, 0.01], [np.nan, 1e-3])
    told = replace(made, problems=("refused: too thin, check it without --fem", ""))
    assert region(plan, told).problems == ("1 × refused: too thin",)


def test_the_row_of_the_run_gives_the_error_at_the_case_s_own_inputs(folder):
    VALIDITY.measure_missing([PLATE], Here())
    row = Row(
        case=PLATE.id, quantity="stiffness", symbol="k", unit="N/mm", kind=Kind.APPROXIMATION,
        status=Status.PASS, analytic=2.0, fem=2.5, scale=2.5, u_num=0.01,
    )  # fmt: skip
    (card,) = of_case(PLATE, result(row)).cards
    assert [card.error, card.U] == pytest.approx([-0.2, 2 * 0.01 / 2.5])


def test_another_numerical_model_than_finite_elements_gives_that_error_too(folder):
    VALIDITY.measure_missing([PLATE], Here())
    row = Row(
        case=PLATE.id, quantity="stiffness", symbol="k", unit="N/mm", kind=Kind.APPROXIMATION,
        status=Status.PASS, analytic=2.0, scale=2.5, u_num=0.01,
        partner=Partner(by="strips", value=2.5),
    )  # fmt: skip
    (card,) = of_case(PLATE, result(row)).cards
    assert [card.error, card.U] == pytest.approx([-0.2, 2 * 0.01 / 2.5])


def test_a_measurement_is_made_once_and_again_where_it_no_longer_stands(folder, capsys):
    VALIDITY.measure_missing([PLATE], Here())
    assert "validity:made-up-plate: 19 points" in capsys.readouterr().out
    VALIDITY.measure_missing([PLATE], Here())
    assert "measured already" in capsys.readouterr().out
    before = (folder / "made-up-plate.json").read_text("utf-8")
    (folder / "made-up-plate.json").write_text("{}", "utf-8")
    VALIDITY.measure_missing([PLATE], Here())  # from the points that are kept
    assert (folder / "made-up-plate.json").read_text("utf-8") == before


@pytest.mark.parametrize("side", ["whole_source_of", "source_of"])
def test_what_another_code_made_of_either_side_is_not_told(folder, monkeypatch, side):
    VALIDITY.measure_missing([PLATE], Here())
    assert not of_case(PLATE, result()).missing
    monkeypatch.setattr(source_code, side, lambda _function: "other")
    found = of_case(PLATE, result())
    assert found.missing.startswith("not measured for this code: freewheel deep validity:made-up")
    assert not found.cards


class Thick(CASE.inputs):
    c: float = quantity("3 mm", "mm", "c", "thickness, which nothing depends on", gt=0)


@pytest.mark.parametrize(
    "changed",
    [
        {"inputs": Thick},
        {"scans": (replace(GRID, star=True), STAR, HELD)},
        {"scans": (GRID, STAR, replace(HELD, at=("a=2mm",)))},
        {"checks": (replace(CASE.checks[0], formal=1), CASE.checks[1])},
        {"checks": (replace(CASE.checks[0], analytic="s"), CASE.checks[1])},
    ],
)
def test_other_inputs_scans_or_comparisons_are_not_measured(folder, changed):
    VALIDITY.measure_missing([PLATE], Here())
    assert kept.measured(PLATE) is not None
    assert kept.measured(replace(PLATE, **changed)) is None


def test_too_few_errors_are_not_measured(folder):
    VALIDITY.measure_missing([PLATE], Here())
    path = folder / "made-up-plate.json"
    data = json.loads(path.read_text("utf-8"))
    data["content"][0]["stiffness"]["error"].pop()
    path.write_text(json.dumps(data), "utf-8")
    assert kept.measured(PLATE) is None


def test_what_is_kept_has_four_digits_and_reads_back(folder):
    plan = kept.plans(PLATE)[0]
    (solved,) = outcome(solve(plan, Here())).courses
    VALIDITY.measure_missing([PLATE], Here())
    (read,) = kept.measured(PLATE).scans[0][1]
    np.testing.assert_allclose(read.error, solved.error, rtol=5e-4)
    np.testing.assert_allclose(read.U_error, solved.U_error, rtol=5e-4)
    assert read.problems == solved.problems


def test_exact_formulas_stand_in_a_table_with_their_largest_difference(folder):
    exact = Identity(name="stiffness", symbol="k", unit="N/mm", analytic="k", fem="k", formal=2)
    plate = replace(PLATE, checks=(exact, CASE.checks[1]))
    registry.CASES = (plate,)
    point._known.cache_clear()
    VALIDITY.measure_missing([plate], Here())
    found = of_case(plate, result())
    (line,) = found.exact
    assert not found.cards
    assert found.others == ("stress",)
    assert found.over.startswith("a 1 to 4 mm (4 values), n 3 to 9 (3 values); a 1 to 5 mm")
    assert (line.quantity, line.points, line.unsolved) == ("stiffness", 19, 4)
    assert line.largest == pytest.approx(ERROR[5], rel=1e-3)  # of the star


def test_what_no_case_of_the_run_shows_is_not_linked(folder):
    case = registry.CASES[0]
    assert not validity([result()], [case])[0].maps
    assert validity([result()], []) == ()


# Every case of the suite


def test_every_case_with_pairs_has_scans_or_says_why_not():
    for case in registry.CASES:
        if pairs(case):
            assert bool(case.scans) != (case.id in LEFT_OUT), case.id
        else:
            assert not case.scans, case.id


def test_the_scans_of_every_case_make_sense():
    for case in registry.CASES:
        for scan, plan in zip(case.scans, kept.plans(case), strict=True):
            assert plan.chosen, case.id
            assert 1 < len(plan.points) <= 80, case.id
            for axis in plan.axes:  # around the paper's own inputs
                assert axis.nominal is not None, (case.id, axis.name)
                held = any(text.startswith(f"{axis.name}=") for text in scan.at)
                inside = axis.values[0] <= axis.nominal <= axis.values[-1]
                assert inside or held, (case.id, axis.name)


def test_links_to_maps_lead_to_cases():
    ids = {case.id for case in registry.CASES}
    assert set(MAPS) <= ids
    assert {name for names in MAPS.values() for name in names} <= ids
    assert set(LEFT_OUT) <= ids


def test_files_of_measurements_stay_small():
    assert sum(path.stat().st_size for path in (records.FOLDER / "validity").iterdir()) < 600e3


# The same statements from the stored numbers, by other means


@pytest.mark.parametrize("name", ["ring-loads-outer", "polyhedral-ring", "spring-accordion"])
def test_cards_say_what_the_stored_numbers_say(name, monkeypatch):
    case = registry.find(name, registry.CASES)
    record = kept.RECORDS.stored(name)
    monkeypatch.setattr(kept, "_made_by", lambda *_: record.made_by)
    told = {card.quantity: card.regions[0] for card in of_case(case, result()).cards}
    axes = [axis.values for axis in kept.plans(case)[0].axes]  # a grid of two, the last one fastest
    assert told
    for row, drawn in told.items():
        stored = record.content[0][row]
        ends = [
            (abs(e) - u, abs(e) + u) if u is not None else (np.nan, np.nan)
            for e, u in zip(stored["error"], stored["U"], strict=True)
        ]
        for one in drawn.limits:
            inside = [high <= one.limit for _, high in ends]
            assert one.inside == sum(inside)
            assert one.outside == sum(low > one.limit for low, _ in ends)
            grid = np.array(inside).reshape([len(values) for values in axes])
            assert held(one, drawn) == largest(grid)


def largest(inside):
    """How many points the largest box of a grid of two axes holds: all boxes are tried."""
    rows, columns = ([*combinations(range(n + 1), 2)] for n in inside.shape)
    boxes = [inside[i:j, k:m] for (i, j), (k, m) in product(rows, columns)]
    return max(box.size * bool(box.all()) for box in boxes)


def held(limit, drawn):
    """How many points lie in the ranges that are told of a limit, all of which are inside."""
    if not limit.box:
        return 0
    grid = np.array(drawn.error).reshape([len(axis.values) for axis in drawn.axes])
    U = np.array(drawn.U).reshape(grid.shape)
    within = np.ix_(*(
        [low <= v <= high for v in axis.values]
        for axis, (_, low, high) in zip(drawn.axes, limit.box, strict=True)
    ))  # fmt: skip
    assert (np.abs(grid[within]) + U[within] <= limit.limit).all()
    return grid[within].size


# Which equation it is


def test_the_equations_that_a_text_names():
    assert numbers("Eqs. 6, 8-10") == {6, 8, 9, 10}
    assert numbers("torque, Eq. 3 as printed") == {3}
    assert numbers("nothing of the kind") == frozenset()


def test_a_formula_is_shown_where_it_is_certain_which():
    case = registry.find("ring-loads-outer", registry.CASES)
    shown = case.equations(case.inputs(), case.analytic(case.inputs()))
    by_name = {pair.name: pair for pair in pairs(case)}
    at_load = by_name["Eq. 6 at a load"]
    assert tex(case, at_load, shown).startswith(r"\delta_{BE} = \frac{N n}{2 \pi l E}")
    assert place(case, at_load) == "Eq. 6, Huang 2018"
    assert tex(case, by_name["rim displacement opposite a load"], shown) == ""
    clutch = registry.find("polyhedral-wedge", registry.CASES)
    printed = next(p for p in pairs(clutch) if p.name.endswith("Eq. 3 as printed"))
    assert tex(clutch, printed, [Equation(tex="M_t = x", place="Eq. 3")]) == ""
    stress = next(p for p in pairs(PLATE) if p.name == "stress")
    assert tex(PLATE, stress, [Equation(tex=r"\sigma = E")]) == r"\sigma = E"
    assert tex(PLATE, stress, [Equation(tex=r"\sigma = E"), Equation(tex=r"\sigma = F")]) == ""
