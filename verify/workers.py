"""Processes that solve tasks and may die: what one takes with it is done again, the rest goes on.

The executors of the standard library give up every task when one process dies, and wait for
those under way when interrupted. Here each process holds one task at a time; killing the run
kills them all, and a process whose parent is gone ends by itself.
"""

import os
import pickle
import signal
import threading
import time
import traceback
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import connection, get_context, parent_process, resource_tracker
from types import FrameType
from typing import Any

TICK = 0.25  # s between two looks of the caller at a run in which nothing happens
SPAWN = get_context("spawn")  # a forked child would share gmsh's state
STOPS = (signal.SIGINT, signal.SIGTERM)


@dataclass(frozen=True)
class Lost:
    """No answer: the process died on the task twice, or the task raised, with its traceback."""

    reason: str
    trace: str = ""


class Pool:
    """`processes` workers that call `function`, which is sent by its name, on task after task.

    `running` holds the start of each task under way, by its number [s, of `time.monotonic`].
    """

    def __init__(self, function: Callable[[Any], Any], processes: int) -> None:
        self.function, self.processes = function, processes
        self.running: dict[int, float] = {}
        self._workers: list[_Worker] = []

    def answers(self, count: int, task: Callable[[int], Any]) -> Iterator[tuple[int, Any] | None]:
        """Number and answer of `count` tasks as they come, and None every TICK seconds.

        `task(number)` is asked for when its turn comes. A task whose process dies is done again
        at the end, alone in a fresh process; Lost is its answer if that dies too.
        """
        try:
            lost = yield from self._round(range(count), task, self.processes)
            for number in lost:
                self._end_workers()
                if how := (yield from self._round([number], task, 1)):
                    yield number, Lost(f"the process died ({how[number]})")
        finally:
            self._end_workers()

    def _round(
        self, numbers: Iterable[int], task: Callable[[int], Any], processes: int
    ) -> Generator[tuple[int, Any] | None, None, dict[int, str]]:
        waiting, lost = deque(numbers), dict[int, str]()
        while waiting or self.running:
            self._hand_out(waiting, task, processes)
            ready = connection.wait([w.connection for w in self._workers], TICK)
            for worker in [w for w in self._workers if w.connection in ready]:
                number = worker.number
                try:
                    answer = worker.answer()
                except (EOFError, OSError):  # it died, perhaps in the middle of its answer
                    self._workers.remove(worker)
                    worker.process.join(1)  # its connection ends a little before itself
                    how = worker.end()
                    if number is not None:
                        lost[number] = how
                        del self.running[number]
                    continue
                if number is not None:
                    del self.running[number]
                    yield number, answer
            yield None
        return lost

    def _hand_out(self, waiting: deque[int], task: Callable[[int], Any], processes: int) -> None:
        while waiting:
            idle = next((w for w in self._workers if w.number is None), None)
            if idle is None:
                if len(self._workers) == processes:
                    return
                with _stops_put_off():
                    self._workers.append(_Worker(self.function))
                continue
            number = waiting.popleft()
            idle.give(number, task(number))
            self.running[number] = time.monotonic()

    def _end_workers(self) -> None:
        while self._workers:
            self._workers.pop().end()
        self.running.clear()


class Here:
    """What a Pool does, in this process and one after the other."""

    def __init__(self, function: Callable[[Any], Any]) -> None:
        self.function = function
        self.running: dict[int, float] = {}

    def answers(self, count: int, task: Callable[[int], Any]) -> Iterator[tuple[int, Any] | None]:
        """Number and answer of `count` tasks."""
        for number in range(count):
            yield number, self.function(task(number))


class _Worker:
    """One process and the number of the task it is at."""

    def __init__(self, function: Callable[[Any], Any]) -> None:
        self.connection, theirs = SPAWN.Pipe()
        self.process = SPAWN.Process(target=_serve, args=(function, theirs), daemon=True)
        self.process.start()
        theirs.close()
        self.number: int | None = None

    def give(self, number: int, task: Any) -> None:
        self.number = number
        try:
            self.connection.send(task)
        except OSError:  # it died while idle: its connection ends, which is found out below
            return

    def answer(self) -> Any:
        answer = self.connection.recv()
        self.number = None
        return answer

    def end(self) -> str:
        """Kill it, if it still lives, and say how it ended."""
        self.process.kill()
        self.process.join()
        self.connection.close()
        code = self.process.exitcode or 0
        return f"signal {-code}" if code < 0 else f"exit status {code}"


def _serve(function: Callable[[Any], Any], tasks: connection.Connection) -> None:
    threading.Thread(target=_end_with_parent, daemon=True).start()
    while True:
        try:
            sent = tasks.recv_bytes()
        except EOFError:
            return
        try:
            answer = pickle.dumps(function(pickle.loads(sent)))  # noqa: S301 - from the parent
        except Exception as error:
            reason = f"{type(error).__name__}: {' '.join(str(error).split())}"
            answer = pickle.dumps(Lost(reason, traceback.format_exc()))
        tasks.send_bytes(answer)


def _end_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)


@contextmanager
def _stops_put_off() -> Iterator[None]:
    """Start processes that Ctrl-C doesn't reach, and be stopped only when they are started.

    A terminal's Ctrl-C goes to all processes; one that is half started would end in a traceback.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    came: list[tuple[int, FrameType | None]] = []
    resource_tracker.ensure_running()  # it would unblock what is blocked here
    handlers = {s: signal.signal(s, lambda s, f: came.append((s, f))) for s in STOPS}
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # children inherit it
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)
    for stop, frame in came:
        handler = handlers[signal.Signals(stop)]
        if callable(handler):
            handler(stop, frame)
        elif handler == signal.SIG_DFL:
            signal.raise_signal(stop)
