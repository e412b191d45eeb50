"""A case file as tests: one test for each of its rows."""

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import Any

import pytest

from verify.app.explain import unsolved_rows
from verify.cases.files import load
from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.results import Row, Status
from verify.form.quantity import CaseError
from verify.jobs.executor import Where
from verify.jobs.guard import named
from verify.jobs.level import Job
from verify.jobs.session import solve
from verify.plugin import STRICT
from verify.plugin.messages import FreewheelError, failure, with_extra

FAILED = (Status.FAIL, Status.SKIP)  # a row that could not be judged is no success either
NOT_JUDGED = (Status.SHOWN, Status.CALIBRATED)  # these fail if the setting is strict


class CaseFile(pytest.File):
    """Collector of a file that declares a case."""

    def collect(self) -> Iterator[pytest.Item]:
        """One test for each row, without solving; one failing test if the file cannot be used."""
        try:
            rows = unsolved_rows(self.case, self.case.inputs(), paper=True)
        except (Exception, SystemExit) as error:
            plain = isinstance(error, InputError | CaseError)
            message = str(error) if plain else named(error)
            place = "" if self.path.name in message else f"{self.path.name}: "
            yield Broken.from_parent(self, name="file", message=place + message)
            return
        for row in rows:
            yield RowItem.from_parent(self, name=row.quantity, row=row)
        if not rows:
            message = "the case has no rows: `comparisons` must yield at least one"
            yield Broken.from_parent(self, name="file", message=f"{self.path.name}: {message}")

    @cached_property
    def case(self) -> Case:
        """Case of the file.

        Raises InputError if the file is wrong.
        """
        return load(str(self.path))

    @cached_property
    def rows(self) -> dict[str, Row]:
        """Judged rows by id; stored finite-element levels are used."""
        (result,) = solve(
            [Job(self.case, self.case.inputs())], Where(1), use_cache=True, quiet=True
        )
        return {row.id: row for row in result.rows}

    def judged(self, row_id: str) -> Row:
        """Judged row with this id.

        Raises FreewheelError, with the reasons of other failed rows, if the row does not exist.
        """
        if found := self.rows.get(row_id):
            return found
        reasons = {row.reason: None for row in self.rows.values() if row.status in FAILED}
        raise FreewheelError("\n".join(["FAIL: the row was not judged", *reasons]))


class Item(pytest.Item):
    """A test that fails with a few lines instead of a traceback."""

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], *args: Any) -> Any:
        """Only the message of the error; with `--full-trace`, the traceback if it is unexpected."""
        if isinstance(excinfo.value, FreewheelError | InputError):
            return with_extra(str(excinfo.value))
        if self.config.getoption("fulltrace"):
            return super().repr_failure(excinfo, *args)
        return with_extra(f"{self.path.name}: {named(excinfo.value)} (traceback: --full-trace)")

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """File and name that pytest prints above a failure."""
        return self.path, None, f"{self.path.name}: {self.name}"

    def not_judged(self, message: str) -> None:
        """Skip the test for the reason `message`; if `freewheel_strict` is set, the test fails."""
        if self.config.getini(STRICT):
            raise FreewheelError(f"{message}\n{STRICT} is set: a result without a verdict fails")
        pytest.skip(message)


class Broken(Item):
    """Test for a file that cannot be used; it fails and states the reason."""

    def __init__(self, *, message: str, **more: Any) -> None:
        super().__init__(**more)
        self.message = message
        self.add_marker("freewheel")

    def runtest(self) -> None:
        """Fail with the message."""
        raise FreewheelError(self.message)


class RowItem(Item):
    """Test of one row; a row without a verdict (SHOWN, CALIBRATED, NOTE) is skipped visibly."""

    def __init__(self, *, row: Row, **more: Any) -> None:
        super().__init__(**more)
        self.row_id = row.id
        self.add_marker("freewheel")
        self.add_marker(row.kind.value)

    def runtest(self) -> None:
        """Judge the row; the first test of a file solves the case."""
        assert isinstance(self.parent, CaseFile)
        row = self.parent.judged(self.row_id)
        self.user_properties += [("status", row.status.value), ("kind", row.kind.value)]
        if row.status in FAILED:
            raise FreewheelError(failure(row, self.path.name))
        message = f"{row.status.value}: {row.reason or 'not judged'}"
        if row.status in NOT_JUDGED:
            self.not_judged(message)
        elif row.status is not Status.PASS:
            pytest.skip(message)
