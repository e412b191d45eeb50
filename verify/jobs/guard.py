"""Converts an error inside a case to a failed row of this case; the other cases continue."""

import traceback
from collections.abc import Callable
from concurrent.futures import BrokenExecutor
from dataclasses import replace
from typing import Any

from verify.core.case import Case, Check
from verify.core.results import Kind, Row, Status

PARTS = ("equations", "findings", "warnings", "tables", "figures", "pictures")  # sequences


def named(error: BaseException) -> str:
    """Name and message of an exception in one line."""
    text = " ".join(str(error).split())
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


def unsolved(error: BaseException) -> bool:
    """Whether a solver raised the error to report that it found no solution.

    All other errors are faults of the code.
    """
    faults = ZeroDivisionError, OverflowError, FloatingPointError
    return isinstance(error, ArithmeticError) and not isinstance(error, faults)


def of_machine(error: BaseException) -> bool:
    """Whether the machine causes the error, for example by a lack of memory.

    Another run may succeed.
    """
    return isinstance(error, MemoryError | OSError | BrokenExecutor)


class Guard:
    """Runs code of a case.

    `rows` contains a failed row for each error, `traces` its traceback.
    """

    def __init__(self, case: Case) -> None:
        self.case = case
        self.rows: list[Row] = []
        self.traces: list[str] = []

    def values(self, inputs: Any) -> dict[str, float]:
        """Values of the formulas; empty if the formulas fail."""
        return dict(self._part("formulas", self.case.analytic, {})(inputs))

    def guarded(self) -> Case:
        """The case, with empty equations, tables and similar parts if they cannot be made."""
        parts: dict[str, Any] = {p: self._part(p, getattr(self.case, p), ()) for p in PARTS}
        return replace(self.case, sketch=self._part("sketch", self.case.sketch, None), **parts)

    def silent(self) -> Case:
        """The case without equations, tables and similar parts, for use if there are no values."""
        empty: dict[str, Any] = dict.fromkeys((*PARTS, "sketch"), lambda *_: ())
        return replace(self.case, **empty | {"sketch": lambda _inputs: None})

    def judged(self, check: Check, rows: Callable[[], list[Row]]) -> list[Row]:
        """Rows of one check; if an error occurs, rows with the same names and the status FAIL."""
        try:
            return list(rows())
        except Exception as error:  # any error concerns only this case
            return self.red(check, self._note(error))

    def red(self, check: Check, reason: str) -> list[Row]:
        """Failed rows in place of the rows of a check, all with the same reason."""
        try:
            known = check.skipped(self.case.id, "")
        except Exception as error:
            self._note(error)
            known = [self.row(getattr(check, "name", type(check).__name__), reason)]
        return [replace(row, status=Status.FAIL, reason=reason) for row in known]

    def row(self, quantity: str, reason: str) -> Row:
        """A failed row for a part of the case."""
        return Row(
            case=self.case.id, quantity=quantity, symbol="", unit="1", kind=Kind.FACT,
            status=Status.FAIL, reason=reason,
        )  # fmt: skip

    def _part(self, name: str, make: Callable[..., Any], empty: Any) -> Callable[..., Any]:
        def made(*arguments: Any) -> Any:
            try:
                found = make(*arguments)
                return tuple(found) if empty == () else found
            except Exception as error:
                self.rows.append(self.row(name, self._note(error)))
                return empty

        return made

    def _note(self, error: Exception) -> str:
        self.traces.append("".join(traceback.format_exception(error)))
        return named(error)
