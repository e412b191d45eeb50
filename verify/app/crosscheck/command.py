"""The command `crosscheck`: second solvers solve meshes and loads of the project."""

import sys
from collections import deque
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path

from verify.app.commands import writable
from verify.core.console import aligned, raised
from verify.core.inputs import InputError
from verify.core.progress import shown
from verify.core.results import Crosscheck, CrossState
from verify.core.terminal import print_wrapped
from verify.jobs.dispatch import Dispatch, queue
from verify.jobs.executor import Lost, local
from verify.studies.crosscheck import store
from verify.studies.crosscheck.judged import judged
from verify.studies.crosscheck.registry import chosen
from verify.studies.crosscheck.solvers import Solver, rerun, solve, solvers
from verify.studies.crosscheck.statement import CALCULIX, SOLVERS, Cross

ROOT = Path(__file__).parents[3]
HEAD = ("problem", "quantity", "unit", "here", "there", "difference", "allowed", "s here",
        "s there", "")  # fmt: skip


def run_list(names: Sequence[str]) -> int:
    """Print the comparisons with their problem and solver, and the installed solvers."""
    for cross in chosen(names):
        print_wrapped(raised(f"{cross.id:38}  {cross.solver:8}  {cross.what}"))
    for one in solvers().values():
        print(f"{one.name}: {one.missing or one.version}")
    return 0


def run_crosscheck(names: Sequence[str], *, out: Path | None, again: bool, keep: bool) -> int:
    """Solve all problems that have no valid stored result, and print all comparisons.

    Returns 1 if a difference exceeds its limit or a problem could not be solved, otherwise 0. Input
    and output files of the solvers remain in `out`. A missing solver is not an error. Raises
    InputError if cases are named and none of their problems is stored or could be solved.
    """
    crosses = chosen(names)
    folder = out or ROOT / "reports" / "out" / "crosscheck"
    writable(folder)
    there = solvers()
    standing, todo, left = _sorted(crosses, there, again=again)
    if names and not standing and not todo:
        why = dict.fromkeys(f"{one.solver}: {there[one.solver].missing}" for one in left)
        raise InputError(
            f"{', '.join(dict.fromkeys(names))}: no problem was compared: {'; '.join(why)}"
        )
    lines = [line for cross, found in standing for line in judged(cross, found)]
    compared, broken = _compared(todo, len(standing), there, folder, keep=keep)
    lines += compared
    _write_hints(crosses, folder)
    _print(lines, {cross.id for cross, _ in standing}, broken)
    for name in SOLVERS:
        print(f"{name}: {there[name].missing or there[name].version}")
    for printed in _counts(lines, [found for _, found in standing], left):
        print(printed)
    outside = sum(line.state is CrossState.OUTSIDE for line in lines)
    return 1 if outside or broken else 0


def _compared(
    todo: Sequence[Cross], known: int, there: Mapping[str, Solver], folder: Path, *, keep: bool
) -> tuple[list[Crosscheck], list[str]]:
    """Comparisons of the solved problems, and reasons why other problems were not solved."""
    lines: list[Crosscheck] = []
    broken: list[str] = []

    def receive(cross: Cross, answer: store.Found | Lost) -> int:
        if isinstance(answer, Lost):
            broken.append(f"{cross.id}: {answer.reason}")
        else:
            lines.extend(judged(cross, answer))
            if keep:
                store.keep(cross, answer)
                return 1
        dispatch.unstored += 1
        return 1

    with shown(quiet=False) as show:
        dispatch = Dispatch(
            "problems of second solvers", known + len(todo), known, show,
            title=lambda cross: cross.id,
        )  # fmt: skip
        function = partial(_solved, there, folder)
        dispatch.run(local(0), function, queue(deque(todo)), receive)
    return lines, broken


def _solved(there: Mapping[str, Solver], folder: Path, cross: Cross) -> store.Found:
    return compare(cross, there[cross.solver], folder)


def compare(cross: Cross, solver: Solver, folder: Path) -> store.Found:
    """Results of one problem by the project and by the second solver.

    The files of the problem are written to a separate folder below `folder`. Raises RuntimeError if
    the second solver fails, LookupError if its output is incomplete.
    """
    own = folder / cross.file
    own.mkdir(parents=True, exist_ok=True)
    posed = cross.pose()
    deck = posed.write(own)
    seconds = solve(cross.solver, deck)
    return store.found_of(
        cross, solver.version, posed.ours, posed.read(deck), (posed.seconds, seconds),
        posed.unknowns,
    )  # fmt: skip


def _sorted(
    crosses: Sequence[Cross], there: Mapping[str, Solver], *, again: bool
) -> tuple[list[tuple[Cross, store.Found]], list[Cross], list[Cross]]:
    """Stored results of this code, problems to solve, and problems whose solver is missing."""
    standing: list[tuple[Cross, store.Found]] = []
    todo: list[Cross] = []
    left: list[Cross] = []
    for cross in crosses:
        found = None if again else store.current(cross)
        if found is not None:
            standing.append((cross, found))
        else:
            (left if there[cross.solver].missing else todo).append(cross)
    return standing, todo, left


def _write_hints(crosses: Sequence[Cross], folder: Path) -> None:
    """Write commands that solve each existing input file again, one per line."""
    decks = [
        (cross, folder / cross.file / f"deck.{'inp' if cross.solver == CALCULIX else 'json'}")
        for cross in crosses
    ]
    printed = [f"cd {c.file} && {rerun(c.solver, deck)}" for c, deck in decks if deck.exists()]
    if printed:
        (folder / "RERUN.txt").write_text("\n".join(printed) + "\n", "utf-8")


def _print(lines: Sequence[Crosscheck], standing: Collection[str], broken: Sequence[str]) -> None:
    """Print one line for each problem; results of an earlier run (`standing`) are marked."""
    table: list[tuple[str, ...]] = [HEAD]
    table += [
        (line.problem, line.quantity, "" if line.unit == "1" else line.unit, f"{line.ours:.6g}",
         f"{line.theirs:.6g}", f"{line.difference:+.1e}", f"{line.allowed:g}",
         *(f"{s:.2f}" for s in line.seconds),
         f"{line.state.value}{', stored' if line.problem in standing else ''}")
        for line in lines
    ]  # fmt: skip
    if lines:
        for row in aligned(table):
            print(raised(row))
    for line in lines:
        if line.state is CrossState.OUTSIDE:
            print_wrapped(raised(
                f"outside: {line.problem}, {line.quantity}: {line.difference:+.2%}, "
                f"allowed {line.allowed:.2%} ({line.why})"
            ))  # fmt: skip
    for one in broken:
        print(f"failed: {one}", file=sys.stderr)


def _counts(
    lines: Sequence[Crosscheck], standing: Sequence[store.Found], left: Sequence[Cross]
) -> Iterator[str]:
    """Lines with the number of comparisons, and of problems not solved in this run."""
    problems = len({line.problem for line in lines})
    yield f"{len(lines)} comparisons of {problems} problems"
    if standing:
        dates = sorted({found.date for found in standing})
        span = " to ".join(dict.fromkeys((dates[0], dates[-1])))
        known = f"{len(standing)} of {problems} problems are stored results of {span}"
        yield f"{known} (--again solves them again)"
    if left:
        absent = dict.fromkeys(cross.solver for cross in left)
        yield f"{len(left)} problems were not solved, for lack of {' and '.join(absent)}"
