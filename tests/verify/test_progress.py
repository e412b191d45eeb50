"""Progress messages of a run."""

import io
import os
import sys
from itertools import pairwise

from verify.core.progress import EVERY, FIRST, Lines, State, duration, line, shown

BUSY = State(12, 48, ("spring-continuum level 8",), 14.2)


def test_a_line_states_what_is_solved_and_how_long_it_takes():
    assert line(BUSY) == "refinement levels 12 of 48, spring-continuum level 8, about 14 s left"
    seconds = {0.0: "1 s", 89.0: "89 s", 90.0: "2 min", 4800.0: "1 h 20 min"}
    assert {number: duration(number) for number in seconds} == seconds
    names = ("a level 8", "b level 4", "c level 2", "d level 1")
    assert "a level 8, b level 4 and 2 more, about" in line(State(0, 4, names, 1.0))


def lines_of(times, state=BUSY):
    """Times at which a line is printed, of states at `times`."""
    now, stream, printed = [0.0], io.StringIO(), []
    lines = Lines(lambda: now[0], stream)
    for now[0] in times:
        before = stream.tell()
        lines(state)
        if stream.tell() > before:
            printed.append(now[0])
    return printed


def test_lines_come_at_most_every_few_seconds_and_none_in_a_short_run():
    printed = lines_of([t / 4 for t in range(200)])
    assert printed[0] == FIRST
    assert {b - a for a, b in pairwise(printed)} == {EVERY}
    assert lines_of([t / 4 for t in range(int(4 * FIRST))]) == []
    assert lines_of([0.0, 10.0, 20.0], State(12, 12, (), 0.0)) == []  # nothing is solved


def test_in_a_notebook_one_line_is_rewritten_and_removed_at_the_end(monkeypatch):
    monkeypatch.setitem(sys.modules, "ipykernel", io)
    monkeypatch.setattr("sys.stderr", io.StringIO())
    with shown(quiet=False) as show:
        for state in (State(0, 48, (), 0.0), BUSY, State(24, 48, ("ring level 4",), 5.0)):
            show(state)
    _, first, second, removed, end = sys.stderr.getvalue().split("\r")
    assert first == f"[####            ] {line(BUSY)}"
    assert second.rstrip().startswith("[########        ] refinement levels 24 of 48, ring level 4")
    assert (removed, len(second), end) == (" " * len(first), len(first), "")


def test_on_a_terminal_a_bar_appears_with_the_first_level_unless_quiet(monkeypatch):
    found = []
    for quiet, states in ((False, [BUSY]), (True, [BUSY]), (False, [])):
        ours, theirs = os.openpty()
        with os.fdopen(theirs, "w") as terminal:
            monkeypatch.setattr("sys.stderr", terminal)
            monkeypatch.setenv("TERM", "xterm")
            monkeypatch.setenv("COLUMNS", "120")
            with shown(quiet=quiet) as show:
                for state in states:
                    show(state)
            terminal.write("end")
        text = b""
        while not text.endswith(b"end"):  # a terminal hands out several writes one by one
            text += os.read(ours, 100_000)
        os.close(ours)
        found.append(text)
    for word in (b"12/48", b"about 14 s left", b"spring-continuum level 8"):
        assert word in found[0]
    assert found[1:] == [b"end"] * 2
