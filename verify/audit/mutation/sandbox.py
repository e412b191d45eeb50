"""Work in forked children: what the parent has loaded is there at once, and nothing comes back.

A child answers with a JSON value through a pipe. It is ended when its time is over, when it takes
too much memory, and when the parent is stopped.
"""

import contextlib
import json
import os
import resource
import selectors
import signal
import sys
import time
from collections import deque
from collections.abc import Callable, Hashable, Iterator
from dataclasses import dataclass, field
from typing import Any

from verify.jobs.guard import named

MEMORY = 6 * 2**30  # bytes that a child may have: a size mistaken fills no machine
LATE = "does not end"
SPARE = 5.0  # s after which a child whose parent is gone ends itself


@dataclass(frozen=True)
class Task:
    """Something for a child to do within `limit` seconds; `key` tells whose answer it is."""

    key: Hashable
    work: Callable[[], Any]
    limit: float


@dataclass(frozen=True)
class Answer:
    """What a child found; or `failure`: LATE where it was ended, else what it raised or died of."""

    key: Hashable
    value: Any
    failure: str
    seconds: float


@dataclass
class _Child:
    task: Task
    pid: int
    start: float
    read: bytearray = field(default_factory=bytearray)


def answers(waiting: deque[Task], jobs: int) -> Iterator[Answer]:
    """The answers of all tasks as they come, `jobs` children at a time.

    Tasks are taken from the left of `waiting`, which may get more with an answer.
    """
    with contextlib.closing(selectors.DefaultSelector()) as selector:
        children: dict[int, _Child] = {}
        try:
            while True:
                while waiting and len(children) < jobs:
                    pipe = _start(waiting.popleft(), children)
                    selector.register(pipe, selectors.EVENT_READ)
                if not children:
                    return
                yield from _step(selector, children)
        finally:
            for child in children.values():
                _end(child.pid)


def _step(selector: selectors.BaseSelector, children: dict[int, _Child]) -> Iterator[Answer]:
    """Read what is there, and answer for children that are done or late."""
    for ready, _ in selector.select(timeout=0.2):
        child = children[ready.fd]
        piece = os.read(ready.fd, 1 << 16)
        if piece:
            child.read += piece
        else:
            yield _ended(selector, children, ready.fd, "")
    now = time.monotonic()
    for pipe, child in list(children.items()):
        if now - child.start > child.task.limit:
            yield _ended(selector, children, pipe, LATE)


def _ended(
    selector: selectors.BaseSelector, children: dict[int, _Child], pipe: int, failure: str
) -> Answer:
    child = children.pop(pipe)
    selector.unregister(pipe)
    os.close(pipe)
    _end(child.pid)
    seconds = time.monotonic() - child.start
    if failure:
        return Answer(child.task.key, None, failure, seconds)
    try:
        value, raised = json.loads(child.read)
    except ValueError:  # ended by a signal, or out of memory
        value, raised = None, "the process died"
    return Answer(child.task.key, value, raised, seconds)


def _end(pid: int) -> None:
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(pid, signal.SIGKILL)
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)
    with contextlib.suppress(ChildProcessError):
        os.waitpid(pid, 0)


def _start(task: Task, children: dict[int, _Child]) -> int:
    """Fork a child for the task; the end of the pipe that it answers through."""
    out, into = os.pipe()
    sys.stdout.flush()
    sys.stderr.flush()
    pid = os.fork()
    if pid == 0:
        os.close(out)
        _work(task, into)
    os.close(into)
    children[out] = _Child(task, pid, time.monotonic())
    return out


def _told(work: Callable[[], Any]) -> tuple[Any, str]:
    """What the work returns, and in words what it raises."""
    try:
        return work(), ""
    except Exception as error:
        return None, named(error)


def _work(task: Task, into: int) -> None:
    """What the child does; it never returns."""
    status = 1
    try:
        os.setpgid(0, 0)  # with whatever it starts
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.setitimer(signal.ITIMER_REAL, task.limit + SPARE)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        nowhere = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nowhere, stream)
        text = json.dumps(_told(task.work)).encode()
        with os.fdopen(into, "wb") as pipe:
            pipe.write(text)
        status = 0
    finally:
        os._exit(status)
