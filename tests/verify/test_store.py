"""The store of results: complete entries, several processes, damaged or full files, its command."""

import json
import multiprocessing
import os
import re
import sqlite3
import time
from pathlib import Path

import numpy as np
import pytest

from verify.app import origin
from verify.app.cli import run
from verify.cases.registry import find
from verify.core import database
from verify.core.store import FILE, Store, packed
from verify.jobs import cache


@pytest.fixture
def store(tmp_path, monkeypatch):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    return Store(tmp_path)


def test_what_is_stored_is_read_by_kind_and_key_and_cleared_by_kind_and_subject(store, tmp_path):
    assert store.load("sweep", ["a"]) == {}
    assert store.groups() == []
    assert store.clear() == 0
    assert not list(tmp_path.iterdir())  # nothing is made by reading
    store.store("sweep", "ring", {"a": b"11", "b": b"2"})
    store.store("sweep", "spring", {"c": b"1"})
    store.store("budget", "ring", {"a": b"3"})
    assert store.load("sweep", ["a", "b", "d"]) == {"a": b"11", "b": b"2"}
    assert store.one("budget", "a") == b"3"
    assert store.one("budget", "b") is None
    assert [(g.kind, g.subject, g.entries, g.size) for g in store.groups()] == [
        ("budget", "ring", 1, 1), ("sweep", "ring", 2, 3), ("sweep", "spring", 1, 1),
    ]  # fmt: skip
    assert [store.clear("sweep", "ring"), store.clear("sweep"), store.clear()] == [2, 1, 1]
    assert store.groups() == []


def test_what_was_used_least_recently_goes_first_where_the_file_grows_too_large(store, monkeypatch):
    monkeypatch.setattr("verify.core.store.RECENT", 0.0)  # each reading is noted
    for n in range(10):
        store.store("sweep", "ring", {f"{n}": bytes(50_000)})
        time.sleep(0.002)
    assert store.groups()[0].entries == 10
    assert store.one("sweep", "0")
    monkeypatch.setattr("verify.core.store.LARGEST", 540_000)
    store.store("sweep", "ring", {"10": bytes(50_000)})
    left = store.load("sweep", [f"{n}" for n in range(11)])
    assert sorted(left) == ["0", "10", "4", "5", "6", "7", "8", "9"]


# Several processes


def write(folder, barrier, name):
    barrier.wait()
    for n in range(40):
        Store(folder).store(name, "ring", {f"{n}": bytes(100)})


def test_processes_that_begin_a_file_at_once_lose_nothing(store, tmp_path):
    context = multiprocessing.get_context("fork")
    barrier = context.Barrier(8)
    names = [f"kind {k}" for k in range(8)]
    writers = [context.Process(target=write, args=(tmp_path, barrier, name)) for name in names]
    for one in writers:
        one.start()
    for one in writers:
        one.join()
    assert [one.exitcode for one in writers] == 8 * [0]
    assert [(group.kind, group.entries) for group in store.groups()] == [(n, 40) for n in names]


# Files that cannot be read or written


def test_a_store_of_a_later_format_is_refused_and_stays(store):
    store.store("sweep", "ring", {"a": b"1"})
    with sqlite3.connect(store.path) as file:
        file.execute("PRAGMA user_version = 9")
    with pytest.raises(OSError, match=r"later version \(format 9; this version reads format 1\)"):
        store.store("sweep", "ring", {"b": b"1"})
    with sqlite3.connect(store.path) as file:
        assert file.execute("SELECT key FROM entries").fetchall() == [("a",)]


def test_a_damaged_file_is_named_and_reads_as_empty_where_that_serves(store):
    store.path.write_bytes(b"no database" * 100)
    assert store.one("sweep", "a") is None
    for action in (store.groups, lambda: store.load("sweep", ["a"])):
        with pytest.raises(OSError, match=rf"{FILE}: .*; remove the file to begin again$"):
            action()


@pytest.mark.parametrize(
    ("error", "words"),
    [
        ("attempt to write a readonly database", "readonly database: results cannot be stored"),
        ("database or disk is full", "free space on its disk, or remove the file to begin again$"),
    ],
)
def test_what_cannot_be_written_can_be_read(store, monkeypatch, error, words):
    def refused(*_):
        raise sqlite3.OperationalError(error)

    store.store("sweep", "ring", {"a": b"1"})
    monkeypatch.setattr(database, "_write_ahead", refused)
    assert store.load("sweep", ["a"]) == {"a": b"1"}
    assert [group.entries for group in store.groups()] == [1]
    with pytest.raises(OSError, match=words):
        store.store("sweep", "ring", {"b": b"1"})
    with pytest.raises(OSError, match=error):
        store.check()


def test_a_file_that_others_write_is_not_read_without_locks(store, monkeypatch):
    store.store("sweep", "ring", {"a": b"1"})
    connect = sqlite3.connect

    def refused(path, **options):
        if "immutable" not in str(path):
            raise sqlite3.OperationalError("unable to open database file")
        return connect(path, **options)

    monkeypatch.setattr(database.sqlite3, "connect", refused)
    assert store.load("sweep", ["a"]) == {"a": b"1"}
    store.path.with_name(f"{FILE}-wal").write_bytes(b"of another process")
    with pytest.raises(OSError, match="unable to open"):
        store.load("sweep", ["a"])


# The command


def test_the_command_lists_and_clears(store, capsys):
    store.store("budget", "ring-lame", {"a": bytes(2_000_000)})
    store.store("level", "ring-lame", {"b": bytes(1_000_000)})
    assert run(["store", "--json"]) == 0
    groups = json.loads(capsys.readouterr().out)["groups"]
    assert {(g["kind"], g["subject"], g["size"]) for g in groups} == {
        ("level", "ring-lame", 1_000_000), ("budget", "ring-lame", 2_000_000),
    }  # fmt: skip
    assert run(["store"]) == 0
    assert "2 results, 3.0 MB" in capsys.readouterr().out
    assert run(["store", "--clear", "budget:ring-lame"]) == 0
    assert [group.kind for group in store.groups()] == ["level"]


def test_options_that_make_no_sense_are_refused(store, capsys):
    store.store("level", "ring-lame", {"a": b"1"})
    for arguments, message in (
        ("ring-lame --json", "store ring-lame: --json and --clear cannot be combined with a case"),
        ("--clear level:", "--clear level:: a subject is missing after the colon"),
        ("--clear budgets", "kinds: level"),
        ("--code numpy.linalg", "--code numpy.linalg: must be a module of the project"),
        ("--code fem.plane", "--code fem.plane: is a package: give one of its modules"),
        ("ring-lame --code fem.plane.solve", "give either a case or a module"),
        ("no-case", "unknown case 'no-case'"),
    ):
        assert run(["store", *arguments.split()]) == 2
        assert message in capsys.readouterr().err
    assert store.one("level", "a")


def test_the_origin_of_a_case_s_numbers_and_the_cases_of_a_module_are_listed(
    store, capsys, monkeypatch
):
    case = find("ring-lame")
    key = cache.key(case, case.inputs(), case.levels[0])
    store.store("level", "ring-lame", {key: bytes(1_500_000)})
    store.store("sweep formulas", "ring-lame", {"a": b"1"})
    assert run(["store", "ring-lame"]) == 0
    out = capsys.readouterr().out
    assert re.search(rf"\n  2 +{key}  {time.strftime('%Y-')}.*, 1\.5 MB\n", out)
    assert re.search(r"\n  4 +[0-9a-f]{32}  not stored", out)
    assert "sweep formulas: 1 results of any code" in out
    assert re.search(r"20..-..-.., of this code  verify/measured/validity/ring-lame.json", out)
    monkeypatch.chdir(Path(__file__).parents[2])
    monkeypatch.setattr(origin, "CASES", [case])  # hashing all takes seconds
    assert run(["store", "--code", "analytic/ring/lame.py"]) == 0
    formulas, reference, *_ = capsys.readouterr().out.splitlines()
    assert ("ring-lame" in formulas, "ring-lame" in reference) == (True, False)


def test_levels_of_an_earlier_version_move_into_the_store_and_other_files_stay(
    store, tmp_path, capsys
):
    """Someone may name a folder that holds more than the store."""
    name = f"{'0a' * 16}.npz"
    files = {"pictures/a.jpg": b"a picture", f"pictures/{name}": packed({"head": np.zeros(1)}),
             f"photos/{name}": b"no level", f"arrays/{name}": packed({"x": np.zeros(1)}),
             "ring-wide/.part-x": b"half"}  # fmt: skip
    path = tmp_path / "ring-lame" / name
    for place, content in {path: packed({"head": np.array("{}")}), **files}.items():
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_bytes(content)
    os.utime(path, (1e9, 1e9))
    assert run(["store", "--json"]) == 0
    printed = capsys.readouterr()
    assert printed.err.startswith("freewheel: 1 results of an earlier version were moved into")
    (group,) = json.loads(printed.out)["groups"]
    assert (group["kind"], group["subject"], group["oldest"]) == ("level", "ring-lame", 1e9)
    assert not path.parent.exists()
    assert {place: (tmp_path / place).read_bytes() for place in files} == files
