"""Case files and parameter files as tests of another project, run by pytest in a process."""

import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from verify.core.results import Kind
from verify.plugin import KINDS

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


def in_sigma(statement):
    """The example with a statement before the first formula of a stress."""
    line = "        return self.M"
    return EXAMPLE.replace(line, f"        {statement}\n{line}", 1)


FILES = {
    "case_right.py": EXAMPLE,
    "case_wrong.py": EXAMPLE.replace("return self.M * (self.r_n - self.r_i)",
                                     "return 1.05 * self.M * (self.r_n - self.r_i)"),
    "case_blunt.py": EXAMPLE.replace("sensitivity=(0.012, ART_29)", "sensitivity=(1e-4, ART_29)"),
    "case_coarse.py": EXAMPLE.replace("refine=2**level", "refine=(1, 4, 2, 3)[level - 1]"),
    "case_broken.py": EXAMPLE.replace("    title = ", "    titel = "),
    "case_raises.py": in_sigma("raise RuntimeError('no value')"),
    "case_exits.py": in_sigma("raise SystemExit(3)"),
    "case_leaves.py": "raise SystemExit(3)\n",
    "case_syntax.py": EXAMPLE.replace("CurvedBar(Case):", "CurvedBar(Case:"),
    "case_import.py": f"import no_such_module\n{EXAMPLE}",
    "case_extra.py": "raise ModuleNotFoundError(\"No module named 'nicegui.ui'\")\n",
    "case_empty.py": EXAMPLE.partition("    def comparisons")[0],
    "case_equal.py": EXAMPLE.replace("refine=2**level", "refine=8"),
    "case_exact.py": EXAMPLE.replace("refine=2**level", "refine=8").replace(
        "force=force / moment", "force=force / moment, iteration=1e-12"),
    "case_shown.py": EXAMPLE.replace("expected=most", "expected=None"),
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
    for file, message in (
        ("case_wrong.py: stress at the inner edge", "FAIL: model error +4.58"),
        ("case_wrong.py: stress at the inner edge", "value 81.1151 MPa, reference 77.5628 MPa"),
        ("case_wrong.py: stress at the inner edge", "next: check the formula"),
        ("case_blunt.py: stress at the inner edge", "FAIL: insufficient sensitivity"),
        ("case_blunt.py: stress at the inner edge", "detection limit 0.79%, required 0.01%"),
        ("case_coarse.py: stress at the inner edge: convergence", "coarse to fine: 79.4938"),
        ("case_equal.py: stress at the inner edge", "the reference does not depend on the level"),
        ("case_broken.py: file", "case_broken.py: titel: annotate it"),
        ("case_raises.py: file", "\ncase_raises.py:44: sigma_i: RuntimeError: no value\n"),
        ("case_exits.py: file", "\ncase_exits.py:44: sigma_i: SystemExit: 3\n"),
        ("case_leaves.py: file", "\ncase_leaves.py:1: SystemExit: 3\n"),
        ("case_syntax.py: file", "\ncase_syntax.py:22: "),
        ("case_import.py: file", "case_import.py:1: ModuleNotFoundError: No module named"),
        ("case_extra.py: file", "\ninstall it: pip install 'freewheel-verification[app]'\n"),
        ("case_empty.py: file", "case_empty.py: the case has no rows"),
        ("fails.toml: check", "fails"),
        ("mistyped.toml: check", "inputs.T"),
    ):  # fmt: skip
        assert file in output
        assert message in output.partition(f" {file} _")[2].partition("\n____")[0] + "\n"
    assert "Traceback" not in output
    assert "INTERNALERROR" not in output
    assert output.count("install it") == 1  # no extra contains the other missing module


def test_an_unexpected_error_is_one_line_with_the_extra_that_is_missing(tmp_path):
    (tmp_path / "conftest.py").write_text(
        "import verify.plugin.parts as parts\n"
        "def read(path):\n"
        "    raise ModuleNotFoundError(\"No module named 'numba'\", name='numba')\n"
        "parts.read = read\n", "utf-8")  # fmt: skip
    (tmp_path / "one.toml").write_text(FILES["holds.toml"], "utf-8")
    _, text = pytest_in(tmp_path, "--freewheel", "one.toml")
    lines = text.partition(" one.toml: check _")[2].splitlines()[1:3]
    assert lines == [
        "one.toml: ModuleNotFoundError: No module named 'numba' (traceback: --full-trace)",
        "install it: pip install 'freewheel-verification[fem]'",
    ]


def test_what_is_right_passes_and_a_series_that_does_not_converge_fails(output):
    assert "case_right.py" not in output
    assert "case_exact.py" not in output  # its round-off is stated, as of an exact reference
    assert "holds.toml" not in output
    coarse = [part for part in output.split("\n____") if "case_coarse.py" in part]
    assert any("FAIL" in part and "converge" in part for part in coarse)


@pytest.mark.slow("pytest in a separate process on a case that is solved")
def test_what_is_shown_is_skipped_with_its_reason_and_fails_where_the_setting_is_strict(project):
    words = ("--freewheel", "case_shown.py", "-k", "inner and not convergence")
    status, text = pytest_in(project, *words)
    assert status == 0
    assert "SHOWN: measured model error: -0.40 ± 0.02 %" in text
    status, text = pytest_in(project, *words, "-o", "freewheel_strict=true")
    assert status == 1
    assert "SHOWN: measured model error: -0.40 ± 0.02 %" in text.partition("FAILURES")[2]


def test_junit_has_status_verdict_and_margin_of_a_part(project):
    pytest_in(project, "--freewheel", "fails.toml", "--junit-xml", "part.xml")
    (case,) = ET.parse(project / "part.xml").iter("testcase")
    found = {one.get("name"): one.get("value") for one in case.iter("property")}
    margin = float(found.pop("margin"))
    assert found == {"status": "FAIL", "kind": "part", "verdict": "fails"}
    assert f"{margin:.3f}" == "0.466"  # 900 MPa allowed of 1933 MPa, as `check` prints it


def test_the_plugin_loads_no_library_of_the_suite_before_a_file_is_collected():
    code = "import pytest, sys; known = {*sys.modules}; import verify.plugin; " \
        "print(*{*sys.modules} - known)"  # fmt: skip
    process = subprocess.run(
        (sys.executable, "-c", code), capture_output=True, text=True, check=True
    )
    assert set(process.stdout.split()) == {"verify", "verify.plugin"}
    assert {kind.value for kind in Kind} == set(KINDS)


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
                      "case_coarse": failed["case_coarse"], "case_equal": True,
                      "case_exact": False, "case_shown": False, "holds.toml": False}  # fmt: skip


def test_without_option_and_setting_nothing_is_collected(project):
    assert pytest_in(project)[0] == 5  # no tests
