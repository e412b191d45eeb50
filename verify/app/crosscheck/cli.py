"""How `freewheel crosscheck` is called."""

from pathlib import Path

from verify.app.arguments import CaseId


def crosscheck(
    *cases: CaseId,
    list: bool = False,  # noqa: A002 - the flag's name
    again: bool = False,
    keep: bool = True,
    out: Path | None = None,
) -> int:
    """Solve the project's meshes and loads by second solvers: calculix, tamaas, ROSS.

    Their results stand beside the project's own in its report. What is kept for this code is shown
    with its date and not solved again. Solvers that are not installed are left out; 1 where a
    comparison is farther apart than allowed, 2 where nothing of the cases named can be compared.

    Parameters
    ----------
    cases
        Cases whose problems to compare, by default all that have some.
    list
        Name the comparisons and the solvers that are there.
    again
        Solve again what is kept for this code, which writes its decks, too.
    keep
        Keep what is found for the report, in verify/measured.
    out
        Folder for decks and answers of what is solved, by default reports/out/crosscheck of this
        checkout.
    """
    from verify.app.crosscheck.command import run_crosscheck, run_list

    if list:
        return run_list(cases)
    return run_crosscheck(cases, out=out, again=again, keep=keep)
