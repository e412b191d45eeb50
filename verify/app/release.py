"""Write a release: a full run without a failed row, of committed code."""

import subprocess
import time
from pathlib import Path

from verify.app.report import make_report
from verify.audit.releases.changes import WITHOUT
from verify.audit.releases.store import path_of, store, version
from verify.cases.registry import CASES
from verify.core.inputs import InputError
from verify.core.results import Report, Status
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve


def release(root: Path, folder: Path | None = None, *, jobs: int = 0) -> Path:
    """Run all cases and store their rows under the version of pyproject.toml; the file.

    InputError if the version is stored already, a file is not committed, or a row failed.
    """
    name = version(root)
    path = path_of(name, folder)
    if path.exists():
        raise InputError(f"{path.name} exists already: raise the version in pyproject.toml")
    refuse_uncommitted(root)
    start = time.perf_counter()
    results = solve([Job(case, case.inputs(), drawn=False) for case in CASES], Where(jobs), True)
    report = make_report(results, CASES, time.perf_counter() - start)
    refuse_red(report)
    return store(report.rows, name, report.provenance["commit"], folder)


def refuse_uncommitted(root: Path) -> None:
    """InputError unless all files are as they were committed."""
    run = ["git", "-C", str(root), "status", "--porcelain"]
    try:
        done = subprocess.run(run, capture_output=True, text=True, timeout=60, check=True)  # noqa: S603
    except (OSError, subprocess.SubprocessError) as error:
        raise InputError("a release needs git, to check that all changes are committed") from error
    if changed := done.stdout.splitlines():
        raise InputError(f"a release needs all changes committed: {changed[0].strip()}")


def refuse_red(report: Report) -> None:
    """InputError if a row failed or was not run, or a demand was loosened without a reason."""
    for row in report.rows:
        if row.status in (Status.FAIL, Status.SKIP):
            raise InputError(f"a release needs every row: {row.id}: {row.status}: {row.reason}")
    if report.drift and report.drift.unexplained:
        raise InputError(f"{WITHOUT}: {report.drift.unexplained[0].row}")
