"""Arguments that several commands share: whole numbers, names of cases, an engine."""

from typing import Annotated, Any, Literal

from cyclopts import Parameter


def whole(_type: Any, tokens: Any) -> int:
    """A whole number; cyclopts alone would round 1.5."""
    given = str(tokens[0].value)
    if not given.lstrip("+-").isdecimal():
        raise ValueError(f"needs a whole number, got {given!r}")
    return int(given)


def case_ids(_context: Any) -> list[str]:
    """Suggestions of a shell for the name of a case."""
    from verify.cases.registry import CASES

    return list(CASES.ids)


Jobs = Annotated[int, Parameter(name=("--jobs", "-j"), converter=whole)]
Number = Annotated[int, Parameter(converter=whole)]
Texts = Annotated[tuple[str, ...], Parameter(negative="", consume_multiple=False)]
Engine = Literal["local", "dask"]
ProblemKind = Literal["plane", "contact", "frame", "ring-sector", "shaft", "axisymmetric"]
CaseId = Annotated[str, Parameter(completer=case_ids)]
