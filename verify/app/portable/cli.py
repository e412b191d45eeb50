"""Command line of `freewheel portable`."""

from pathlib import Path

from verify.app.arguments import CaseId, Jobs, Number, Texts


def portable(
    *cases: CaseId,
    only: Texts = (),
    seeds: Number = 10,
    list: bool = False,  # noqa: A002 - the flag's name
    again: bool = False,
    jobs: Jobs = 0,
    out: Path | None = None,
) -> int:
    """Compare every row on this machine with the same row on emulated machines.

    An emulated machine has another core type of OpenBLAS, another number of BLAS threads, numpy or
    numba for another processor, or inputs perturbed by 1e-13. Each machine has a separate cache.
    The command lists rows whose status differs, whose value changes by more than a tenth of the
    tolerance, or whose tolerance differs. Exit status 1: a status differs, or another difference
    has no stated reason. The same command continues an interrupted run.

    Parameters
    ----------
    cases
        Cases to run; the default is all cases (see `freewheel list`).
    only
        Emulated machine to compare with this machine; the default is all. The option may be
        repeated.
    seeds
        Number of perturbed input sets.
    list
        List the machines, with the reason if a machine cannot be emulated here.
    again
        First remove the results of earlier runs.
    jobs
        Number of machines that are emulated in parallel; 0 for one per core.
    out
        Folder for the results, by default reports/out/portable of this checkout.
    """
    from verify.audit.portable.command import run_list, run_portable

    if list:
        return run_list(seeds)
    return run_portable(cases, only=only, seeds=seeds, jobs=jobs, again=again, out=out)
