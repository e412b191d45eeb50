"""Figures and pictures are drawn while cases are solved, and a failure stops nothing."""

from types import SimpleNamespace

import pytest

from reports import ahead
from reports.ahead import Ahead


def case(name, pictures):
    return SimpleNamespace(id=name, pictures=range(pictures), figures=())


@pytest.fixture
def drawn(monkeypatch):
    """The cases of each process of pyvista, of which the first fails."""
    found = []

    def frames(cases, _folder, _hint):
        found.append([one.id for one in cases])
        if len(found) == 1:
            raise OSError("no room")

    monkeypatch.setattr(ahead, "frames", frames)
    return found


def test_pictures_are_drawn_together_and_those_of_the_last_cases_at_once(drawn, tmp_path):
    done = []

    def first():
        done.append("read")
        raise ValueError("of other work")

    counts = (5, 3, 9, 1, 0, 2)
    with Ahead(len(counts) + 1, tmp_path, "", first) as pictures:
        for n, count in enumerate(counts):
            pictures.add(case(f"case {n}", count))
    assert done == ["read"]
    assert drawn == [["case 0", "case 1"], ["case 2"], ["case 3", "case 4"], ["case 5"]]


def test_an_interrupted_run_does_not_wait(drawn, tmp_path):
    waiting = SimpleNamespace(is_over=False)

    def first():
        while not waiting.is_over:
            pass

    with pytest.raises(KeyboardInterrupt), Ahead(1, tmp_path, "", first):
        raise KeyboardInterrupt
    waiting.is_over = True
    assert drawn == []
