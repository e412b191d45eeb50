"""A dask cluster as an engine: an existing cluster at an address, or one started for the run."""

import logging
import time
from collections.abc import Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from typing import Any

from verify.jobs.engine import Engine, GoneError
from verify.jobs.processes import GUARD, interrupts_blocked

PATIENCE = 10.0  # s for a scheduler to answer, and for its first worker
EVERY = 1.0  # s between two questions for the workers
# Workers give memory back at once by default, and every larger array costs its page faults again:
# a fifth to a third of a solve.
ENVIRONMENT = {
    "distributed.nanny.pre-spawn-environ.MALLOC_TRIM_THRESHOLD_": 1 << 30,
    "distributed.nanny.pre-spawn-environ.MALLOC_MMAP_THRESHOLD_": 1 << 25,
}
AHEAD = 1  # task that waits on the cluster for each that is solved


@contextmanager
def dask(processes: int, scheduler: str = "") -> Iterator[Engine]:
    """Engine of the dask cluster at the address `scheduler` (tcp://host:port), or of a local one.

    If `scheduler` is empty, a local cluster is started; it has `processes` workers with one thread
    each. Raises GoneError if no scheduler or worker answers.
    """
    import dask.config
    from distributed import Client, LocalCluster
    from distributed.scheduler import KilledWorker

    for name in [n for n in logging.root.manager.loggerDict if n.startswith("distributed")]:
        logging.getLogger(name).setLevel(logging.CRITICAL)  # errors are reported here
    with dask.config.set({"distributed.comm.timeouts.connect": f"{PATIENCE}s"} | ENVIRONMENT):
        cluster: Any = None
        if not scheduler:
            try:
                with interrupts_blocked():
                    cluster = LocalCluster(
                        n_workers=processes, threads_per_worker=1, processes=True,
                        dashboard_address=None, silence_logs=logging.CRITICAL, host="127.0.0.1",
                    )  # fmt: skip
            except RuntimeError as error:
                raise GoneError(
                    f"no worker can be started ({error}); in a script, {GUARD}"
                ) from error
        try:
            client: Any = Client(cluster or scheduler, timeout=PATIENCE, set_as_default=False)
        except OSError as error:
            raise GoneError(
                f"no dask scheduler answers at {scheduler} within {PATIENCE:g} s: check the address"
            ) from error
        try:
            place = scheduler or "this machine"
            try:
                client.wait_for_workers(1, timeout=PATIENCE)
            except TimeoutError as error:
                raise GoneError(
                    f"the scheduler at {place} has no workers: start at least one"
                ) from error
            yield Engine(
                client.get_executor(pure=False),
                _Threads(client),
                deadly=(KilledWorker, CancelledError),
                gone=lambda: "" if _listens(client) else f"the scheduler at {place} is gone",
                ahead=AHEAD,
                remote=True,
            )
        finally:
            with suppress(Exception):  # a scheduler that died answers no farewell
                client.close(timeout=2)
            if cluster is not None:
                with suppress(Exception):
                    cluster.close(timeout=5)


class _Threads:
    """Number of threads of the workers. It is requested repeatedly, because workers may change."""

    def __init__(self, client: Any) -> None:
        self.client, self.asked, self.count = client, 0.0, 1

    def __call__(self) -> int:
        if _listens(self.client) and time.monotonic() > self.asked + EVERY:
            self.asked = time.monotonic()
            with suppress(OSError, TimeoutError):  # it may die while it is asked
                self.count = max(1, sum(self.client.nthreads().values()))
        return self.count


def _listens(client: Any) -> bool:
    return bool(client.status == "running")
