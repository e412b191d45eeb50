"""Outcomes of mutants, stored immediately, so that an interrupted run can be continued."""

import json
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import asdict, dataclass
from enum import StrEnum

from verify.core.store import Store

KIND = "mutant"  # of entries: their subject is the code


class By(StrEnum):
    """Outcome of a mutant: the kind of check that detected it, or none."""

    ROWS = "rows"  # a row is red that was not
    REFUSED = "refused"  # a check of the project raised its error
    TESTS = "tests"
    NOTHING = "nothing"
    CRASHED = "crashed"  # any other exception was raised
    TIME = "time"  # it does not end, or exhausts the memory


CAUGHT_BY_ROWS = (By.ROWS, By.REFUSED)
APART = (By.CRASHED, By.TIME)  # noticed by any run, and no merit of the suite's


@dataclass(frozen=True)
class Outcome:
    """Outcome of a mutant; `what` is the row, the error or the test that detected it."""

    id: str
    by: By
    what: str
    seconds: float


class Outcomes:
    """Outcomes of mutants of the code version `code`; each outcome is stored immediately."""

    def __init__(self, store: Store, code: str) -> None:
        self.store, self.code = store, code
        self.found = {outcome.id: outcome for outcome in self._read()}

    def _read(self) -> Iterator[Outcome]:
        for content in self.store.all(KIND, self.code).values():
            with suppress(ValueError, LookupError, TypeError):  # of another version
                data = json.loads(content)
                yield Outcome(**{**data, "by": By(data["by"])})

    def add(self, outcome: Outcome) -> None:
        """Store an outcome.

        Raises OSError if the disk is full.
        """
        self.found[outcome.id] = outcome
        content = json.dumps(asdict(outcome), ensure_ascii=False).encode()
        self.store.store(KIND, self.code, {f"{self.code} {outcome.id}": content})
