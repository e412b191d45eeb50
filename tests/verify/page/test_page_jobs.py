"""Jobs in other processes: results, errors, progress, time limit and end."""

import asyncio
import os
import time
from collections.abc import Callable
from typing import Any

import pytest

from verify.app.page.jobs import CancelledError, FailedError, Jobs, Worker
from verify.core.inputs import InputError

ENDED = 20.0  # s within which each test has ended, also where a limit is not observed
Notify = Callable[[Any], None]


def doubled(x: int, notify: Notify) -> int:
    notify("half")
    return 2 * x


def wrong(_notify: Notify) -> None:
    raise InputError("r_i: needs\na length")


def broken(_notify: Notify) -> None:
    raise SystemExit(3)


def dead(_notify: Notify) -> None:
    os._exit(1)


def sleeping(_notify: Notify) -> None:
    time.sleep(ENDED)


async def _all(worker: Worker) -> None:
    states: list[Any] = []
    assert await worker.ask(doubled, 4, notify=states.append) == 8
    assert states == ["half"]
    with pytest.raises(InputError, match="needs a length"):
        await worker.ask(wrong)
    with pytest.raises(FailedError, match="SystemExit: 3"):
        await worker.ask(broken)
    with pytest.raises(FailedError, match="the process ended"):
        await worker.ask(dead)
    assert await worker.ask(doubled, 5) == 10  # by a fresh process
    with pytest.raises(FailedError, match=r"stopped after 0\.2 s"):
        await worker.ask(sleeping, seconds=0.2)
    task = asyncio.create_task(worker.ask(sleeping))
    await asyncio.sleep(0.2)
    pid = worker._process.pid
    worker.end()
    with pytest.raises(CancelledError):
        await task
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)


def test_answers_errors_limit_of_time_and_end() -> None:
    worker = Worker()
    try:
        asyncio.run(asyncio.wait_for(_all(worker), ENDED))
    finally:
        worker.end()


async def _limited() -> None:
    jobs = Jobs(2)
    first, _ = jobs.begin(), jobs.begin()
    with pytest.raises(InputError, match="2 jobs are running"):
        jobs.begin()
    jobs.finish(first)
    jobs.begin()
    jobs.end()
    assert jobs.begin()


def test_the_number_of_jobs_is_limited() -> None:
    asyncio.run(_limited())
