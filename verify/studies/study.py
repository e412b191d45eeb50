"""A study: long computations of one kind, done once for each case and stored with the project."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.suggestions import nearest
from verify.jobs.executor import Where


@dataclass(frozen=True)
class Study:
    """A study: one kind of long computation, with one record for each case.

    `is_measured` states whether a case has a record for the present code. `measure` computes cases,
    stores each record as soon as it is complete and prints a line for it; it returns False if a
    part failed. If its last argument is True, failed parts are computed again.
    """

    name: str
    cases: Callable[[], Sequence[Case]]
    is_measured: Callable[[Case], bool]
    measure: Callable[[Sequence[Case], Where, bool], bool]

    def title(self, case: Case) -> str:
        """Name of the study of `case` on the command line."""
        return f"{self.name}:{case.id}"

    def chosen(self, names: Sequence[str]) -> list[Case]:
        """Cases selected by `names`: the name of the study selects all cases, "NAME:CASE" one case.

        Raises InputError if a case is unknown.
        """
        known = {case.id: case for case in self.cases()}
        selected = [name.partition(":")[2] for name in names if name != self.name]
        for case_id in selected:
            if case_id not in known:
                asked = f"{self.name}:{case_id}".rstrip(":")
                there = nearest(case_id, known)
                raise InputError(f"{asked}: unknown study; similar names: {there}")
        return list(known.values()) if self.name in names else [known[one] for one in selected]

    def measure_missing(self, cases: Sequence[Case], where: Where, *, again: bool = False) -> bool:
        """Compute the records that are missing for the present code; False if a part failed.

        With `again`, all records are computed again. Raises OSError if a record cannot be written.
        """
        missing = [case for case in cases if again or not self.is_measured(case)]
        for case in cases:
            if case not in missing:
                print(f"{self.title(case)}: measured already, --again makes the record again")
        return not missing or self.measure(missing, where, again)
