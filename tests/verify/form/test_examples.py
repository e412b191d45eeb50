"""Every example passes as it stands, and a mistake in its formula fails the row."""

import importlib
import json
import os
import re
from functools import cache
from pathlib import Path

import pytest

from verify.app.cli import run
from verify.cases.registry import find
from verify.core.results import Status
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, Solved, judge_case, solve_level

EXAMPLES = Path(__file__).parents[3] / "examples"
GUIDE = EXAMPLES.parent / "docs" / "own_case.md"
FORMULAS = {  # file without .py: row, the formula's last line, factors that the row must notice
    "curved_bar": ("stress at the inside", "return self.M * (self.r_n - self.r_i)", (0.98, 1.02)),
    "dunkerley": ("critical speed by Dunkerley", "return 1 / sqrt(terms)", (0.98, 1.02)),
    "leaf_spring": ("rate without shear", "return self.E * self.b * self.t**3", (0.98, 1.02)),
    "shaft_shoulder": ("stress concentration factor", "return float(s ** np", (0.8, 1.2)),
    "stepped_hub": ("normal force of the fit", "return 4 * np.pi * self.R * (", (0.98, 1.02)),
}


def statuses(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, file: Path) -> dict[str, str]:
    monkeypatch.chdir(tmp_path)
    run(["verify", os.path.relpath(file), "--out", "out", "--jobs", "1"])
    rows = json.loads(Path("out/results.json").read_text(encoding="utf-8"))["rows"]
    return {row["quantity"]: row["status"] for row in rows}


@pytest.mark.parametrize("name", FORMULAS)
def test_passes_in_sixty_lines(tmp_path, monkeypatch, name):
    file = EXAMPLES / f"{name}.py"
    assert len(file.read_text(encoding="utf-8").splitlines()) <= 60
    found = statuses(tmp_path, monkeypatch, file)
    assert FORMULAS[name][0] in found
    assert set(found.values()) == {"PASS"}


@pytest.mark.parametrize(
    ("name", "factor"), [(n, f) for n, (_, _, factors) in FORMULAS.items() for f in factors]
)
def test_wrong_formula_fails(tmp_path, monkeypatch, name, factor):
    row, line, _ = FORMULAS[name]
    text = (EXAMPLES / f"{name}.py").read_text(encoding="utf-8")
    assert text.count(line) == 1
    side = "low" if factor < 1 else "high"
    file = tmp_path / f"{name}_{side}.py"  # a module is read once
    wrong = line.replace("return ", f"return {factor} * ")
    file.write_text(text.replace(line, wrong), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    case = find(file.name)
    judged = judge_case(Job(case, case.inputs()), levels(name))
    assert {r.quantity: r.status for r in judged.rows}[row] is Status.FAIL


@cache
def levels(name: str) -> list[Solved]:
    """Levels of an example, whose references know nothing of the formula."""
    case = find(os.path.relpath(EXAMPLES / f"{name}.py"))
    return [solve_level(case, case.inputs(), level, default_folder()) for level in case.levels]


def names_of(guide):
    """Modules and what is inside them, as the guide names them."""
    return set(re.findall(r"[`(]((?:verify|fem|meshes)\.[\w.]*\w)", guide))


@pytest.mark.parametrize("name", sorted(names_of(GUIDE.read_text(encoding="utf-8"))))
def test_what_the_guide_names_exists(name):
    module, _, own = name.rpartition(".")
    try:
        importlib.import_module(name)
    except ModuleNotFoundError:
        assert hasattr(importlib.import_module(module), own)
