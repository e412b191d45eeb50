"""The command line: loaded modules, exit statuses, and one line for an error."""

import json
import os
import subprocess
import sys

import pytest

from analytic.ring import lame
from verify.app import commands
from verify.app.cli import run
from verify.cases.registry import CASES

HEAVY = ("gmsh", "skfem", "meshio", "pyvista", "matplotlib", "sklearn", "numba", "llvmlite",
         "scipy.stats")  # fmt: skip
COLD = """
import sys
from verify.app.cli import run
for words in (["--help"], ["init", "ring-lame"], ["check", "my.toml"], ["design", "--help"]):
    assert run(words) == 0, words
print([m for m in {heavy!r} if m in sys.modules], file=sys.stderr)
"""


def test_nothing_heavy_is_imported_before_it_is_needed(tmp_path):
    assert run(["init", "ring-lame", "--out", str(tmp_path / "my.toml")]) == 0
    done = subprocess.run(
        [sys.executable, "-c", COLD.format(heavy=HEAVY)], cwd=tmp_path,
        capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip
    assert done.stderr.splitlines()[-1] == "[]"
    assert all(word in done.stdout for word in ("verify", "check", "list", "doctor"))


def test_list_and_completion_name_every_case(capsys):
    assert run(["list"]) == 0
    out = capsys.readouterr().out
    for case in CASES:
        assert f"{case.id} " in out
        assert case.title in out
    assert "inputs: r_i [mm], r_o [mm], p_i [MPa], E [GPa], nu\n" in out
    assert "optional: p_o [MPa], R_p [MPa]\n" in out
    # the verdicts come first; required inputs and those that are assumed have separate lines
    of_clutch = [line.strip() for line in out.partition("\nsprag-clutch ")[2].splitlines()]
    assert of_clutch[1].startswith(
        "verdicts: unsafe: Eq. 6; cannot be verified: Eq. 7; exact: Eq. 8"
    )
    assert of_clutch[2] == "inputs: R_i [mm], R_e [mm], l [mm], T [N m]"
    assert run(["__complete", "init", ""]) == 0
    offered = capsys.readouterr().out.split()[1:]  # after the opening directive
    assert [*CASES.ids, "design-spring", "design-sprag"] == offered


@pytest.mark.slow("a run with its report")
def test_verify_writes_the_report_and_a_failed_row_makes_the_exit_status_one(
    tmp_path, capsys, monkeypatch
):
    out = tmp_path / "out"
    assert run(["verify", "spring-accordion", "--out", str(out)]) == 0
    written = {p.name for p in out.iterdir()}
    assert {"report.html", "report.pdf", "tables.xlsx", "results.json", "results.schema.json",
            "rows.csv", "junit.xml"} <= written  # fmt: skip
    assert str(out / "report.html") in capsys.readouterr().out.replace("\n", "")
    right = lame.strain_energy
    monkeypatch.setattr(lame, "strain_energy", lambda **k: 1.001 * right(**k))
    monkeypatch.setattr(commands, "QUICK", ("ring-lame",))
    assert run(["verify", "--quick", "--out", str(out)]) == 1
    assert "FAIL" in capsys.readouterr().out
    rows = json.loads((out / "results.json").read_text())["rows"]
    assert {row["case"] for row in rows} == {"ring-lame"}


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("verify ring-lam", "unknown case 'ring-lam', did you mean ring-lame?"),
        ("verify ring-lame --quick", "do not name cases together with"),
        ("verify --pdf short", 'Invalid value "short" for --pdf. Choose from: "record", "full"'),
        ("verify --jobs -1", "--jobs must be 0 (one per core) to 256, got -1"),
        ("verify ring-lame --out file/out", "file: is a file, expected a folder"),
        ("explain displacement nowhere.toml", "nowhere.toml: cannot be read"),
        ("chekc a.toml", "chekc"),
        ("check", "FILE"),
        ("verify --out ", "an argument is empty"),
    ],
)
def test_bad_command_lines_end_with_one_line_and_status_two(
    line, message, capsys, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("")
    assert run(line.split(" ")) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("freewheel: ")
    assert err.count("\n") == 1
    assert message in err
    assert len(err) < 300


def test_a_fault_of_the_program_is_one_line_and_a_file(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr("verify.app.commands.run_list", lambda: {}["nothing"])
    assert run(["list"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "KeyError: 'nothing'" in line
    (file,) = tmp_path.iterdir()
    assert str(file) in line
    assert "Traceback" in file.read_text("utf-8")
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "none"))
    assert run(["list"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.endswith("the traceback cannot be written: No such file or directory")


FAULT = """
from verify.app import cli, commands
def run_list():
    raise RuntimeError("a file of \\u03bd \\udcff")
commands.run_list = run_list
cli.main(["list"])
"""


def test_a_fault_of_the_program_is_one_line_whatever_the_terminal_can_print(tmp_path):
    environment = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0",
                   "TMPDIR": str(tmp_path)}  # fmt: skip
    done = subprocess.run([sys.executable, "-c", FAULT], env=environment, capture_output=True,
                          text=True, check=False)  # fmt: skip
    assert done.returncode == 2
    (line,) = done.stderr.splitlines()
    assert line.startswith("freewheel: internal error: RuntimeError: a file of ")
    (file,) = tmp_path.iterdir()
    assert "a file of ν \\udcff" in file.read_text("utf-8")
