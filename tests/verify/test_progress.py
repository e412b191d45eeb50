"""What a run says while it works."""

import io
import os
from contextlib import suppress
from itertools import pairwise

import pytest

from verify.core.progress import EVERY, FIRST, Lines, State, duration, line, shown

BUSY = State(12, 48, ("spring-continuum level 8",), 14.2)


def test_a_line_says_what_is_solved_and_how_long_it_takes():
    assert line(BUSY) == "refinement levels 12 of 48, spring-continuum level 8, about 14 s left"


def test_a_line_names_two_levels_at_most():
    names = ("a level 8", "b level 4", "c level 2", "d level 1")
    assert "a level 8, b level 4 and 2 more, about" in line(State(0, 4, names, 1.0))


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0.0, "1 s"), (14.4, "14 s"), (89.0, "89 s"), (90.0, "2 min"), (3540.0, "59 min"),
     (3600.0, "1 h 0 min"), (4800.0, "1 h 20 min")],
)  # fmt: skip
def test_durations_are_rounded(seconds, words):
    assert duration(seconds) == words


def lines_of(times, state=BUSY):
    """Times at which a line is printed, of states shown at `times`."""
    now = [0.0]
    stream, printed = io.StringIO(), []
    lines = Lines(lambda: now[0], stream)
    for now[0] in times:
        before = stream.tell()
        lines(state)
        if stream.tell() > before:
            printed.append(now[0])
    return printed


def test_lines_come_at_most_every_few_seconds():
    printed = lines_of([t / 4 for t in range(200)])
    assert printed[0] == FIRST
    assert {b - a for a, b in pairwise(printed)} == {EVERY}


def test_a_short_run_says_nothing():
    assert lines_of([t / 4 for t in range(int(4 * FIRST))]) == []


def test_nothing_is_said_when_nothing_is_solved():
    assert lines_of([0.0, 10.0, 20.0], State(12, 12, (), 0.0)) == []


def test_a_quiet_run_says_nothing(capsys):
    with shown(quiet=True) as show:
        show(BUSY)
    assert capsys.readouterr() == ("", "")


def everything(terminal):
    """What can be read of it: a terminal hands out several writes one by one."""
    text = b""
    with suppress(BlockingIOError):
        while read := os.read(terminal, 100_000):
            text += read
    return text.decode()


def test_on_a_terminal_a_bar_appears_with_the_first_level_and_goes_with_the_last(monkeypatch):
    ours, theirs = os.openpty()
    with os.fdopen(theirs, "w") as terminal:
        monkeypatch.setattr("sys.stderr", terminal)
        monkeypatch.setenv("TERM", "xterm")
        monkeypatch.setenv("COLUMNS", "120")
        with shown(quiet=False):
            pass
        terminal.flush()
        os.set_blocking(ours, False)
        with pytest.raises(BlockingIOError):  # nothing was written
            os.read(ours, 10_000)
        with shown(quiet=False) as show:
            show(BUSY)
        terminal.flush()
        text = everything(ours)
    os.close(ours)
    for word in ("12/48", "about 14 s left", "spring-continuum level 8"):
        assert word in text
