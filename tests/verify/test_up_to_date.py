"""`verify` does not repeat a report without changes, and detects any change."""

import json
import shutil

import pytest

from verify.app import commands, up_to_date
from verify.app.cli import run
from verify.app.up_to_date import STAMP
from verify.core.store import Store
from verify.jobs.executor import Where


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """A report of the smallest case in a separate store."""
    folder = tmp_path_factory.mktemp("first")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FREEWHEEL_CACHE", str(folder / "cache"))
        out, summary = str(folder / "out"), str(folder / "job.md")
        assert run(["verify", "ring-lame", "-j", "1", "--out", out, "--summary", summary]) == 0
    return folder


class MakesError(Exception):
    """The command continues with solving, or with a report."""


@pytest.fixture
def report(first, tmp_path, monkeypatch):
    """A copy of it that a test may change; a run that does not find it raises MakesError."""
    shutil.copytree(first, tmp_path, dirs_exist_ok=True)
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))

    def make(*_, **_options):
        raise MakesError

    monkeypatch.setattr(commands, "solve", make)
    monkeypatch.setattr(commands, "make_report", make)
    return tmp_path


def verified(report, **form):
    given = {"quick": False, "where": Where(1), "out": report / "out", "use_cache": True}
    return commands.run_verify(["ring-lame"], **given | form)


@pytest.mark.slow("a report to begin with, from an empty store")
def test_a_second_run_prints_the_same_with_the_same_status_and_solves_nothing(report, capsys):
    page = (report / "out" / "report.html").stat().st_mtime_ns
    assert verified(report) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "nothing has changed since" in lines[-1]
    assert any(line.startswith("ring-lame") for line in lines)
    assert (report / "out" / "report.html").stat().st_mtime_ns == page
    note = report / "out" / STAMP
    note.write_text(json.dumps(json.loads(note.read_text("utf-8")) | {"status": 1}), "utf-8")
    assert verified(report, summary=report / "again.md") == 1
    assert (report / "again.md").read_text("utf-8") == (report / "job.md").read_text("utf-8")
    # a run that trusts no results, and other forms of the report
    for form in ({"use_cache": False}, {"single_file": True}, {"full_pdf": True}):
        with pytest.raises(MakesError):
            verified(report, **form)


CHANGES = {
    "a changed file": lambda report, _: (report / "out" / "rows.csv").write_text(""),
    "a removed file": lambda report, _: (report / "out" / "tables.xlsx").unlink(),
    "a torn note": lambda report, _: (report / "out" / STAMP).write_text("{"),
    "removed results": lambda report, _: Store(report / "cache").clear("level"),
    "other code": lambda _, patch: patch.setattr(up_to_date, "digest", lambda: "of other files"),
    "other versions": lambda _, patch: patch.setattr(
        up_to_date, "conditions", lambda _root: {"versions": {"numpy": "9"}}
    ),
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_a_change_is_detected(report, monkeypatch, change):
    change(report, monkeypatch)
    with pytest.raises(MakesError):
        verified(report)
