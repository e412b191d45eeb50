"""Every case, in the order of the report."""

from verify.case import Case
from verify.cases.ring import LAME
from verify.cases.spring_accordion import ACCORDION
from verify.cases.spring_continuum import CONTINUUM

CASES: tuple[Case, ...] = (LAME, ACCORDION, CONTINUUM)


def find(case_id: str) -> Case:
    """The case named `case_id`; ValueError listing the known ones."""
    for case in CASES:
        if case.id == case_id:
            return case
    raise ValueError(f"unknown case {case_id!r}; known are {', '.join(c.id for c in CASES)}")
