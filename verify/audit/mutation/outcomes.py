"""What became of each mutant, kept as it comes: an interrupted run goes on where it was."""

import json
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import asdict, dataclass
from enum import StrEnum
from pathlib import Path


class By(StrEnum):
    """What noticed a mutant."""

    ROWS = "rows"  # a row is red that was not
    REFUSED = "refused"  # the project's own check raised its error
    TESTS = "tests"
    NOTHING = "nothing"
    CRASHED = "crashed"  # anything else was raised
    TIME = "time"  # it does not end, or takes the machine's memory


CAUGHT_BY_ROWS = (By.ROWS, By.REFUSED)
APART = (By.CRASHED, By.TIME)  # noticed by any run, and no merit of the suite's


@dataclass(frozen=True)
class Outcome:
    """A mutant's fate; `what` names the rows, the error or the test."""

    id: str
    by: By
    what: str
    seconds: float


class Store:
    """Outcomes as lines of a file, each written whole before the next mutant counts as done."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.found = {outcome.id: outcome for outcome in self._read()}

    def _read(self) -> Iterator[Outcome]:
        with suppress(OSError):
            for line in self.path.read_text("utf-8").splitlines():
                with suppress(ValueError, TypeError):  # a line that a killed run left half
                    data = json.loads(line)
                    yield Outcome(**{**data, "by": By(data["by"])})

    def add(self, outcome: Outcome) -> None:
        """Keep an outcome; OSError where there is no room."""
        self.found[outcome.id] = outcome
        self.path.parent.mkdir(parents=True, exist_ok=True)
        with self.path.open("a", encoding="utf-8") as file:
            # a new line first: what a killed run left half stands alone
            file.write("\n" + json.dumps(asdict(outcome), ensure_ascii=False))
