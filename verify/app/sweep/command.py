"""The action of the command `sweep`."""

import json
import shlex
import sys
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from functools import partial
from pathlib import Path
from typing import IO

from verify.app.commands import ROOT, load, writable
from verify.core.files import write_whole
from verify.core.inputs import InputError
from verify.core.progress import Lines, shown
from verify.jobs.executor import Where
from verify.studies.sweep import plan as plans
from verify.studies.sweep.axes import changed
from verify.studies.sweep.console import print_outcome
from verify.studies.sweep.messages import bare
from verify.studies.sweep.outcome import Outcome, outcome
from verify.studies.sweep.pairs import NO_FORMULA, portion, selected
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.records import record
from verify.studies.sweep.run import solve
from verify.studies.sweep.tables import REFUSED, points_csv, sensitivity_csv, validity_csv
from verify.verdicts.of_sweep import verdict_in_words

PAGE = "sweep.html"


def run_sweep(
    path: Path, *, vary: Sequence[str], star: bool, sample: str, tolerances: Sequence[str],
    only: Sequence[str], where: Where, out: Path | None, as_json: bool, again: bool,
) -> int:  # fmt: skip
    """Compare formulas and finite elements over a grid or a sample; returns 1 if a point failed.

    A point also fails if a row does not converge. A point does not fail if the rules of the inputs
    reject it, or if a formula has no value. All points are counted, and the other results are
    stored. Returns 0 if no point failed. Raises InputError if all points are rejected.
    """
    plan = planned(path, vary=vary, star=star, sample=sample, tolerances=tolerances, only=only)
    _some_possible(plan)
    folder = out or ROOT / "reports" / "out" / f"sweep-{path.stem}"
    writable(folder)
    announce(plan)
    with nullcontext(Lines()) if as_json else shown(quiet=False) as show:
        solved = solve(plan, where, again=again, show=show)
    found = outcome(solved)
    _some_accepted(found.problems)
    made = files(found, command(path, vary, star, sample, tolerances, only))
    _write(made, folder)
    if as_json:
        print(made["sweep.json"].decode(), end="")
    else:
        print_outcome(found, verdict_in_words)
    message = f"written: {', '.join(str(folder / name) for name in made)}"
    print(message, file=sys.stderr if as_json else sys.stdout)
    return 1 if any(map(_has_failed, (found.problems, *(c.problems for c in found.courses)))) else 0


def _has_failed(problems: Sequence[str]) -> bool:
    """Whether a point failed for a reason other than rejected inputs or a missing formula value."""
    return any(p and p != NO_FORMULA and not p.startswith(REFUSED) for p in problems)


def _some_possible(plan: Plan) -> None:
    """Raise InputError if the rules of the inputs reject every point."""
    refused = []
    for row in plan.points:
        try:
            changed(plan.inputs, dict(zip(plan.names, row, strict=True)))
        except InputError as error:
            refused.append(f"{REFUSED}: {error}")
        else:
            return
    _some_accepted(refused)


def _some_accepted(problems: Sequence[str]) -> None:
    """Raise InputError if all `problems` are rejections; a solver may also reject a point."""
    if all(problem.startswith(f"{REFUSED}:") for problem in problems):
        raise InputError(f"every point is rejected, the first because: {bare(problems[0])}")


def planned(
    path: Path, *, vary: Sequence[str], star: bool, sample: str, tolerances: Sequence[str],
    only: Sequence[str],
) -> Plan:  # fmt: skip
    """Sweep that a parameter file and the options define.

    Raises InputError if an option is wrong.
    """
    if vary and sample:
        raise InputError("--vary (a grid) and --sample cannot be combined")
    if not vary and not sample:
        raise InputError("give --vary NAME=a:b:n, or --sample sobol:N with --tolerance")
    if star and not vary:
        raise InputError("--star requires --vary")
    if tolerances and not sample:
        raise InputError("--tolerance requires --sample")
    name, case, inputs, _ = load(path)
    chosen = selected(case, only)
    if sample:
        return plans.sample(case, name, inputs, chosen, sample, tolerances)
    return plans.grid(case, name, inputs, chosen, vary, star=star)


def announce(plan: Plan) -> None:
    """Print the numbers of points and rows of a sweep, and how to reduce the computation."""
    part = portion(plan.case, plan.chosen)
    rows = f"{len(plan.chosen)} row{'s' if len(plan.chosen) != 1 else ''}"
    print(f"{plan.name}: {len(plan.points):,} points of {plan.case.id}, {rows}", file=sys.stderr)
    if not part.name and plan.case.portions:
        names = ", ".join(f"{p.name} ({_rows(plan, p.keys)})" for p in plan.case.portions)
        print(
            f"these parts can be solved much faster with --only: {names}",
            file=sys.stderr,
            flush=True,
        )


def _rows(plan: Plan, keys: Sequence[str]) -> str:
    return "; ".join(pair.name for pair in plan.chosen if pair.fem in keys)


def command(
    path: Path, vary: Sequence[str], star: bool, sample: str, tolerances: Sequence[str],
    only: Sequence[str],
) -> str:  # fmt: skip
    """Command that repeats this sweep."""
    parts = ["freewheel", "sweep", path.name]
    parts += [part for text in vary for part in ("--vary", text)]
    parts += ["--star"] * star + (["--sample", sample] if sample else [])
    parts += [part for text in tolerances for part in ("--tolerance", text)]
    parts += [part for text in only for part in ("--only", text)]
    return shlex.join(parts)


def files(found: Outcome, repeat: str) -> Mapping[str, bytes]:
    """Files of the output folder (name: content)."""
    from reports.sweep import page as page_html
    from verify.app.sweep.page import page

    tables = (
        {"sensitivity.csv": sensitivity_csv(found)}
        if found.solved.plan.tolerances
        else {"validity.csv": validity_csv(found)}
    )
    texts = {
        PAGE: page_html(page(found, repeat)),
        "points.csv": points_csv(found),
        **tables,
        "sweep.json": json.dumps(record(found, repeat), ensure_ascii=False, indent=1) + "\n",
    }
    return {name: text.encode() for name, text in texts.items()}


def _write(made: Mapping[str, bytes], folder: Path) -> None:
    for name, content in made.items():
        try:
            write_whole(folder / name, partial(_fill, content))
        except OSError as error:
            raise OSError(f"{folder / name} cannot be written: {error.strerror}") from error


def _fill(content: bytes, file: IO[bytes]) -> None:
    file.write(content)
