"""The validity explorer: its data, and answers of its script against an interpolation in Python."""

import json
import re

import numpy as np
import pytest
from scipy.interpolate import RegularGridInterpolator

from reports.explorer import DECIMALS, of_cases
from reports.explorer_tables import in_percent
from reports.links import FIRST, FOLDER
from tests.reports.browser import CHROMIUM, looked_at

PAGE = f"{FOLDER}/explorer.html"
STEP = 10.0**-DECIMALS  # of the errors in the page
RING, K = "polyhedral-ring", "K of the paper"
pytestmark = pytest.mark.slow("pages are made, and a browser fills in the form")


@pytest.fixture(scope="module")
def data(made):
    found = re.search(r'id="explorer-data">(.*?)</script>', made[PAGE], re.DOTALL)
    return json.loads(found[1])


def test_the_data_are_the_stored_points(explored, data):
    cases = {one["id"]: one for one in data["cases"]}
    assert list(cases) == [one.case.id for one in of_cases(explored)]
    count = 0
    for study in explored.studies:
        one = cases[study.case]
        n = [s for s in explored.studies if s.case == study.case].index(study)
        assert [tuple(p) for p in one["studies"][n]["points"]] == list(study.points)
        for formula in study.formulas:
            shown = next(f for f in one["formulas"] if f["name"] == formula.quantity)
            at = next(found for number, *found in shown["at"] if number == n)
            for key, whole in zip(("error", "U"), at, strict=False):
                values = [np.nan if v is None else v * STEP for v in whole]
                np.testing.assert_allclose(values, getattr(formula, key), rtol=0, atol=0.6 * STEP)
            count += len(formula.error)
    assert count == sum(len(f.error) for s in explored.studies for f in s.formulas) > 500


def test_pages_lead_to_the_explorer_and_its_data_to_places(data, made):
    assert f'href="{PAGE}#explore-' in made[FIRST]
    assert 'href="explorer.html#explore-polyhedral-ring"' in made[f"{FOLDER}/{RING}.html"]
    assert all(f'id="{v["place"]}"' in made[FIRST] for v in data["verdicts"])
    for one in data["cases"]:
        page = made[f"{FOLDER}/{one['id']}.html"]
        assert all(f'id="{f["row"]}"' in page for f in one["formulas"])


def test_tables_hold_every_point_without_a_script(explored, made):
    tables = made[PAGE].partition('id="stored-points"')[2].partition("</section>")[0]
    cells = re.findall(r"<td>([^<]*)", tables)
    wide = [int(n) for n in re.findall(r'colspan="(\d+)">all errors within 0.001 %', tables)]
    formulas = [f for s in explored.studies for f in s.formulas]
    tiny = [f for f in formulas if max(np.abs(f.error) + f.U) < 1e-5]
    assert len(wide) == len(tiny) > 10
    assert len(cells) == sum(len(f.error) for f in formulas if f not in tiny)
    assert cells.count("–") == 1


def test_an_error_in_per_cent():
    for error, U, words in (
        (-0.1722, 0.0031, "−17.2 ± 0.3"), (-0.1722, 0.0003, "−17.2"), (0.0, 0.0, "<0.001"),
        (2.853, 0.1, "+285 ± 10"), (0.0, 3e-3, "0 ± 0.3"), (np.nan, np.nan, "–"),
        (3e-6, 9e-6, "+0.0003 ± 0.0009"),
    ):  # fmt: skip
        assert in_percent(error, U) == words


def course(report, case, quantity, *, star):
    """Points by axis, and errors and bars over them, of a study of a row."""
    study, formula = next(
        (study, f) for study in report.studies for f in study.formulas
        if (study.case, study.is_star, f.quantity) == (case, star, quantity)
    )  # fmt: skip
    return study, np.array(study.points), np.array(formula.error), np.array(formula.U)


def around(x, at):
    """Indices of the points at or on both sides of a value."""
    if len(same := np.flatnonzero(np.isclose(x, at, rtol=1e-9))):
        return list(same)
    i = int(np.searchsorted(x, at))
    return [i - 1, i]


def bent(x, e, at):
    """The interpolation error on a line of points, of its largest curvature: none at a point."""
    near = around(x, at)
    if len(near) == 1:
        return 0.0
    i, j = near
    a, b = np.diff(x)[:-1], np.diff(x)[1:]
    curvature = np.abs(e[1:-1] - (e[:-2] * b + e[2:] * a) / (a + b)) / (a * b)
    c = np.concatenate([[np.nan], curvature, [np.nan]])
    return float(np.nanmax(c[near]) * (x[j] - x[i]) ** 2 + abs(e[j] - e[i]) / 4)


def on_grid(report, case, quantity, at):
    """Error and bar at a point of a grid over two inputs."""
    _, points, error, U = course(report, case, quantity, star=False)
    axes = [np.unique(points[:, k]) for k in (0, 1)]
    e, u = (v.reshape(len(axes[0]), -1) for v in (error, U))
    (z,) = RegularGridInterpolator(axes, e)([at])
    near = [around(x, v) for x, v in zip(axes, at, strict=True)]
    more = max(bent(axes[0], e[:, j], at[0]) for j in near[1])
    more += max(bent(axes[1], e[i, :], at[1]) for i in near[0])
    return float(z), float(u[np.ix_(*near)].max() + more)


def on_line(report, case, quantity, name, at):
    """Error and bar at a value of one input of a star."""
    study, points, error, U = course(report, case, quantity, star=True)
    k = [axis.name for axis in study.axes].index(name)
    mine = (np.delete(points, k, axis=1) == np.delete(points[0], k)).all(axis=1)
    order = np.argsort(points[mine, k])
    x, e, u = (v[order] for v in (points[mine, k], error[mine], U[mine]))
    if study.axes[k].log:
        x, at = np.log(x), np.log(at)
    return float(np.interp(at, x, e)), float(u[around(x, at)].max() + bent(x, e, at))


def lines_of(study):
    """Values and rows of all lines of a study along an axis, over the logarithm where it is so."""
    points = np.array(study.points)
    for k, axis in enumerate(study.axes):
        others = np.delete(points, k, axis=1)
        for at in np.unique(others[:1] if study.is_star else others, axis=0):
            rows = np.flatnonzero((others == at).all(axis=1))
            rows = rows[np.argsort(points[rows, k])]
            yield (np.log if axis.log else np.array)(points[rows, k]), rows


def test_nearly_every_stored_point_lies_within_the_bar_that_the_others_give(explored):
    """Each inner point of lines of four or more is left out in turn, which doubles an interval."""
    held = tried = 0
    for study in explored.studies:
        for x, rows in (line for line in lines_of(study) if len(line[0]) > 3):
            for f in study.formulas:
                error, U = (np.array(v)[rows] for v in (f.error, f.U))
                if not np.isfinite(error).all() or np.abs(error).max() < 1e-4:
                    continue
                for j in range(1, len(x) - 1):
                    less, e = np.delete(x, j), np.delete(error, j)
                    bar = bent(less, e, x[j]) + U[j] + max(U[j - 1], U[j + 1])
                    held += abs(np.interp(x[j], less, e) - error[j]) <= bar
                    tried += 1
    assert tried > 200
    assert held >= 0.98 * tried


BEAM = "stiffness by Eqs. 1-9 against curved beam elements"
STAR, ANGLE = "freewheel-torque", "clamping angle under torque"


GRID = (  # case, row, what is typed, and the point of the study
    (RING, K, (("value", "z", 7), ("value", "delta_1", 4.5)), (7, 4.5)),
    (RING, K, (("value", "z", 12), ("value", "delta_1", 8)), (12, 8)),
    (RING, K, (("slide", "z", 9), ("slide", "delta_1", 250)), (9, 5)),
    ("spring-accordion", BEAM, (("value", "n", 9), ("value", "b", 0.15)), (9, 0.15)),
    ("spring-accordion", BEAM, (("value", "n", 16), ("value", "b", 0.37)), (16, 0.37)),
    # a study at other values of R_a and z than those of the case
    (STAR, ANGLE, (("value", "R_a", 19), ("value", "z", 6), ("value", "T", 52),
                   ("value", "X", 11.44)), (52, 11.44)),
)  # fmt: skip
LINE = (
    (RING, K, (("value", "rho", 1.5),), ("rho", 1.5)),
    ("freewheel-torque", "normal force", (("value", "T", 20),), ("T", 20)),
    ("ring-lame", "bore displacement, plane stress", (("value", "nu", 0.2),), ("nu", 0.2)),
    ("contact-roller-flat", "", (("value", "F", 2000),), ("F", 2000)),
    # the line at the inputs of the case, not the finer grid at another e
    (RING, K, (("ratio", "delta_1", 0.0333),), ("delta_1", 0.0333 * 80)),
    (RING, K, (("value", "d_e", 100), ("value", "delta_1", 5.5), ("value", "rho", 2.5)),
     ("delta_1", 4.4)),
)  # fmt: skip
NONE = (
    (RING, K, (("value", "z", 13),), "outside the stored range of 3 to 12"),
    (RING, K, (("value", "z", 6.5),), "a whole number"),
    (RING, K, (("value", "rho", 1.5), ("value", "z", 8)), "not compared"),
    (STAR, ANGLE, (("value", "T", 52), ("value", "X", 11.44)), "not compared"),
    (STAR, ANGLE, (("value", "R_a", 19), ("value", "T", 52), ("value", "z", 7)), "not compared"),
    ("spring-accordion", BEAM, (("value", "r", 0.8), ("value", "alpha", 70)), "one at a time"),
    ("spring-accordion", BEAM, (("value", "n", 6), ("value", "b", 0.2)), "does not converge"),
    ("spring-accordion", BEAM, (("value", "n", 7), ("value", "b", 0.19)), "does not converge"),
)


def named(report, case, quantity):
    """A row of a study whose name begins so."""
    return next(
        f.quantity for s in report.studies if s.case == case for f in s.formulas
        if f.quantity.startswith(quantity)
    )  # fmt: skip


@pytest.fixture(scope="module")
def answers(folder, explored):
    """What the page answers to each question, by its fields and by the address they gave."""
    if not CHROMIUM:
        pytest.skip("no chromium fills in the form")
    asked = [
        {"case": case, "formula": named(explored, case, q), "typed": typed}
        for case, q, typed, _ in (*GRID, *LINE, *NONE)
    ]
    place, given = folder / FOLDER, json.dumps(asked)
    seen = looked_at(place, "explorer", 1320, host="explorer_host.html", status=given)
    assert seen["console"] == []
    assert seen["options"] == len(of_cases(explored))
    assert [one["error"] for one in seen["sent"]] == [one["error"] for one in seen["direct"]]
    return seen["direct"]


def test_answers_are_those_of_an_interpolation_in_python(answers, explored):
    given = [(on_grid, *one[:2], (one[-1],)) for one in GRID]
    given += [(on_line, *one[:2], one[-1]) for one in LINE]
    for (interpolated, case, q, at), found in zip(given, answers, strict=False):
        wanted = interpolated(explored, case, named(explored, case, q), *at)
        stated = found["error"], found["bar"]
        assert stated == pytest.approx(wanted, rel=1e-6, abs=2 * STEP), found


def test_an_answer_states_class_side_bar_factor_and_verdict_and_draws_numbers(answers):
    for words in (
        "Beyond 10 %, on the unsafe side", "error −11.9 % ± 0.5 % (between stored points, with",
        "the formula is too low, the unsafe side", "formula × 1.136 (1.129 to 1.142)",
        "Belcin, Eq. 11 from all its comparisons: unsafe. Use instead: the series",
        "(δ1/de = 0.05625)",
        "(stored for e = 2 mm, distance of the hub contact from the middle of a flat)",
    ):  # fmt: skip
        assert words in answers[0]["text"]
    stored = answers[1]["text"]
    assert "error −9.07 % ± < 0.01 % (stored point)" in stored
    assert "formula × 1.100." in stored
    assert "Within 1 %" in answers[len(GRID) + 2]["text"]
    assert "the error bar includes both signs" in answers[len(GRID) + 2]["text"]
    assert all(one["curves"] >= 1 and one["out"] == 0 for one in answers)


def test_there_is_no_answer_where_nothing_is_stored(answers):
    for (*_, words), found in zip(NONE, answers[len(GRID) + len(LINE) :], strict=True):
        assert found["error"] is found["bar"] is None
        assert words in found["text"]
        assert "No data" in found["text"]
