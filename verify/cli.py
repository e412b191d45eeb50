"""The command `freewheel`. Exit status 0 passed, 1 a row failed, 2 bad input."""

import errno
import os
import signal
import sys
import tempfile
import traceback
from pathlib import Path
from typing import Annotated, Any, Literal

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")  # processes run side by side, and small solves gain nothing

from cyclopts import App, CycloptsError, Parameter  # noqa: E402 - threads are counted at import

from verify.definitions.cli import search  # noqa: E402

app = App(
    name="freewheel",
    help="Settles how far the design formulas of freewheel clutches can be trusted.",
    help_format="plaintext",
    version="0.1.0",
    exit_on_error=False,
    print_error=False,
    suppress_keyboard_interrupt=False,
)

BAD_INPUT = 2

app.command(search)


def _whole(_type: Any, tokens: Any) -> int:
    """A whole number; cyclopts by itself would round 1.5."""
    given = str(tokens[0].value)
    if not given.lstrip("+-").isdecimal():
        raise ValueError(f"needs a whole number, got {given!r}")
    return int(given)


def _case_ids(_context: Any) -> list[str]:
    """What a shell offers where a case is named."""
    from verify.cases.registry import CASES

    return [case.id for case in CASES]


def _templates(_context: Any) -> list[str]:
    """What a shell offers where a template is named."""
    return [*_case_ids(_context), "design-spring", "design-sprag"]


Jobs = Annotated[int, Parameter(name=("--jobs", "-j"), converter=_whole)]
Number = Annotated[int, Parameter(converter=_whole)]
Texts = Annotated[tuple[str, ...], Parameter(negative="", consume_multiple=False)]
Engine = Literal["local", "dask"]
Group = Literal["references", "formulas", "judging", "finite-elements"]
Groups = Annotated[tuple[Group, ...], Parameter(negative="", consume_multiple=False)]
CaseId = Annotated[str, Parameter(completer=_case_ids)]


@app.command
def verify(
    *cases: CaseId,
    quick: bool = False,
    jobs: Jobs = 0,
    engine: Engine = "local",
    scheduler: str = "",
    out: Path | None = None,
    cache: bool = True,
) -> int:
    """Pair every formula with finite elements, judge the rows and write the report.

    Parameters
    ----------
    cases
        Cases to run, all by default; see `freewheel list`.
    quick
        Only the cheap cases, at full sharpness; the others are skipped.
    jobs
        Processes, 0 for one a core.
    engine
        Processes of this machine, or a dask cluster.
    scheduler
        Address of the cluster's scheduler, tcp://host:8786; without it dask makes a cluster here.
    out
        Folder for the report, by default reports/out of this checkout.
    cache
        Reuse finite-element results of earlier runs.
    """
    from verify.commands import run_verify
    from verify.engines import Where

    where = Where(jobs, engine, scheduler)
    return run_verify(cases, quick=quick, where=where, out=out, use_cache=cache)


@app.command
def check(
    file: Path,
    /,
    *,
    fem: bool = False,
    dynamic: bool = False,
    json: bool = False,
    out: Path | None = None,
    jobs: Jobs = 0,
    cache: bool = True,
) -> int:
    """Put the parameters of a file through the formulas and warn where they leave their range.

    Parameters
    ----------
    file
        Parameter file (TOML): case = "ring-lame" and a table [inputs], a unit on every value.
    fem
        Run the finite elements too and judge the formulas on these parameters.
    dynamic
        Run the motion in time too, of a case that has one; compiled the first time, which takes
        some seconds.
    json
        Print JSON instead of text.
    out
        Folder for a report on these parameters: the page, tables, pictures, meshes.
    jobs
        Processes, 0 for one a core.
    cache
        Reuse finite-element results of earlier runs.
    """
    from verify.commands import run_check

    return run_check(
        file, use_fem=fem, use_dynamic=dynamic, as_json=json, jobs=jobs, use_cache=cache, out=out
    )


@app.command
def init(
    case: Annotated[str, Parameter(completer=_templates)], /, *, out: Path | None = None
) -> int:
    """Print a commented parameter file of a case with the paper's numbers.

    Parameters
    ----------
    case
        The case, see `freewheel list`; design-spring and design-sprag are tasks for
        `freewheel design`.
    out
        File to write instead; one that exists is never overwritten.
    """
    from verify.template import hand_over, run_init

    if case == "design-spring":
        from verify.design.template import template as of_spring

        hand_over(of_spring(), out)
        return 0
    if case == "design-sprag":
        from verify.design_sprag.template import template as of_sprag

        hand_over(of_sprag(), out)
        return 0
    return run_init(case, out)


@app.command
def design(
    file: Path,
    /,
    *,
    choose: Number | None = None,
    fem: bool = True,
    json: bool = False,
    out: Path | None = None,
) -> int:
    """Find the accordion springs that do a task, or the crown of a sprag with the least pressure.

    Parameters
    ----------
    file
        The task (TOML), see `freewheel init design-spring` and `freewheel init design-sprag`; a
        file of sprag-clutch does as well.
    choose
        Of springs, the member of the front to go on with; by default the one nearest to the best
        of everything that finite elements keep.
    fem
        Set finite elements beside every member of the front, a half-space beside the crown.
    json
        Print JSON instead of text.
    out
        Folder for the page, all candidates and a parameter file of what is chosen.
    """
    from verify.inputs import read_parameter_file

    case, _, _ = read_parameter_file(file)
    if case in ("design-sprag", "sprag-clutch"):
        from verify.design_sprag.command import run_design as run_sprag

        return run_sprag(file, choose=choose, use_fem=fem, as_json=json, out=out)
    from verify.design.command import run_design

    return run_design(file, choose=choose, use_fem=fem, as_json=json, out=out)


@app.command
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
    from verify.engines import Where
    from verify.sweep.command import run_sweep

    return run_sweep(
        file, vary=vary, star=star, sample=sample, tolerances=tolerance, only=only,
        where=Where(jobs, engine, scheduler), out=out, as_json=json, again=again,
    )  # fmt: skip


@app.command
def explain(
    *row: CaseId,
    json: bool = False,
    jobs: Jobs = 0,
    cache: bool = True,
) -> int:
    """Show how a row was judged, number by number; a parameter file may stand last.

    Parameters
    ----------
    row
        The row's name, a part of it, or words that it contains.
    json
        Print JSON instead of text.
    jobs
        Processes, 0 for one a core.
    cache
        Reuse finite-element results of earlier runs.
    """
    from verify.explain import run_explain

    return run_explain(row, as_json=json, jobs=jobs, use_cache=cache)


@app.command
def deep(*cases: str, again: bool = False, jobs: Jobs = 0) -> int:
    """Measure what takes longer than `verify` may: maps, regions, error budgets for its report.

    What was measured is kept while the code stands that made it; a run goes on where one was
    interrupted.

    Parameters
    ----------
    cases
        Measurements to make: validity, validity:CASE, budget, budget:CASE or a map's name; by
        default all that are missing.
    again
        Measure anew what is there already.
    jobs
        Processes, 0 for one a core.
    """
    from verify.deep import run_deep

    return run_deep(cases, jobs=jobs, again=again)


@app.command
def crosscheck(
    *cases: CaseId,
    list: bool = False,  # noqa: A002 - the flag's name
    again: bool = False,
    keep: bool = True,
    out: Path | None = None,
) -> int:
    """Solve the project's meshes and loads by second solvers: calculix, tamaas, ROSS.

    Their results stand beside the project's own in its report. Those that are not installed are
    left out; 1 where a comparison is farther apart than allowed.

    Parameters
    ----------
    cases
        Cases whose problems to compare, by default all that have some.
    list
        Name the comparisons and the solvers that are there.
    again
        Solve anew what is kept for this code.
    keep
        Keep what is found for the report, in verify/measured.
    out
        Folder for decks and answers, by default reports/out/crosscheck of this checkout.
    """
    from verify.crosscheck.command import run_crosscheck, run_list

    if list:
        return run_list(cases)
    return run_crosscheck(cases, out=out, again=again, keep=keep)


@app.command
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
    from verify.mutation.command import run_mutants

    return run_mutants(whole=all, seed=seed, jobs=jobs, only=only)


@app.command
def doctor(*, json: bool = False) -> int:
    """Say what this machine has and lacks for a run, and what to install.

    Parameters
    ----------
    json
        Print JSON instead of text.
    """
    from verify.doctor import run_doctor

    return run_doctor(as_json=json)


@app.command
def completion(shell: Literal["bash", "zsh", "fish"], /) -> int:
    """Print the completion script of a shell; `--install-completion` sets it up."""
    print(app.generate_completion(shell=shell))
    return 0


app.register_install_completion_command(help="Set up completion for the shell in use.")


@app.command(name="list")
def list_cases() -> int:
    """Name the cases and what they verify."""
    from verify.commands import run_list

    return run_list()


def main(arguments: list[str] | None = None) -> None:
    """Entry point; ends the process with the exit status."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # ends like Ctrl-C
    sys.exit(run(sys.argv[1:] if arguments is None else arguments))


def run(arguments: list[str]) -> int:
    """Run one command line and return its exit status."""
    if "" in arguments and arguments[0] != "__complete":  # where a shell asks what may follow
        return _complain("an argument is empty: a variable of the shell that is not set?")
    try:
        status = int(app(arguments, result_action="return_value") or 0)
        sys.stdout.flush()  # a full disk or a closed pipe is noticed here, not at the very end
        return status
    except CycloptsError as error:
        return _complain(str(error))
    except KeyboardInterrupt as stop:  # solving says what is kept
        return _complain(str(stop) or "interrupted", status=130)
    except BrokenPipeError:  # `freewheel ... | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except ImportError as error:
        return _complain(f"{error}: see freewheel doctor")
    except (ValueError, OSError) as error:
        if isinstance(error, OSError) and error.errno == errno.ENOSPC and not error.filename:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return _complain(f"standard output: {error.strerror}")
        return _complain(str(error))
    except Exception as error:  # a fault of the program: one line, and the rest in a file
        with tempfile.NamedTemporaryFile(
            "w", prefix="freewheel-", suffix=".txt", delete=False
        ) as file:
            file.write(traceback.format_exc())
        said = f"{type(error).__name__}: {error}; this is a fault of the program"
        return _complain(f"{said}, its traceback is in {file.name}")


def _complain(message: str, status: int = BAD_INPUT) -> int:
    print(f"freewheel: {' '.join(message.split())}", file=sys.stderr)
    return status


if __name__ == "__main__":
    main()
