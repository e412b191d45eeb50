"""Missing components are named with the packages that contain them, by `doctor` and on use."""

import os
import signal
import subprocess
import sys

import pytest

from verify.app import doctor
from verify.app.cli import run
from verify.app.doctor import MISSING, OK, OPTIONAL
from verify.app.installed import installed, mismatches
from verify.core import environment
from verify.core.environment import NEWEST, OLDEST
from verify.studies.crosscheck import solvers

LOST = "libGLU.so.1: cannot open shared object file: No such file or directory"


@pytest.fixture
def broken(monkeypatch, capsys):
    """Output of `doctor` on a machine of Linux without libraries, whose processes answer."""

    def diagnosis(libraries=(), answers=None):
        monkeypatch.setattr(sys, "platform", "linux")
        monkeypatch.setattr(environment, "loads", lambda library: library not in libraries)
        monkeypatch.setattr(
            environment, "probe", lambda script, _s: next(
                (answer for part, answer in (answers or {}).items() if part in script), ""
            ),
        )  # fmt: skip
        status = run(["doctor"])
        return status, capsys.readouterr().out.splitlines()

    return diagnosis


def test_a_lost_library_ends_with_the_line_that_installs_it(broken, capsys):
    assert run(["doctor"]) == 0  # these tests run
    lines = capsys.readouterr().out.splitlines()
    assert {line.split()[0] for line in lines[:-1]} <= {OK, OPTIONAL, MISSING}
    assert any("gmsh makes meshes" in line and line.startswith(OK) for line in lines)
    status, lines = broken(("libGLU.so.1",), {"gmsh": f"OSError: {LOST}"})
    assert (status, lines[-1]) == (2, "verify cannot run: apt-get install libglu1-mesa")
    assert any(line.startswith("missing") and "libGLU.so.1" in line for line in lines)


def test_without_pictures_a_cache_or_second_solvers_verify_still_runs(
    broken, monkeypatch, tmp_path
):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "file" / "cache"))
    monkeypatch.setattr(doctor.shutil, "which", lambda _program: None)
    monkeypatch.setenv("FREEWHEEL_CROSSCHECK", str(tmp_path / "python"))
    monkeypatch.setattr(solvers, "ENVIRONMENT", tmp_path)
    solvers.solver.cache_clear()
    status, lines = broken(("libEGL.so.1",), {"pyvista": f"killed by {signal.SIGSEGV.name}"})
    solvers.solver.cache_clear()
    assert (status, lines[-1]) == (
        0,
        "verify runs, but some parts of the report are missing: apt-get install libegl1",
    )
    problem = environment.missing_for_pictures()
    assert problem.startswith("pyvista cannot draw off-screen (killed by SIGSEGV); ")
    assert "results cannot be stored and reused" in "\n".join(lines)
    optional = [x.split()[1] for x in lines if x.startswith(OPTIONAL) and "not installed" in x]
    assert optional == ["calculix", "tamaas", "ROSS", "chromium"]


def test_versions_that_are_not_the_locked_ones_are_named():
    lock = (
        f"numpy=={installed('numpy')} \\\n    --hash=sha256:0\n"
        "scipy==0.0.1 \\\n    --hash=sha256:0\n"
        "no-such-package==1.0 \\\n"
        "colorama==0.0.1 ; sys_platform == 'no such system' \\\n"
        "pint==0.0.1 ; python_version > '3' \\\n"
    )
    scipy, pint = (f"{name} {installed(name)}, lock file 0.0.1" for name in ("scipy", "pint"))
    assert mismatches(lock) == [scipy, "no-such-package absent, lock file 1.0", pint]


def test_an_older_or_newer_python_is_refused_in_one_line(monkeypatch):
    assert environment.python_problem(OLDEST) == environment.python_problem((*NEWEST, 7)) == ""
    monkeypatch.setattr(environment.shutil, "which", lambda name: name == "python3.12")
    for version in ((3, 10, 13), (NEWEST[0], NEWEST[1] + 1, 0)):
        message = environment.python_problem(version)
        assert message.endswith(f", but this is {version[0]}.{version[1]}: make PYTHON=python3.12")


def test_what_may_crash_is_tried_in_a_separate_process():
    for script, seconds, answer in (
        ("raise SystemExit(3)", 30.0, "exit status 3"),
        ("import os; os.kill(os.getpid(), 11)", 30.0, "killed by SIGSEGV"),
        ("import time; time.sleep(60)", 1.0, "no answer within 1 s"),
    ):
        assert environment.probe(script, seconds) == answer


def test_without_gmsh_s_libraries_finite_elements_name_the_package(tmp_path):
    (tmp_path / "gmsh.py").write_text(f"raise OSError({LOST!r})")
    (tmp_path / "pyvista.py").write_text("import os\nos.kill(os.getpid(), 11)")
    path = tmp_path / "ring.toml"
    assert run(["init", "ring-lame", "--out", str(path)]) == 0
    line = "gmsh, which makes the meshes, needs libGLU.so.1: apt-get install libglu1-mesa\n"
    for options, expected in (
        ((), (0, "")), (("--fem", "--no-cache"), (2, f"freewheel: {line}")),
    ):  # fmt: skip
        done = subprocess.run(
            [sys.executable, "-m", "verify", "check", *options, str(path)],
            env=os.environ | {"PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])},
            capture_output=True, text=True, check=False, timeout=300,
        )  # fmt: skip
        assert (done.returncode, done.stderr) == expected
