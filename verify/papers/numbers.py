"""Equation numbers in a text."""

import re

_NUMBERS = re.compile(r"Eqs?\. ([\d, and-]*\d)")


def numbers(text: str) -> frozenset[int]:
    """Numbers of the equations that a text names: "Eqs. 6, 8-10" gives 6, 8, 9 and 10.

    >>> sorted(numbers("Eqs. 6, 8-10 and 12"))
    [6, 8, 9, 10, 12]
    """
    found: set[int] = set()
    for given in _NUMBERS.findall(text.replace("–", "-")):
        for part in re.split(r", | and ", given):
            first, _, last = part.strip(" ,").partition("-")
            if first.isdecimal():
                found.update(range(int(first), int(last or first) + 1))
    return frozenset(found)
