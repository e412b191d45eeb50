"""The command `freewheel`; exit status 0: passed, 1: failed, 2: wrong input, 3: undecided."""

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

from verify.app.arguments import CaseId, Engine, Jobs, ProblemKind, case_ids  # noqa: E402
from verify.app.crosscheck.cli import crosscheck  # noqa: E402
from verify.app.design.cli import design  # noqa: E402
from verify.app.mutation.cli import mutants  # noqa: E402
from verify.app.page.cli import app as local_page  # noqa: E402
from verify.app.portable.cli import portable  # noqa: E402
from verify.app.readings.cli import search  # noqa: E402
from verify.app.sweep.cli import sweep  # noqa: E402

app = App(
    name="freewheel",
    help="Verifies the design formulas of freewheel clutches against finite elements.",
    help_format="markdown",
    version="0.2.0",
    exit_on_error=False,
    print_error=False,
    suppress_keyboard_interrupt=False,
)

BAD_INPUT = 2

for _command in (search, design, sweep, crosscheck, mutants, portable):
    app.command(_command)
app.command(local_page, name="app")


def _templates(_context: Any) -> list[str]:
    """Names of cases and templates that a shell suggests."""
    return [*case_ids(_context), "design-spring", "design-sprag"]


@app.command
def verify(
    *cases: CaseId,
    quick: bool = False,
    jobs: Jobs = 0,
    engine: Engine = "local",
    scheduler: str = "",
    out: Path | None = None,
    cache: bool = True,
    single_file: bool = False,
    pdf: Literal["record", "full"] = "record",
    summary: Path | None = None,
) -> int:
    """Compare every formula with finite elements, judge the rows and write the report.

    Parameters
    ----------
    cases
        Cases to run; the default is all cases (see `freewheel list`).
    quick
        Run only the fast cases of every subject; their rows are judged as without this option.
    jobs
        Number of processes; 0 for one per core.
    engine
        Place of the computation: processes on this machine (local), or a dask cluster (dask).
    scheduler
        Address of the scheduler of the cluster, such as tcp://host:8786; without an address, dask
        starts a local cluster.
    out
        Folder for the report; the default is reports/out of this checkout.
    cache
        Reuse finite-element results of earlier runs.
    single_file
        Write the report as a single page, for e-mail, instead of one page per case.
    pdf
        Content of report.pdf: record (verdicts, tables, errata of the papers, one page per case) or
        full (everything). The PDF of a single case is always full.
    summary
        File to which a summary in Markdown is appended, for the page of a CI job; /dev/stdout
        prints it.
    """
    from verify.app.commands import run_verify
    from verify.jobs.executor import Where

    where = Where(jobs, engine, scheduler)
    return run_verify(
        cases, quick=quick, where=where, out=out, use_cache=cache, single_file=single_file,
        full_pdf=pdf == "full", summary=summary,
    )  # fmt: skip


@app.command
def check(
    file: Path,
    /,
    *,
    fem: bool = False,
    dynamic: bool = False,
    json: bool = False,
    keys: bool = False,
    units: Literal["si", "mm", "inch"] | None = None,
    out: Path | None = None,
    jobs: Jobs = 0,
    cache: bool = True,
) -> int:
    """Print whether a part holds, and its design value, margin and limiting criterion.

    Exit status: 0 the part holds, 1 the part or a row fails, 2 wrong input, 3 "cannot say".

    Parameters
    ----------
    file
        Parameter file (TOML): case = "ring-lame" and a table [inputs]; every value has a unit.
    fem
        Also solve the finite elements for these inputs and compare the formulas with them.
    dynamic
        Also simulate the motion in time, if the case supports it; the first run takes some seconds
        longer.
    json
        Print JSON instead of text; `--keys` lists its keys.
    keys
        List the keys of all inputs and computed values of the case; FILE may also be the name
        of a case.
    units
        Units of the answer: si (m, N, Pa), mm (mm, N, MPa) or inch (in, lbf, ksi). The default is
        inch if most lengths of the file are in inches, otherwise mm.
    out
        Folder for a report on these inputs: page, tables, pictures, meshes.
    jobs
        Number of processes; 0 for one per core.
    cache
        Reuse finite-element results of earlier runs.
    """
    from verify.app.check_command import Options, run_check

    if keys:
        from verify.app.check_keys import run_keys

        return run_keys(file)
    options = Options(fem=fem, dynamic=dynamic, json=json, jobs=jobs, cache=cache, out=out,
                      units=units)  # fmt: skip
    return run_check(file, options)


@app.command
def init(
    case: Annotated[str, Parameter(completer=_templates)], /, *, out: Path | None = None
) -> int:
    """Print a commented parameter file of a case with numbers of the paper or of this project.

    Parameters
    ----------
    case
        A case (`freewheel list`), or a task of `freewheel design`: design-spring, design-sprag.
    out
        File to which the text is written instead of the terminal; it must not exist.
    """
    from verify.answers.template import hand_over, run_init

    if case == "design-spring":
        from verify.studies.design.template import template as of_spring

        hand_over(of_spring(), out)
        return 0
    if case == "design-sprag":
        from verify.studies.design_sprag.template import template as of_sprag

        hand_over(of_sprag(), out)
        return 0
    return run_init(case, out)


@app.command
def explain(
    *row: CaseId,
    json: bool = False,
    jobs: Jobs = 0,
    cache: bool = True,
) -> int:
    """Print step by step how a row was judged, or print the verdict of a formula.

    Parameters
    ----------
    row
        Name of a row, or words of this name; a parameter file may follow. For the verdict of an
        equation: its paper and number, such as Belcin Eq. 20.
    json
        Print JSON instead of text.
    jobs
        Number of processes; 0 for one per core.
    cache
        Reuse finite-element results of earlier runs.
    """
    from verify.app.explain import run_explain

    return run_explain(row, as_json=json, jobs=jobs, use_cache=cache)


@app.command
def deep(*cases: str, again: bool = False, jobs: Jobs = 0) -> int:
    """Run the studies that take too long for `verify`: maps, validity regions, error budgets.

    Results remain valid until the code that computed them changes. The same command continues an
    interrupted run.

    Parameters
    ----------
    cases
        Studies to run: validity, validity:CASE, budget, budget:CASE or the name of a map; the
        default is all studies without a valid result.
    again
        Write the records again from stored results, and compute failed points again.
        To compute all points again, first run `freewheel store --clear KIND:CASE`.
    jobs
        Number of processes; 0 for one per core.
    """
    from verify.studies.deep import run_deep

    return run_deep(cases, jobs=jobs, again=again)


@app.command
def doctor(*, json: bool = False) -> int:
    """List the required components, which of them are missing, and what to install.

    Parameters
    ----------
    json
        Print JSON instead of text.
    """
    from verify.app.doctor import run_doctor

    return run_doctor(as_json=json)


@app.command
def store(
    case: CaseId = "", /, *, json: bool = False, clear: str | None = None, code: str = ""
) -> int:
    """List the stored results by kind and subject, with their sizes and ages.

    Parameters
    ----------
    case
        Case whose stored results are listed, with their files and whether they are valid
        for this code.
    json
        Print JSON instead of text.
    clear
        Before listing, remove the results of a kind, or of KIND:SUBJECT (such as fem:ring-lame).
    code
        Module, such as `analytic.ring.lame`, or its file; the cases that use it are listed.
    """
    from verify.app.store import run_origin, run_store

    if case or code:
        return run_origin(case, code, other=json or clear is not None)
    return run_store(as_json=json, clear=clear)


@app.command
def new_case(file: Path, /, *, kind: ProblemKind = "plane") -> int:
    """Write a commented Python file with a new case; the file runs without changes.

    Parameters
    ----------
    file
        File to write, such as `my_pipe.py`; it must not exist.
    kind
        Kind of problem: a plane body, two bodies in contact, a frame of beams, a sector of a ring,
        a shaft as a rotor, or a body of revolution.
    """
    from verify.app.new_case import run_new_case

    return run_new_case(file, kind)


@app.command
def completion(shell: Literal["bash", "zsh", "fish"], /) -> int:
    """Print the completion script of a shell; `--install-completion` installs it."""
    print(app.generate_completion(shell=shell))
    return 0


app.register_install_completion_command(help="Set up completion for the shell in use.")


@app.command(name="list")
def list_cases() -> int:
    """List the cases with their verdicts and inputs."""
    from verify.app.commands import run_list

    return run_list()


def main(arguments: list[str] | None = None) -> None:
    """Entry point; ends the process with the exit status."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # ends like Ctrl-C
    sys.exit(run(sys.argv[1:] if arguments is None else arguments))


def run(arguments: list[str]) -> int:
    """Run one command line and return its exit status."""
    if "" in arguments and arguments[0] != "__complete":  # a shell requests suggestions
        return _complain("an argument is empty: possibly a shell variable is not set")
    try:
        status = int(app(arguments, result_action="return_value") or 0)
        sys.stdout.flush()  # a full disk or a closed pipe is noticed here, not at the very end
        return status
    except CycloptsError as error:
        return _complain(str(error))
    except KeyboardInterrupt as stop:  # its message states what is stored
        return _complain(str(stop) or "interrupted", status=130)
    except BrokenPipeError:  # `freewheel ... | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except ImportError as error:
        from verify.app.extras import missing_library

        return _complain(missing_library(error))
    except (ValueError, OSError) as error:
        if isinstance(error, OSError) and error.errno == errno.ENOSPC and not error.filename:
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return _complain(f"standard output: {error.strerror}")
        return _complain(str(error))
    except Exception as error:  # an internal error: one line, and the traceback in a file
        return _complain(f"internal error: {type(error).__name__}: {error}{_traced()}")


def _traced() -> str:
    """Write the traceback of the present error to a file.

    Returns a phrase with the name of the file, or with the reason why it was not written.
    """
    try:
        with tempfile.NamedTemporaryFile(
            "w", prefix="freewheel-", suffix=".txt", delete=False, encoding="utf-8",
            errors="backslashreplace",
        ) as file:  # fmt: skip
            file.write(traceback.format_exc())
    except OSError as error:
        return f"; the traceback cannot be written: {error.strerror}"
    return f"; the traceback is in {file.name}"


def _complain(message: str, status: int = BAD_INPUT) -> int:
    print(f"freewheel: {' '.join(message.split())}", file=sys.stderr)
    return status


if __name__ == "__main__":
    main()
