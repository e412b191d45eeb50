"""Engine that runs tasks in forked child processes, which have the parent's loaded modules.

A child process returns a JSON value through a pipe. It is ended if it exceeds its time or memory
limit, or if the parent process ends.
"""

import contextlib
import json
import os
import resource
import select
import selectors
import signal
import sys
import time
from collections.abc import Callable, Collection, Hashable, Iterator
from concurrent.futures import Executor, Future
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from verify.jobs.engine import Engine
from verify.jobs.guard import named

MEMORY = 6 * 2**30  # bytes: memory limit of a child, in case a mutant changes a size
LATE = "does not end"
DIED = "the process died"
GRACE = 0.1  # s without output after which a child process counts as hanging
SPARE = 5.0  # s after which a child whose parent is gone ends itself


@dataclass(frozen=True)
class Task:
    """A task for a child process with the time limit `limit` [s]; `key` identifies its result."""

    key: Hashable
    work: Callable[[], Any]
    limit: float


@dataclass(frozen=True)
class Answer:
    """Result of a child process.

    `failure` is LATE after a time-out, otherwise an error or a signal; it is empty if there is a
    value.
    """

    key: Hashable
    value: Any
    failure: str
    seconds: float


@contextmanager
def forks(jobs: int) -> Iterator[Engine]:
    """Engine with at most `jobs` child processes at a time, one per task; it ends them at exit."""
    executor = Forks()
    try:
        yield Engine(executor, lambda: jobs, deadly=(), wait=executor.wait)
    finally:
        executor.shutdown()


def perform(task: Task) -> Any:
    """Do the work of a task; called in a child process."""
    return task.work()


@dataclass
class _Child:
    task: Task
    pid: int
    start: float
    future: Future[Answer]
    read: bytearray = field(default_factory=bytearray)


class Forks(Executor):
    """Executor that runs tasks in child processes; only `wait` sets the results of the futures.

    The executor has no thread, because a thread would be forked, too.
    """

    def __init__(self) -> None:
        self.selector = selectors.DefaultSelector()
        self.children: dict[int, _Child] = {}

    def submit(self, function: Callable[..., Any], /, *args: Any, **_: Any) -> Future[Any]:
        """Fork a child process that calls `function` with its only argument, a Task."""
        (task,) = args
        pipe, pid = _start(task, function)
        future: Future[Answer] = Future()
        self.children[pipe] = _Child(task, pid, time.monotonic(), future)
        self.selector.register(pipe, selectors.EVENT_READ)
        return future

    def wait(self, futures: Collection[Future[Any]], seconds: float) -> Collection[Future[Any]]:
        """Futures of child processes that have finished or exceeded their limit.

        The function waits for `seconds` at most.
        """
        for ready, _ in self.selector.select(timeout=seconds):
            if piece := os.read(ready.fd, 1 << 16):
                self.children[ready.fd].read += piece
            else:
                self._conclude(ready.fd, DIED)
        now = time.monotonic()
        for pipe, child in list(self.children.items()):
            is_late = now - child.start > child.task.limit
            if is_late or _has_ended(child.pid):  # its child processes may hold the pipe open
                child.read += _rest(pipe)  # it may have answered just before the limit
                self._conclude(pipe, LATE if is_late else DIED)
        return [future for future in futures if future.done()]

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = True) -> None:  # noqa: ARG002
        """End all child processes."""
        for pipe in list(self.children):
            self._conclude(pipe, LATE)
        self.selector.close()

    def _conclude(self, pipe: int, otherwise: str) -> None:
        """End a child process.

        The result of the process is its output, or `otherwise` if the output is incomplete.
        """
        child = self.children.pop(pipe)
        self.selector.unregister(pipe)
        os.close(pipe)
        _end(child.pid)
        try:
            value, failure = json.loads(child.read)
        except ValueError:  # ended by a signal, or out of memory
            value, failure = None, otherwise
        seconds = time.monotonic() - child.start
        child.future.set_result(Answer(child.task.key, value, failure, seconds))


def _has_ended(pid: int) -> bool:
    """Whether a child process has ended; this query does not remove it from the process table."""
    return os.waitid(os.P_PID, pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None


def _rest(pipe: int) -> bytes:
    """Content of a pipe, including data that are being written."""
    found, end = bytearray(), time.monotonic() + SPARE
    while time.monotonic() < end and select.select([pipe], [], [], GRACE)[0]:
        if not (piece := os.read(pipe, 1 << 16)):
            break
        found += piece
    return bytes(found)


def _end(pid: int) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(pid, signal.SIGKILL)
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)
    with contextlib.suppress(ChildProcessError):
        os.waitpid(pid, 0)


def _start(task: Task, function: Callable[[Task], Any]) -> tuple[int, int]:
    """Fork a child process for the task; return the read end of the result pipe, and the pid."""
    out, into = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    pid = os.fork()
    if pid == 0:
        os.close(out)
        _work(task, function, into)
    os.close(into)
    return out, pid


def _outcome(task: Task, function: Callable[[Task], Any]) -> str:
    """JSON text with the result of the function for the task, or with its error."""
    try:
        return json.dumps([function(task), ""])
    except Exception as error:
        return json.dumps([None, named(error)])


def _work(task: Task, function: Callable[[Task], Any], into: int) -> None:
    """Do the work of a child process; this function never returns."""
    status = 1
    try:
        os.setpgid(0, 0)  # including its child processes
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_REAL, task.limit + SPARE)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        nowhere = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nowhere, stream)
        text = _outcome(task, function).encode()
        with os.fdopen(into, "wb") as pipe:
            pipe.write(text)
        status = 0
    finally:
        os._exit(status)
