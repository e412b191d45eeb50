"""An executor whose processes may die. Only the task of the dead process is lost.

The executors of the standard library stop all tasks if one process dies, and wait for running tasks
when they are shut down. Here, each thread of a pool controls one process. Shutting down kills all
processes, and a process ends if its parent process has ended.
"""

import os
import pickle
import signal
import threading
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from multiprocessing import (
    connection,
    current_process,
    get_context,
    parent_process,
    resource_tracker,
)
from typing import Any

SPAWN = get_context("spawn")  # a forked child would share gmsh's state
THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
# glibc gives every large array back to the system at once, and the next one costs its pages again:
# up to a fifth of the time of a solver with many of them. Processes hold as much as this.
MEMORY = ("MALLOC_MMAP_THRESHOLD_", "MALLOC_TRIM_THRESHOLD_")
HELD = 2**30  # bytes

UNGUARDED = 97  # exit status of a process whose script starts processes while it is imported
GUARD = (
    "each process that was started imports the script again, and the script then starts processes "
    'itself: put the calls of the script under `if __name__ == "__main__":`'
)


def refuse_reimport() -> None:
    """End this process if it is still importing the script of its parent; the parent reports this.

    A spawned process imports this script before it gets a task. Without
    `if __name__ == "__main__":`, the script would run in every process and write its files there.
    """
    if getattr(current_process(), "_inheriting", False):  # set by multiprocessing until it is done
        os._exit(UNGUARDED)


class WorkerDiedError(BrokenExecutor):
    """The process died during this task. The message states its exit status or signal."""


class RemoteTraceback(Exception):  # noqa: N818 - the cause of another exception, never raised
    """Traceback of an exception in another process, as text."""


class Processes(ThreadPoolExecutor):
    """Executor with `count` spawned processes, each with one task at a time.

    Functions are transferred by name.

    A task whose process dies raises WorkerDiedError; the next task gets a new process. Each process
    has one BLAS thread unless the environment states another number.
    """

    def __init__(self, count: int) -> None:
        refuse_reimport()
        for name in THREADS:  # inherited: two processes of two threads each wait for each other
            os.environ.setdefault(name, "1")
        for name in MEMORY:
            os.environ.setdefault(name, str(HELD))
        resource_tracker.ensure_running()  # started by a thread it would let Ctrl-C through there
        super().__init__(count, initializer=_without_interrupts)
        self._own = threading.local()
        self._workers: set[_Worker] = set()
        self._ended = False
        self._unguarded = False
        self._changing = threading.Lock()

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Future of `function(*args, **kwargs)`, computed in one of the processes."""
        return super().submit(self._remotely, function, args, kwargs)

    def gone(self) -> str:
        """Reason why no process can execute a task any more, or ""."""
        return GUARD if self._unguarded else ""

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = True) -> None:
        """Kill the processes. Running tasks are lost, and waiting tasks are cancelled."""
        self._ended = True
        self.renew()
        super().shutdown(wait, cancel_futures=cancel_futures)

    def renew(self) -> None:
        """Kill the processes. New processes are started for the next tasks."""
        with self._changing:
            for worker in self._workers:
                worker.process.kill()
                worker.process.join()

    def _remotely(self, function: Callable[..., Any], args: Any, kwargs: Any) -> Any:
        worker = self._worker()
        try:
            is_done, answer = worker.call(function, args, kwargs)
        except (EOFError, OSError) as error:  # it ended, possibly in the middle of its answer
            raise WorkerDiedError(f"the process died ({self._end(worker)})") from error
        if is_done:
            return answer
        raised, trace = answer
        raise raised from RemoteTraceback(trace)

    def _worker(self) -> "_Worker":
        """Process of this thread, or a new one if the last process has died."""
        worker: _Worker | None = getattr(self._own, "worker", None)
        if worker is not None and worker.process.is_alive():
            return worker
        if worker is not None and worker in self._workers:
            self._end(worker)
        with self._changing:
            if self._ended:
                raise WorkerDiedError("shut down")
            self._own.worker = worker = _Worker()
            self._workers.add(worker)
        return worker

    def _end(self, worker: "_Worker") -> str:
        how = worker.end()
        self._unguarded |= worker.process.exitcode == UNGUARDED
        with self._changing:
            self._workers.discard(worker)
        return how


class _Worker:
    """One process, connected by a pipe."""

    def __init__(self) -> None:
        self.connection, theirs = SPAWN.Pipe()
        self.process = SPAWN.Process(target=_serve, args=(theirs,), daemon=True)
        self.process.start()
        theirs.close()

    def call(self, function: Callable[..., Any], args: Any, kwargs: Any) -> tuple[bool, Any]:
        """Run a function in the process.

        Returns True and the result, or False and the exception with its traceback.

        Raises EOFError or OSError if the process dies.
        """
        task = pickle.dumps((function, args, kwargs))
        self.connection.send_bytes(task)
        is_done, answer = pickle.loads(self.connection.recv_bytes())  # noqa: S301 - a child process
        return is_done, answer

    def end(self) -> str:
        """Kill the process if it is still running, and return a text on how it ended."""
        self.process.join(1)  # its connection ends a little before itself
        self.process.kill()
        self.process.join()
        self.connection.close()
        code = self.process.exitcode or 0
        return f"signal {-code}" if code < 0 else f"exit status {code}"


def _without_interrupts() -> None:
    """Block Ctrl-C in this thread and in the processes that it starts.

    A terminal sends Ctrl-C to all processes; these ones then do not react to it.
    """
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


@contextmanager
def interrupts_blocked() -> Iterator[None]:
    """Threads and processes that are started in this context do not receive Ctrl-C."""
    resource_tracker.ensure_running()  # started by one of them it would let Ctrl-C through there
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _serve(tasks: connection.Connection) -> None:
    threading.Thread(target=_end_with_parent, daemon=True).start()
    while True:
        try:
            sent = tasks.recv_bytes()
        except EOFError:
            return
        tasks.send_bytes(_answer(sent))


def _answer(sent: bytes) -> bytes:
    try:
        function, args, kwargs = pickle.loads(sent)  # noqa: S301 - from the parent
        return pickle.dumps((True, function(*args, **kwargs)))
    except Exception as error:
        trace = traceback.format_exc()
        try:
            sent = pickle.dumps((False, (error, trace)))
            pickle.loads(sent)  # noqa: S301 - some exceptions can be sent and not received
        except Exception:
            plain = RuntimeError(f"{type(error).__name__}: {error}")
            return pickle.dumps((False, (plain, trace)))
        return sent


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
