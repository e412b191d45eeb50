"""Lines that are longer than the width of the terminal."""

import sys

from verify.core.terminal import print_wrapped, wrapped


def test_a_long_last_cell_is_wrapped_below_itself():
    line = "  ok  margin 2.0  " + "one two three four " * 3
    found = wrapped(line.rstrip(), 50)
    assert [part.rstrip() for part in found] == [
        "  ok  margin 2.0  one two three four one two three",
        "                  four one two three four",
    ]


def test_a_long_sentence_is_set_in_and_a_short_line_or_a_pipe_stays(monkeypatch, capsys):
    line = "  " + "word " * 12 + "end"
    parts = wrapped(line, 40)
    assert all(len(part) <= 40 for part in parts)
    assert parts[1].startswith("      word")
    assert wrapped(line, 100) == wrapped(line, 0) == [line]
    monkeypatch.setenv("COLUMNS", "40")
    print_wrapped(line)
    assert capsys.readouterr().out == f"{line}\n"
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    print_wrapped(line)
    assert capsys.readouterr().out.splitlines() == parts


def test_no_line_ends_within_a_number_with_its_unit():
    line = "a text with 34 characters and then b = 3.9984 mm, T = 25 N m and 26 % of Eq. 3"
    for columns in range(40, 78):
        parts = wrapped(line, columns)
        assert " ".join(part.strip() for part in parts) == line
        ends = [part.split()[-1] for part in parts[:-1]]
        assert not {"b", "=", "3.9984", "T", "25", "N", "26", "Eq."} & set(ends)
