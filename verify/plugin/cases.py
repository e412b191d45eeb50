"""A case file as tests: one for each of its rows."""

from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import Any

import pytest

from verify.app.explain import row_in_words, unsolved_rows
from verify.cases.files import load
from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.results import Row, Status
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve

FAILED = (Status.FAIL, Status.SKIP)  # a row that could not be judged is no success either


class FreewheelError(Exception):
    """A row or a part that fails; its message is what the test prints."""


class CaseFile(pytest.File):
    """A file that declares a case."""

    def collect(self) -> Iterator[pytest.Item]:
        """A test for each row, known without solving; one that fails where the file is wrong."""
        try:
            rows = unsolved_rows(self.case, self.case.inputs(), paper=True)
        except InputError as error:
            yield Broken.from_parent(self, name="file", message=str(error))
            return
        for row in rows:
            yield RowItem.from_parent(self, name=row.quantity, row=row)

    @cached_property
    def case(self) -> Case:
        """The case of the file; InputError."""
        return load(str(self.path))

    @cached_property
    def rows(self) -> dict[str, Row]:
        """The judged rows by their ids; levels come from the store where they are there."""
        (result,) = solve(
            [Job(self.case, self.case.inputs())], Where(1), use_cache=True, quiet=True
        )
        return {row.id: row for row in result.rows}


class Item(pytest.Item):
    """A test that fails with a few lines in place of a traceback."""

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], *args: Any) -> Any:
        """The message alone."""
        if isinstance(excinfo.value, FreewheelError | InputError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, *args)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """The file and the name that pytest prints above a failure."""
        return self.path, None, f"{self.path.name}: {self.name}"


class Broken(Item):
    """A file that cannot be used: one test, which says why."""

    def __init__(self, *, message: str, **more: Any) -> None:
        super().__init__(**more)
        self.message = message
        self.add_marker("freewheel")

    def runtest(self) -> None:
        """Fail."""
        raise FreewheelError(self.message)


class RowItem(Item):
    """A row of a case. A row that is not judged (SHOWN, CALIBRATED, NOTE) is skipped visibly."""

    def __init__(self, *, row: Row, **more: Any) -> None:
        super().__init__(**more)
        self.row_id = row.id
        self.add_marker("freewheel")
        self.add_marker(row.kind.value)

    def runtest(self) -> None:
        """Judge the row; the first row of a file solves the case."""
        assert isinstance(self.parent, CaseFile)
        row = self.parent.rows[self.row_id]
        self.user_properties += [("status", row.status.value), ("kind", row.kind.value)]
        if row.status in FAILED:
            raise FreewheelError(f"{row.status.value}: {row.reason}\n{row_in_words(row)}")
        if row.status is not Status.PASS:
            pytest.skip(f"{row.status.value}: {row.reason or 'not judged'}")
