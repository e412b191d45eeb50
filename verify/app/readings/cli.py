"""Command line of `freewheel search`."""

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
    """Find the interpretation of a formula that reproduces a printed number.

    A reading is an interpretation of an input or formula: a symbol can be a radius or a
    diameter, a state can be plane stress or plane strain. The command tries all combinations of
    readings, and states how many of them would fit by chance. Exit status 0: the formula or a
    reading reproduces the number; 1: no reading does.

    Parameters
    ----------
    name
        A published number or erratum with listed readings (such as wang2023:k1-theory), a row
        (CASE/row), or a case with --key and --printed.
    key
        Key of a value of the formulas, see `freewheel check --keys`.
    printed
        The number with all its printed digits, which determine its accuracy.
    unit
        Unit of the number; by default the unit of the value in the case.
    file
        Parameter file of the case; by default the inputs of the paper.
    changes
        Largest number of readings in a combination, 1 to 3. With 0, the
        limit declared with the published number or erratum is used, or 2 if there is none.
    rounded
        Treat the paper's inputs as rounded to their last printed digit, not as exact.
    json
        Print JSON instead of text.
    """
    from verify.app.readings.command import run_search

    return run_search(
        name, key=key, printed=printed, unit=unit, file=file, changes=changes, rounded=rounded,
        as_json=json,
    )  # fmt: skip
