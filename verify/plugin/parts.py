"""A parameter file as a test: a part that fails its check fails the test."""

from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO

import pytest

from verify.answers.answer import EXIT_STATUS, Verdict
from verify.app.check_command import Options, run_check
from verify.plugin.cases import FreewheelError, Item

LINES = 12  # of an answer, which come first


class PartFile(pytest.File):
    """A parameter file."""

    def collect(self) -> Iterator[pytest.Item]:
        """One test, of the name of the command."""
        item = PartItem.from_parent(self, name="check")
        item.add_marker("freewheel")
        yield item


class PartItem(Item):
    """What `freewheel check FILE` says; an answer that cannot be given is skipped visibly."""

    def runtest(self) -> None:
        """Check the part by its formulas."""
        with redirect_stdout(StringIO()) as printed:
            status = run_check(self.path, Options())
        answer = printed.getvalue().splitlines()
        if status == EXIT_STATUS[Verdict.FAILS]:
            raise FreewheelError("\n".join(answer[:LINES]))
        if status == EXIT_STATUS[Verdict.CANNOT_SAY]:
            pytest.skip(answer[0])
