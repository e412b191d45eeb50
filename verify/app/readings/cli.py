"""How `freewheel search` is called."""

from pathlib import Path


def search(
    name: str,
    /,
    *,
    key: str = "",
    printed: str = "",
    unit: str = "",
    file: Path | None = None,
    changes: int = 0,
    rounded: bool = False,
    json: bool = False,
) -> int:
    """Find which reading gives a printed number: diameter or radius, half or whole, and so on.

    Every combination of a few readings is tried, and told is how many would fit by accident. Exit
    status 0 where one reproduces the number, 1 where none does.

    Parameters
    ----------
    name
        A published number or erratum with readings of its own (wang2023:k1-theory), a row
        (CASE/row), or a case with --key and --printed.
    key
        Formula value of the case, see `freewheel check --json`.
    printed
        The number with all digits as it is printed, for they say how exact it is.
    unit
        Its unit, by default that in which the case shows the value.
    file
        Parameter file of the case; by default the paper's numbers.
    changes
        Readings at once, 1 to 3; by default 2, or as many as a number's own search has.
    rounded
        Take the paper's inputs as rounded to their last printed digit, not as exact.
    json
        Print JSON instead of text.
    """
    from verify.app.readings.command import run_search

    return run_search(
        name, key=key, printed=printed, unit=unit, file=file, changes=changes, rounded=rounded,
        as_json=json,
    )  # fmt: skip
