"""Case files and parameter files as tests of another project, run by pytest in a process."""

import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

EXAMPLE = (Path(__file__).parents[3] / "examples" / "winkler_bach.py").read_text("utf-8")
PART = """case = "freewheel-clutch"
[inputs]
R = "16.5 mm"
r = "2.5 mm"
X = "11.39565 mm"
R_a = "21 mm"
L = "10 mm"
T = "{T} N m"
"""
FILES = {
    "case_right.py": EXAMPLE,
    "case_wrong.py": EXAMPLE.replace("return self.M * (self.r_n - self.r_i)",
                                     "return 1.05 * self.M * (self.r_n - self.r_i)"),
    "case_blunt.py": EXAMPLE.replace("sensitivity=(0.012, ART_29)", "sensitivity=(1e-4, ART_29)"),
    "case_coarse.py": EXAMPLE.replace("refine=2**level", "refine=(1, 4, 2, 3)[level - 1]"),
    "case_broken.py": EXAMPLE.replace("    title = ", "    titel = "),
    "holds.toml": PART.format(T=10),
    "fails.toml": PART.format(T=500),
    "mistyped.toml": PART.format(T="1O"),
}  # fmt: skip


def pytest_in(folder, *words):
    """Status and output of pytest in a folder."""
    environment = {**os.environ, "FREEWHEEL_CACHE": str(folder / "cache"), "PYTEST_ADDOPTS": ""}
    command = (sys.executable, "-m", "pytest", "-p", "no:cacheprovider",
               "-q", "-rs", *words)  # fmt: skip
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True,
                          check=False)  # fmt: skip
    return done.returncode, done.stdout + done.stderr


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    folder = tmp_path_factory.mktemp("project")
    for name, text in FILES.items():
        (folder / name).write_text(text, "utf-8")
    (folder / "pytest.ini").write_text("[pytest]\n", "utf-8")
    return folder


@pytest.fixture(scope="module")
def output(project):
    status, text = pytest_in(project, "--freewheel", *FILES)
    assert status == 1
    return text


@pytest.mark.slow("pytest in a separate process on cases that are solved")
def test_a_failure_states_what_is_wrong_without_a_traceback(output):
    for file, says in (
        ("case_wrong.py: stress at the inner edge", "FAIL: model error +4.58"),
        ("case_blunt.py: stress at the inner edge", "FAIL: insufficient sensitivity"),
        ("case_broken.py: file", "case_broken.py: titel: annotate it"),
        ("fails.toml: check", "fails"),
        ("mistyped.toml: check", "inputs.T"),
    ):  # fmt: skip
        assert file in output
        assert says in output.partition(file)[2].partition("\n____")[0]
        assert "Traceback" not in output


def test_what_is_right_passes_and_a_series_that_does_not_converge_fails(output):
    assert "case_right.py" not in output
    assert "holds.toml" not in output
    coarse = [part for part in output.split("\n____") if "case_coarse.py" in part]
    assert any("FAIL" in part and "converge" in part for part in coarse)


@pytest.mark.slow("pytest starts two processes")
def test_files_of_patterns_run_by_configuration_side_by_side_with_junit(project):
    settings = "[pytest]\nfreewheel_collect = true\nfreewheel_parts = holds.toml\n"
    (project / "settings.ini").write_text(settings, "utf-8")
    status, text = pytest_in(
        project, "-c", "settings.ini", "-n", "2", "--dist", "loadfile", "--junit-xml", "junit.xml",
        "-k", "inner and not convergence or check", "-m", "approximation or freewheel",
        "--deselect", "case_broken.py",
    )  # fmt: skip
    assert status == 1, text
    found = {(case.get("classname"), case.get("name")): case.find("failure") is not None
             for case in ET.parse(project / "junit.xml").iter("testcase")}  # fmt: skip
    failed = {name: is_red for (name, _), is_red in found.items()}
    assert failed == {"case_right": False, "case_wrong": True, "case_blunt": True,
                      "case_coarse": failed["case_coarse"], "holds.toml": False}  # fmt: skip


def test_without_option_and_setting_nothing_is_collected(project):
    assert pytest_in(project)[0] == 5  # no tests
