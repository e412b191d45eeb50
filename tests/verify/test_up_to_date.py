"""`verify` makes no report again of which nothing has changed, and any change is noticed."""

import shutil

import pytest

from verify.app import commands, up_to_date
from verify.app.cli import run
from verify.core.store import Store

AGAIN = "nothing has changed since"


@pytest.fixture(scope="module")
def first(tmp_path_factory):
    """A report of the smallest case in a store of its own, and what was printed."""
    folder = tmp_path_factory.mktemp("first")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FREEWHEEL_CACHE", str(folder / "cache"))
        assert run(["verify", "ring-lame", "--jobs", "1", "--out", str(folder / "out")]) == 0
    return folder


@pytest.fixture
def report(first, tmp_path, monkeypatch):
    """A copy of them that a test may change."""
    shutil.copytree(first, tmp_path, dirs_exist_ok=True)
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "cache"))
    return tmp_path


def verified(report, *options):
    return run(["verify", "ring-lame", "--jobs", "1", "--out", str(report / "out"), *options])


def test_a_second_run_prints_the_same_and_solves_nothing(report, monkeypatch, capsys):
    monkeypatch.setattr(commands, "solve", None)
    page = (report / "out" / "report.html").stat().st_mtime_ns
    assert verified(report) == 0
    lines = capsys.readouterr().out.splitlines()
    assert AGAIN in lines[-1]
    assert any(line.startswith("ring-lame") for line in lines)
    assert (report / "out" / "report.html").stat().st_mtime_ns == page


def changed_file(report, _monkeypatch):
    (report / "out" / "rows.csv").write_text("")


def removed_file(report, _monkeypatch):
    (report / "out" / "tables.xlsx").unlink()


def removed_results(report, _monkeypatch):
    Store(report / "cache").clear("level")


def other_code(_report, monkeypatch):
    monkeypatch.setattr(up_to_date, "digest", lambda: "of other files")


def other_versions(_report, monkeypatch):
    monkeypatch.setattr(up_to_date, "conditions", lambda _root: {"versions": {"numpy": "9"}})


def torn_note(report, _monkeypatch):
    note = report / "out" / up_to_date.STAMP
    note.write_text(note.read_text()[:100])


CHANGES = (changed_file, removed_file, removed_results, other_code, other_versions, torn_note)


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: change.__name__)
def test_a_change_is_noticed(report, monkeypatch, capsys, change):
    change(report, monkeypatch)
    assert verified(report) == 0
    assert AGAIN not in capsys.readouterr().out
    assert verified(report) == 0
    assert AGAIN in capsys.readouterr().out


def test_a_run_that_trusts_no_results_is_made(report, capsys):
    assert verified(report, "--no-cache") == 0
    assert AGAIN not in capsys.readouterr().out


def test_a_failed_row_fails_again(report, monkeypatch, capsys):
    monkeypatch.setattr(up_to_date, "digest", lambda: "of a wrong formula")
    monkeypatch.setattr(commands, "_exit_status", lambda _report: 1)
    assert verified(report) == 1
    monkeypatch.setattr(commands, "solve", None)
    assert verified(report) == 1
    assert AGAIN in capsys.readouterr().out
