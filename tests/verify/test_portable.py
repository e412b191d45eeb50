"""Emulated machines and perturbed inputs, and a sample of rows on some of them."""

import json
import math
import os

import pytest
from pydantic import ValidationError, model_validator

from verify.app.cli import run
from verify.audit.portable import command, reasons, runner
from verify.audit.portable.compare import Kind
from verify.audit.portable.moving import Record
from verify.audit.portable.perturbation import SIZE, Outcome, perturb_defaults, perturbed
from verify.audit.portable.store import CaseRecord, Place
from verify.audit.portable.variants import (
    BASELINE,
    CORE_TYPE,
    Machines,
    Variant,
    candidates,
    machines,
)
from verify.cases.registry import CASES, find
from verify.core.inputs import EntryError, Inputs, count, quantity, table, word
from verify.core.store import Store
from verify.jobs.level import Job

FLAGS = frozenset({"pni", "sse4_2", "avx", "avx2"})
FOUND = ["X86_V3", "X86_V4"]
# cheap cases with eigenvalues, series, contact and plane elements, of which none moves by chance
SAMPLE = ("rotor-clutch", "rotor-shaft", "ring-rotation", "polyhedral-pressure", "spring-stages",
          "ring-lame", "contact-pair")  # fmt: skip


class Part(Inputs):
    length: float = quantity("1 mm", "mm", "l", "length")
    ratio: float = quantity(1.0, "1", "", "ratio")
    node: int = count(3, "", "node")


def sample(*, fixed=False, strict=False):
    """A new model with a number, a bound that its default meets, words and a table."""

    class Sample(Inputs):
        E: float = quantity("210 GPa", "GPa", "E", "modulus", le=210 if strict else 1e6)
        z: int = count(12, "z", "number")
        R_p: float | None = quantity(None, "MPa", "R_p", "strength", omitted=None, example="1 MPa")
        head: str = word("free", "head")
        parts: tuple[Part, ...] = table((Part(), Part(length=0.002)), "parts")

        @model_validator(mode="after")
        def _first(self):
            if fixed and self.parts[0].ratio != 1.0:
                raise EntryError("parts", 1, "ratio = 1", "the first part has the ratio 1")
            return self

    return Sample


def numbers(value):
    """All floats of nested inputs."""
    if isinstance(value, dict):
        value = tuple(value.values())
    if isinstance(value, tuple):
        return [x for one in value for x in numbers(one)]
    return [value] if isinstance(value, float) else []


def test_each_number_moves_by_some_1e_13_and_nothing_else_does():
    inputs = sample()()
    before, after = inputs.model_dump(), perturbed(inputs, seed=1)
    steps = [b / a - 1 for a, b in zip(numbers(before), numbers(after), strict=True)]
    assert all(0 < abs(step) < 5 * SIZE for step in steps)
    assert len({round(step / SIZE, 3) for step in steps}) == len(steps) == 5
    assert (after["z"], after["R_p"], after["head"]) == (12, None, "free")
    assert [part["node"] for part in after["parts"]] == [3, 3]
    assert perturbed(inputs, seed=1) == after
    assert perturbed(inputs, seed=2) != after


def test_perturbed_defaults_are_the_paper_s_inputs_and_still_obey_their_bounds():
    model = sample()
    before = model()
    assert perturb_defaults([model], seed=1) == {model: Outcome()}
    assert model() != before
    assert model() == model.model_validate(perturbed(before, seed=1))
    assert Job(find("ring-lame"), model()).is_paper
    with pytest.raises(ValidationError):
        model(E=1e99)


def test_a_number_that_a_rule_fixes_stays_and_is_named():
    model = sample(fixed=True)
    assert perturb_defaults([model], seed=1) == {model: Outcome(fixed=("parts[1].ratio",))}
    assert [part.ratio == 1.0 for part in model().parts] == [True, False]


def test_every_case_accepts_perturbed_inputs():
    for case in CASES:
        fixed = ("shafts[1].ratio",) if case.id == "rotor-system" else ()
        for seed in range(1, 4):
            found = case.inputs.model_validate(perturbed(case.inputs(), seed, fixed))
            assert found != case.inputs(), case.id


def probe(environment):
    """A machine whose OpenBLAS has kernels of Haswell for whatever is newer than Nehalem."""
    core = environment.get(CORE_TYPE, "Haswell")
    return {
        "blas": core if core in ("Prescott", "Nehalem") else "Haswell",
        "threads": environment["OMP_NUM_THREADS"],
        "numpy": [] if "NPY_DISABLE_CPU_FEATURES" in environment else FOUND,
        "numba": environment.get("NUMBA_CPU_NAME", "host"),
    }


def test_machines_that_are_no_others_or_that_the_processor_is_not_are_not_emulated():
    found = machines(candidates(FOUND, seeds=2), probe, FLAGS, {})
    assert [one.name for one in found.variants] == [
        "baseline", "threads-2", "core-prescott", "core-nehalem", "numpy-baseline",
        "numba-generic", "perturbed-1", "perturbed-2",
    ]  # fmt: skip
    assert found.not_emulated == {
        "core-sandybridge": "the same is in effect as in baseline",
        "core-haswell": "the same is in effect as in baseline",
        "core-zen": "the same is in effect as in baseline",
        "core-skylakex": "the processor lacks avx512vl",
    }


ROW = Record(id="ring/bore", kind="exact", status="PASS", difference=0.0, tolerance=1.0, scale=1.0)


def summary_of(tmp_path, row, stated=()):
    """The comparison of a baseline with a variant that has this row, both as stored."""
    variants = (Variant(BASELINE, "here"), Variant("there", "elsewhere"))
    emulated = Machines(variants, {BASELINE: {}, "there": {}}, {})
    work = []
    for name, one in ((BASELINE, ROW), ("there", row)):
        place = Place(Store(tmp_path), name, "key")
        place.keep("ring", CaseRecord(rows=(one,), seconds=1.0))
        work.append(runner.Work(place=place, folder=tmp_path / name, environment={},
                                cases=("ring",)))  # fmt: skip
    return command.summarized(work, emulated, {}, stated, is_full=True)


def with_changes(**changes):
    return Record(**{**vars(ROW), **changes})


def test_a_planted_flip_or_move_is_printed_and_written_and_decides(tmp_path):
    assert summary_of(tmp_path, ROW).is_portable
    flipped = summary_of(tmp_path, with_changes(status="FAIL", reason="not sharp"))
    assert not flipped.is_portable
    text = "\n".join(command.lines(flipped))
    assert "status: ring/bore: PASS here, FAIL in there" in text
    moved = summary_of(tmp_path, with_changes(difference=0.2))
    assert not moved.is_portable
    assert "value: ring/bore moves without a reason in there" in "\n".join(command.lines(moved))
    command.write(moved, tmp_path)
    data = json.loads((tmp_path / "portable.json").read_text("utf-8"))
    assert data["portable"] is False
    assert data["moves"][0]["move"] == pytest.approx(0.2)
    assert "| ring/bore | there | 0.2 |" in (tmp_path / "portable.md").read_text("utf-8")


def test_a_reason_makes_a_move_portable_and_one_that_explains_nothing_is_named(tmp_path):
    why = "the residual is round-off, which differs"
    used, unused = (reasons.Reason(rows=f"{name}/*", why=why) for name in ("ring", "roller"))
    found = summary_of(tmp_path, with_changes(difference=0.2), (used, unused))
    assert found.is_portable
    assert found.unused == ("roller/*",)
    assert not summary_of(tmp_path, with_changes(status="FAIL"), (used,)).is_portable
    not_a_number = with_changes(difference=math.nan)
    assert [d.kind for d in summary_of(tmp_path, not_a_number).differences] == [Kind.VALUE]


def test_a_process_that_ends_badly_is_named_with_its_last_line(tmp_path):
    work = runner.Work(place=Place(Store(tmp_path), "v", "key"), folder=tmp_path,
                       environment={**os.environ}, cases=("nocase",))  # fmt: skip
    (how,) = runner.run_all([work], 1, lambda _state: None).values()
    assert how.startswith("exit status 1: ValueError: unknown case 'nocase'")
    assert str(tmp_path / runner.LOG) in how


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--only", "core-z80"], "--only core-z80: no such machine; known are baseline"),
        (["--seeds", "-1"], "--seeds is 0 to 1000, got -1"),
    ],
)
def test_wrong_arguments_are_refused_in_one_line(arguments, words, capsys):
    assert run(["portable", *arguments]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.soak
def test_a_sample_of_rows_has_the_same_verdicts_on_other_machines(tmp_path, monkeypatch, capsys):
    """Perturbed inputs and two BLAS threads, with caches of their own; run again, nothing is."""
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    arguments = ["portable", *SAMPLE, "--only", "perturbed-1", "--only", "threads-2", "--jobs", "2"]
    status = run([*arguments, "--out", str(tmp_path)])
    text = capsys.readouterr().out
    data = json.loads((tmp_path / "portable.json").read_text("utf-8"))
    first = [d["row"] for d in data["differences"] if d["kind"] != Kind.VALUE]
    assert not first, text
    assert not data["failures"], text
    assert {m["cases"] for m in data["machines"]} == {len(SAMPLE)}
    own = Store(tmp_path / "cache-machines" / "perturbed-1").groups()
    assert ("level", "ring-lame") in {(group.kind, group.subject) for group in own}
    assert status == (0 if data["portable"] else 1)
    stored = Store(tmp_path / "cache").groups()
    assert run([*arguments, "--out", str(tmp_path)]) == status
    assert Store(tmp_path / "cache").groups() == stored
