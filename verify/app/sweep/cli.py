"""How `freewheel sweep` is called."""

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
    """Say over ranges of the inputs how wrong formulas are, and where they stop being usable.

    Writes the difference of each row's formula from finite elements with its error bar, and the
    region where it stays within 2, 5 and 10 %; or, of a sample, which tolerances matter. Points are
    kept as they are solved: a sweep that was stopped goes on, a finer one reuses them.

    Parameters
    ----------
    file
        Parameter file (TOML), see `freewheel init`.
    vary
        An input and its values: z=3:12:10, b=0.3mm:2mm:9, b=0.1mm:10mm:9:log, E=190GPa,210GPa or
        supports[2].k=...; several make a grid.
    star
        Vary one input at a time instead, the others as in the file.
    sample
        sobol:N, a sample for sensitivity indices with N a power of two: N (d + 2) points for d
        tolerances.
    tolerance
        An input of the sample and how far off it may be, evenly distributed: b=±0.05mm, E=±5%.
    only
        Rows whose names contain this; some cases solve only what these need.
    jobs
        Processes, 0 for one a core.
    engine
        Processes of this machine, or a dask cluster.
    scheduler
        Address of the cluster's scheduler, tcp://host:8786; without it dask makes a cluster here.
    out
        Folder for the page and tables, by default reports/out/sweep-FILE of this checkout.
    json
        Print JSON instead of text.
    again
        Solve anew the points that failed.
    """
    from verify.app.sweep.command import run_sweep
    from verify.jobs.executor import Where

    return run_sweep(
        file, vary=vary, star=star, sample=sample, tolerances=tolerance, only=only,
        where=Where(jobs, engine, scheduler), out=out, as_json=json, again=again,
    )  # fmt: skip
