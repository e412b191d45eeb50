"""Verdicts of record: stored, compared and printed."""

import json
import re
from dataclasses import replace

import pytest

from verify.app.cli import run
from verify.cases.registry import find
from verify.core.verdicts import Safe, Verdict
from verify.studies.validity.store import measured
from verify.verdicts import record
from verify.verdicts.declared import declared
from verify.verdicts.place import WITHOUT_RANGE
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
        f"verdict of {one.id}: accurate; {one.words} in the record"
    ]
    one = next(one for one in kept if one.ranges)
    assert changed(one, ranges=(replace(one.ranges[0], words="all"),)) == [
        f"verdict of {one.id}: the ranges differ from the record"
    ]
    one = next(one for one in kept if one.safe is Safe.BELOW and one.error)
    assert changed(one, safe=Safe.ABOVE) == [
        f"verdict of {one.id}: the safe side differs from the record"
    ]
    for name in ("error", "above", "below"):
        one = next(one for one in kept if getattr(one, name))
        for change, lines in ((1.005, 0), (1.02, 1)):
            assert len(changed(one, **{name: change * getattr(one, name)})) == lines
        assert changed(one, **{name: None}) == [
            f"verdict of {one.id}: the errors differ from the record"
        ]
    one = next(one for one in kept if one.within)
    assert changed(one, within=0.5) == [
        f"verdict of {one.id}: {one.words}; {one.words} in the record"
    ]
    one = next(one for one in kept if one.design)
    spanned = replace(one.design[0], spanned=not one.design[0].spanned)
    assert changed(one, design=(spanned, *one.design[1:])) == [
        f"verdict of {one.id}: the ranges differ from the record"
    ]
    one = replace(one, id="new")
    assert record.moved((*kept, one)) == [f"verdict of new: {one.words}; not in the record"]
    assert record.moved(kept[1:]) == [f"verdict of {kept[0].id}: only in the record"]


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
        assert set(one.ranges) == set(ranges(studies)), one.id


# Beginnings of what a formula gives, with the side on which an error leaves a margin. They are
# written here again, because the declarations and the record could be changed together.
ABOVE = (
    "friction", "clamping angle", "contact angles", "contact pressure", "contribution of each",
    "normal force of a sprag", "normal force per torque", "largest normal force", "wind-up (angle",
    "hoop stress", "mean hoop stress", "pressure that causes", "pressure that closes",
    "correction factor", "blocking pressure required", "centrifugal growth",
)  # fmt: skip
BELOW = (
    "torque", "largest load", "force of the guided spring", "growth of the ring",
    "force of the pressure", "normal force on a roller", "blocking pressure: total",
)  # fmt: skip


# too small an angle requires too little friction; too large a one gives too much torque of a cup
NEITHER = ("nagler2021/Eq. 5, corrected",)


def test_safe_sides_are_those_of_the_purpose_of_a_value():
    for one in record.kept():
        begins = one.what.startswith
        side = Safe.ABOVE if begins(ABOVE) else Safe.BELOW if begins(BELOW) else Safe.NEITHER
        side = Safe.NEITHER if one.id in NEITHER else side
        if one.safe is not Safe.NEITHER or one.verdict not in WITHOUT_RANGE:
            assert one.safe is side, (one.id, one.what)


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
    assert of_20[4:11] == ["unsafe", "the", "values", "are", "up", "to", "439"]
