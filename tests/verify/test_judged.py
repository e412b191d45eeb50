"""Stored judged cases and parts of a report are read back unchanged, or not at all."""

import pickle
from dataclasses import replace

import numpy as np
import pytest

from verify.app.parts import Parts
from verify.cases.registry import CASES
from verify.core import pickled
from verify.core.results import Status
from verify.core.store import Store
from verify.jobs import judged
from verify.jobs.level import Job
from verify.jobs.scheduler import run

NAME = "ring-lame"


@pytest.fixture(autouse=True)
def without_judged():
    """Here they have keys."""


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    """A store with the levels of a case, the case as a job, and its result."""
    folder = tmp_path_factory.mktemp("judged")
    case = CASES.named(NAME)
    job = Job(case, case.inputs())
    (found,) = run([job], cache_folder=folder)
    return folder, job, found


def test_a_result_comes_back_for_its_key_with_its_rows_figures_and_fields(result, tmp_path):
    folder, job, before = result
    judged.keep(folder, job, before, "key")
    found = judged.load(folder, {NAME: "key"})[NAME]
    assert found.result.rows == before.rows
    assert found.result.cached
    assert len(found.levels) == len(CASES.named(NAME).levels)
    assert np.array_equal(found.result.figures[0].y, before.figures[0].y)
    assert [f.name for f in found.result.fields] == [f.name for f in before.fields]
    assert np.array_equal(found.result.fields[-1].points, before.fields[-1].points)
    assert found.result.cells == {f.name: len(f.cells) for f in before.fields}
    # another key, a torn entry and one whose levels are gone are none
    assert judged.load(folder, {NAME: "other"}) == {}
    content = Store(folder).one(judged.KIND, "key")
    elsewhere = Store(tmp_path)
    elsewhere.store(judged.KIND, NAME, {"key": content})
    assert judged.load(tmp_path, {NAME: "key"}) == {}  # it has no level
    elsewhere.store(judged.KIND, NAME, {"key": content[: len(content) // 2]})
    assert judged.load(tmp_path, {NAME: "key"}) == {}
    assert judged.load(tmp_path / "none", {NAME: "key"}) == {}


def test_a_result_with_an_error_or_without_its_levels_is_not_stored(result, tmp_path):
    folder, job, found = result
    judged.keep(folder, job, replace(found, errors=("a traceback",)), "other")
    judged.keep(tmp_path, job, found, "other")
    for place in (folder, tmp_path):
        assert Store(place).one(judged.KIND, "other") is None


def test_a_key_follows_the_files_of_the_case_and_the_libraries(monkeypatch):
    modules = {NAME: CASES.module_of(NAME)}
    before = judged.keys(modules)
    assert judged.keys(modules) == before
    monkeypatch.setattr(judged, "version", lambda _name: "9")
    assert judged.keys(modules) != before
    monkeypatch.undo()
    monkeypatch.setattr(judged, "digest_of", lambda *_modules: "of other files")
    assert judged.keys(modules) != before


def test_only_results_are_read(tmp_path):
    values = [{"a": (1, 2.5, None)}, np.arange(3.0), np.float64(2.0), Status.PASS]
    for value in values:
        found = pickled.from_bytes(pickled.to_bytes(value))
        assert np.array_equal(found, value) if isinstance(value, np.ndarray) else found == value
    for other in (tmp_path, print, pickle.dumps):
        with pytest.raises(pickle.UnpicklingError):
            pickled.from_bytes(pickle.dumps(other))


def made(parts, calls, *, module="verify.judging.judge"):
    """Parts of two cases, with a note of each that is made."""
    return parts.of_cases("part", module, ["a", "b"], lambda name: calls.append(name) or name * 2)


def test_a_part_is_made_once_for_a_key_and_a_module_and_without_a_store_each_time(tmp_path):
    calls = []
    keys = {"a": "1", "b": "2"}
    for _ in range(2):
        assert made(Parts(tmp_path, keys), calls) == {"a": "aa", "b": "bb"}
    assert calls == ["a", "b"]
    made(Parts(tmp_path, keys | {"b": "3"}), calls)
    made(Parts(tmp_path, {"a": "1"}), calls)
    assert calls[2:] == ["b", "b"]
    for other in (Parts(), Parts(None, keys)):
        made(other, calls)
        made(other, calls)
    assert calls[4:] == ["a", "b"] * 4
    made(Parts(tmp_path, keys), calls, module="verify.judging.claims")
    assert calls[12:] == ["a", "b"]


def test_a_part_of_all_cases_follows_each(tmp_path):
    calls = []
    for key in ("2", "2", "3"):
        parts = Parts(tmp_path, {"a": "1", "b": key})
        parts.of_all("all", "verify.judging.judge", ["a", "b"], lambda: calls.append(1))
    assert len(calls) == 2
