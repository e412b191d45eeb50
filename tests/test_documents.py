"""The documents agree with the program."""

import re
import tomllib
from pathlib import Path

import pytest

from verify.app.cli import run
from verify.cases.registry import CASES, find
from verify.core.environment import NEWEST, OLDEST, PACKAGES, python_problem
from verify.core.inputs import build

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text("utf-8")
VERIFIED = (ROOT / "docs" / "verified.md").read_text("utf-8")
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
CONSOLE = re.compile(r"```console\n(.*?)```", re.DOTALL)


def test_readme_is_short_and_the_verdicts_name_every_case():
    assert len(README.splitlines()) <= 150
    assert len(README.encode()) <= 12_000
    assert [case.id for case in CASES if f"`{case.id}`" not in VERIFIED] == []


def sessions():
    """Commands of the README's consoles, each with the lines that it prints first."""
    for block in CONSOLE.findall(README):
        for part in block.split("$ ")[1:]:
            command, *shown = part.splitlines()
            yield command, shown


@pytest.mark.slow("templates of every tool are checked, as a reader checks them")
def test_the_examples_print_what_the_readme_shows(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    compared = 0
    for command, shown in sessions():
        words, _, target = command.partition(" > ")
        name, *arguments = words.split()
        if name != "freewheel" or "--fem" in arguments:
            continue
        capsys.readouterr()
        run(arguments)
        printed = capsys.readouterr().out
        if target:
            Path(target).write_text(printed, "utf-8")
        assert printed.splitlines()[: len(shown)] == shown, command
        compared += len(shown)
    assert compared > 15


def test_the_parameter_file_and_the_numbers_of_the_readme_are_those_of_the_formulas():
    data = tomllib.loads(re.search(r"```toml\n(.*?)```", README, re.DOTALL)[1])
    assert build(find(data["case"]).inputs, data["inputs"], "README").n == 12
    ring, star, strip = (
        case.analytic(case.inputs())
        for case in map(find, ("polyhedral-clutch", "freewheel-torque", "spring-width"))
    )
    for text in (
        f"transmits {ring['M_wide']:.0f} (plane strain)",
        f"to {ring['M_el']:.0f} N m (plane stress)",
        f"gives {ring['M_21']:.0f} N m",
        f"overestimates the wind-up by {100 * (star['phi_printed'] / star['phi'] - 1):.0f} %",
        f"increases the stiffness by up to {100 * (strip['f'] - 1):.1f} %",
    ):
        assert text in README, text


def test_packages_and_versions_of_python_are_the_same_everywhere():
    assert f"apt-get install -y {' '.join(PACKAGES)}\n" in README
    oldest, newest = (".".join(map(str, version)) for version in (OLDEST, NEWEST))
    assert f"Python {oldest} to {newest}" in README
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert project["requires-python"] == f">={oldest},<3.{NEWEST[1] + 1}"
    assert f"Python {oldest} to {newest}" in python_problem((3, 10))


def test_commands_and_links_of_the_documents_are_right():
    for page in PAGES:
        text = page.read_text("utf-8")
        for target in re.findall(r"\]\(([^)#]+)\)", text):
            assert "://" in target or (page.parent / target).exists(), (page.name, target)
    pages = "\n".join(page.read_text("utf-8") for page in PAGES)
    for command in {*re.findall(r"^(?:\$ )?freewheel ([a-z]\S*)", pages, re.MULTILINE)}:
        assert run([command.strip("`."), "--help"]) == 0, command


@pytest.mark.parametrize(("name", "least"), [("requirements", 50), ("requirements-docs", 20)])
def test_requirements_are_locked_with_hashes_and_name_no_index(name, least):
    lock = (ROOT / f"{name}.txt").read_text("utf-8")
    pins = re.findall(r"^[a-z0-9._-]+==\S+", lock, re.MULTILINE)
    assert len(pins) > least
    assert lock.count("--hash=sha256:") >= len(pins)
    assert not re.search(r"--(extra-)?index-url|--find-links|https?://", lock)
