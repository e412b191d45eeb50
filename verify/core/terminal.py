"""Printing of lines on a terminal: long lines are wrapped to its width, piped lines are not."""

import re
import shutil
import sys
import textwrap

LEAST = 40  # columns
ROOM = 30  # columns at least, for the last cell of a table
INSET = 4
_GAP = re.compile(r"(?<=\S) {2,}(?=\S)")
# spaces of "b = 3.9 mm", "25 N m" and "26 %", where no line may end
_WHOLE = re.compile(
    r"(?<=\d) (?=(?:[µmk]?m|µm|k?N|[GM]?Pa|kg|s|Hz|J|rad|deg|r/min|in|lbf|ksi|%)(?![\w]))"
    r"|(?<=[\d ]N) (?=mm?(?!\w))| (?==)|(?<==) |(?<=≤|≥|±) | (?=±)|(?<=Eq\.) (?=\d)"
)
_SPACE = "\u00a0"


def print_wrapped(*lines: str) -> None:
    """Print lines, each wrapped to the width of the terminal."""
    columns = width()
    for line in lines:
        print("\n".join(wrapped(line, columns)))


def width() -> int:
    """Number of columns of the terminal; 0 if the output is a file or a pipe."""
    if sys.stdout.isatty():
        return max(shutil.get_terminal_size().columns, LEAST)
    return 0


def wrapped(line: str, columns: int) -> list[str]:
    """A line as parts of at most `columns` columns.

    In a line of a table, the last cell is continued below its beginning.
    """
    if not columns or len(line) <= columns:
        return [line]
    inset = len(line) - len(line.lstrip()) + INSET
    starts = [gap.end() for gap in _GAP.finditer(line) if gap.end() <= columns - ROOM]
    parts = textwrap.wrap(
        _WHOLE.sub(_SPACE, line), columns,
        subsequent_indent=" " * (starts[-1] if starts else inset),
        break_on_hyphens=False, break_long_words=False,
    )  # fmt: skip
    return [part.replace(_SPACE, " ") for part in parts]
