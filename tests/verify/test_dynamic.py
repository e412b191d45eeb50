"""`check --dynamic` on a small made-up case: a ring that swings, with what may go wrong in it."""

import json
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.verify.template_text import whole
from verify.answers import parameter_file
from verify.answers.template import template
from verify.app.cli import run
from verify.cases import registry
from verify.cases.ring.lame.case import LAME
from verify.core import progress, units
from verify.core.case import Dynamic, Output
from verify.core.figures import Curve, Curves

RING = """\
case = "ring-lame"
[inputs]
r_i = "60 mm"
r_o = "90 mm"
p_i = "100 MPa"
E = "210 GPa"
nu = 0.3
"""


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
def ring(tmp_path):
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    return path


@pytest.fixture
def swings(monkeypatch):
    """Give the ring's case a dynamic part."""

    def give(part=SWINGS, **more):
        case = replace(LAME, dynamic=part, findings=lambda q, v: ("holds",), **more)
        monkeypatch.setattr(parameter_file, "find", lambda _id: case)
        return case

    return give


def raising(error):
    def fails(*_):
        raise error

    return fails


def refused(arguments, capsys):
    """The one line that a command ends with."""
    assert run(list(map(str, arguments))) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    return said.err


def test_its_findings_and_values_stand_after_the_static_ones(ring, swings, capsys):
    swings()
    assert run(["check", "--dynamic", str(ring)]) == 0
    lines = capsys.readouterr().out.splitlines()
    notes = lines.index("notes")
    assert lines[notes + 1 : notes + 3] == ["  holds", "  swings to 2 times"]
    at = lines.index("the swing")
    assert lines[notes + 3].startswith("values by the formulas")
    assert notes + 3 < at
    # r_i/E (2.6 + nu) p by hand is 82.857 µm at the bore
    assert lines[at + 1].split() == ["u_max", "165.714", "µm", "largest", "displacement"]
    assert lines[at + 2].split()[:3] == ["t", "0.003", "s"]
    assert lines[-1] == "(check --fem compares the values marked * with: finite elements)"


def test_without_being_asked_it_is_offered_and_does_not_run(ring, swings, capsys):
    swings(replace(SWINGS, run=raising(AssertionError("ran"))))
    assert run(["check", str(ring)]) == 0
    out = capsys.readouterr().out
    assert out.count("(check --dynamic adds the swing)") == 1


def test_a_case_without_a_dynamic_part_offers_none_and_refuses_it_in_one_line(
    ring, tmp_path, capsys
):
    assert run(["check", str(ring)]) == 0
    assert "--dynamic" not in capsys.readouterr().out
    said = refused(["check", "--dynamic", ring, "--out", tmp_path / "out"], capsys)
    assert said.endswith("ring.toml: case ring-lame has no dynamic part: leave out --dynamic\n")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("error", [ArithmeticError, ValueError])
@pytest.mark.parametrize("part", ["run", "findings", "figures"])
def test_what_has_no_answer_ends_with_one_line_and_status_two(
    part, error, ring, tmp_path, swings, capsys
):
    swings(replace(SWINGS, **{part: raising(error("dt is 1e-05 s,\ntoo long for D_V"))}))
    said = refused(["check", "--dynamic", ring, "--out", tmp_path / "out"], capsys)
    assert "ring.toml: the swing: dt is 1e-05 s, too long for D_V" in said


def test_a_value_that_is_not_finite_is_refused_by_name(ring, swings, capsys):
    swings(replace(SWINGS, run=lambda q, v: {"peak": float("nan"), "time": 1.0}))
    assert "the swing: peak is not finite" in refused(["check", "--dynamic", ring], capsys)


def test_a_fault_of_the_program_in_it_is_no_traceback_either(
    ring, swings, capsys, monkeypatch, tmp_path
):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    swings(replace(SWINGS, run=raising(KeyError("N"))))
    assert "this is a fault of the program" in refused(["check", "--dynamic", ring], capsys)


def test_json_has_it_under_its_own_key(ring, swings, capsys):
    swings()
    assert run(["check", "--json", "--dynamic", str(ring)]) == 0
    found = json.loads(capsys.readouterr().out)
    static, dynamic = found["findings"], found["dynamic"]
    assert static == ["holds"]
    assert dynamic["findings"] == ["swings to 2 times"]
    assert (dynamic["what"], dynamic["verdict"]) == ("the swing", "swings")
    assert [v["key"] for v in dynamic["values"]] == ["peak", "time"]
    assert dynamic["values"][0]["value"] == pytest.approx(2 * 60e3 / 210e3 * 290, rel=1e-12)
    assert "peak" not in {v["key"] for v in found["values"]}
    assert run(["check", "--json", str(ring)]) == 0
    assert json.loads(capsys.readouterr().out)["dynamic"] is None


def test_a_report_has_its_figures_values_and_findings(ring, swings, tmp_path):
    swings()
    out = tmp_path / "out"
    assert run(["check", "--dynamic", str(ring), "--out", str(out)]) == 0
    page = (out / "report.html").read_text("utf-8")
    for words in ("A ring swings", "largest displacement", "swings to 2 times"):
        assert words in page
    assert "freewheel check --dynamic ring.toml" in page
    assert run(["check", str(ring), "--out", str(out)]) == 0
    assert "A ring swings" not in (out / "report.html").read_text("utf-8")


def test_the_verdict_of_both_parts_together_comes_first(ring, swings, capsys, tmp_path):
    said = ("holds at rest, breaks as it swings", "at rest: holds")
    swings(replace(SWINGS, overall=lambda q, v: ("breaks", said)))
    assert run(["check", "--dynamic", str(ring), "--out", str(tmp_path / "out")]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"ring: fails: {said[0]}"
    at = lines.index("notes")
    assert lines[at + 1 : at + 4] == [*(f"  {words}" for words in said), "  swings to 2 times"]
    assert said[0] in (tmp_path / "out" / "report.html").read_text("utf-8")
    assert run(["check", "--json", "--dynamic", str(ring)]) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["details"]["verdict"] == "breaks"
    assert found["findings"] == list(said)
    assert run(["check", "--json", str(ring)]) == 0
    assert json.loads(capsys.readouterr().out)["findings"] == ["holds"]


def test_nothing_of_it_is_marked_as_judged_where_finite_elements_refuse(ring, swings, capsys):
    marked = tuple(replace(o, judged=True) for o in SWINGS.outputs)
    swings(replace(SWINGS, outputs=marked))
    assert run(["check", "--dynamic", str(ring)]) == 0
    assert "largest displacement *" in capsys.readouterr().out
    swings(replace(SWINGS, outputs=marked), too_large=lambda q: "too many cells")
    assert run(["check", "--dynamic", str(ring)]) == 0
    assert "*" not in capsys.readouterr().out


def test_a_slow_part_is_reported_while_it_runs(capsys):
    with progress.told_if_slow("compiles", quiet=False, after=0.02):
        time.sleep(0.2)
        print("over", file=sys.stderr)
    first, second, third = capsys.readouterr().err.splitlines()
    assert (first, second) == ("compiles", "over")
    assert third.startswith("done after 0.")


def test_outputs_of_every_dynamic_part_have_known_units_and_keys_of_their_own():
    for case in registry.CASES:
        if case.dynamic is not None:
            assert all(units.factor(output.unit) for output in case.dynamic.outputs)
            ours = [output.key for output in case.dynamic.outputs]
            assert len(ours) == len(set(ours))
            assert not set(ours) & {output.key for output in case.outputs}


def test_cases_with_a_dynamic_part_compile_nothing_before_they_are_asked_to(tmp_path):
    paths = []
    for case in registry.CASES:
        if case.dynamic is not None:
            paths.append(str(tmp_path / f"{case.id}.toml"))
            Path(paths[-1]).write_text(whole(template(case)), "utf-8")
    assert paths
    script = (
        "import sys\nfrom pathlib import Path\nfrom verify.app.cli import run\n"
        f"for path in {paths!r}:\n"
        "    assert run(['init', Path(path).stem]) == run(['check', path]) == 0\n"
        "print([m for m in ('numba', 'llvmlite') if m in sys.modules], file=sys.stderr)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False, timeout=120
    )
    assert done.stderr.splitlines()[-1] == "[]"
