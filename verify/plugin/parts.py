"""A parameter file as a test, which fails if the machine part fails its check."""

from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO

import pytest

from verify.answers.answer import EXIT_STATUS, Verdict
from verify.answers.parameter_file import read
from verify.app.check_command import Options, check_part, exit_status, in_system
from verify.app.check_console import print_check
from verify.jobs.executor import Where
from verify.plugin.cases import Item
from verify.plugin.messages import FreewheelError

STATUS = {Verdict.HOLDS: "PASS", Verdict.FAILS: "FAIL", Verdict.CANNOT_SAY: "SHOWN"}
LINES = 12  # of an answer, which come first


class PartFile(pytest.File):
    """Collector of a parameter file."""

    def collect(self) -> Iterator[pytest.Item]:
        """One test with the name of the command, "check"."""
        item = PartItem.from_parent(self, name="check")
        item.add_marker("freewheel")
        yield item


class PartItem(Item):
    """Test of the verdict of `freewheel check FILE`; "cannot say" skips it with a reason."""

    def runtest(self) -> None:
        """Check the part by its formulas."""
        file = read(self.path)
        checked = check_part(file, str(self.path), Options(), Where(0))
        answer = checked.answer
        limiting = answer.limiting
        self.user_properties += [
            ("status", STATUS[answer.verdict]), ("kind", "part"),
            ("verdict", answer.verdict.value),
            ("margin", "" if limiting is None else f"{limiting.margin:.6g}"),
        ]  # fmt: skip
        with redirect_stdout(StringIO()) as printed:
            print_check(in_system(checked, file.system), file.system)
        lines = printed.getvalue().splitlines()[:LINES]
        if exit_status(checked) == EXIT_STATUS[Verdict.FAILS]:
            further = f"all numbers: freewheel check {self.path.name}"
            raise FreewheelError("\n".join([*lines, further]))
        if answer.verdict is Verdict.CANNOT_SAY:
            self.not_judged(lines[0])
