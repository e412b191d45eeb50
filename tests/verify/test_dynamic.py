"""`check --dynamic` on a small invented case: a vibrating ring, and its possible errors."""

import json
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.verify.ring_file import RING
from tests.verify.template_text import whole
from verify.answers import parameter_file
from verify.answers.template import template
from verify.app.cli import run
from verify.cases import registry
from verify.cases.ring.lame.case import LAME
from verify.core import progress, units
from verify.core.case import Dynamic, Output
from verify.core.figures import Curve, Curves

BY_HAND = 2 * 60e3 / 210e3 * 290  # µm, twice r_i/E (2.6 + nu) p at the bore


def swing(inputs, values):
    """A peak twice the static displacement, as a step load has it without damping."""
    return {"peak": 2 * values["u_bore"], "time": 3e-3}


def swung(_inputs, values):
    t = np.linspace(0.0, values["time"], 9)
    line = Curve(name="swing", x=t * 1e3, y=1e6 * values["peak"] * t / t[-1])
    return (Curves(title="A ring swings", x_label="ms", y_label="µm", curves=(line,)),)


SWINGS = Dynamic(
    run=swing,
    what="the swing",
    outputs=(
        Output(key="peak", symbol="u_max", unit="µm", what="largest displacement", judged=False),
        Output(key="time", symbol="t", unit="s", what="time of the peak", judged=False),
    ),
    findings=lambda q, v: (f"swings to {v['peak'] / v['u_bore']:g} times",),
    summary=lambda q, v: {"verdict": "swings", "factor": v["peak"] / v["time"] * q.r_i},
    figures=swung,
)


@pytest.fixture
def check(monkeypatch, tmp_path, capsys):
    """Exit status, stdout and stderr of `check` on a ring with a dynamic part."""
    path = tmp_path / "ring.toml"
    path.write_text(RING)

    def checked(*options, part=SWINGS, **more):
        case = replace(LAME, dynamic=part, findings=lambda q, v: ("holds",), **more)
        monkeypatch.setattr(parameter_file, "find", lambda _id: case)
        status = run(["check", *map(str, options), str(path)])
        return status, *capsys.readouterr()

    return checked


def raising(error):
    def fails(*_):
        raise error

    return fails


def test_its_findings_and_values_stand_after_the_static_ones(check):
    status, out, _ = check("--dynamic")
    lines = out.splitlines()
    notes, at = lines.index("notes"), lines.index("the swing")
    assert status == 0
    assert lines[notes + 1 : notes + 3] == ["  holds", "  swings to 2 times"]
    assert lines[notes + 3].startswith("values by the formulas")
    assert notes + 3 < at
    assert lines[at + 1].split() == ["u_max", f"{BY_HAND:.3f}", "µm", "largest", "displacement"]
    # nothing of it is marked as judged where finite elements refuse
    marked = replace(SWINGS, outputs=tuple(replace(o, judged=True) for o in SWINGS.outputs))
    assert "largest displacement *" in check("--dynamic", part=marked)[1]
    assert "*" not in check("--dynamic", part=marked, too_large=lambda q: "too many cells")[1]


def test_without_the_option_it_does_not_run_and_is_refused_where_there_is_none(check):
    status, out, _ = check(part=replace(SWINGS, run=raising(AssertionError("ran"))))
    assert status == 0
    assert out.count("(check --dynamic adds the swing)") == 1
    assert "--dynamic" not in check(part=None)[1]
    status, out, error = check("--dynamic", part=None)
    assert (status, out) == (2, "")
    assert error.endswith("ring.toml: case ring-lame has no dynamic part; omit --dynamic\n")


def test_what_has_no_answer_ends_with_one_line_and_status_two(check, tmp_path):
    for what, fault, words in (
        ("run", raising(ArithmeticError("dt is 1e-05 s,\ntoo long")), "dt is 1e-05 s, too long"),
        ("run", lambda q, v: {"peak": float("nan"), "time": 1.0}, "the value peak is not finite"),
        ("findings", raising(ValueError("no peak")), "no peak"),
        ("figures", raising(ValueError("no path")), "no path"),
    ):
        part = replace(SWINGS, **{what: fault})
        status, message, error = check("--dynamic", "--out", tmp_path / "out", part=part)
        assert (status, message, error.count("\n")) == (2, "", 1)
        assert f"ring.toml: the swing: {words}" in error


def test_json_and_the_report_have_its_values_findings_and_figures(check, tmp_path):
    found = json.loads(check("--json", "--dynamic")[1])
    static, dynamic = found["findings"], found["dynamic"]
    assert (static, dynamic["findings"]) == (["holds"], ["swings to 2 times"])
    assert (dynamic["what"], dynamic["verdict"]) == ("the swing", "swings")
    assert [v["key"] for v in dynamic["values"]] == ["peak", "time"]
    assert dynamic["values"][0]["value"] == pytest.approx(BY_HAND, rel=1e-12)
    assert "peak" not in {v["key"] for v in found["values"]}
    assert json.loads(check("--json")[1])["dynamic"] is None
    out = tmp_path / "out"
    assert check("--dynamic", "--out", out)[0] == 0
    page = (out / "report.html").read_text("utf-8")
    for words in ("A ring swings", "largest displacement", "swings to 2 times"):
        assert words in page


def test_the_verdict_of_both_parts_together_comes_first(check):
    message = ("holds at rest, breaks as it swings", "at rest: holds")
    part = replace(SWINGS, overall=lambda q, v: ("breaks", message))
    status, out, _ = check("--dynamic", part=part)
    lines = out.splitlines()
    at = lines.index("notes")
    assert (status, lines[0]) == (1, f"ring: fails: {message[0]}")
    assert lines[at + 1 : at + 4] == [*(f"  {words}" for words in message), "  swings to 2 times"]
    found = json.loads(check("--json", "--dynamic", part=part)[1])
    assert (found["details"]["verdict"], found["findings"]) == ("breaks", list(message))


def test_a_slow_part_is_reported_while_it_runs(capsys):
    with progress.message_if_slow("compiles", quiet=False, after=0.02):
        time.sleep(0.2)
        print("over", file=sys.stderr)
    first, second, third = capsys.readouterr().err.splitlines()
    assert (first, second) == ("compiles", "over")
    assert third.startswith("done after 0.")


def test_cases_with_a_dynamic_part_have_separate_keys_and_compile_nothing_before_use(
    tmp_path,
):
    paths = []
    for case in (case for case in registry.CASES if case.dynamic is not None):
        assert all(units.factor(output.unit) for output in case.dynamic.outputs)
        ours = [output.key for output in case.dynamic.outputs]
        assert len(ours) == len({*ours} - {output.key for output in case.outputs})
        paths.append(str(tmp_path / f"{case.id}.toml"))
        Path(paths[-1]).write_text(whole(template(case)), "utf-8")
    assert paths
    script = (
        "import sys\nfrom verify.app.cli import run\n"
        f"assert not any(run(['check', path]) for path in {paths!r})\n"
        "assert not {'numba', 'llvmlite'} & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", script], capture_output=True, check=True, timeout=120)
