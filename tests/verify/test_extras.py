"""The package without its extras: formulas can be checked; other commands name the extra."""

import subprocess
import sys
from pathlib import Path

import pytest

from verify.app import extras
from verify.app.extras import PACKAGE, extra_of, missing_library, shared_names

EXTRA = {
    "cvxopt", "distributed", "fastapi", "gmsh", "jinja2", "latex2mathml", "matplotlib", "meshio",
    "nicegui", "numba", "PIL", "pyvista", "skfem", "sklearn", "threadpoolctl", "typst", "uvicorn",
    "xlsxwriter",
}  # fmt: skip
WITHOUT = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {names}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)
sys.meta_path.insert(0, Absent())
from verify.app.cli import main
main()
"""


def freewheel(*words: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """A command line where no library of an extra can be imported."""
    code = WITHOUT.format(names=EXTRA)
    command = [sys.executable, "-c", code, *words]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("case", ["freewheel-clutch", "rotor-system"])
def test_formulas_are_checked_without_extras(case: str, tmp_path: Path) -> None:
    assert freewheel("init", case, "--out", "my.toml", folder=tmp_path).returncode == 0
    done = freewheel("check", "my.toml", folder=tmp_path)
    assert done.returncode in {0, 1, 3}
    assert done.stderr == ""


def test_finite_elements_name_their_extra(tmp_path: Path) -> None:
    freewheel("init", "ring-lame", "--out", "my.toml", folder=tmp_path)
    done = freewheel("check", "--fem", "--no-cache", "my.toml", folder=tmp_path)
    assert done.returncode == 2
    assert "pip install 'freewheel-verification[fem]'" in done.stderr
    assert done.stderr.count("\n") == 1


def test_the_local_page_names_its_extra(tmp_path: Path) -> None:
    done = freewheel("app", "--no-browser", "--port", "0", folder=tmp_path)
    assert done.returncode == 2
    assert "nicegui is not installed" in done.stderr
    assert "pip install 'freewheel-verification[app]'" in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(("module", "extra"), [
    ("gmsh", "fem"), ("sklearn", "fem"), ("PIL", "report"), ("distributed", "dask"), ("numpy", ""),
    ("nicegui", "app"), ("uvicorn", "app"),
])  # fmt: skip
def test_extra_of_a_module(module: str, extra: str) -> None:
    assert extra_of(module) == extra


def test_unknown_module_is_left_to_the_doctor() -> None:
    error = ImportError("libGL.so.1: cannot open shared object file")
    assert missing_library(error) == f"{error}: see freewheel doctor"


def test_names_of_another_package_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    owners = {"fem": [PACKAGE, "other"], "verify": [PACKAGE], "numpy": ["numpy"]}
    monkeypatch.setattr(extras, "packages_distributions", lambda: owners)
    assert shared_names() == ["fem"]
