"""A file that takes longer than the ledger says, and a slow test without a reason, are found."""

import json

import pytest

from tests import seconds


@pytest.fixture
def run(tmp_path, monkeypatch):
    """A whole run of three files, of which the ledger has 20 s, 10 s and 3 s."""
    ledger = tmp_path / "seconds.json"
    ledger.write_text(json.dumps({"a.py": 20.0, "b.py": 10.0, "d.py": 3.0}))
    monkeypatch.setattr(seconds, "LEDGER", ledger)
    monkeypatch.setattr(seconds, "slow", {})

    def made(d=3.0, **spent):
        monkeypatch.setattr(
            seconds, "spent", {f"{k}.py::test_{k}": v for k, v in (spent | {"d": d}).items()}
        )
        return seconds.faults()

    return made


def test_a_run_like_the_ledger_has_no_faults(run):
    seconds.slow.update({"a.py::test_a": "a whole case", "b.py::test_b": "a whole case"})
    assert run(a=20.0, b=10.0) == []
    assert run(a=60.0, b=30.0, d=9.0) == [], "a machine of a third of the speed"


def test_a_file_that_has_grown_is_named(run):
    seconds.slow.update({"a.py::test_a": "a whole case", "b.py::test_b": "a whole case"})
    (line,) = run(a=20.0, b=60.0)
    assert line.startswith("b.py: 60 s")
    seconds.slow["c.py::test_c"] = "new"
    (line,) = run(a=20.0, b=10.0, c=15.0)
    assert line.startswith("c.py: 15 s, 10 s expected")


def test_a_slow_test_states_its_reason(run):
    seconds.slow["a.py::test_a"] = "a whole case"
    (line,) = run(a=20.0, b=10.0)
    assert line.startswith("b.py::test_b: 10 s without a mark")


def test_a_run_of_a_part_has_no_faults(run):
    assert run(a=300.0) == []
