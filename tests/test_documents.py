"""The documents say what the program does."""

import re
import tomllib
from pathlib import Path

import pytest

from reports.verdicts import markdown
from verify.cases.registry import CASES
from verify.cli import run
from verify.commands import make_report
from verify.environment import NEWEST, OLDEST, PACKAGES, python_problem
from verify.inputs import build

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")


def test_readme_names_every_case():
    for case in CASES:
        assert f"`{case.id}`" in README


def test_the_parameter_file_of_the_readme_is_one():
    data = tomllib.loads(re.search(r"```toml\n(.*?)```", README, re.DOTALL)[1])
    case = next(c for c in CASES if c.id == data["case"])
    assert build(case.inputs, data["inputs"], "README").n == 12


def test_the_debian_packages_are_those_of_the_set_up():
    assert f"apt-get install -y {' '.join(PACKAGES)}\n" in README


def test_the_range_of_python_versions_is_the_same_everywhere():
    oldest, newest = (".".join(map(str, version)) for version in (OLDEST, NEWEST))
    assert f"Python {oldest} to {newest}" in README
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert project["requires-python"] == f">={oldest},<3.{NEWEST[1] + 1}"
    assert f"Python {oldest} to {newest}" in python_problem((3, 10))


def test_the_table_of_verdicts_is_that_of_this_code(judged):
    cases = [judged(case) for case in CASES]
    table = markdown(make_report(cases, CASES, 0.0))
    printed = README.partition("<!-- verdicts -->\n")[2].partition("\n<!-- /verdicts -->")[0]
    assert printed == table, "run make readme"


@pytest.mark.parametrize("command", re.findall(r"^freewheel (\S+)", README, re.MULTILINE))
def test_every_command_of_the_readme_is_one(command):
    assert run([command.strip("`."), "--help"]) == 0


def test_links_of_the_readme_lead_somewhere():
    for target in re.findall(r"\]\(([^)#]+)\)", README):
        assert (ROOT / target).exists(), target


def test_requirements_are_locked_with_hashes_and_name_no_index():
    lock = (ROOT / "requirements.txt").read_text("utf-8")
    pins = re.findall(r"^[a-z0-9._-]+==\S+", lock, re.MULTILINE)
    assert len(pins) > 50
    assert lock.count("--hash=sha256:") >= len(pins)
    assert not re.search(r"--(extra-)?index-url|--find-links|https?://", lock)
