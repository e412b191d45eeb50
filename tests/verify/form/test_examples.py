"""Every example and template passes unchanged, and a fault in its formula fails the row."""

import importlib
import os
import re
from pathlib import Path

import pytest

from verify.cases.registry import find
from verify.core.results import Status
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, judge_case, solve_level

ROOT = Path(__file__).parents[3]
EXAMPLES, TEMPLATES = ROOT / "examples", ROOT / "verify" / "app" / "templates"
FORMULAS = {  # file without .py: row, the formula's last line, factors that the row must notice
    "curved_bar": ("stress at the inside", "return self.M * (self.r_n - self.r_i)", (0.98, 1.02)),
    "dunkerley": ("critical speed by Dunkerley", "return 1 / sqrt(terms)", (0.98, 1.02)),
    "leaf_spring": ("rate without shear", "return self.E * self.b * self.t**3", (0.98, 1.02)),
    "shaft_shoulder": ("stress concentration factor", "return float(s ** np", (0.8, 1.2)),
    "stepped_hub": ("normal force of the fit", "return 4 * np.pi * self.R * (", (0.98, 1.02)),
    "axisymmetric": ("stress in the middle, Eq. 1", "return (3 + self.nu) / 8", (0.98, 1.02)),
    "contact": ("peak pressure", "return 0.591 * sqrt", (0.98, 1.02)),
    "frame": ("rate, Eq. 1", "return 4 * self.E", (0.98, 1.02)),
    "plane": ("hoop stress, Eq. 1", "return self.p * (self.r_i", (0.98, 1.02)),
    "ring_sector": ("mean growth of the bore", "return self.N * (", (0.98, 1.02)),
    "shaft": ("first bending frequency, Eq. 1", "return pi * self.d_o", (0.98, 1.02)),
}
TEMPLATED = {path.stem for path in TEMPLATES.glob("[!_]*.py")}


def test_every_template_has_its_formula_here():
    assert FORMULAS.keys() >= TEMPLATED


@pytest.mark.parametrize("name", FORMULAS)
def test_an_example_of_sixty_lines_passes_and_its_formula_off_by_a_few_per_cent_fails(
    tmp_path, monkeypatch, name
):
    row, line, factors = FORMULAS[name]
    written = (TEMPLATES if name in TEMPLATED else EXAMPLES) / f"{name}.py"
    text = written.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 60
    assert text.count(line) == 1
    case = find(os.path.relpath(written))
    levels = [solve_level(case, case.inputs(), level, default_folder()) for level in case.levels]
    right = judge_case(Job(case, case.inputs()), levels)
    assert {one.status for one in right.rows} == {Status.PASS}
    monkeypatch.chdir(tmp_path)
    for n, factor in enumerate(factors):
        file = tmp_path / f"{name}_{n}.py"  # a module is read once
        wrong = line.replace("return ", f"return {factor} * ")
        file.write_text(text.replace(line, wrong), encoding="utf-8")
        off = find(file.name)
        judged = judge_case(Job(off, off.inputs()), levels)
        assert {r.quantity: r.status for r in judged.rows}[row] is Status.FAIL


def test_what_the_guide_names_exists():
    guide = (EXAMPLES.parent / "docs" / "own_case.md").read_text(encoding="utf-8")
    for name in set(re.findall(r"[`(]((?:verify|fem|meshes)\.[\w.]*\w)", guide)):
        module, _, own = name.rpartition(".")
        try:
            importlib.import_module(name)
        except ModuleNotFoundError:
            assert hasattr(importlib.import_module(module), own), name
