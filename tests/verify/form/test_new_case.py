"""`freewheel new-case`: each kind of template is verified without changes."""

import json
from pathlib import Path
from typing import get_args

import pytest

from reports import write
from reports.typesetting import NotSet
from verify.app.arguments import ProblemKind
from verify.app.cli import run
from verify.cases import files
from verify.core import source_code
from verify.jobs.executor import Where, local


@pytest.fixture
def _in_process(tmp_path, monkeypatch):
    """An empty folder; levels are solved in this process, and no PDF is written."""

    def not_set(*_):
        raise NotSet("it is not asked for")

    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv(files.FILES, "")
    monkeypatch.setattr(source_code, "_outside", set())
    monkeypatch.setattr(Where, "entered", lambda _: local(0))
    monkeypatch.setattr(write, "printed", not_set)
    monkeypatch.chdir(tmp_path)
    yield
    files._loaded.cache_clear()


@pytest.mark.slow("a report of every kind is made, as a user makes it")
@pytest.mark.usefixtures("_in_process")
@pytest.mark.parametrize("kind", get_args(ProblemKind))
def test_a_template_passes_as_it_is_written(kind):
    name = f"new_{kind.replace('-', '_')}.py"
    assert run(["new-case", name, "--kind", kind]) == 0
    assert Path(name).read_text("utf-8").splitlines()[0].endswith(f'freewheel verify {name}."""')
    assert run(["verify", name, "--out", "out"]) == 0
    rows = json.loads(Path("out/results.json").read_text("utf-8"))["rows"]
    assert {row["status"] for row in rows} == {"PASS"}
    assert any(row["kind"] == "approximation" for row in rows)


@pytest.mark.usefixtures("_in_process")
def test_the_template_is_a_plane_case_unless_another_kind_is_named():
    assert run(["new-case", "one.py"]) == 0
    assert run(["new-case", "two.py", "--kind", "plane"]) == 0
    one, two = (Path(name).read_text("utf-8") for name in ("one.py", "two.py"))
    assert one.replace("one.py", "two.py") == two


@pytest.mark.usefixtures("_in_process")
@pytest.mark.parametrize(
    ("arguments", "message"),
    [(["exists.py"], "exists already"),
     (["exists.py", "--kind", "shaft"], "exists already"),
     (["my-bar.py"], "letters, digits and _"),
     (["new.py", "--kind", "gear"], '"gear" for --kind. Choose from: "plane", "contact"')],
)  # fmt: skip
def test_a_wrong_file_or_kind_is_one_line_and_nothing_is_written(arguments, message, capsys):
    Path("exists.py").write_text("old", "utf-8")
    assert run(["new-case", *arguments]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert message in line
    assert {path.name for path in Path.cwd().glob("*.py")} == {"exists.py"}
    assert Path("exists.py").read_text("utf-8") == "old"
