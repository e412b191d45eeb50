"""Range of validity of formulas: measured, valid while its code is unchanged, printed on cards."""

from dataclasses import replace

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
from verify.studies.sweep.pairs import pairs
from verify.studies.sweep.run import solve
from verify.studies.validity import store as kept
from verify.studies.validity.cards import of_case
from verify.studies.validity.equations import place, tex
from verify.studies.validity.left_out import LEFT_OUT, MAPS
from verify.studies.validity.measuring import VALIDITY
from verify.studies.validity.regions import region

GRID = Scan(vary=("a=1mm,2mm,3mm,4mm", "n=3,6,9"), only=("stiffness",))
STAR = Scan(vary=("a=1mm,2mm,4mm,5mm", "b=1mm,2mm"), only=("stiffness",), star=True)
HELD = Scan(vary=("b=1mm,2mm",), only=("stiffness",), at=("a=1mm",))
PLATE = replace(CASE, paper="wang2023", place="Sec. 1", scans=(GRID, STAR, HELD))
NAN = np.nan


def error(a):
    """10 (a / 40 mm)², by hand: the error of the made-up case."""
    return 10 * (a / 40) ** 2


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


def limits(region):
    return [(one.limit, one.inside, one.outside, one.undecided, one.words) for one in region.limits]


def test_a_card_states_where_the_error_stays_within_each_limit_and_what_breaks_it(known):
    (card,) = known.cards
    grid, star, held = card.regions
    assert grid.over == "a 1 to 4 mm (4 values), n 3 to 9 (3 values)"
    assert (grid.points, grid.unsolved) == (12, 4)
    # 0.6, 2.5, 5.6 and just below 10 %: nothing is solved with 9 holes
    assert limits(grid) == [
        (0.02, 2, 6, 0, "a = 1 mm, n 3 to 6"),
        (0.05, 4, 4, 0, "a 1 to 2 mm, n 3 to 6"),
        (0.10, 8, 0, 0, "all a, n 3 to 6"),
    ]
    assert grid.problems == ("at 4 points: level 1: ValueError: 9 holes do not fit",)
    assert grid.error[3 * 3] == pytest.approx(error(4), abs=1e-4)  # a = 4 mm, n = 3
    assert grid.breaks == (
        "at the default inputs, the error exceeds 5 %; therefore, the inputs are changed from the "
        "middle of the range in which the error is within 5 %: if a is increased, the error first "
        "exceeds 5 % between a = 2 and 3 mm (at about 2.8)"
    )
    assert star.over == "a 1 to 5 mm (4 values), b 1 to 2 mm (2 values), one input varied at a time"
    assert limits(star)[1] == (0.05, 2, 3, 0, "a 1 to 2 mm (other inputs constant)")
    assert held.over == "b 1 to 2 mm (2 values), at a = 1 mm"
    assert limits(held)[0] == (0.02, 2, 0, 0, "the whole measured range")
    assert held.breaks == "the error exceeds 5 % at no measured point"


def test_a_point_that_is_not_surely_inside_has_its_reason(folder):
    plan = kept.plans(PLATE)[2]  # b = 1 mm and 2 mm, where the case has it
    for error_at_1, U, counts, words in (
        (0.04, 0.02, (1, 0, 1, 0),
         "if b is reduced, the error is within 5 % as far as b = 2 mm; at 1 mm, the error bar "
         "crosses the limit (undecided)"),
        (0.08, 0.01, (1, 1, 0, 0),
         "if b is reduced, the error first exceeds 5 % between b = 1 and 2 mm (at about 1.5)"),
        (NAN, NAN, (1, 0, 0, 1),
         "the error exceeds 5 % at no point that has a result; there is no result at b = 1 mm"),
    ):  # fmt: skip
        found = region(plan, course(plan, [error_at_1, 0.01], [U, 0.001]))
        middle = found.limits[1]
        assert (middle.inside, middle.outside, middle.undecided, found.unsolved) == counts
        assert middle.words == "b = 2 mm"
        assert found.breaks == words


def test_inputs_varied_one_at_a_time_are_no_box(folder):
    plan = kept.plans(PLATE)[1]  # a = 4 mm and b = 2 mm of the case, then a = 1, 2, 5 and b = 1
    of = {(1e-3, 2e-3): 0.01, (2e-3, 2e-3): 0.03, (5e-3, 2e-3): 0.2, (4e-3, 1e-3): 0.2}
    errors = [of.get((v[0], v[1]), 0.01) for v in plan.points.tolist()]
    found = region(plan, course(plan, errors, [1e-4] * 5))
    assert (
        found.limits[1].words
        == "a 1 to 4 mm (other inputs constant); only b = 2 mm (other inputs constant)"
    )
    errors = [0.2 if v[0] == 1e-3 else NAN if v[0] == 5e-3 else 0.01 for v in plan.points]
    found = region(plan, course(plan, errors, [1e-4] * 5))  # no answer hides no break
    assert (
        found.breaks
        == "if a is reduced, the error first exceeds 5 % between a = 1 and 2 mm (at about 1.8)"
    )


def test_the_row_of_the_run_gives_the_error_at_the_inputs_of_the_case(folder, known):
    row = Row(
        case=PLATE.id, quantity="stiffness", symbol="k", unit="N/mm", kind=Kind.APPROXIMATION,
        status=Status.PASS, analytic=2.0, fem=2.5, scale=2.5, u_num=0.01,
    )  # fmt: skip
    for one in (row, replace(row, fem=None, partner=Partner(by="strips", value=2.5))):
        (card,) = of_case(PLATE, result(one)).cards
        assert [card.error, card.U] == pytest.approx([-0.2, 2 * 0.01 / 2.5])


def test_exact_formulas_are_in_a_table_with_their_largest_difference(folder, monkeypatch):
    exact = Identity(name="stiffness", symbol="k", unit="N/mm", analytic="k", fem="k", formal=2)
    plate = replace(PLATE, checks=(exact, CASE.checks[1]))
    monkeypatch.setattr(registry, "CASES", (plate,))
    point._known.cache_clear()
    VALIDITY.measure_missing([plate], Here())
    found = of_case(plate, result())
    (line,) = found.exact
    assert (found.cards, found.others) == ((), ("stress",))
    assert (line.quantity, line.points, line.unsolved) == ("stiffness", 19, 4)
    assert line.largest == pytest.approx(error(5), rel=1e-3)  # of the star


# Records


def test_a_measurement_is_made_once_and_again_where_it_no_longer_stands(folder, capsys):
    (solved,) = outcome(solve(kept.plans(PLATE)[0], Here())).courses
    VALIDITY.measure_missing([PLATE], Here())
    assert "validity:made-up-plate: 19 points" in capsys.readouterr().out
    VALIDITY.measure_missing([PLATE], Here())
    assert "measured already" in capsys.readouterr().out
    (read,) = kept.measured(PLATE).scans[0][1]
    np.testing.assert_allclose(read.error, solved.error, rtol=5e-4)
    np.testing.assert_allclose(read.U_error, solved.U_error, rtol=5e-4)
    assert read.problems == solved.problems
    file = folder / "made-up-plate.json"
    before = file.read_text("utf-8")
    file.write_text("{}", "utf-8")
    VALIDITY.measure_missing([PLATE], Here())  # from the points in the store
    assert file.read_text("utf-8") == before
    # a record stays where processes die
    for stored in (folder.parent / "cache").glob("store.sqlite*"):
        stored.unlink()
    assert not VALIDITY.measure_missing([PLATE], Dying(), again=True)
    assert "points were not completed" in capsys.readouterr().out
    assert file.read_text("utf-8") == before


class Thick(CASE.inputs):
    c: float = quantity("3 mm", "mm", "c", "thickness, which nothing depends on", gt=0)


def test_a_record_is_that_of_its_code_inputs_scans_and_comparisons(folder, known, monkeypatch):
    assert kept.measured(PLATE) is not None
    for changed in (
        {"inputs": Thick},
        {"scans": (replace(GRID, star=True), STAR, HELD)},
        {"checks": (replace(CASE.checks[0], analytic="s"), CASE.checks[1])},
    ):
        assert kept.measured(replace(PLATE, **changed)) is None
    monkeypatch.setattr(source_code, "source_of", lambda _function: "other")
    found = of_case(PLATE, result())
    assert found.missing.startswith(
        "range of validity not computed for the present code: run `freewheel deep validity:made-up"
    )
    assert not found.cards


def test_every_case_with_pairs_has_scans_around_its_inputs_or_a_reason_for_none():
    ids = {case.id for case in registry.CASES}
    assert {*MAPS, *LEFT_OUT, *(name for names in MAPS.values() for name in names)} <= ids
    for case in registry.CASES:
        assert bool(case.scans) == bool(pairs(case) and case.id not in LEFT_OUT), case.id
        for scan, plan in zip(case.scans, kept.plans(case), strict=True):
            assert 1 < len(plan.points) <= 80, case.id
            for axis in plan.axes:
                is_held = any(text.startswith(f"{axis.name}=") for text in scan.at)
                is_inside = axis.values[0] <= axis.nominal <= axis.values[-1]
                assert is_inside or is_held, (case.id, axis.name)


def test_a_formula_has_its_equation_where_it_is_certain_which():
    case = registry.find("ring-loads-outer", registry.CASES)
    equations = case.equations(case.inputs(), case.analytic(case.inputs()))
    by_name = {pair.name: pair for pair in pairs(case)}
    at_load = by_name["deflection by Eq. 6, compared with the displacement under a sprag"]
    assert tex(case, at_load, equations).startswith(r"\delta_{BE} = \frac{N n}{2 \pi l E}")
    assert place(case, at_load) == "Huang 2018, Eq. 6"
    assert tex(case, by_name["rim displacement at the angle of a sprag"], equations) == ""
    stress = next(p for p in pairs(PLATE) if p.name == "stress")
    one, other = Equation(tex=r"\sigma = E"), Equation(tex=r"\sigma = F")
    assert [tex(PLATE, stress, found) for found in ([one], [one, other])] == [one.tex, ""]


@pytest.mark.parametrize(
    ("case_id", "name", "expected"),
    [
        ("polyhedral-clutch", "pressure for the target torque, Eqs. 17 to 20",
         "Belcin, Eqs. 17 to 20"),
        ("sprag-wedge", "wind-up of a clutch with rigid races by Palmgren's law (Huang 2022, "
         "Eqs. 2, 4), at N_0",
         "Huang 2022, Eqs. 2, 4"),
        ("ring-lame", "bore displacement, plane stress",
         "Huang 2018, Eq. 6, based on Lamé's formulas"),
    ],
)  # fmt: skip
def test_the_place_of_a_row_is_in_the_paper_that_its_name_states(case_id, name, expected):
    case = registry.find(case_id, registry.CASES)
    (pair,) = (pair for pair in pairs(case) if pair.name == name)
    assert place(case, pair) == expected
