"""Compare two outputs of the suite: results.json, or the output of `list`, `check` and `sweep`.

    python -m tools.same_rows BEFORE AFTER
    python -m tools.same_rows BEFORE AFTER --other-machine
    python -m tools.same_rows BEFORE AFTER --renamed names.toml

Rows, their order, statuses, kinds and texts must be equal, and numbers must be equal bit for bit.
With --other-machine, a number of a row may differ by the numerical error of this row, and an
estimate of an error may differ by a factor of two; numbers in texts are not compared. A file of
names has an array `renamed` of tables with `was` and `now`; they apply to the texts of BEFORE.
Exit status: 0 equal, 1 different, 2 a file cannot be read.
"""

import argparse
import json
import math
import re
import sys
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

IDENTIFIERS = ("id", "key", "name")  # fields that identify a record of a list
OF_THE_RUN = frozenset(("provenance", "seconds", "made", "date"))  # differ from run to run
ERRORS = ("u_num", "u_ref", "u_it", "tolerance")  # numerical errors of both sides of a row
ESTIMATES = frozenset((
    "u_num", "u_ref", "u_it", "u_input", "tolerance", "detects", "gci", "levels_u", "order", "used",
    "allowed",
))  # fmt: skip
DERIVED = frozenset(("difference",))  # computed from values that are compared
FACTOR = 2.0  # permitted ratio of two estimates of an error on different machines
UNSTATED = 1e-3  # relative tolerance of a number without a stated error: observed order, margin
NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")  # in a text
MOST_PRINTED = 40


@dataclass(frozen=True)
class Difference:
    """A position in the output, and its two values as text."""

    where: str
    was: str
    now: str

    def __str__(self) -> str:
        return f"{self.where}: {self.was} -> {self.now}"


@dataclass(frozen=True)
class Comparison:
    """Rule for equal numbers.

    If `exact`, numbers must be equal bit for bit. Otherwise, they may differ by `allowed`, the
    numerical error of the row.
    """

    exact: bool = True
    allowed: float = 0.0
    is_estimate: bool = False

    def differences(self, was: Any, now: Any, where: str = "") -> Iterator[Difference]:
        """Differences of two JSON values."""
        if isinstance(was, Mapping) and isinstance(now, Mapping):
            yield from self._records(was, now, where)
        elif isinstance(was, list) and isinstance(now, list):
            yield from self._lists(was, now, where)
        elif _are_numbers(was, now):
            if not self._is_equal_number(was, now):
                yield Difference(where, repr(was), repr(now))
        elif type(was) is not type(now) or self._text(was) != self._text(now):
            yield Difference(where, repr(was), repr(now))

    def _text(self, value: Any) -> Any:
        return value if self.exact or not isinstance(value, str) else NUMBER.sub("#", value)

    def _records(
        self, was: Mapping[str, Any], now: Mapping[str, Any], where: str
    ) -> Iterator[Difference]:
        allowed = max(self.allowed, _error(was))
        keys = [key for key in was if key not in OF_THE_RUN]
        found = [key for key in now if key not in OF_THE_RUN]
        yield from _names(keys, found, where)
        for key in keys:
            if key in now and (self.exact or key not in DERIVED):
                inner = Comparison(self.exact, allowed, self.is_estimate or key in ESTIMATES)
                yield from inner.differences(was[key], now[key], f"{where}/{key}")

    def _lists(self, was: Sequence[Any], now: Sequence[Any], where: str) -> Iterator[Difference]:
        names, found = _identifiers(was), _identifiers(now)
        if names is None or found is None:
            if len(was) != len(now):
                yield Difference(f"{where} (length)", str(len(was)), str(len(now)))
            for i, (one, other) in enumerate(zip(was, now, strict=False)):
                yield from self.differences(one, other, f"{where}[{i}]")
            return
        yield from _names(names, found, where)
        others = dict(zip(found, now, strict=True))
        for name, one in zip(names, was, strict=True):
            if name in others:
                yield from self.differences(one, others[name], f"{where}[{name}]")

    def _is_equal_number(self, was: float, now: float) -> bool:
        if was == now or (math.isnan(was) and math.isnan(now)):
            return True
        if self.exact:
            return False
        small, large = sorted((abs(was), abs(now)))
        if self.is_estimate and small > 0 and large <= FACTOR * small:
            return True
        return abs(was - now) <= (self.allowed or UNSTATED * large)


def _are_numbers(*values: Any) -> bool:
    return all(isinstance(v, int | float) and not isinstance(v, bool) for v in values)


def _error(record: Mapping[str, Any]) -> float:
    """Numerical error stated in a record; 0 if none is stated."""
    stated = (record.get(key) for key in ERRORS)
    return max((float(u) for u in stated if _are_numbers(u)), default=0.0)


def _identifiers(records: Sequence[Any]) -> list[str] | None:
    """Identifiers of the records of a list; None if no field identifies them."""
    if not records or not all(isinstance(record, Mapping) for record in records):
        return None
    for key in IDENTIFIERS:
        names = [str(record.get(key)) for record in records]
        if len(set(names)) == len(names):
            return names
    return None


def _names(was: Sequence[str], now: Sequence[str], where: str) -> Iterator[Difference]:
    """Differences of two lists of names.

    These are the names in only one of the lists, and the first change of order.
    """
    known, found = set(was), set(now)
    yield from (Difference(f"{where}[{name}]", "present", "missing") for name in was
                if name not in found)  # fmt: skip
    yield from (Difference(f"{where}[{name}]", "absent", "added") for name in now
                if name not in known)  # fmt: skip
    common = [n for n in was if n in found], [n for n in now if n in known]
    for one, other in zip(*common, strict=False):
        if one != other:
            yield Difference(f"{where} (order)", one, other)
            return


def read(path: Path) -> Any:
    """Content of a file: JSON, or the lines of any other text."""
    text = path.read_text("utf-8")
    try:
        return json.loads(text)
    except ValueError:
        return text.splitlines()


def renamed(value: Any, names: Sequence[tuple[str, str]]) -> Any:
    """JSON value in which old names in texts are replaced by the new names."""
    if isinstance(value, str):
        for was, now in names:
            value = value.replace(was, now)
        return value
    if isinstance(value, list):
        return [renamed(one, names) for one in value]
    if isinstance(value, Mapping):
        return {renamed(k, names): renamed(v, names) for k, v in value.items()}
    return value


def main(arguments: Sequence[str] | None = None) -> int:
    """Print every difference and their number; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", type=Path)
    parser.add_argument("after", type=Path)
    parser.add_argument("--other-machine", action="store_true")
    parser.add_argument("--renamed", type=Path)
    given = parser.parse_args(arguments)
    try:
        names: list[tuple[str, str]] = []
        if given.renamed:
            listed = tomllib.loads(given.renamed.read_text("utf-8"))["renamed"]
            names = [(one["was"], one["now"]) for one in listed]
        was, now = renamed(read(given.before), names), read(given.after)
    except (OSError, ValueError, KeyError) as error:
        print(f"same_rows: {error}", file=sys.stderr)
        return 2
    found = list(Comparison(exact=not given.other_machine).differences(was, now))
    for one in found[:MOST_PRINTED]:
        print(one)
    print(f"{len(found)} differences" if found else "equal")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
