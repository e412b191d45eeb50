"""Runs jobs for a command, with cache, processes, progress display, and a clean end if stopped."""

import sys
from collections.abc import Callable
from pathlib import Path

from verify.core import source_memory
from verify.core.progress import shown
from verify.core.results import CaseResult
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.earlier_files import adopt
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.processes import refuse_reimport
from verify.jobs.scheduler import run


def solve(
    work: list[Job],
    where: Where,
    use_cache: bool,
    *,
    quiet: bool = False,
    judged: Callable[[CaseResult], None] | None = None,
) -> list[CaseResult]:
    """Run the jobs on the given engine, with the cache, and progress on stderr.

    On this machine, `judged` receives each case that is judged while other cases are solved; on a
    cluster, it is not called. The messages of KeyboardInterrupt and GoneError state what is stored
    for the next run.
    """
    refuse_reimport()
    folder = _cache_folder() if use_cache and any(job.use_fem for job in work) else None
    with shown(quiet=quiet) as show:
        return run(
            work, engine=where.entered(), cache_folder=folder, show=show, warn=_print_message,
            judged=judged if where.engine == "local" else None,
        )  # fmt: skip


def stored_levels(work: list[Job]) -> list[str]:
    """Keys of the stored levels from which the results of jobs are judged."""
    return [
        cache.key(job.case, job.inputs, level)
        for job in work if job.use_fem
        for level in job.case.levels
    ]  # fmt: skip


def _cache_folder() -> Path | None:
    """Folder of the store.

    It is None, after a message, if the store can be neither written nor read.
    """
    folder = cache.default_folder()
    source_memory.use(folder)
    store = Store(folder)
    try:
        store.check()
        if moved := adopt(folder):
            _print_message(f"{moved} results of an earlier version were moved into {store.path}")
    except OSError as error:
        _print_message(f"{error}: going on without")
        return folder if _is_readable(store) else None
    return folder


def _is_readable(store: Store) -> bool:
    try:
        return bool(store.groups())
    except OSError:
        return False


def _print_message(message: str) -> None:
    print(f"freewheel: {message}", file=sys.stderr, flush=True)
