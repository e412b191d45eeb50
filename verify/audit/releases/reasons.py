"""Reasons for loosened requirements or bands: one entry for each change."""

import re
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, StringConstraints, ValidationError

from verify.core.inputs import InputError
from verify.core.results import Change

FILE = Path(__file__).parent / "changes.toml"

Words = Annotated[str, StringConstraints(min_length=1, strip_whitespace=True)]
Why = Annotated[str, StringConstraints(min_length=20, strip_whitespace=True)]
Aspect = Literal[
    "demand", "interval", "bound", "reference", "acceptance", "scale", "status", "gone", "name"
]


class Reason(BaseModel):
    """One entry of changes.toml: rows (* stands for any letters), the change, and the reason.

    `since` is the release before the change; `what` describes the change.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    rows: Words
    aspect: Aspect
    what: Words
    why: Why
    since: Words

    def covers(self, change: Change, release: str) -> bool:
        """Whether the entry applies to this change since this release."""
        pattern = ".*".join(map(re.escape, self.rows.split("*")))
        named = re.fullmatch(pattern, change.row) is not None
        return named and self.aspect == change.aspect and self.since == release


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
    if unknown := [key for key in data if key != "changes"]:
        raise InputError(f"{path}: {unknown[0]}: unknown key; the only permitted key is changes")
    entries = data.get("changes", [])
    if not isinstance(entries, list):
        raise InputError(f'{path}: the key "changes" must be a list of tables, [[changes]]')
    return tuple(_reason(entry, n, path) for n, entry in enumerate(entries, start=1))


def _reason(entry: object, number: int, path: Path) -> Reason:
    try:
        return Reason.model_validate(entry)
    except ValidationError as error:
        fault = error.errors()[0]
        key = ".".join(map(str, fault["loc"]))
        place = f"changes[{number}]" + (f".{key}" if key else "")
        raise InputError(f"{path}: {place}: {fault['msg']}") from error


def stated(change: Change, reasons: Sequence[Reason], release: str) -> str:
    """Reason for a change; empty if none is stated."""
    return next((r.why for r in reasons if r.covers(change, release)), "")
