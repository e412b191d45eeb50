"""Command line of `freewheel crosscheck`."""

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

    The report compares their results with those of the project. Stored results of this code are
    listed with their date and not solved again. Solvers that are not installed are skipped. Exit
    status 1: a difference exceeds the allowed one; 2: no problem of the named cases was compared.

    Parameters
    ----------
    cases
        Cases to compare, by default all that have a problem for a second solver.
    list
        List the comparisons and the installed solvers.
    again
        Solve the stored problems again, which also writes their decks.
    keep
        Store the results for the report, in verify/measured.
    out
        Folder for decks and answers, by default reports/out/crosscheck of this checkout.
    """
    from verify.app.crosscheck.command import run_crosscheck, run_list

    if list:
        return run_list(cases)
    return run_crosscheck(cases, out=out, again=again, keep=keep)
