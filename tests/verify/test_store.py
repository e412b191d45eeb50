"""The store of results: whole entries, several processes, damaged and full files, its command."""

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
from verify.core.store import FILE, Store, packed, unpacked
from verify.jobs import cache


@pytest.fixture
def store(tmp_path):
    return Store(tmp_path)


def test_what_is_stored_is_read_by_kind_and_key(store):
    store.store("sweep", "ring", {"a": b"1", "b": b"2"})
    store.store("budget", "ring", {"a": b"3"})
    assert store.load("sweep", ["a", "b", "c"]) == {"a": b"1", "b": b"2"}
    assert store.one("budget", "a") == b"3"
    assert store.one("budget", "b") is None


def test_nothing_is_made_by_reading(store, tmp_path):
    assert store.load("sweep", ["a"]) == {}
    assert store.groups() == []
    assert store.clear() == 0
    assert not list(tmp_path.iterdir())


def test_groups_and_what_clear_removes(store):
    store.store("sweep", "ring", {"a": b"11"})
    store.store("sweep", "spring", {"b": b"1"})
    store.store("budget", "ring", {"c": b"1"})
    assert [(g.kind, g.subject, g.entries, g.size) for g in store.groups()] == [
        ("budget", "ring", 1, 1), ("sweep", "ring", 1, 2), ("sweep", "spring", 1, 1),
    ]  # fmt: skip
    assert store.clear("sweep", "ring") == 1
    assert store.clear("sweep") == 1
    assert store.clear() == 1
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


def test_a_store_of_a_later_format_is_refused_and_stays(store):
    store.store("sweep", "ring", {"a": b"1"})
    with sqlite3.connect(store.path) as database:
        database.execute("PRAGMA user_version = 9")
    with pytest.raises(OSError, match=r"later version \(format 9, this one reads 1\)"):
        store.store("sweep", "ring", {"b": b"1"})
    with sqlite3.connect(store.path) as database:
        assert database.execute("SELECT key FROM entries").fetchall() == [("a",)]


def test_a_damaged_file_is_named_and_reads_as_empty_where_that_serves(store):
    store.path.write_bytes(b"no database" * 100)
    assert store.one("sweep", "a") is None
    for action in (store.groups, lambda: store.load("sweep", ["a"])):
        with pytest.raises(OSError, match=rf"{FILE}: .*; remove it to begin again$"):
            action()


def test_a_locked_file_is_waited_for_and_then_named(store, monkeypatch):
    store.store("sweep", "ring", {"a": b"1"})
    monkeypatch.setattr("verify.core.database.PATIENCE", 0.01)
    other = sqlite3.connect(store.path, isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    with pytest.raises(OSError, match=r"locked: results cannot be stored there$"):
        store.store("sweep", "ring", {"b": b"1"})
    other.close()


def write_many(folder, name):
    for n in range(40):
        Store(folder).store(name, "ring", {f"{n}": bytes(100)})


def test_processes_at_once_lose_nothing(tmp_path):
    context = multiprocessing.get_context("fork")
    writers = [context.Process(target=write_many, args=(tmp_path, f"kind {k}")) for k in range(8)]
    for one in writers:
        one.start()
    for one in writers:
        one.join()
    assert [g.entries for g in Store(tmp_path).groups()] == 8 * [40]


def begin(folder, barrier, name):
    barrier.wait()
    Store(folder).store(name, "ring", {"a": b"1"})


def test_processes_that_begin_a_file_at_once_wait_for_each_other(tmp_path):
    context = multiprocessing.get_context("fork")
    barrier = context.Barrier(8)
    names = [f"kind {k}" for k in range(8)]
    writers = [context.Process(target=begin, args=(tmp_path, barrier, name)) for name in names]
    for one in writers:
        one.start()
    for one in writers:
        one.join()
    assert [one.exitcode for one in writers] == 8 * [0]
    assert [group.kind for group in Store(tmp_path).groups()] == names


def test_what_cannot_be_written_can_be_read(store, monkeypatch):
    store.store("sweep", "ring", {"a": b"1"})

    def refused(*_):
        raise sqlite3.OperationalError("attempt to write a readonly database")

    monkeypatch.setattr("verify.core.database._write_ahead", refused)
    assert store.load("sweep", ["a"]) == {"a": b"1"}
    assert [group.entries for group in store.groups()] == [1]
    with pytest.raises(OSError, match=r"readonly database: results cannot be stored there$"):
        store.store("sweep", "ring", {"b": b"1"})
    with pytest.raises(OSError, match=r"readonly database"):
        store.check()


def test_a_file_that_others_write_is_not_read_without_locks(store, monkeypatch):
    store.store("sweep", "ring", {"a": b"1"})
    connect = sqlite3.connect

    def refused(path, **options):
        if "immutable" not in str(path):
            raise sqlite3.OperationalError("unable to open database file")
        return connect(path, **options)

    monkeypatch.setattr("verify.core.database.sqlite3.connect", refused)
    assert store.load("sweep", ["a"]) == {"a": b"1"}
    store.path.with_name(f"{FILE}-wal").write_bytes(b"of another process")
    with pytest.raises(OSError, match="unable to open"):
        store.load("sweep", ["a"])


def test_a_full_disk_is_named_with_what_to_do(store, monkeypatch):
    def full(*_):
        raise sqlite3.OperationalError("database or disk is full")

    monkeypatch.setattr("verify.core.database._write_ahead", full)
    with pytest.raises(OSError, match=r"make room on its disk, or remove it to begin again$"):
        store.store("sweep", "ring", {"a": b"1"})


def test_arrays_survive():
    arrays = {"N": np.arange(3.0), "p": np.ones((2, 2))}
    again = unpacked(packed(arrays))
    assert all(np.array_equal(arrays[name], again[name]) for name in arrays)


def test_the_command_lists_and_clears(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    Store(tmp_path).store("budget", "ring-lame", {"a": bytes(2_000_000)})
    Store(tmp_path).store("level", "ring-lame", {"b": bytes(1_000_000)})
    assert run(["store"]) == 0
    out = capsys.readouterr().out
    assert "2 results, 3.0 MB" in out
    assert run(["store", "--json"]) == 0
    groups = json.loads(capsys.readouterr().out)["groups"]
    assert {(g["kind"], g["subject"], g["size"]) for g in groups} == {
        ("level", "ring-lame", 1_000_000), ("budget", "ring-lame", 2_000_000),
    }  # fmt: skip
    assert run(["store", "--clear", "budgets"]) == 2
    assert "kinds: budget, level" in capsys.readouterr().err
    assert run(["store", "--clear", "budget:ring-lame"]) == 0
    assert run(["store", "--clear", "level"]) == 0
    assert "0 results" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["ring-lame", "--json"], "store ring-lame: --json and --clear go without a case"),
        (["--clear", "level:"], "--clear level:: no subject after the colon"),
        (["--code", "numpy.linalg"], "--code numpy.linalg: no module of the project"),
        (["--code", "fem.plane"], "--code fem.plane: is a package: name one of its modules"),
        (["ring-lame", "--code", "fem.plane.solve"], "a case or a module, one of them"),
    ],
)
def test_options_that_make_no_sense_are_refused(arguments, message, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    Store(tmp_path).store("level", "ring-lame", {"a": b"1"})
    assert run(["store", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert Store(tmp_path).one("level", "a")


def test_the_origin_of_a_case_s_numbers_is_listed(capsys, tmp_path, monkeypatch):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    case = find("ring-lame")
    key = cache.key(case, case.inputs(), case.levels[0])
    Store(tmp_path).store("level", "ring-lame", {key: bytes(1_500_000)})
    Store(tmp_path).store("sweep formulas", "ring-lame", {"a": b"1"})
    assert run(["store", "ring-lame"]) == 0
    out = capsys.readouterr().out
    assert re.search(rf"\n  2 +{key}  {time.strftime('%Y-')}.*, 1\.5 MB\n", out)
    assert re.search(r"\n  4 +[0-9a-f]{32}  not stored", out)
    assert "sweep formulas: 1 results of any code" in out
    assert re.search(r"20..-..-.., of this code  verify/measured/validity/ring-lame.json", out)
    assert run(["store", "no-case"]) == 2


def test_the_cases_of_a_module_are_listed(capsys, monkeypatch):
    monkeypatch.chdir(Path(__file__).parents[2])
    monkeypatch.setattr(origin, "CASES", [find("ring-lame")])  # hashing all takes seconds
    assert run(["store", "--code", "analytic/ring/lame.py"]) == 0
    formulas, reference, *_ = capsys.readouterr().out.splitlines()
    assert "ring-lame" in formulas
    assert "ring-lame" not in reference


def test_files_of_an_earlier_version_keep_their_dates(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    (tmp_path / "ring-lame").mkdir()
    path = tmp_path / "ring-lame" / f"{'0a' * 16}.npz"
    path.write_bytes(packed({"head": np.array("{}")}))
    os.utime(path, (1e9, 1e9))
    assert run(["store", "--json"]) == 0
    said = capsys.readouterr()
    assert said.err.startswith("freewheel: 1 results of an earlier version were moved into")
    (group,) = json.loads(said.out)["groups"]
    assert (group["kind"], group["subject"], group["oldest"]) == ("level", "ring-lame", 1e9)
    assert not path.parent.exists()


def test_other_files_in_the_folder_of_the_store_stay(tmp_path, monkeypatch):
    """Someone may name a folder that holds more than the store."""
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path))
    name = f"{'0a' * 16}.npz"
    files = {"pictures/a.jpg": b"a picture", f"pictures/{name}": packed({"head": np.zeros(1)}),
             f"photos/{name}": b"no level", f"arrays/{name}": packed({"x": np.zeros(1)}),
             "ring-lame/.part-x": b"half"}  # fmt: skip
    for place, content in files.items():
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_bytes(content)
    assert run(["store"]) == 0
    assert {place: (tmp_path / place).read_bytes() for place in files} == files
    assert Store(tmp_path).groups() == []
