"""Figures and pictures are drawn while cases are solved, and a failure stops nothing."""

from types import SimpleNamespace

import pytest

from reports import ahead
from reports.ahead import Ahead


def case(name):
    return SimpleNamespace(id=name, figures=())


@pytest.fixture
def drawn(monkeypatch):
    """The cases that were drawn, each with the process; the first fails."""
    found = []

    def frames(cases, _folder, _hint, process):
        found.append(([one.id for one in cases], process))
        if len(found) == 1:
            raise OSError("no room")

    monkeypatch.setattr(ahead, "frames", frames)
    return found


def test_each_case_is_drawn_as_it_comes_by_one_process(drawn, tmp_path):
    done = []

    def first():
        done.append("read")
        raise ValueError("of other work")

    with Ahead(tmp_path, "", first) as pictures:
        for n in range(3):
            pictures.add(case(f"case {n}"))
    assert done == ["read"]
    assert [names for names, _ in drawn] == [["case 0"], ["case 1"], ["case 2"]]
    assert len({id(process) for _, process in drawn}) == 1


def test_an_interrupted_run_does_not_wait(drawn, tmp_path):
    waiting = SimpleNamespace(is_over=False)

    def first():
        while not waiting.is_over:
            pass

    with pytest.raises(KeyboardInterrupt), Ahead(tmp_path, "", first):
        raise KeyboardInterrupt
    waiting.is_over = True
    assert drawn == []
