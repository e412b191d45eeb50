"""Command line of `freewheel mutants`."""

from typing import Annotated, Literal

from cyclopts import Parameter

from verify.app.arguments import Jobs, Number

Group = Literal["references", "formulas", "judging", "finite-elements"]
Groups = Annotated[tuple[Group, ...], Parameter(negative="", consume_multiple=False)]


def mutants(
    *,
    all: bool = False,  # noqa: A002 - the flag's name
    seed: Number = 0,
    jobs: Jobs = 0,
    only: Groups = (),
) -> int:
    """Insert faults into references, formulas, judging and finite elements; count detected faults.

    The command uses finite-element results of an earlier `verify`. Every result is stored
    immediately; the same command continues an interrupted run. The report contains the share of
    detected faults in the random sample with seed 0.

    Parameters
    ----------
    all
        Test all faults instead of a random sample; this takes hours.
    seed
        Seed of the random sample of faults. Results of a seed other than 0 are only printed.
    jobs
        Number of processes; 0 for one per core.
    only
        Group of faults: references, formulas, judging or finite-elements; the default is all
        groups. The option may be repeated.
    """
    from verify.audit.mutation.command import run_mutants

    return run_mutants(whole=all, seed=seed, jobs=jobs, only=only)
