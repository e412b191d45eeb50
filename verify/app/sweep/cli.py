"""Command line of `freewheel sweep`."""

from pathlib import Path

from verify.app.arguments import Engine, Jobs, Texts


def sweep(
    file: Path,
    /,
    *,
    vary: Texts = (),
    star: bool = False,
    sample: str = "",
    tolerance: Texts = (),
    only: Texts = (),
    jobs: Jobs = 0,
    engine: Engine = "local",
    scheduler: str = "",
    out: Path | None = None,
    json: bool = False,
    again: bool = False,
) -> int:
    """Compute the errors of the formulas over ranges of the inputs, and their range of validity.

    For each row, the command writes the difference between formula and finite elements with its
    error bar, and the regions in which the difference is within 2, 5 and 10 %. For a sample, the
    command writes the influence of the tolerances. Solved points are stored: the same command
    continues an interrupted sweep, and a finer sweep reuses the points.

    Parameters
    ----------
    file
        Parameter file (TOML), see `freewheel init`.
    vary
        An input and its values: FIRST:LAST:COUNT (z=3:12:10, b=0.3mm:2mm:9), the same with :log
        for logarithmic spacing (b=0.1mm:10mm:9:log), or a list (E=190GPa,210GPa). An input in a
        table is written as supports[2].k=... Several inputs give a grid.
    star
        Vary one input at a time instead of a grid; the other inputs have the values of the file.
    sample
        sobol:N, a sample for sensitivity indices; N is a power of two. A sample with d tolerances
        has N (d + 2) points.
    tolerance
        An input of the sample and its tolerance, uniformly distributed: b=±0.05mm, E=±5%.
    only
        Text in the names of the rows to compute; for some cases, this reduces the computation.
    jobs
        Number of processes; 0 for one per core.
    engine
        Place of the computation: processes on this machine (local), or a dask cluster (dask).
    scheduler
        Address of the scheduler of the cluster, such as tcp://host:8786; without an address, dask
        starts a local cluster.
    out
        Folder for the page and tables; the default is reports/out/sweep-FILE of this checkout.
    json
        Print JSON instead of text.
    again
        Solve failed points again.
    """
    from verify.app.sweep.command import run_sweep
    from verify.jobs.executor import Where

    return run_sweep(
        file, vary=vary, star=star, sample=sample, tolerances=tolerance, only=only,
        where=Where(jobs, engine, scheduler), out=out, as_json=json, again=again,
    )  # fmt: skip
