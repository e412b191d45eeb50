"""Names of rows in earlier versions, of which `renamed.toml` holds the parts that have changed."""

import tomllib
from functools import cache
from pathlib import Path

FILE = Path(__file__).with_name("renamed.toml")


@cache
def _parts() -> tuple[tuple[str, str], ...]:
    """Parts of names as they were and as they are, in the order in which they apply."""
    listed = tomllib.loads(FILE.read_text("utf-8"))["renamed"]
    return tuple((one["was"], one["now"]) for one in listed)


def present_name(name: str) -> str:
    """What a row of an earlier version is called now.

    >>> present_name("freewheel-torque/way of the rollers (Eq. 6)")
    'freewheel-torque/travel of the rollers (Eq. 6)'
    """
    for was, now in _parts():
        name = name.replace(was, now)
    return name


def former_name(name: str) -> str:
    """What a row was called before, to search by old words; one of them where there are several.

    >>> former_name("freewheel-torque/travel of the rollers (Eq. 6)")
    'freewheel-torque/way of the rollers (Eq. 6)'
    """
    for was, now in reversed(_parts()):
        name = name.replace(now, was)
    return name
