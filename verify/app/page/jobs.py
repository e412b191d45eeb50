"""Runs jobs in other processes, with progress and a time limit. Jobs can be ended at any time."""

import asyncio
import os
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from multiprocessing import connection
from typing import Any

from verify.core.inputs import InputError
from verify.jobs.processes import SPAWN

MOST_RUNNING = 2  # jobs of all pages at a time
LONGEST = 1800.0  # s of a job
WATCH = 1.0  # s between two looks for the parent
POLL = 0.004  # s between two polls for an answer


class CancelledError(Exception):
    """The job was cancelled before it had a result."""


class FailedError(Exception):
    """The job has no result. The message states the reason in one line."""


class Worker:
    """A process that does one job at a time. After a forced end, a new process replaces it."""

    def __init__(self) -> None:
        self._process: Any = None
        self._pipe: connection.Connection | None = None
        self._turn = asyncio.Lock()

    async def ask(
        self, function: Callable[..., Any], *arguments: Any, seconds: float = LONGEST,
        notify: Callable[[Any], None] = lambda _state: None,
    ) -> Any:  # fmt: skip
        """Result of `function`, which is executed in the process.

        `function` must be defined at the top level of a module. `notify` receives each state of
        progress that it reports. Raises InputError or FailedError with the message of an error in
        `function`, FailedError after `seconds`, and CancelledError after `end`.
        """
        async with self._turn:
            pipe = self._started()
            try:
                pipe.send((function, arguments))
                return await self._answer(pipe, time.monotonic() + seconds, seconds, notify)
            except (EOFError, OSError) as error:
                ended = self._process is None
                self.end()
                raise (CancelledError if ended else FailedError)("the process ended") from error

    async def _answer(
        self, pipe: connection.Connection, until: float, seconds: float,
        notify: Callable[[Any], None],
    ) -> Any:  # fmt: skip
        while True:
            while not pipe.poll():
                if time.monotonic() > until:
                    self.end()
                    raise FailedError(f"stopped after {seconds:g} s")
                await asyncio.sleep(POLL)
            kind, value = pipe.recv()
            if kind == "state":
                notify(value)
            elif kind == "done":
                return value
            else:
                raise (InputError if kind == "input" else FailedError)(value)

    def end(self) -> None:
        """End the process and its child processes immediately."""
        process, self._process = self._process, None
        if process is not None:
            with suppress(ProcessLookupError, PermissionError):
                os.killpg(process.pid, signal.SIGKILL)
            process.kill()
            process.join()
        if self._pipe is not None:
            self._pipe.close()
            self._pipe = None

    def _started(self) -> connection.Connection:
        if self._pipe is None:
            self._pipe, theirs = SPAWN.Pipe()
            self._process = SPAWN.Process(target=_work, args=(theirs, os.getpid()))
            self._process.start()
            theirs.close()
        return self._pipe


class Jobs:
    """The jobs of all pages, with a limit of simultaneous jobs."""

    def __init__(self, most: int = MOST_RUNNING) -> None:
        self._most, self._running = most, set[Worker]()

    def begin(self) -> Worker:
        """Return a worker for a job. Raises InputError if too many jobs are running."""
        if len(self._running) >= self._most:
            raise InputError(f"{self._most} jobs are running; wait for one or cancel it")
        worker = Worker()
        self._running.add(worker)
        return worker

    def finish(self, worker: Worker) -> None:
        """End the worker of a job, even if the job has no result yet."""
        self._running.discard(worker)
        worker.end()

    def end(self) -> None:
        """End all jobs."""
        for worker in tuple(self._running):
            self.finish(worker)


def _work(pipe: connection.Connection, parent: int) -> None:
    """Function that runs in the process.

    The process has a separate process group, which ends if the parent process ends.
    """
    os.setsid()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_watch, args=(parent,), daemon=True).start()
    with suppress(EOFError, OSError):
        while True:
            function, arguments = pipe.recv()
            try:
                answer = ("done", function(*arguments, lambda state: pipe.send(("state", state))))
            except InputError as error:
                answer = ("input", _line(error))
            except (Exception, SystemExit) as error:
                answer = ("failed", f"{type(error).__name__}: {_line(error)}")
            pipe.send(answer)


def _line(error: BaseException) -> str:
    return " ".join(str(error).split())


def _watch(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(WATCH)
    with suppress(ProcessLookupError, PermissionError):
        os.killpg(0, signal.SIGKILL)
