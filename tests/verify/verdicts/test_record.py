"""Verdicts of record: stored, compared, placed against the inputs of a user, and printed."""

import json
import math
import re
from dataclasses import replace

import pytest

from verify.app.cli import run
from verify.cases.registry import find
from verify.core.verdicts import Form, FormulaVerdict, Safe, Side, Verdict, VerdictRange
from verify.studies.validity.store import measured
from verify.verdicts import record
from verify.verdicts.declared import declared
from verify.verdicts.place import Where, place
from verify.verdicts.regions import ranges


def test_the_record_has_a_verdict_of_each_declared_formula_with_its_evidence(tmp_path):
    forms = {f"{key}/{f.name}, {f.form}": f for key, d in declared().items() for f in d.formulas}
    assert [one.id for one in record.kept()] == list(forms)
    for one in record.kept():
        f = forms[one.id]
        assert one.verdict is not Verdict.NONE
        assert (one.rows, one.model_rows, one.errata) == (f.part, f.model, f.errata)
        assert one.safe == f.safe
    file = tmp_path / "verdicts.json"  # a stored file is read again
    record.keep(record.kept(), file)
    assert file.read_text("utf-8") == record.FILE.read_text("utf-8")


def test_a_verdict_that_is_not_the_one_of_record_is_named():
    kept = record.kept()

    def changed(which, **changes):
        return record.moved(tuple(replace(o, **changes) if o is which else o for o in kept))

    assert record.moved(kept) == []
    one = next(one for one in kept if one.verdict is Verdict.PART)
    assert changed(one, verdict=Verdict.ACCURATE, words="accurate") == [
        f"verdict of {one.id}: accurate; {one.words} on record"
    ]
    one = next(one for one in kept if one.ranges)
    assert changed(one, ranges=(replace(one.ranges[0], words="all"),)) == [
        f"verdict of {one.id}: its ranges are not those of record"
    ]
    one = next(one for one in kept if one.safe is Safe.BELOW and one.error)
    assert changed(one, safe=Safe.ABOVE) == [
        f"verdict of {one.id}: its safe side is not that of record"
    ]
    for change, lines in ((1.005, 0), (1.02, 1)):
        assert len(changed(one, error=change * one.error)) == lines
    one = next(one for one in kept if one.design)
    spanned = replace(one.design[0], spanned=not one.design[0].spanned)
    assert changed(one, design=(spanned, *one.design[1:])) == [
        f"verdict of {one.id}: its ranges are not those of record"
    ]
    assert record.moved(kept[1:]) == [f"verdict of {kept[0].id}: on record only"]


def test_ranges_of_record_are_those_of_the_stored_studies():
    """A widened range of record, or a changed error of a stored study, fails without a run."""
    stored = {
        case.id: measured(case)
        for case in map(find, {r.case for o in record.kept() for r in o.ranges})
    }
    for one in record.kept():
        rows = one.rows if one.is_of_part else one.model_rows
        studies = [
            (plan, course)
            for case, found in stored.items() for plan, courses in found.scans
            for course in courses if f"{case}/{course.pair.name}" in rows
        ]  # fmt: skip
        now = {(r.case, r.over, r.limit): (r.box, r.inside) for r in ranges(studies)}
        kept = {(r.case, r.over, r.limit): (r.box, r.inside) for r in one.ranges}
        assert kept.items() <= now.items(), one.id


def test_a_user_s_inputs_lie_inside_outside_or_were_not_compared():
    box = (Side(name="r_i", symbol="r_i", unit="mm", low=5.0, high=24.0),
           Side(name="nu", symbol="ν", unit="1", low=0.1, high=0.4))  # fmt: skip
    wide = tuple(replace(side, low=side.low / 2, high=side.high * 1.1) for side in box)
    for star, changes, where in (
        (True, {}, Where.INSIDE),
        (True, {"r_i": 6e-3}, Where.INSIDE),
        (True, {"r_i": 4e-3}, Where.OUTSIDE),
        (True, {"r_i": 6e-3, "nu": 0.2}, Where.NOT_COMPARED),
        (False, {"r_i": 6e-3, "nu": 0.2}, Where.INSIDE),
        (False, {"r_i": 6e-3, "nu": 0.43}, Where.OUTSIDE),
        (False, {"r_i": 6e-3, "nu": 0.45}, Where.NOT_COMPARED),
        (False, {"E": 1e11}, Where.NOT_COMPARED),
    ):
        sides = VerdictRange(case="ring-lame", limit=0.05, words="", over="", box=box,
                             studied=wide, is_star=star, inside=4, points=5)  # fmt: skip
        one = FormulaVerdict(
            id="x", paper="huang2018", source="", name="Eq. 6", form=Form.PRINTED, what="",
            words="", verdict=Verdict.PART, safe=Safe.ABOVE, ranges=(sides,), rows=("ring-lame/x",),
        )  # fmt: skip
        found = place(one, "ring-lame", find("ring-lame").inputs(**changes))
        assert found.where is where, (star, changes)


def test_a_study_with_constant_inputs_is_about_parts_with_these_values():
    nu = Side(name="nu", symbol="ν", unit="1", low=0.1, high=0.4)
    held = Side(name="r_i", symbol="r_i", unit="mm", low=6.0, high=6.0)
    study = VerdictRange(case="ring-lame", limit=0.05, words="", over="", box=(nu,), studied=(nu,),
                         held=(held,), inside=4, points=5)  # fmt: skip
    one = FormulaVerdict(
        id="x", paper="huang2018", source="", name="Eq. 6", form=Form.PRINTED, what="",
        words="", verdict=Verdict.PART, safe=Safe.ABOVE, ranges=(study,), rows=("ring-lame/x",),
    )  # fmt: skip
    for changes, where in (
        ({"r_i": 6e-3}, Where.INSIDE),
        ({"r_i": 6e-3, "nu": 0.2}, Where.INSIDE),
        ({"nu": 0.2}, Where.NOT_COMPARED),
        ({"r_i": 7e-3}, Where.NOT_COMPARED),
        ({"r_i": 7e-3, "nu": 0.2}, Where.NOT_COMPARED),
        ({"r_i": 6e-3, "nu": 0.45}, Where.NOT_COMPARED),
    ):
        found = place(one, "ring-lame", find("ring-lame").inputs(**changes))
        assert found.where is where, changes


def test_a_study_that_varies_an_input_away_from_its_default_does_not_hold_at_the_default():
    """Torque of the sprag clutch: 25 N m by default; at ν_0 = 2.5° and z = 8 only to 22 N m."""
    one = next(o for o in record.kept() if o.id == "huang2018/Eq. 9, corrected")
    sprag = find("sprag-wedge").inputs
    for T, where in ((12.5, Where.INSIDE), (18.0, Where.INSIDE), (25.0, Where.NOT_COMPARED)):
        found = place(one, "sprag-wedge", sprag(T=T, z=8, nu_0=math.radians(2.5)))
        assert found.where is where, T
    assert found.words == "beyond what was compared: T 12.5 to 22 N m at ν_0 = 2.5 deg, n_s = 8"


def test_the_centre_of_a_star_with_constant_inputs_can_be_beyond_a_limit():
    """At the default of the varied input, outside the range within the limit."""
    held = Side(name="nu", symbol="ν", unit="1", low=0.2, high=0.2)
    box = Side(name="r_i", symbol="r_i", unit="mm", low=1.0, high=2.0)
    star = VerdictRange(
        case="ring-lame", limit=0.05, words="", over="", box=(box,), is_star=True,
        studied=(replace(box, high=24.0),), held=(held,), inside=2, points=5,
    )  # fmt: skip
    one = replace(record.kept()[0], verdict=Verdict.PART, rows=("ring-lame/x",), ranges=(star,))
    for changes, where in (({}, Where.OUTSIDE), ({"r_i": 1.5e-3}, Where.INSIDE)):
        found = place(one, "ring-lame", find("ring-lame").inputs(nu=0.2, **changes))
        assert found.where is where, changes


# Beginnings of what a formula gives, with the side on which an error leaves a margin. They are
# written here again, because the declarations and the record could be changed together.
ABOVE = (
    "friction", "clamping angle", "contact angles", "contact pressure", "share of each slice",
    "normal force of a sprag", "normal force per torque", "largest normal force", "torsion angle",
    "hoop stress", "mean hoop stress", "pressure for that", "the same pressure", "correction for",
    "blocking pressure needed", "centrifugal growth",
)  # fmt: skip
BELOW = (
    "torque", "largest load", "force of the guided spring", "growth of the ring",
    "force of the pressure", "normal force on a roller", "blocking pressure left",
)  # fmt: skip


def test_safe_sides_are_those_of_the_purpose_of_a_value():
    for one in record.kept():
        if one.safe is not Safe.NEITHER:
            begins = ABOVE if one.safe is Safe.ABOVE else BELOW
            assert one.what.startswith(begins), (one.id, one.what, one.safe)


def test_an_equation_is_explained_in_both_forms_and_as_json(capsys):
    for words in (["Belcin", "Eq.", "20"], ["belcin", "20"], ["Belcin Eq. 20"]):
        assert run(["explain", *words]) == 0
        out = capsys.readouterr().out
        assert "Belcin, Eq. 20, printed" in out
        assert re.search(r"^  verdict +unsafe$", out, re.MULTILINE)
        assert "polyhedral-clutch/torque, Eq. 20" in out
    assert run(["explain", "--json", "huang2018", "Eq. 8"]) == 0
    (one,) = json.loads(capsys.readouterr().out)
    assert (one["verdict"], one["form"]) == ("exact", "printed")


@pytest.mark.slow("ranges of ten assumed inputs are gone through")
def test_check_prints_the_verdicts_of_its_formulas(tmp_path, capsys):
    assert run(["init", "polyhedral-clutch"]) == 0
    file = tmp_path / "mine.toml"
    file.write_text(capsys.readouterr().out, "utf-8")
    run(["check", str(file)])
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    (of_20,) = (line for line in lines if line[:4] == ["Belcin,", "Eq.", "20", "corrected"])
    assert of_20[4:9] == ["unsafe", "up", "to", "439", "%"]
