"""The action of the command `design` for accordion springs."""

import json
import shlex
import sys
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import IO

from verify.answers.answer import EXIT_STATUS, Verdict
from verify.answers.answer_units import assumed_in, record_in_units
from verify.answers.assumed.listed import print_assumed
from verify.answers.console import headline
from verify.answers.record import answer_record
from verify.app.commands import writable
from verify.core.files import write_whole
from verify.core.terminal import print_wrapped
from verify.core.unit_systems import System
from verify.studies.design.answer import answer
from verify.studies.design.console import print_outcome
from verify.studies.design.inputs import load
from verify.studies.design.outcome import CHOSEN, Outcome, carry_out, chosen_file
from verify.studies.design.records import candidates_csv, record

PAGE, TABLE = "design.html", "candidates.csv"


def run_design(
    path: Path, *, choose: int | None, use_fem: bool, as_json: bool, out: Path | None,
    units: System | None = None,
) -> int:  # fmt: skip
    """Find springs for the task in a file, print the answer and return the exit status.

    The status is 0 if a spring was found and confirmed, 1 if not, 3 if it is undecided.
    """
    task = load(path)
    system = units or task.system
    if out is not None:
        writable(out)
    outcome = carry_out(
        task, choose=choose, use_fem=use_fem, drawn=as_json or out is not None, quiet=as_json
    )
    found = answer(outcome)
    if as_json:
        listed = {"assumed": [one.record() for one in task.assumed]}
        whole = record(outcome) | listed | {"answer": answer_record(found)}
        print(json.dumps(record_in_units(whole, system), ensure_ascii=False))
    else:
        notes = () if outcome.verified else ("not verified by finite elements",)
        print_wrapped(*headline(task.name, found, notes, system))
        print_outcome(outcome, system)
        print_assumed(assumed_in(task.assumed, system))
    if out is not None:
        made = files(outcome, command(path, choose, use_fem=use_fem))
        _write(made, out)
        message = f"written: {', '.join(str(out / name) for name in made)}"
        print(message, file=sys.stderr if as_json else sys.stdout)
    return EXIT_STATUS[found.verdict] if outcome.passed else EXIT_STATUS[Verdict.FAILS]


def command(path: Path, choose: int | None, *, use_fem: bool) -> str:
    """Command that repeats this search."""
    chosen = "" if choose is None else f"--choose {choose} "
    fem = "" if use_fem else "--no-fem "
    return f"freewheel design {fem}{chosen}{shlex.quote(path.name)}"


def files(outcome: Outcome, repeat: str) -> Mapping[str, bytes]:
    """Files of the output folder (name: content)."""
    from reports.design import page as page_html
    from verify.app.design.page import page

    texts = {TABLE: candidates_csv(outcome.search)}
    if outcome.chosen is not None:
        texts[CHOSEN] = chosen_file(outcome)
        repeat += f"\nfreewheel check --fem {CHOSEN}"
    texts[PAGE] = page_html(page(outcome, repeat))
    return {name: text.encode() for name, text in texts.items()}


def _write(made: Mapping[str, bytes], out: Path) -> None:
    """Write all files; if no spring was selected, remove the file of a spring selected earlier."""
    for name, content in made.items():
        try:
            write_whole(out / name, partial(_fill, content))
        except OSError as error:
            raise OSError(f"{out / name} cannot be written: {error.strerror}") from error
    if CHOSEN not in made:
        (out / CHOSEN).unlink(missing_ok=True)


def _fill(content: bytes, file: IO[bytes]) -> None:
    file.write(content)
