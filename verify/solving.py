"""Run jobs for a command: processes, cache and progress."""

import os
import sys
import tempfile
from pathlib import Path

from verify import cache
from verify.inputs import InputError
from verify.results import CaseResult
from verify.run import Job, run

MOST_JOBS = 256


def solve(work: list[Job], jobs: int, use_cache: bool, *, quiet: bool = False) -> list[CaseResult]:
    """Run the jobs in `jobs` processes (0: one a core), with the cache and progress on stderr."""
    if not 0 <= jobs <= MOST_JOBS:
        raise InputError(f"--jobs is 0 (one a core) to {MOST_JOBS}, got {jobs}")
    folder = _writable_cache() if use_cache and any(job.use_fem for job in work) else None
    processes = jobs if jobs > 0 else os.cpu_count() or 1
    if quiet or not any(job.use_fem for job in work) or not sys.stderr.isatty():
        return run(work, processes=processes, cache_folder=folder)
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("finite elements", total=None)

        def progress(what: str, done: int, total: int) -> None:
            bar.update(task, description=what, completed=done, total=total)

        return run(work, processes=processes, cache_folder=folder, progress=progress)


def _writable_cache() -> Path | None:
    """The cache folder; None, with a word about it, where nothing can be stored."""
    folder = cache.default_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError as error:
        print(f"freewheel: no cache in {folder} ({error.strerror}): going on", file=sys.stderr)
        return None
