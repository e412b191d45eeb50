"""Emulated machines and perturbed inputs: their differences, and a sample of rows."""

import json
import math
import os
from dataclasses import replace

import pytest
from pydantic import ValidationError, model_validator

from verify.app.cli import run
from verify.audit.portable import command, reasons, runner
from verify.audit.portable import variants as emulating
from verify.audit.portable.compare import Kind, differences
from verify.audit.portable.moving import Record, move, record
from verify.audit.portable.perturbation import SIZE, Outcome, perturb_defaults, perturbed
from verify.audit.portable.store import CaseRecord, Place
from verify.audit.portable.variants import BASELINE, CORE_TYPE, Variant
from verify.cases.registry import CASES, find
from verify.core.inputs import EntryError, InputError, Inputs, count, quantity, table, word
from verify.core.results import Kind as RowKind
from verify.core.results import Partner, Row, Status
from verify.core.store import Store
from verify.jobs.level import Job

FOUND = ["X86_V3", "X86_V4"]


# cheap cases with eigenvalues, series, contact and plane elements, of which none moves by chance
SAMPLE = ("rotor-clutch", "rotor-shaft", "ring-rotation", "polyhedral-pressure", "spring-stages",
          "ring-lame", "contact-pair")  # fmt: skip


# Perturbed inputs


class Part(Inputs):
    length: float = quantity("1 mm", "mm", "l", "length")
    ratio: float = quantity(1.0, "1", "", "ratio")


class Sample(Inputs):
    """A number, a bound equal to its default, a word and a table."""

    E: float = quantity("210 GPa", "GPa", "E", "modulus", le=1e6)
    z: int = count(12, "z", "number")
    R_p: float | None = quantity(None, "MPa", "R_p", "strength", omitted=None, example="1 MPa")
    head: str = word("free", "head")
    parts: tuple[Part, ...] = table((Part(), Part(length=0.002)), "parts")


class Fixed(Sample):
    @model_validator(mode="after")
    def _first(self):
        if self.parts[0].ratio != 1.0:
            raise EntryError("parts", 1, "ratio = 1", "the first part has the ratio 1")
        return self


def test_each_number_moves_by_some_1e_13_and_nothing_else_does():
    found = perturbed(Sample(), seed=1)
    numbers = [found["E"] / 210e9]
    numbers += [x for i, part in enumerate(found["parts"])
                for x in (part["length"] / (0.001, 0.002)[i], part["ratio"])]  # fmt: skip
    assert all(0 < abs(number - 1) < 5 * SIZE for number in numbers)
    assert len({round((number - 1) / SIZE, 3) for number in numbers}) == 5
    assert (found["z"], found["R_p"], found["head"]) == (12, None, "free")
    assert perturbed(Sample(), seed=1) == found != perturbed(Sample(), seed=2)


def test_perturbed_defaults_are_the_paper_s_inputs_and_still_obey_their_rules():
    model = type("Copy", (Sample,), {})
    before = model()
    assert perturb_defaults([model], seed=1) == {model: Outcome()}
    assert before != model() == model.model_validate(perturbed(before, seed=1))
    assert Job(find("ring-lame"), model()).is_paper
    with pytest.raises(ValidationError):
        model(E=1e99)
    # a number that a rule fixes stays and is named
    assert perturb_defaults([Fixed], seed=1) == {Fixed: Outcome(fixed=("parts[1].ratio",))}
    assert [part.ratio == 1.0 for part in Fixed().parts] == [True, False]
    for case in CASES:
        fixed = ("shafts[1].ratio",) if case.id == "rotor-system" else ()
        found = case.inputs.model_validate(perturbed(case.inputs(), 1, fixed))
        assert found != case.inputs(), case.id


def test_machines_that_are_no_others_or_that_the_processor_is_not_are_not_emulated():
    def probe(environment):
        """OpenBLAS has kernels of Haswell for everything newer than Nehalem."""
        core = environment.get(CORE_TYPE, "Haswell")
        return {
            "blas": core if core in ("Prescott", "Nehalem") else "Haswell",
            "threads": environment["OMP_NUM_THREADS"],
            "numpy": [] if "NPY_DISABLE_CPU_FEATURES" in environment else FOUND,
            "numba": environment.get("NUMBA_CPU_NAME", "host"),
        }

    flags = frozenset({"pni", "sse4_2", "avx", "avx2"})
    found = emulating.machines(emulating.candidates(FOUND, seeds=2), probe, flags, {})
    assert [one.name for one in found.variants] == [
        "baseline", "threads-2", "core-prescott", "core-nehalem", "numpy-baseline",
        "numba-generic", "perturbed-1", "perturbed-2",
    ]  # fmt: skip
    same = "the same settings are in effect as in baseline"
    assert found.not_emulated == {
        "core-sandybridge": same, "core-haswell": same, "core-zen": same,
        "core-skylakex": "the processor lacks avx512vl",
    }  # fmt: skip


# Differences of a row

VALUES = {"formula": 2.0, "reference": 2.001}
MOVED = {"difference": -0.003, "values": {**VALUES, "reference": 2.003}}
ROW = Record(
    id="ring/bore", kind="identity", status="PASS", values=VALUES, difference=-0.001,
    tolerance=0.01, scale=2.0,
)  # fmt: skip
OTHERS = tuple(replace(ROW, id=f"ring/{name}") for name in ("rim", "hoop"))
ROWS = (ROW, *OTHERS)
# an order of 2 against 0.5, of which 1e-9 is uncertain: the margin is 1.5
FACT = replace(ROW, kind="fact", values={"reference": 2.0}, difference=1.5, tolerance=1e-9)
NAN = math.nan


def test_the_size_of_a_move():
    free = replace(ROW, tolerance=None, scale=None, difference=None, values={"formula": 50.0})
    for was, now, size in (
        (ROW, MOVED, 0.2),  # its reference moves by shares of the tolerance
        # both sides move equally, on the same inputs
        (ROW, {"values": {"formula": 2.002, "reference": 2.003}}, 0.2),
        # without a finite tolerance: shares of 1e-5 of the scale
        (replace(ROW, tolerance=NAN), {"values": {**VALUES, "reference": 7.0}}, 249950),
        (replace(ROW, values={}), {"difference": 0.001}, 0.2),
        (FACT, {"values": {"reference": 1.85}, "difference": 1.35}, 0.1),
        (replace(ROW, values={"formula": NAN}), {"values": {"formula": 2.0}}, math.inf),
        (replace(ROW, difference=NAN, values={"formula": NAN}), {}, 0.0),
        (replace(ROW, difference=None), {"difference": 0.001}, math.inf),
        # without a scale: shares of 1e-5 of the largest number
        (free, {"values": {"formula": 50.0005}}, 1.0),
        (replace(free, scale=0.0), {"values": {"formula": 50.0005}}, 1.0),
        (replace(free, scale=-1.0), {"values": {"formula": 50.0005}}, 1.0),
        (replace(free, scale=math.inf), {"values": {"formula": 50.0005}}, 1.0),
        (replace(free, difference=math.inf), {"values": {"formula": 50.0005}}, 1.0),
        (replace(free, values={"formula": -50.0}), {"values": {"formula": -50.0005}}, 1.0),
        (replace(free, values={"formula": 0.5}), {"values": {"formula": 0.500005}}, 1.0),
        (replace(free, values={"formula": 0.5}, difference=5.0), {"difference": 5.00005}, 1.0),
        (replace(free, values={"formula": 0.0}), {"values": {"formula": 1e-9}}, math.inf),
    ):
        found = move(was, replace(was, **now), perturbed=False)
        assert found == pytest.approx(size, rel=1e-4)


def test_the_record_of_a_row_has_the_value_of_its_partner():
    row = Row(
        case="ring", quantity="bore", symbol="u", unit="mm", kind=RowKind.IDENTITY,
        status=Status.PASS, analytic=2.0, difference=0.001,
    )  # fmt: skip
    assert record(row).values == {"formula": 2.0, "reference": None}
    beside = replace(row, partner=Partner(by="series", value=2.001))
    assert record(beside).values == {"formula": 2.0, "reference": None, "partner": 2.001}


def test_what_a_value_may_move_by():
    # perturbed: 1e-5 of the scale of 2 where the tolerance is less, the tolerance where it is more
    sharp = replace(ROW, tolerance=1e-6)
    both = {"values": {"formula": 2.00001, "reference": 2.00101}}
    assert move(sharp, replace(sharp, **both), perturbed=True) == pytest.approx(0.5)
    assert move(ROW, replace(ROW, **both), perturbed=True) == pytest.approx(1e-3)
    # a fact: its margin without the uncertainty, on either side; nothing where it is undecided
    for margin, U, size in ((1.5, 0.5, 0.1), (-1.5, 0.5, 0.1), (0.3, 0.5, math.inf)):
        was = replace(FACT, values={}, difference=margin, tolerance=U)
        now = replace(was, difference=margin + 0.1)
        assert move(was, now, perturbed=False) == pytest.approx(size)


def compared(before=ROW, *, perturbed=False, **change):
    now = replace(before, **change)
    return differences((before, *OTHERS), (now, *OTHERS), "there", perturbed=perturbed)


def test_a_status_a_value_or_a_tolerance_that_differs_is_reported():
    for change, kind, was, now in (
        ({"status": "FAIL", "reason": "sharp"}, Kind.STATUS, "PASS", "FAIL (sharp)"),
        # by more than a tenth of the tolerance
        ({"difference": -0.0021, "values": {**VALUES, "reference": 2.0021}}, Kind.VALUE, "", ""),
        ({"difference": -0.0019, "values": {**VALUES, "reference": 2.0019}}, None, "", ""),
        # a tolerance is estimated and may differ by a factor of two
        ({"tolerance": 0.02}, None, "", ""),
        ({"tolerance": 0.0201}, Kind.VALUE, "tolerance 0.01", "tolerance 0.0201"),
        ({"tolerance": None}, Kind.VALUE, "tolerance 0.01", "tolerance none"),
    ):
        found = compared(**change)
        assert [(one.row, one.kind) for one in found] == ([(ROW.id, kind)] if kind else [])
        assert all(one.was.endswith(was) and one.now.endswith(now) for one in found)


def test_other_rows_are_reported():
    for there, kind in (
        (ROWS[1:], Kind.MISSING), ((*ROWS, replace(ROW, id="new")), Kind.ADDED),
        ((ROWS[1], ROWS[0], *ROWS[2:]), Kind.ORDER), ((ROW, *ROWS), Kind.DUPLICATE),
    ):  # fmt: skip
        assert kind in {one.kind for one in differences(ROWS, there, "x", perturbed=False)}


def test_of_a_fact_a_tenth_of_its_margin_counts_and_perturbed_sides_may_move_equally():
    assert [compared(FACT, tolerance=U) == [] for U in (0.14, 0.16)] == [True, False]
    assert compared(replace(FACT, tolerance=0.05), tolerance=0.15) == []
    alike = {name: value * (1 + 1e-7) for name, value in VALUES.items()}
    assert compared(values=alike, perturbed=True) == []
    assert [one.kind for one in compared(perturbed=True, **MOVED)] == [Kind.VALUE]


# What is printed and written


def summary_of(tmp_path, stated=(), **change):
    """The comparison of a baseline with a variant that has a changed row, both as stored."""
    variants = (Variant(BASELINE, "here"), Variant("there", "on another machine"))
    emulated = emulating.Machines(variants, {BASELINE: {}, "there": {}}, {})
    work = []
    for name, one in ((BASELINE, ROW), ("there", replace(ROW, **change))):
        place = Place(Store(tmp_path), name, "key")
        place.keep("ring", CaseRecord(rows=(one,), seconds=1.0))
        work.append(runner.Work(place=place, folder=tmp_path / name, environment={},
                                cases=("ring",)))  # fmt: skip
    return command.summarized(work, emulated, {}, stated, is_full=True)


def test_a_flip_or_move_is_printed_and_written_and_decides(tmp_path):
    assert summary_of(tmp_path).is_portable
    flipped = summary_of(tmp_path, status="FAIL", reason="not sharp")
    assert not flipped.is_portable
    assert "status: ring/bore: PASS here, FAIL in there" in "\n".join(command.lines(flipped))
    moved = summary_of(tmp_path, **MOVED)
    assert not moved.is_portable
    assert "value: ring/bore changes without a reason in there" in "\n".join(command.lines(moved))
    command.write(moved, tmp_path)
    data = json.loads((tmp_path / "portable.json").read_text("utf-8"))
    assert data["portable"] is False
    assert data["moves"][0]["move"] == pytest.approx(0.2)
    assert "| ring/bore | there | 0.2 |" in (tmp_path / "portable.md").read_text("utf-8")


def test_a_reason_makes_a_move_portable_and_one_that_explains_nothing_is_named(tmp_path):
    path = tmp_path / "reasons.toml"
    entry = '[[moves]]\nrows = "{}/*"\nwhy = "the residual is round-off, which differs"\n'
    path.write_text(entry.format("ring") + entry.format("roller"), "utf-8")
    stated = reasons.read(path)
    found = summary_of(tmp_path, stated, **MOVED)
    assert found.is_portable
    assert found.unused == ("roller/*",)
    assert not summary_of(tmp_path, stated, status="FAIL").is_portable
    path.write_text(entry.format("ring") + 'kind = "exact"\n', "utf-8")  # of other rows
    assert not summary_of(tmp_path, reasons.read(path), **MOVED).is_portable
    path.write_text("[[moves]]\nrows = 'a'\nwhy = 'short'\n", "utf-8")
    with pytest.raises(InputError, match=r"moves\[1\]\.why"):
        reasons.read(path)


def test_wrong_arguments_are_refused_in_one_line(capsys):
    for option, value, words in (
        ("--only", "core-z80", "unknown machine; known are baseline"),
        ("--seeds", "-1", "--seeds must be 0 to 1000, got -1"),
    ):
        assert run(["portable", option, value]) == 2
        assert words in capsys.readouterr().err


@pytest.mark.soak
def test_a_sample_of_rows_has_the_same_verdicts_on_other_machines(tmp_path, monkeypatch, capsys):
    """Perturbed inputs and two BLAS threads, with separate caches; run again, nothing is solved."""
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    arguments = ["portable", *SAMPLE, "--only", "perturbed-1", "--only", "threads-2", "--jobs", "2",
                 "--out", str(tmp_path)]  # fmt: skip
    status = run(arguments)
    text = capsys.readouterr().out
    data = json.loads((tmp_path / "portable.json").read_text("utf-8"))
    assert not [d["row"] for d in data["differences"] if d["kind"] != Kind.VALUE], text
    assert not data["failures"], text
    assert {m["cases"] for m in data["machines"]} == {len(SAMPLE)}
    own = Store(tmp_path / "cache-machines" / "perturbed-1").groups()
    assert ("level", "ring-lame") in {(group.kind, group.subject) for group in own}
    assert status == (0 if data["portable"] else 1)
    stored = Store(tmp_path / "cache").groups()
    assert run(arguments) == status
    assert Store(tmp_path / "cache").groups() == stored


def test_a_process_that_ends_badly_is_named_with_its_last_line(tmp_path):
    work = runner.Work(place=Place(Store(tmp_path), "v", "key"), folder=tmp_path,
                       environment={**os.environ}, cases=("nocase",))  # fmt: skip
    (how,) = runner.run_all([work], 1, lambda _state: None).values()
    assert how.startswith("exit status 1: ValueError: unknown case 'nocase'")
    assert str(tmp_path / runner.LOG) in how
