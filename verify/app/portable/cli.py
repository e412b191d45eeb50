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
    """Compare every row with the same row on emulated machines.

    A machine is another core type of OpenBLAS, another number of BLAS threads, numpy or numba
    for another processor, or inputs perturbed by 1e-13. Each runs with a separate cache. Lists
    rows whose status differs, and rows whose value changes by more than a tenth of the tolerance
    or whose tolerance differs. Exit status 1: there are rows of the first kind, or of the second
    without a stated reason. An interrupted run continues where it stopped.

    Parameters
    ----------
    cases
        Cases to run, all by default; see `freewheel list`.
    only
        A machine to compare with this one, all by default. May be repeated.
    seeds
        Number of perturbed input sets.
    list
        List the machines, and why some cannot be emulated here.
    again
        Remove the results of earlier runs.
    jobs
        Machines emulated in parallel, 0 for one per core.
    out
        Folder for the results, by default reports/out/portable of this checkout.
    """
    from verify.audit.portable.command import run_list, run_portable

    if list:
        return run_list(seeds)
    return run_portable(cases, only=only, seeds=seeds, jobs=jobs, again=again, out=out)
