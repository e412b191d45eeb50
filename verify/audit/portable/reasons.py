"""Reasons why values of rows may differ between machines: one entry per pattern of rows."""

import re
import tomllib
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, StringConstraints, ValidationError

from verify.audit.portable.compare import Difference, Kind
from verify.core.inputs import InputError

FILE = Path(__file__).parent / "reasons.toml"

Pattern = Annotated[str, StringConstraints(min_length=1, strip_whitespace=True)]
Why = Annotated[str, StringConstraints(min_length=20, strip_whitespace=True)]
RowKind = Literal["identity", "asymptotic", "approximation", "trend", "fact", "exact"]


class Reason(BaseModel):
    """One entry of reasons.toml: rows (* stands for any letters), kind of row, and reason."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    rows: Pattern
    why: Why
    kind: RowKind | None = None

    def covers(self, difference: Difference) -> bool:
        """Whether the entry explains `difference`; only differences of values are explained."""
        pattern = ".*".join(map(re.escape, self.rows.split("*")))
        return (
            difference.kind is Kind.VALUE
            and self.kind in (None, difference.row_kind)
            and re.fullmatch(pattern, difference.row) is not None
        )


def read(path: Path | None = None) -> tuple[Reason, ...]:
    """All entries of the file; empty without a file.

    Raises InputError, which states the first error in one line, if the file is wrong.
    """
    path = path or FILE
    try:
        data = tomllib.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        return ()
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from error
    if unknown := [key for key in data if key != "moves"]:
        raise InputError(f"{path}: {unknown[0]}: unknown key; the only permitted key is moves")
    entries = data.get("moves", [])
    if not isinstance(entries, list):
        raise InputError(f"{path}: the key moves must be a list of tables [[moves]]")
    return tuple(_reason(entry, number, path) for number, entry in enumerate(entries, start=1))


def explained(
    found: Sequence[Difference], reasons: Sequence[Reason]
) -> tuple[list[Difference], list[Reason]]:
    """Differences with their stated reasons, and the reasons to which no difference belongs."""
    result = [
        replace(one, reason=next((r.why for r in reasons if r.covers(one)), "")) for one in found
    ]
    return result, [r for r in reasons if not any(r.covers(one) for one in found)]


def _reason(entry: object, number: int, path: Path) -> Reason:
    try:
        return Reason.model_validate(entry)
    except ValidationError as error:
        fault = error.errors()[0]
        place = ".".join((f"moves[{number}]", *map(str, fault["loc"])))
        raise InputError(f"{path}: {place}: {fault['msg']}") from error
