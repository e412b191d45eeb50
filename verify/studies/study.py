"""A study: long measurements of one kind, made once for each case and stored with the project."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.suggestions import nearest
from verify.jobs.executor import Where


@dataclass(frozen=True)
class Study:
    """One kind of measurements; a case has one measurement of each kind.

    `is_measured` states whether a case has a record for the present code. `measure` measures cases,
    stores each as soon as it is complete and prints a line for it; False if a part failed.
    With its last argument, failed parts are solved again.
    """

    name: str
    cases: Callable[[], Sequence[Case]]
    is_measured: Callable[[Case], bool]
    measure: Callable[[Sequence[Case], Where, bool], bool]

    def title(self, case: Case) -> str:
        """The name of a measurement on the command line."""
        return f"{self.name}:{case.id}"

    def chosen(self, names: Sequence[str]) -> list[Case]:
        """The selected cases: the name of the study selects all, "NAME:CASE" one; InputError."""
        known = {case.id: case for case in self.cases()}
        selected = [name.partition(":")[2] for name in names if name != self.name]
        for case_id in selected:
            if case_id not in known:
                asked = f"{self.name}:{case_id}".rstrip(":")
                there = nearest(case_id, known)
                raise InputError(f"{asked}: no such measurement; known are {there}")
        return list(known.values()) if self.name in names else [known[one] for one in selected]

    def measure_missing(self, cases: Sequence[Case], where: Where, *, again: bool = False) -> bool:
        """Measure the cases without a record for the present code; False if a part failed.

        With `again` all of them. OSError if a record cannot be written.
        """
        missing = [case for case in cases if again or not self.is_measured(case)]
        for case in cases:
            if case not in missing:
                print(f"{self.title(case)}: measured already, --again makes the record again")
        return not missing or self.measure(missing, where, again)
