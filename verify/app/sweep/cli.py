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

    Writes the difference of each row's formula from finite elements with its error bar, and the
    region where it is within 2, 5 and 10 %; for a sample, the influence of the tolerances. Solved
    points are stored: an interrupted sweep continues where it stopped, a finer one reuses them.

    Parameters
    ----------
    file
        Parameter file (TOML), see `freewheel init`.
    vary
        An input and its values: z=3:12:10, b=0.3mm:2mm:9, b=0.1mm:10mm:9:log, E=190GPa,210GPa or
        supports[2].k=...; several make a grid.
    star
        Vary one input at a time instead, with the others as in the file.
    sample
        sobol:N, a sample for sensitivity indices with N a power of two: N (d + 2) points for d
        tolerances.
    tolerance
        An input of the sample and its tolerance, uniformly distributed: b=±0.05mm, E=±5%.
    only
        Only rows whose names contain this; some cases then solve less.
    jobs
        Processes, 0 for one per core.
    engine
        Processes on this machine, or a dask cluster.
    scheduler
        Address of the cluster's scheduler, tcp://host:8786; without it dask starts a local cluster.
    out
        Folder for the page and tables, by default reports/out/sweep-FILE of this checkout.
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
