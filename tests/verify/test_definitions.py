"""A planted reading is found and named; accidental agreement is counted."""

import json
import math
from itertools import combinations

import numpy as np
import pytest

from verify.app.cli import run
from verify.cases.registry import CASES
from verify.papers.digits import half_last_digit
from verify.papers.ledger import erratum, published
from verify.studies.readings import registry
from verify.studies.readings.misprints import is_misprint, misprints
from verify.studies.readings.readings import angle, count, elastic, length, result
from verify.studies.readings.search import DIGIT, SPANS, Reading, search

INPUTS = {"F": 18.0, "r": 4.02, "b": 3.05, "a": 0.2, "n": 12, "E": 206.0, "nu": 0.3}
READINGS = (*length("r"), *length("b"), *angle("a"), *count("n"), *elastic("E", "nu"), *result())


def formula(q):
    """Something with a radius, a width, an angle, a count and an elasticity."""
    return q["F"] * q["r"] ** 2 / (q["b"] * q["n"]) * math.sin(q["a"]) / q["E"]


EXACT = formula(INPUTS | {"r": 8.04})  # with a diameter for the radius


def planted(**changed):
    """What the formula gives with other inputs, to five digits."""
    return f"{formula({**INPUTS, **changed}):.5f}"


def test_a_planted_reading_is_found_and_named():
    for changed, *names in (
        ({"r": 8.04}, "2 r instead of r"),
        ({"a": math.atan(math.sin(0.2))}, "sin a instead of tan a"),
        ({"r": 8.04, "n": 11}, "2 r instead of r", "n − 1 instead of n"),
    ):
        most = len(changed)
        found = search(formula, INPUTS, planted(**changed), READINGS, most=most, digits=False)
        assert not found.met
        assert tuple(names) in [hit.readings for hit in found.hits]
        assert found.best.value == pytest.approx(formula({**INPUTS, **changed}))
        assert found.is_evidence or most > 1


def test_the_window_is_half_a_last_digit_and_what_rounded_inputs_move_the_result():
    beyond = f"{EXACT + 2e-5:.5f}"
    assert not search(formula, INPUTS, beyond, READINGS, most=1).hits
    printed = f"{EXACT * 1.002:.5f}"
    assert not search(formula, INPUTS, printed, READINGS, most=1).hits
    # 4.02 ± 0.005, squared: 0.25 %
    found = search(formula, INPUTS, printed, READINGS, most=1, rounding={"r": 0.005})
    assert found.best.readings == ("2 r instead of r",)
    assert found.best.off == pytest.approx(2 * 0.005 / 4.02 * EXACT, rel=2e-3)


def test_a_number_is_met_unchanged_or_by_no_reading():
    assert search(formula, INPUTS, planted(), READINGS).met
    found = search(formula, INPUTS, f"{formula(INPUTS) * 1.2345:.6f}", READINGS, digits=False)
    assert (found.hits, found.best, found.is_evidence) == ((), None, False)
    pairs = sum(a.of != b.of for a, b in combinations(READINGS, 2))
    assert found.tried == 1 + len(READINGS) + pairs
    # readings without a value are counted and no hit
    broken = Reading(name="root of less than zero", of="x", inputs=lambda _q: {"a": math.nan})
    raising = Reading(name="no root", of="y", result=lambda v, _q: math.sqrt(-v))
    found = search(formula, INPUTS, planted(r=8.04), (broken, raising, *length("r")), most=1)
    assert (found.without_value, found.tried) == (2, 5)
    assert found.best.readings == ("2 r instead of r",)
    for printed in ("0", "abc"):
        with pytest.raises(ValueError, match="number"):
            search(formula, INPUTS, printed, READINGS)


def test_a_misprinted_digit_is_one_change_of_what_stands():
    text = planted()
    wrong = text[:-2] + str((int(text[-2]) + 3) % 10) + text[-1]
    found = search(formula, INPUTS, wrong, READINGS)
    assert (found.best.readings, found.best.changes) == ((DIGIT,), 1)
    assert is_misprint(float(text), wrong)
    assert sum(math.isclose(x, float(wrong)) for x in misprints(float(text), wrong)) == 1
    # of fewer than three digits any number is a misprint of any other
    assert not search(lambda _q: 7.9, {}, "6", (), most=1).hits


def test_accidental_hits_are_as_many_as_counted():
    """Numbers that have nothing to do with the formula, spread about the printed one.

    Most of them are near where many readings give nearly what the first one does.
    """
    printed, factor = "0.00773", 1.15
    found = search(formula, INPUTS, printed, READINGS, digits=False, rounding={"r": 0.005})
    distinct = []
    for t in sorted(found.found, key=lambda t: (t.changes, -t.off)):
        if all(not math.isclose(t.value, x.value, rel_tol=1e-9) for x in distinct):
            distinct.append(t)
    tried = [t for t in distinct if t.readings]
    value, off = (np.array([getattr(t, name) for t in tried]) for name in ("value", "off"))
    half = half_last_digit(printed)

    def hits(span):
        drawn = float(printed) * span ** np.random.default_rng(1).uniform(-1, 1, 100_000)
        return sum(
            float(np.mean(np.abs(drawn - v) <= half + o)) for v, o in zip(value, off, strict=True)
        )

    assert found.chance[2] == pytest.approx(hits(factor), rel=0.03)
    assert hits(factor) == max(map(hits, SPANS))
    assert found.chance[2] > 0.05  # so that a hit of two readings says nothing here
    assert found.chance[1] < found.chance[2]


PROBLEMS = {problem.reference: problem for problem in registry.PROBLEMS}


def test_errata_of_the_ledger_are_found_again():
    """With three changes so many other combinations are near that the hit is no evidence."""
    for reference, *names in (
        (
            "wang2023:k1-theory",
            "L_1 instead of 2 L_1 in L_2",
            "b instead of h in L_2",
            "alternating sign of the term F x in M_2",
        ),
        ("huang2018:table-2-relative-error", "relative to the predicted value"),
    ):
        found = PROBLEMS[reference].search()
        assert [hit.readings for hit in found.hits] == [tuple(names)]
        assert found.is_evidence == (len(names) == 1)


def test_every_search_names_entries_that_exist():
    for problem in registry.PROBLEMS:
        key = problem.reference.partition(":")[0]
        assert CASES.named(problem.case)
        assert all(erratum(f"{key}:{name}") for name in problem.errata)
        assert problem.search(1).as_it_stands is not None
    assert not set(PROBLEMS) & set(registry.WITHOUT_FORMULA)
    assert all(published(reference) for reference in registry.WITHOUT_FORMULA)


def test_the_command_finds_a_diameter_put_in_for_a_radius(tmp_path, capsys):
    lame = CASES[0]
    q = lame.inputs()
    wrong = lame.analytic(q.model_copy(update={"r_o": 2 * q.r_o}))["hoop_bore"] / 1e6
    command = ["search", "ring-lame", "--key", "hoop_bore", "--printed", f"{wrong:.2f}"]
    command += ["--changes", "1"]
    assert run([*command, "--json"]) == 0
    hits = [hit["readings"] for hit in json.loads(capsys.readouterr().out)["hits"]]
    # a stress knows their ratio
    assert sorted(hits) == [["2 r_o instead of r_o"], ["r_i/2 instead of r_i"]]
    assert run(["init", "ring-lame", "--out", str(tmp_path / "my.toml")]) == 0
    assert run([*command, "--file", str(tmp_path / "my.toml")]) == 0
    assert "2 r_o instead of r_o" in capsys.readouterr().out
    # without a reading that gives the number the status is one
    assert run(["search", "wang2023:k1-fea"]) == 1
    assert "no reading reproduces the number" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "line"),
    [
        (["foo:bar"], "no printed number"),
        (["ring-lame"], "give --key"),
        (
            ["ring-lame", "--key", "hoop_bore", "--printed", "1", "--unit", "mm"],
            "must have the dimension of MPa",
        ),
        (["ring-lame/no row"], "has no row"),
        (["wang2023:k1-theory", "--changes", "9"], "--changes must be 1 to 3"),
    ],
)
def test_wrong_words_are_one_line_and_two(words, line, capsys):
    assert run(["search", *words]) == 2
    out, err = capsys.readouterr()
    assert line in err
    assert (out, err.count("\n")) == ("", 1)
