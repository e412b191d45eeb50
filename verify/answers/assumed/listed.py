"""Lists of assumed inputs for the terminal and for a report."""

from collections.abc import Sequence
from dataclasses import replace

from verify.answers.assumed.rules import Assumed
from verify.core.console import aligned
from verify.core.results import CaseResult
from verify.core.terminal import print_wrapped


def print_assumed(assumed: Sequence[Assumed]) -> None:
    """Print every assumed input with its value and source.

    Print nothing if all inputs are given.
    """
    if not assumed:
        return
    print("assumed, because the file does not give them")
    lines = aligned([(one.name, one.text, one.source) for one in assumed])
    print_wrapped(*(f"  {line}" for line in lines))


def with_sources(result: CaseResult, assumed: Sequence[Assumed]) -> CaseResult:
    """Copy of the result, in which each assumed input has the source "assumed, ..."."""
    sources = {one.name: f"assumed, {one.source}" for one in assumed}
    inputs = tuple(replace(i, source=sources.get(i.name, i.source)) for i in result.inputs)
    return replace(result, inputs=inputs)
