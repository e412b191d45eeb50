"""The command `design`, apart from reading the command line."""

import json
import sys
from collections.abc import Mapping
from pathlib import Path

from verify.commands import writable
from verify.design.inputs import load
from verify.design.outcome import CHOSEN, Outcome, carry_out, chosen_file
from verify.design.records import candidates_csv, record
from verify.design.told import print_outcome
from verify.files import write_whole

TABLE = "candidates.csv"


def run_design(
    path: Path, *, choose: int | None, use_fem: bool, as_json: bool, out: Path | None
) -> int:
    """Springs for the task in a file; 0 where one is found and finite elements agree, else 1."""
    task = load(path)
    if out is not None:
        writable(out)
    outcome = carry_out(task, choose=choose, use_fem=use_fem, quiet=as_json)
    if as_json:
        print(json.dumps(record(outcome), ensure_ascii=False))
    else:
        print_outcome(outcome)
    if out is not None:
        _write(files(outcome), out)
        told = f"written: {', '.join(str(out / name) for name in files(outcome))}"
        print(told, file=sys.stderr if as_json else sys.stdout)
    return 0 if outcome.passed else 1


def files(outcome: Outcome) -> Mapping[str, str]:
    """What goes into the folder, by name."""
    found = {TABLE: candidates_csv(outcome.search)}
    if outcome.chosen is not None:
        found[CHOSEN] = chosen_file(outcome)
    return found


def _write(made: Mapping[str, str], out: Path) -> None:
    """Every file whole; a chosen spring of an earlier task goes."""
    for name, text in made.items():
        try:
            write_whole(out / name, lambda file, text=text: file.write(text.encode()))
        except OSError as error:
            raise OSError(f"{out / name} cannot be written: {error.strerror}") from error
    if CHOSEN not in made:
        (out / CHOSEN).unlink(missing_ok=True)
