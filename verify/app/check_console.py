"""Terminal output of `check`: the answer, its limits, values, inputs, and the evidence."""

from collections.abc import Sequence
from dataclasses import dataclass

from verify.answers.answer import Answer
from verify.answers.assumed.listed import print_assumed
from verify.answers.assumed.rules import Assumed
from verify.answers.console import headline, limits
from verify.answers.evidence import reference_of_design
from verify.answers.shared_readings import SharedReading
from verify.core.case import Case
from verify.core.console import aligned, print_rows, raised
from verify.core.console_rows import number, unit_of
from verify.core.figures import LIMITS_TITLE, FormulaValue, Table
from verify.core.results import CaseResult
from verify.core.terminal import print_wrapped
from verify.core.unit_systems import System
from verify.jobs.dynamic import DynamicResult
from verify.verdicts.console import Placed

NOTABLE = 0.01  # relative error that formula and reference share


@dataclass(frozen=True, kw_only=True)
class Checked:
    """A checked part: the answer and its evidence; `notes` are printed below the margin."""

    case: Case
    result: CaseResult
    answer: Answer
    used_fem: bool
    dynamic: DynamicResult | None = None
    notes: tuple[str, ...] = ()
    assumed: tuple[Assumed, ...] = ()
    shared: tuple[SharedReading, ...] = ()
    verdicts: tuple[Placed, ...] = ()


def is_notable(one: SharedReading) -> bool:
    """Whether the error that formula and reference share is known and at least NOTABLE."""
    return one.effect is not None and abs(one.effect) >= NOTABLE


def answer_lines(checked: Checked, system: System = "mm") -> list[str]:
    """First lines of the answer: verdict, design value, margin, limiting criterion, and notes."""
    n = len(checked.result.warnings)
    warned = (f"{n} warning{'s' if n > 1 else ''}, listed below the limits",) if n else ()
    notes = (*warned, *(one.sentence for one in checked.shared if is_notable(one)), *checked.notes)
    if checked.assumed:
        notes = (*notes, f"assumed inputs: {', '.join(one.text for one in checked.assumed)}")
    if checked.used_fem and (beside := reference_of_design(checked.answer, checked.result.rows)):
        notes = (beside, *notes)
    return headline(checked.result.name, checked.answer, notes, system)


def limits_table(checked: Checked, system: System) -> Table:
    """Table of the limits of the part, for its report."""
    header = ("", "criterion", "value", "limit", "margin", "source")
    return Table(
        title=LIMITS_TITLE,
        header=header,
        rows=tuple(limits(checked.answer, system)),
    )


def print_check(checked: Checked, system: System = "mm") -> None:
    """Print the whole answer in the units of `system`, with the verdict first."""
    result, dynamic = checked.result, checked.dynamic
    for line in answer_lines(checked, system):
        print_wrapped(raised(line))
    _print_table("limits", [_limit(cells) for cells in limits(checked.answer, system)])
    for warning in result.warnings:
        print_wrapped(raised(f"warning: {warning}"))
    _print_list("notes", dynamic.after(result.findings) if dynamic else result.findings)
    _print_table(f"values by the formulas: {result.title} ({result.id})",
                 [_value(v) for v in result.values])  # fmt: skip
    if dynamic:
        _print_table(dynamic.what, [_value(v) for v in dynamic.values])
    _print_table(
        "verdicts of the formulas (freewheel explain EQUATION prints the evidence)",
        [_verdict(one.line) for one in checked.verdicts],
    )
    _print_table("inputs", [(i.symbol, number(i.value), unit_of(i.unit), i.what)
                            for i in result.inputs])  # fmt: skip
    print_assumed(checked.assumed)
    _print_list("assumptions that formula and reference share",
                [one.sentence for one in checked.shared if not is_notable(one)])  # fmt: skip
    if checked.used_fem:
        print_rows(result.rows)
    print_wrapped(*_hints(checked))


def _hints(checked: Checked) -> list[str]:
    found = []
    if checked.case.dynamic and not checked.dynamic:
        found.append(f"(check --dynamic adds {checked.case.dynamic.what})")
    if checked.used_fem:
        return found
    if checked.result.refused:
        return [*found, f"(check --fem is not possible: {checked.result.refused})"]
    method = checked.case.method.case
    return [*found, f"(check --fem compares the values marked * with: {method})"]


def _print_table(title: str, lines: Sequence[tuple[str, ...]]) -> None:
    if lines:
        print(title)
        print_wrapped(*(f"  {line}" for line in aligned(lines)))


def _print_list(title: str, lines: Sequence[str]) -> None:
    if lines:
        print(title)
        print_wrapped(*(raised(f"  {line}") for line in lines))


def _limit(cells: tuple[str, ...]) -> tuple[str, ...]:
    """Cells of a limit with its numbers first and long texts in the last column."""
    state, what, value, limit, margin, source = cells
    return state, margin, value, limit, f"{what}; {source}"


def _verdict(cells: tuple[str, ...]) -> tuple[str, ...]:
    """Cells of a verdict: equation, verdict, and one column for all other texts."""
    return *cells[:2], "; ".join(filter(None, cells[2:]))


def _value(v: FormulaValue) -> tuple[str, ...]:
    return v.symbol, f"{v.value:.6g}", unit_of(v.unit), f"{v.label}{' *' if v.judged else ''}"
