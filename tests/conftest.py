"""Fixtures that run cases with the shared cache; each process computes missing results once."""

import ctypes
import gc
import os
import resource
import signal
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import Path

import pytest
from hypothesis import settings

from verify.core import source_memory
from verify.core.case import Case
from verify.core.inputs import Inputs
from verify.core.plain_code import PROJECT
from verify.core.results import CaseResult, Row, Status
from verify.jobs.cache import default_folder
from verify.jobs.level import Job, judge_case, solve_level

# `make test` tries the same examples on every machine; HYPOTHESIS_PROFILE=default tries new ones
settings.register_profile("repeatable", derandomize=True)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "repeatable"))

pytest_plugins = ["tests.seconds"]

KEEP = (*PROJECT, "tests")  # packages whose functions have caches
LARGE = 700_000_000  # bytes of a worker; beyond them its caches are emptied before the next file

# A shell starts background jobs deaf to Ctrl-C, and the programs under test would inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Sort the tests: files that solve whole cases first, so that short files fill up the end."""
    items.sort(key=lambda item: not item.nodeid.startswith("tests/verify/"))


@pytest.fixture(autouse=True)
def without_judged(monkeypatch: pytest.MonkeyPatch) -> None:
    """Disable stored judged cases, because their keys do not include what a test patches."""
    monkeypatch.setattr("verify.jobs.judged.keys", lambda _modules: {})


@pytest.fixture(autouse=True, scope="module")
def _forgotten(request: pytest.FixtureRequest) -> Iterator[None]:
    """Empty the caches of a test module after its last test.

    Solved problems with their factors are large, and there are many tests.
    """
    yield
    for kept in vars(request.module).values():
        if getattr(kept, "__module__", "") == request.module.__name__:
            getattr(kept, "cache_clear", lambda: None)()
    source_memory.forget()
    if resident() > LARGE:
        forget()


def resident() -> int:
    """Memory of this process [bytes]; 0 if the system does not report it."""
    pages = Path("/proc/self/statm")
    return int(pages.read_text().split()[1]) * resource.getpagesize() if pages.exists() else 0


def forget() -> None:
    """Empty the caches of all functions of the project and of these fixtures."""
    for one in gc.get_objects():
        # no isinstance: it would evaluate weak proxies
        if type(one) is type(solved) and one.__module__.partition(".")[0] in KEEP:
            one.cache_clear()
    gc.collect()
    with suppress(OSError, AttributeError):  # of glibc
        ctypes.CDLL(None).malloc_trim(0)


@lru_cache(maxsize=48)
def solved(case: Case, inputs: Inputs):
    return [solve_level(case, inputs, level, default_folder()) for level in case.levels]


@pytest.fixture(scope="session")
def judged() -> Callable[..., CaseResult]:
    """Function: judged case for inputs (default: of the paper), with cached finite elements."""

    def judge(case: Case, inputs: Inputs | None = None, *, drawn: bool = True) -> CaseResult:
        q = case.inputs() if inputs is None else inputs
        return judge_case(Job(case, q, drawn=drawn), solved(case, q))

    return judge


@pytest.fixture(scope="session")
def of_paper(judged) -> Callable[[Case], CaseResult]:
    """Function: case judged once on the inputs of the paper, for tests that change nothing."""
    return cache(judged)


@pytest.fixture(scope="session")
def red() -> Callable[[CaseResult], list[Row]]:
    """Function: failed rows of a judged case."""
    return lambda result: [row for row in result.rows if row.status is Status.FAIL]
