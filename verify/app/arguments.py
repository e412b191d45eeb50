"""Arguments that several commands share: integers, names of cases, the engine."""

from typing import Annotated, Any, Literal

from cyclopts import Parameter


def whole(_type: Any, tokens: Any) -> int:
    """Integer given as an argument of a command.

    Raises ValueError for a decimal number, which cyclopts would round.
    """
    given = str(tokens[0].value)
    if not given.lstrip("+-").isdecimal():
        raise ValueError(f"must be a whole number, got {given!r}")
    return int(given)


def case_ids(_context: Any) -> list[str]:
    """Names of cases that a shell suggests for the completion of a command line."""
    from verify.cases.registry import CASES

    return list(CASES.ids)


Jobs = Annotated[int, Parameter(name=("--jobs", "-j"), converter=whole)]
Number = Annotated[int, Parameter(converter=whole)]
Texts = Annotated[tuple[str, ...], Parameter(negative="", consume_multiple=False)]
Engine = Literal["local", "dask"]
ProblemKind = Literal["plane", "contact", "frame", "ring-sector", "shaft", "axisymmetric"]
CaseId = Annotated[str, Parameter(completer=case_ids)]
