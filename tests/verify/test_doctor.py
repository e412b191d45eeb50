"""The command `doctor`: what is there, what is missing, what to do about it."""

import json
import signal
import sys
from pathlib import Path

import pytest

from verify.app import doctor
from verify.app.cli import run
from verify.app.doctor import MISSING, OK, OPTIONAL, Finding
from verify.app.installed import PIN, installed, mismatches
from verify.core import environment
from verify.studies.crosscheck import solvers


@pytest.fixture
def quick(monkeypatch):
    """Every process that is tried ends well, unless a test says otherwise."""
    answers = {}
    monkeypatch.setattr(
        environment, "probe", lambda script, _s: next(
            (said for part, said in answers.items() if part in script), ""
        ),
    )  # fmt: skip
    return answers


def test_a_machine_that_runs_these_tests_can_run_verify(capsys):
    assert run(["doctor"]) == 0
    out = capsys.readouterr().out.splitlines()
    assert {line.split()[0] for line in out[:-1]} <= {OK, OPTIONAL, MISSING}
    assert any("gmsh makes meshes" in line and line.startswith(OK) for line in out)


def test_json_says_the_same(quick, capsys):
    assert run(["doctor", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["ok"] is True
    assert {"Python", "lock", "gmsh makes meshes", "cache"} <= {
        f["what"] for f in found["findings"]
    }


def test_a_lost_library_ends_with_the_line_that_installs_it(quick, monkeypatch, capsys):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(environment, "loads", lambda library: library != "libGLU.so.1")
    quick["gmsh"] = "OSError: libGLU.so.1: cannot open shared object file"
    assert run(["doctor"]) == 2
    out = capsys.readouterr().out.splitlines()
    assert out[-1] == "verify cannot run: apt-get install libglu1-mesa"
    assert any(line.startswith("missing") and "libGLU.so.1" in line for line in out)


def test_without_pictures_verify_still_runs(quick, monkeypatch, capsys):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(environment, "loads", lambda library: library != "libEGL.so.1")
    quick["pyvista"] = f"killed by {signal.SIGSEGV.name}"
    assert run(["doctor"]) == 0
    out = capsys.readouterr().out.splitlines()
    assert out[-1] == "verify runs, with less: apt-get install libegl1"


def test_a_broken_pdf_writer_is_named(quick, capsys):
    quick["typst"] = "ModuleNotFoundError: No module named 'typst'"
    assert run(["doctor"]) == 0
    assert capsys.readouterr().out.splitlines()[-1].endswith("No module named 'typst'")


def test_a_missing_package_stops_a_run(quick, monkeypatch, capsys):
    monkeypatch.setattr(doctor, "SOLVING", (*doctor.SOLVING, "no_such_package"))
    assert run(["doctor"]) == 2
    assert "missing no_such_package: make .venv/.ready" in capsys.readouterr().out


def test_a_cache_that_cannot_be_written_is_told(quick, monkeypatch, tmp_path, capsys):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("FREEWHEEL_CACHE", str(blocked / "cache"))
    assert run(["doctor"]) == 0
    assert "every run solves anew" in capsys.readouterr().out


def test_second_solvers_are_optional(quick, monkeypatch, tmp_path, capsys):
    solvers.solver.cache_clear()
    monkeypatch.setattr(doctor.shutil, "which", lambda _program: None)
    monkeypatch.setenv("FREEWHEEL_CROSSCHECK", str(tmp_path / "python"))
    monkeypatch.setattr(solvers, "OWN", tmp_path)
    assert run(["doctor"]) == 0
    lines = [x for x in capsys.readouterr().out.splitlines() if x.startswith(OPTIONAL)]
    assert [x.split()[1] for x in lines] == ["calculix", "tamaas", "ROSS", "chromium"]
    assert all("not installed" in x for x in lines)
    assert "no ccx among the programs" in lines[0]
    assert all(x.endswith("make crosscheck installs it") for x in lines[1:3])
    solvers.solver.cache_clear()


def test_second_solvers_are_those_of_their_own_environment(quick, monkeypatch, capsys):
    python = Path("/somewhere/.venv-crosscheck/bin/python")
    monkeypatch.setattr(solvers, "solver", lambda name: solvers.Solver(name, "1.2.3"))
    monkeypatch.setattr(solvers, "interpreter", lambda: python)
    assert run(["doctor", "--json"]) == 0
    found = {f["what"]: f for f in json.loads(capsys.readouterr().out)["findings"]}
    assert [found[name]["state"] for name in ("calculix", "tamaas", "ROSS")] == [OK] * 3
    assert found["ROSS"]["detail"] == f"1.2.3, {python}"
    assert str(python) not in found["calculix"]["detail"]


def test_versions_that_are_not_the_locked_ones_are_named():
    lock = (
        f"numpy=={installed('numpy')} \\\n    --hash=sha256:0\n"
        "scipy==0.0.1 \\\n    --hash=sha256:0\n"
        "no-such-package==1.0 \\\n"
        "colorama==0.0.1 ; sys_platform == 'no such system' \\\n"
        "pint==0.0.1 ; python_version > '3' \\\n"
    )
    assert mismatches(lock) == [
        f"scipy {installed('scipy')}, lock 0.0.1",
        "no-such-package absent, lock 1.0",
        f"pint {installed('pint')}, lock 0.0.1",
    ]


def test_every_pin_of_the_lock_is_read():
    lock = (doctor.ROOT / "requirements.txt").read_text("utf-8")
    pins = [line for line in lock.splitlines() if line[:1].isalnum()]
    assert len(PIN.findall(lock)) == len(pins) > 50


@pytest.mark.parametrize(
    ("fatal", "word"), [(True, "verify cannot run"), (False, "verify runs, with less")]
)
def test_the_last_line_says_whether_verify_can_run(fatal, word):
    found = [Finding("a", OK, ""), Finding("b", MISSING, "no b", fatal), Finding("c", OPTIONAL, "")]
    assert doctor.conclusion(found) == f"{word}: no b"
