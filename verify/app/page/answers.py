"""The answer of `freewheel check` to the inputs of a page, as plain data."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from verify.answers.console import limits, margin, number
from verify.answers.parameter_file import completed
from verify.app.check_command import Options, check_part, in_system
from verify.app.check_console import Checked, answer_lines
from verify.app.page.described import model_of
from verify.app.page.sketches import named_sketch
from verify.cases.registry import find
from verify.core.case import Case
from verify.core.console import raised, sentences
from verify.core.console_rows import row_cells, title, unit_of
from verify.core.inputs import InputError
from verify.core.wrong_values import MISSING, wrong_values
from verify.jobs.executor import ThisProcess

WHERE = "page"
_PLACE = re.compile(r"inputs\.(\w+(?:\[\d+\](?:\.\w+)?)?)")
_MISSING = re.compile(r"inputs: missing (\w+(?:, \w+)*) \(")
Cells = tuple[tuple[str, ...], ...]


@dataclass(frozen=True, kw_only=True)
class Shown:
    """Content of a page for one set of inputs.

    `faults` are errors by name of the input, `fault` is an error that concerns no single input;
    with an error, there is no verdict. `beside` are warnings by name of the input, `warnings` all
    other warnings. `assumed` contains text and source of each assumed input by its name.
    """

    verdict: str = ""
    lines: tuple[str, ...] = ()
    design: str = ""
    margin: str = ""
    limiting: str = ""
    limits: Cells = ()
    values: Cells = ()
    fault: str = ""
    faults: Mapping[str, str] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    beside: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    assumed: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    sketch: str = ""
    refused: str = ""
    rows: Cells = ()
    rows_title: str = ""
    rows_notes: tuple[str, ...] = ()


def shown(
    case_name: str, name: str, raw: Mapping[str, Any], notes: bool, _notify: Callable[[Any], None]
) -> Shown:
    """The answer for raw inputs.

    Without `notes`, the influence of the assumed inputs on the margin is not computed, because this
    is slow. Errors of inputs are part of the answer. Raises InputError if there is no such case.
    """
    try:
        case = find(case_name)
    except ValueError as error:
        raise InputError(str(error)) from error
    try:
        file = completed(case, raw, name=name, where=WHERE, named=case_name)
        options = Options(json=True, notes=notes)
        return of_checked(in_system(check_part(file, WHERE, options, ThisProcess()), file.system))
    except InputError as error:
        return _wrong(case, raw, str(error))


def of_checked(checked: Checked) -> Shown:
    """Answer of a check as plain data."""
    answer, result = checked.answer, checked.result
    worst = answer.limiting
    beside, general = _placed(checked)
    return Shown(
        verdict=str(answer.verdict),
        lines=tuple(raised(line.strip()) for line in answer_lines(checked)),
        design="" if answer.design is None else
        f"{answer.design.symbol} = {number(answer.design.value, answer.design.unit)}, "
        f"{answer.design.what}",
        margin="" if worst is None or answer.failures else margin(worst),
        limiting="" if worst is None or answer.failures else raised(worst.what),
        limits=tuple(limits(answer)),
        values=tuple((v.symbol, f"{v.value:.6g}", unit_of(v.unit), v.what) for v in result.values),
        warnings=general, beside=beside,
        assumed={one.name: (one.text, one.source) for one in checked.assumed},
        notes=tuple(map(raised, result.findings)), refused=result.refused,
        sketch=named_sketch(result.sketch, model_of(checked.case)),
        **_evidence(checked),
    )  # fmt: skip


def _evidence(checked: Checked) -> dict[str, Any]:
    rows = checked.result.rows
    if not checked.used_fem:
        return {}
    cells = tuple(tuple(map(raised, line)) for line in row_cells(rows))
    return {"rows": cells, "rows_title": title(rows), "rows_notes": tuple(sentences(rows))}


def _placed(checked: Checked) -> tuple[dict[str, tuple[str, ...]], tuple[str, ...]]:
    """Warnings by the input that they concern, and all other warnings.

    A warning concerns an input if its text begins with the name of the input, or if this is the
    only input that the text names.
    """
    beside: dict[str, tuple[str, ...]] = {}
    general = []
    by_symbol = model_of(checked.case)
    names = {**by_symbol, **{name: name for name in by_symbol.values()}}
    for warning in checked.result.warnings:
        first = re.match(r"[\w\[\].]+", warning)
        words = re.findall(r"\w+", warning)
        known = {names[w] for w in words if w in names and (_is_symbol(w) or f"{w} =" in warning)}
        place = first[0] if first and (first[0] in names or "[" in first[0]) else ""
        place = names.get(place, place) or (known.pop() if len(known) == 1 else "")
        if place:
            beside[place] = (*beside.get(place, ()), raised(warning))
        else:
            general.append(raised(warning))
    return beside, tuple(general)


def _is_symbol(word: str) -> bool:
    """Whether a word is certainly a name of an input, unlike "slices" or "a" in a sentence."""
    return "_" in word or not word.isascii() or word.isupper()


def _wrong(case: Case, raw: Mapping[str, Any], message: str) -> Shown:
    """Answer that states each missing or invalid input or, if none, the violated rule."""
    faults = wrong_values(case.inputs, raw)
    if match := _MISSING.search(message):
        faults |= dict.fromkeys(match[1].split(", "), MISSING)
    if not faults and (match := _PLACE.search(message)):
        faults[match[1]] = _bare(message, match[1])
    return Shown(faults=faults, fault="" if faults else _bare(message, ""))


def _bare(message: str, place: str) -> str:
    text = message.removeprefix(f"{WHERE}: ").removeprefix("inputs.").removeprefix("inputs: ")
    return text.removeprefix(f"{place}: ")
