"""What the machine lacks is said with the packages that bring it."""

import signal
import subprocess
import sys

import pytest

from verify.core import environment
from verify.core.environment import LIBRARIES, NEWEST, OLDEST, PICTURES

LOST = "libGLU.so.1: cannot open shared object file: No such file or directory"
RING = """\
case = "ring-lame"
[inputs]
r_i = "60 mm"
r_o = "90 mm"
p_i = "100 MPa"
E = "210 GPa"
nu = 0.3
"""


@pytest.fixture
def without(monkeypatch):
    """Make libraries vanish from the dynamic linker's sight."""

    def hide(*names):
        there = {library for library, _, _ in LIBRARIES} - set(names)
        monkeypatch.setattr(environment, "loads", there.__contains__)

    return hide


@pytest.fixture
def stub(tmp_path, monkeypatch):
    """Put a module that runs `code` before the installed one, also for processes started here."""

    def write(name, code):
        (tmp_path / f"{name}.py").write_text(code)
        monkeypatch.setenv("PYTHONPATH", str(tmp_path))
        monkeypatch.syspath_prepend(tmp_path)
        monkeypatch.delitem(sys.modules, name, raising=False)

    return write


def freewheel(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "verify", *map(str, arguments)],
        capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip


def test_what_is_missing_is_named_with_its_package(without, monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    without("libGLU.so.1", "libEGL.so.1")
    assert environment.missing_libraries() == ("libGLU.so.1", "libEGL.so.1")
    assert environment.missing_libraries(PICTURES) == ("libEGL.so.1",)
    assert environment.install_line(environment.missing_libraries()) == (
        "apt-get install libglu1-mesa libegl1"
    )


def test_libraries_are_asked_for_on_linux_alone(without, monkeypatch):
    without("libGLU.so.1")
    monkeypatch.setattr(sys, "platform", "darwin")
    assert environment.missing_libraries() == ()


@pytest.mark.parametrize("version", [OLDEST, (3, 12, 1), (*NEWEST, 7)])
def test_pythons_of_the_lock_are_accepted(version):
    assert environment.python_problem(version) == ""


@pytest.mark.parametrize("version", [(3, 10, 13), (NEWEST[0], NEWEST[1] + 1, 0), (4, 0, 0)])
def test_an_older_or_newer_python_is_refused_in_one_line(version, monkeypatch):
    monkeypatch.setattr(environment.shutil, "which", lambda name: name == "python3.12")
    assert environment.python_problem(version) == (
        f"needs Python 3.11 to 3.14, this is {version[0]}.{version[1]}: make PYTHON=python3.12"
    )
    monkeypatch.setattr(environment.shutil, "which", lambda name: None)
    assert environment.python_problem(version).endswith(": set PYTHON")


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ("pass", ""),
        ("raise SystemExit(3)", "exit status 3"),
        ("raise OSError('no such')", "OSError: no such"),
        ("import os; os.kill(os.getpid(), 11)", "killed by SIGSEGV"),
        ("import time; time.sleep(60)", "no answer within 1 s"),
    ],
)
def test_what_may_crash_is_tried_in_a_process_of_its_own(script, said):
    assert environment.probe(script, 1.0 if "sleep" in script else 30.0) == said


def test_pictures_that_kill_the_process_are_named(stub):
    stub("pyvista", f"import os\nos.kill(os.getpid(), {int(signal.SIGSEGV)})")
    said = environment.missing_for_pictures()
    assert said.startswith("pyvista cannot draw off-screen (killed by SIGSEGV); ")
    assert "apt-get install" in said  # the libraries are there: their drivers may be missing


def test_missing_opengl_is_named_with_its_packages(stub, without, monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    stub("pyvista", f"import os\nos.kill(os.getpid(), {int(signal.SIGSEGV)})")
    without("libEGL.so.1", "libGL.so.1")
    assert environment.missing_for_pictures().endswith(
        "missing libEGL.so.1, libGL.so.1: apt-get install libgl1 libegl1"
    )


def test_an_empty_picture_is_no_picture(stub):
    stub(
        "pyvista",
        "import numpy\nSphere = dict\nclass Plotter:\n"
        "    def __init__(self, **_): pass\n    def add_mesh(self, *_, **__): pass\n"
        "    def screenshot(self, **_): return numpy.zeros((64, 64, 3))\n",
    )
    assert "the picture stays empty" in environment.missing_for_pictures()


@pytest.mark.parametrize("command", ["verify", "check --fem", "explain"])
def test_without_gmsh_s_libraries_what_needs_them_names_the_package(command, stub, tmp_path):
    stub("gmsh", f"raise OSError({LOST!r})")
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    arguments = {
        "verify": ["verify", "ring-lame", "--no-cache", "--out", tmp_path / "out"],
        "check --fem": ["check", "--fem", "--no-cache", path],
        "explain": ["explain", "ring-lame/axial stress, plane strain", "--no-cache"],
    }[command]
    done = freewheel(*arguments)
    assert done.returncode == 2
    assert done.stderr == (
        "freewheel: gmsh, which makes the meshes, needs libGLU.so.1: apt-get install libglu1-mesa\n"
    )


@pytest.mark.parametrize("command", ["check", "list", "init", "--help", "completion"])
def test_the_rest_works_without_gmsh_and_pyvista(command, stub, tmp_path):
    stub("gmsh", f"raise OSError({LOST!r})")
    stub("pyvista", f"import os\nos.kill(os.getpid(), {int(signal.SIGSEGV)})")
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    more = {"check": [path], "init": ["ring-lame"], "completion": ["bash"]}.get(command, [])
    done = freewheel(command, *more)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_gmsh_that_is_not_installed_is_no_traceback(stub, tmp_path):
    stub("gmsh", "raise ModuleNotFoundError(\"No module named 'gmsh'\")")
    done = freewheel("verify", "ring-lame", "--no-cache", "--out", tmp_path / "out")
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "cannot be imported (No module named 'gmsh'): see freewheel doctor" in done.stderr
