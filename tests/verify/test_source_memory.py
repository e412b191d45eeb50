"""Hashes of sources are stored while no file of the project changes, for its functions alone."""

import pytest

from analytic.ring import lame
from verify.core import source_memory


@pytest.fixture
def memory(tmp_path, monkeypatch):
    """A memory in a folder of its own, as another process would find it after `keep`."""
    monkeypatch.setattr(source_memory, "_used", [])

    def begun():
        source_memory._used[:] = [source_memory.Memory(tmp_path)]
        return source_memory._used[0]

    return begun


def counted():
    """A function that returns how often it was called."""
    calls = []
    return lambda: calls.append(1) or len(calls)


def test_what_was_found_is_found_by_the_next_process(memory):
    make = counted()
    before = memory()
    assert source_memory.remembered("x", lame.stresses, make) == 1
    before.keep()
    memory()
    assert source_memory.remembered("x", lame.stresses, make) == 1
    assert source_memory.remembered("y", lame.stresses, make) == 2


def test_nothing_is_remembered_after_a_file_has_changed(memory, monkeypatch):
    make = counted()
    before = memory()
    source_memory.remembered("x", lame.stresses, make)
    before.keep()
    monkeypatch.setattr(source_memory, "digest", lambda: "of other files")
    memory()
    assert source_memory.remembered("x", lame.stresses, make) == 2


@pytest.mark.parametrize("change", ["content", "name", "new"])
def test_the_digest_follows_every_file(tmp_path, monkeypatch, change):
    monkeypatch.setattr(source_memory, "ROOT", tmp_path)
    folder = tmp_path / "fem" / "plane"
    folder.mkdir(parents=True)
    file = folder / "solve.py"
    file.write_text("a = 1\n")
    digest = source_memory.digest.__wrapped__
    before = digest()
    if change == "content":
        file.write_text("a = 2\n")
    elif change == "name":
        file.rename(folder / "solves.py")
    else:
        (folder / "data.toml").write_text("")
    assert digest() != before


def test_what_a_run_writes_does_not_count(tmp_path, monkeypatch):
    monkeypatch.setattr(source_memory, "ROOT", tmp_path)
    digest = source_memory.digest.__wrapped__
    before = digest()
    for name in ("reports/out", "fem/__pycache__"):
        (tmp_path / name).mkdir(parents=True)
        (tmp_path / name / "file").write_text("x")
    assert digest() == before
