"""The command `explain`: the judgement of a row, or the verdict of an equation."""

import json
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from difflib import get_close_matches
from functools import partial
from itertools import product
from pathlib import Path

from verify.app.commands import load
from verify.cases.files import is_file_name
from verify.cases.names import former_name, present_name
from verify.cases.registry import CASES, find
from verify.core import source_memory
from verify.core.case import Case, Context
from verify.core.inputs import InputError, Inputs
from verify.core.results import Row, Status
from verify.core.terminal import print_wrapped
from verify.core.verdicts import FormulaVerdict, Verdict
from verify.jobs import cache
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve
from verify.judging.explain.steps import derive
from verify.verdicts.console import explained, named

BESIDE = ": convergence"  # ends the name of the convergence row of a finite-element row
LISTED = 12


def run_explain(words: Sequence[str], *, as_json: bool, jobs: int, use_cache: bool) -> int:
    """Print the judgement of the row named by `words`, and return the exit status.

    If the last word is a parameter file, the row is judged for its inputs.
    """
    path = _file(words[-1]) if words else None
    name = " ".join(words[:-1] if path else words)
    if not path and (found := named(name)):
        return _verdicts(found, as_json=as_json)
    if path is not None and is_file_name(path.name):
        case, inputs = find(str(path)), find(str(path)).inputs()
        row_id = find_row(name, row_ids(case, inputs, paper=True), f" of {path}")
    elif path is None:
        if use_cache:
            source_memory.use(cache.default_folder())
        row_id = find_row(name, list(_ids_of_paper(name)))
        case = find(row_id.partition("/")[0])
        inputs = case.inputs()
    else:
        _, case, inputs, _ = load(path)
        paper = Job(case, inputs).is_paper
        row_id = find_row(name, row_ids(case, inputs, paper=paper), f" with {path}")
    (result,) = solve([Job(case, inputs)], Where(jobs), use_cache, quiet=as_json)
    row = next(row for row in result.rows if row.id == row_id)
    if as_json:
        print(_json(row))
    else:
        print_wrapped(*row_in_words(row).split("\n"))
    return 1 if row.status in (Status.FAIL, Status.SKIP) else 0


def _verdicts(found: Sequence[FormulaVerdict], *, as_json: bool) -> int:
    """Print the verdicts of an equation as printed and as corrected; return the exit status."""
    if as_json:
        print(json.dumps([asdict(one) for one in found], ensure_ascii=False))
    else:
        print_wrapped(*(line for one in found for line in explained(one)))
    return 1 if any(one.verdict is Verdict.NONE for one in found) else 0


def _file(word: str) -> Path | None:
    """Path of a parameter file or case file; None if `word` is not a file.

    The file may be unreadable; the function that reads it then reports the error.
    """
    path = Path(word)
    named = word.endswith((".toml", ".py")) or path.is_file() or (os.sep in word and path.is_dir())
    return path if named else None


def _ids_of_paper(name: str) -> Iterator[str]:
    """Ids of all rows of the suite, or of one case if `name` begins with its id.

    If `name` is empty, they are the ids of the first case; messages use the first id as an example.
    """
    named = name.partition("/")[0] if _plain(name) else CASES.ids[0]
    for case_id in [named] if named in CASES.ids else CASES.ids:
        case = find(case_id)
        ids = partial(row_ids, case, case.inputs(), paper=True)
        yield from source_memory.remembered("rows", case.analytic, ids)


def row_ids(case: Case, inputs: Inputs, *, paper: bool) -> list[str]:
    """Ids of the rows of a case, determined without finite elements.

    Without `paper`, rows that are only judged at the inputs of the paper are omitted.
    """
    return [row.id for row in unsolved_rows(case, inputs, paper=paper)]


def unsolved_rows(case: Case, inputs: Inputs, *, paper: bool) -> list[Row]:
    """Rows of a case without finite elements; rows that need them have the status SKIP.

    Without `paper`, rows that are only judged at the inputs of the paper are omitted.
    """
    context = Context(case.id, inputs, case.analytic(inputs), (), paper)
    return [
        row
        for check in case.checks
        if paper or not check.paper_only
        for row in (check.skipped(case.id, "") if check.needs_fem else check.rows(context))
    ]


def find_row(name: str, ids: Sequence[str], where: str = "") -> str:
    """Id of the row that `name` matches.

    `name` is the id of the row, the id without the case, a part of the id, or words of the id, in
    this order of precedence. Former names of renamed rows are also accepted: a complete former name
    takes precedence over parts of present names, and these over parts of former names. A row takes
    precedence over its convergence row. Raises InputError with a list of the matches unless exactly
    one row matches.
    """
    text = _plain(name)
    if not text:
        raise InputError(f"give the name of a row, such as {ids[0]!r}")
    cases = dict.fromkeys(i.partition("/")[0] for i in ids)
    has_case = name.partition("/")[0] in cases
    wholes = [name] if has_case else [f"{case}/{name}" for case in cases]
    complete = set(map(present_name, wholes))
    if name not in ids and len(found := [i for i in ids if i in complete]) == 1:
        return found[0]
    tests: tuple[Callable[[str], bool], ...] = (
        lambda i: text in (i, i.partition("/")[2]),
        lambda i: text in i,
        lambda i: all(word in i for word in text.split()),
    )
    versions: tuple[Callable[[str], str], ...] = (str, former_name)
    for version, matches in product(versions, tests):
        found = [i for i in ids if matches(_plain(version(i)))]
        main = [i for i in found if not i.endswith(BESIDE)] if BESIDE[2:] not in text else []
        found = main or found
        if len(found) == 1:
            return found[0]
        if found:
            raise InputError(
                f"{len(found)} rows match {name!r}; give one of these names: {_listed(found)}"
            )
    if name.endswith(")") and " (" in name:  # with the symbol and the unit, as on a page
        return find_row(name.rpartition(" (")[0], ids, where)
    near = get_close_matches(text, map(_plain, ids), n=3, cutoff=0.3)
    meant = [i for i in ids if _plain(i) in near]
    hint = f"similar rows: {_listed(meant)}" if meant else f"the cases are {', '.join(cases)}"
    raise InputError(f"no row{where} matches {name!r}; {hint}")


def _plain(name: str) -> str:
    """Name in lower case without commas, so that a row can be found by its words."""
    return " ".join(name.lower().replace(",", " ").split())


def _listed(ids: Sequence[str]) -> str:
    more = f"; and {len(ids) - LISTED} more" if len(ids) > LISTED else ""
    return "; ".join(ids[:LISTED]) + more


def row_in_words(row: Row) -> str:
    """Text with the id of a row and the steps of its judgement, one line each."""
    steps = derive(row).steps
    width = max(len(label) for label, _ in steps)
    head = f"{row.id} ({', '.join(filter(None, (row.symbol, row.kind.value)))})"
    return "\n".join([head, *(f"  {label:{width}}  {text}" for label, text in steps)])


def _json(row: Row) -> str:
    from reports.records import row_record  # only the command line may import reports

    steps = [{"label": label, "text": text} for label, text in derive(row).steps]
    return json.dumps({"row": row_record(row), "steps": steps}, ensure_ascii=False)
