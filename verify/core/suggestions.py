"""Suggestions of known names for an unknown name."""

from collections.abc import Iterable
from difflib import get_close_matches

FEW = 6  # names that a line has room for
LIKE = 0.4  # of difflib's ratio: below, names have nothing in common


def nearest(name: str, known: Iterable[str], *, most: int = FEW, between: str = ", ") -> str:
    """Text with at most `most` known names, and the number of the other known names.

    Names similar to `name` are first.
    """
    every = list(known)
    like = get_close_matches(name, every, n=most, cutoff=LIKE)
    order = [*like, *(one for one in every if one not in like)]
    more = f" and {len(order) - most} more" if len(order) > most else ""
    return f"{between.join(order[:most])}{more}"
