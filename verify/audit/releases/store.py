"""Judged rows of a release, stored as one small file for each version."""

import gzip
import json
import math
import re
import time
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from verify.core.files import write_whole
from verify.core.inputs import InputError
from verify.core.results import Kind, Row
from verify.judging.judge import COVERAGE

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[2]
ENDING = ".json.gz"
FORMAT = 1
EXACTLY = 15  # significant digits of values that are compared to round-off
ENOUGH = 9  # of all other data

_VERSION = re.compile(r"\d+(\.\d+)*")
EARLIER = {"required": "asked"}  # words of the records of version 0.1.0
_FIGURE = re.compile(r"(\d+(?:\.\d+)?) ?% (accepted|asked|required)|(accepted): (\d+(?:\.\d+)?) ?%")


@dataclass(frozen=True, kw_only=True)
class Kept:
    """Stored values of a row; dimensional numbers are in `unit`.

    `reference` is the value with which the formula is compared: that of finite elements, or that of
    another method. `figures` are the acceptance limits [%] in the text of a fact, each with
    "accepted" or "required". `accepted` is the limit of a difference, relative to the scale of the
    row.
    """

    kind: str
    status: str
    unit: str
    analytic: float | None = None
    reference: float | None = None
    difference: float | None = None
    scale: float | None = None
    tolerance: float | None = None
    u_num: float | None = None
    u_ref: float | None = None
    demand: float | None = None
    detects: float | None = None
    interval: tuple[float, float] | None = None
    figures: tuple[tuple[str, float], ...] = ()
    accepted: float | None = None

    @property
    def bound(self) -> float | None:
        """Permissible residual of a balance, relative to its scale."""
        if self.kind != "exact" or self.tolerance is None or not self.scale:
            return None
        return self.tolerance / self.scale


@dataclass(frozen=True, kw_only=True)
class Release:
    """A release: version, date and commit of its run, and its rows by id."""

    version: str
    date: str
    commit: str
    rows: Mapping[str, Kept]


def kept(row: Row) -> Kept:
    """Stored values of a row; numbers that are not finite are omitted."""
    low, high = row.interval or (math.nan, math.nan)
    limits = (_short(low), _short(high))
    return Kept(
        kind=row.kind.value, status=row.status.value, unit=row.unit,
        analytic=_short(row.analytic, EXACTLY), reference=_short(row.reference, EXACTLY),
        difference=_short(row.difference), scale=_short(row.scale, EXACTLY),
        tolerance=_short(row.tolerance), u_num=_short(row.u_num), u_ref=_short(row.u_ref),
        demand=_short(row.demand), detects=_short(row.detects),
        interval=None if limits[0] is None or limits[1] is None else (limits[0], limits[1]),
        figures=_figures(row.reason) if row.kind == "fact" else (),
        accepted=_short(_accepted(row)),
    )  # fmt: skip


def _accepted(row: Row) -> float | None:
    """Permissible difference, relative to the scale; None if no figure was stated beforehand.

    The numerical uncertainty is added, because the tolerance of the row does not contain it.
    """
    stated = row.kind is Kind.IDENTITY and row.grid is None and row.interval_source
    if not stated or row.tolerance is None or row.u_num is None or not row.scale:
        return None
    return (row.tolerance + COVERAGE * row.u_num) / row.scale


def _short(value: float | None, digits: int = ENOUGH) -> float | None:
    return float(f"{value:.{digits}g}") if value is not None and math.isfinite(value) else None


def _figures(words: str) -> tuple[tuple[str, float], ...]:
    """Acceptance limits in a text: "0.2% accepted", "accepted: 1%", "2% required"."""
    return tuple(
        (EARLIER.get(word, word), float(match[1] or match[4]))
        for match in _FIGURE.finditer(words) for word in (match[2] or match[3],)
    )  # fmt: skip


def version(root: Path = ROOT) -> str:
    """Version of the project in pyproject.toml."""
    found: str = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]["version"]
    return found


def path_of(name: str, folder: Path | None = None) -> Path:
    """Path of the file of a release."""
    return (folder or FOLDER) / f"{name}{ENDING}"


def store(rows: Sequence[Row], name: str, commit: str, folder: Path | None = None) -> Path:
    """Write a release and return its file; the bytes are identical for the same run and day."""
    by_case: dict[str, dict[str, Any]] = {}
    for row in rows:
        by_case.setdefault(row.case, {})[row.quantity] = _line(kept(row))
    data = {
        "format": FORMAT, "version": name, "date": time.strftime("%Y-%m-%d", time.gmtime()),
        "commit": commit, "columns": [field.name for field in fields(Kept)], "rows": by_case,
    }  # fmt: skip
    text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    packed = gzip.compress(text.encode("utf-8"), mtime=0)
    path = path_of(name, folder)
    write_whole(path, lambda file: file.write(packed))
    return path


def _line(one: Kept) -> list[Any]:
    """Values of a row in the order of the columns, without empty columns at the end."""
    line = [getattr(one, field.name) for field in fields(Kept)]
    while line[-1] is None or line[-1] == ():
        line.pop()
    return line


def load(path: Path) -> Release:
    """Release from its file.

    Raises InputError if the file is not a release.
    """
    try:
        data = json.loads(gzip.decompress(path.read_bytes()))
        names = data["columns"]
        if data["format"] != FORMAT or set(names) - {field.name for field in fields(Kept)}:
            raise InputError(f"{path}: its format differs from that of the present version")
        rows = {
            f"{case}/{quantity}": _kept(dict(zip(names, line, strict=False)))
            for case, lines in data["rows"].items()
            for quantity, line in lines.items()
        }
        return Release(version=data["version"], date=data["date"], commit=data["commit"], rows=rows)
    except InputError:
        raise
    except (OSError, ValueError, LookupError, TypeError, AttributeError, EOFError) as error:
        raise InputError(f"{path} is not a release file: {error}") from error


def _kept(line: dict[str, Any]) -> Kept:
    interval = line.get("interval")
    line["interval"] = None if interval is None else (interval[0], interval[1])
    line["figures"] = tuple((word, value) for word, value in line.get("figures") or ())
    return Kept(**line)


def newest(folder: Path | None = None) -> Release | None:
    """Release with the highest version; None if there is no release."""
    found = {
        _order(name): path
        for path in (folder or FOLDER).glob(f"*{ENDING}")
        if _VERSION.fullmatch(name := path.name.removesuffix(ENDING))
    }
    return load(found[max(found)]) if found else None


def is_later(name: str, than: str) -> bool:
    """Whether `name` is a version that is later than the version `than`.

    >>> is_later("0.10.0", "0.9.1"), is_later("0.9.1", "0.9.1"), is_later("next", "0.9.1")
    (True, False, False)
    """
    return _VERSION.fullmatch(name) is not None and _order(name) > _order(than)


def _order(name: str) -> tuple[int, ...]:
    return tuple(map(int, name.split(".")))
