"""How `freewheel mutants` is called."""

from typing import Annotated, Literal

from cyclopts import Parameter

from verify.app.arguments import Jobs, Number

Group = Literal["references", "formulas", "judging", "finite-elements"]
Groups = Annotated[tuple[Group, ...], Parameter(negative="", consume_multiple=False)]


def mutants(
    *,
    all: bool = False,  # noqa: A002 - what it is called on the command line
    seed: Number = 0,
    jobs: Jobs = 0,
    only: Groups = (),
) -> int:
    """Move references, break formulas, judging and elements on purpose: count what is noticed.

    Takes the finite elements of an earlier `verify`. Every outcome is kept as it comes, so that a
    run goes on where one was interrupted; the score of seed 0 enters the report.

    Parameters
    ----------
    all
        Try every mutant instead of a sample, which takes hours.
    seed
        Another sample, whose score is printed and not kept.
    jobs
        Processes, 0 for one a core.
    only
        references, formulas, judging or finite-elements; by default all. May stand several times.
    """
    from verify.audit.mutation.command import run_mutants

    return run_mutants(whole=all, seed=seed, jobs=jobs, only=only)
