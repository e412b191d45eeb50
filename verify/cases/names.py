"""Names of rows in earlier versions; `renamed.toml` lists the changed parts of the names."""

import tomllib
from functools import cache
from pathlib import Path

FILE = Path(__file__).with_name("renamed.toml")


@cache
def _parts() -> tuple[tuple[str, str], ...]:
    """Earlier and present parts of names, as pairs in the order in which they are applied."""
    listed = tomllib.loads(FILE.read_text("utf-8"))["renamed"]
    return tuple((one["was"], one["now"]) for one in listed)


def present_name(name: str) -> str:
    """Present name of the row that was called `name` in an earlier version.

    >>> present_name("freewheel-torque/torsion, Eq. 7 as printed")
    'freewheel-torque/wind-up, Eq. 7 as printed'
    """
    for was, now in _parts():
        name = name.replace(was, now)
    return name


def former_name(name: str) -> str:
    """An earlier name of the row `name`, for searches by old words; not necessarily the only one.

    >>> former_name("freewheel-torque/wind-up, Eq. 7 as printed")
    'freewheel-torque/torsion, Eq. 7 as printed'
    """
    for was, now in reversed(_parts()):
        name = name.replace(now, was)
    return name
