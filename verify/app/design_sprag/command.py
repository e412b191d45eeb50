"""The action of the command `design` for the crown of a sprag."""

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
from verify.core.inputs import InputError
from verify.core.terminal import print_wrapped
from verify.core.unit_systems import System
from verify.studies.design_sprag.answer import answer
from verify.studies.design_sprag.console import print_outcome
from verify.studies.design_sprag.inputs import load
from verify.studies.design_sprag.outcome import Outcome, carry_out
from verify.studies.design_sprag.records import (
    CHOSEN,
    chosen_file,
    designs_csv,
    profile_csv,
    record,
)

PAGE = "design.html"


def run_design(
    path: Path, *, choose: int | None, use_fem: bool, as_json: bool, out: Path | None,
    units: System | None = None,
) -> int:  # fmt: skip
    """Find the optimal crown for a task, print the answer and return the exit status.

    The status is 0 if the crown is confirmed and within its limits, 1 if not, 3 if undecided.
    """
    task = load(path)
    system = units or task.system
    if choose is not None:
        raise InputError(
            "--choose is only for springs: a crown has one optimum and no Pareto front"
        )
    if out is not None:
        writable(out)
    outcome = carry_out(task, str(path), use_half_space=use_fem, quiet=as_json)
    found = answer(outcome)
    if as_json:
        listed = {"assumed": [one.record() for one in task.assumed]}
        whole = record(outcome) | listed | {"answer": answer_record(found)}
        print(json.dumps(record_in_units(whole, system), ensure_ascii=False))
    else:
        notes = () if outcome.checks else ("not verified by a half-space",)
        print_wrapped(*headline(task.name, found, notes, system))
        print_outcome(outcome, system)
        print_assumed(assumed_in(task.assumed, system))
    if out is not None:
        made = files(outcome, f"freewheel design {'' if use_fem else '--no-fem '}"
                              f"--out {shlex.quote(out.name or '.')} "
                              f"{shlex.quote(path.name)}", out.name)  # fmt: skip
        for name, text in made.items():
            try:
                write_whole(out / name, partial(_fill, text))
            except OSError as error:
                raise OSError(f"{out / name} cannot be written: {error.strerror}") from error
        message = f"written: {', '.join(str(out / name) for name in made)}"
        print(message, file=sys.stderr if as_json else sys.stdout)
    return EXIT_STATUS[found.verdict] if outcome.passed else EXIT_STATUS[Verdict.FAILS]


def files(outcome: Outcome, repeat: str, folder: str) -> Mapping[str, str]:
    """Files of the output folder (name: content)."""
    from reports.design import page as page_html
    from verify.app.design_sprag.page import page

    repeat += f"\nfreewheel check --dynamic {shlex.quote(str(Path(folder) / CHOSEN))}"
    return {
        "profile.csv": profile_csv(outcome),
        "designs.csv": designs_csv(outcome),
        CHOSEN: chosen_file(outcome),
        PAGE: page_html(page(outcome, repeat)),
    }


def _fill(text: str, file: IO[bytes]) -> None:
    file.write(text.encode())
