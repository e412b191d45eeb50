"""Readable names of errata, derived from their keys in the ledgers."""

import re

_PLACE = re.compile(r"(eq|eqs|fig|sec|table)-((?:\d+-)+)")
_SYMBOL = re.compile(r"\b([a-z])-([a-z])\b")
KINDS = {"eq": "Eq", "eqs": "Eq", "fig": "Fig", "sec": "Sec", "table": "Table"}


def erratum_name(key: str) -> str:
    """Name of an erratum with its place and subject.

    >>> erratum_name("eq-9-axial-force-per-roller"), erratum_name("eq-3-4-5-first-index")
    ('Eq. 9: axial force per roller', 'Eqs. 3, 4, 5: first index')
    >>> erratum_name("sec-4-2-z-m-trend"), erratum_name("table-1-radii"), erratum_name("arc-radius")
    ('Sec. 4.2: z_m trend', 'Table 1: radii', 'arc radius')
    """
    place = _PLACE.match(key)
    subject = _SYMBOL.sub(r"\1_\2", key[place.end() :] if place else key).replace("-", " ")
    return f"{_words(place[1], place[2].split('-')[:-1])}: {subject}" if place else subject


def _words(kind: str, numbers: list[str]) -> str:
    if kind == "sec":
        return f"Sec. {'.'.join(numbers)}"
    plural = "s" if len(numbers) > 1 else ""
    mark = "" if kind == "table" else "."
    return f"{KINDS[kind]}{plural}{mark} {', '.join(numbers)}"
