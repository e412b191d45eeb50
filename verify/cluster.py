"""A dask cluster as an engine: one that listens somewhere, or one of processes made for the run."""

import logging
from collections.abc import Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from typing import Any

from verify.engines import Engine, GoneError
from verify.inputs import InputError

PATIENCE = 30.0  # s for a scheduler to answer, and for its first worker
AHEAD = 1  # task that waits on the cluster for each that is solved


@contextmanager
def dask(processes: int, scheduler: str = "") -> Iterator[Engine]:
    """The cluster of the scheduler at an address, tcp://host:port; without one, a local one.

    A local cluster has `processes` workers of one thread. GoneError where nothing answers.
    """
    import dask.config
    from distributed import Client, LocalCluster
    from distributed.scheduler import KilledWorker

    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what matters is said here
    with dask.config.set({"distributed.comm.timeouts.connect": f"{PATIENCE}s"}):
        cluster: Any = None
        if not scheduler:
            cluster = LocalCluster(
                n_workers=processes, threads_per_worker=1, processes=True, dashboard_address=None,
                silence_logs=logging.CRITICAL, host="127.0.0.1",
            )  # fmt: skip
        try:
            client: Any = Client(cluster or scheduler, timeout=PATIENCE, set_as_default=False)
        except (OSError, ValueError) as error:
            if isinstance(error, ValueError):
                raise InputError(f"--scheduler {scheduler}: {error}") from error
            raise GoneError(
                f"no dask scheduler answers at {scheduler} within {PATIENCE:g} s"
            ) from error
        try:
            place = scheduler or "this machine"
            try:
                client.wait_for_workers(1, timeout=PATIENCE)
            except TimeoutError as error:
                raise GoneError(f"the scheduler at {place} has no workers") from error
            yield Engine(
                client.get_executor(pure=False),
                lambda: max(1, sum(client.nthreads().values())) if _listens(client) else 1,
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


def _listens(client: Any) -> bool:
    return bool(client.status == "running")
