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
    """Solve problems of the project with second solvers: calculix, tamaas, ROSS.

    The second solvers use the meshes and loads of the project; the report compares the results.
    Results that are stored for this code are listed with their date and not solved again. Solvers
    that are not installed are skipped. Exit status 1: a difference exceeds its limit; 2: no problem
    of the named cases was compared.

    Parameters
    ----------
    cases
        Cases to compare; the default is all cases with a problem for a second solver.
    list
        List the comparisons and the installed solvers.
    again
        Solve problems with stored results again; this also writes their input files.
    keep
        Store the results for the report, in verify/measured.
    out
        Folder for input and output files; the default is reports/out/crosscheck of this checkout.
    """
    from verify.app.crosscheck.command import run_crosscheck, run_list

    if list:
        return run_list(cases)
    return run_crosscheck(cases, out=out, again=again, keep=keep)
