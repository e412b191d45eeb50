"""Measurement of the project's solution times."""

import time
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")


def timed(solve: Callable[[], T]) -> tuple[T, float]:
    """Result of `solve`, and the time [s] that it took."""
    start = time.perf_counter()
    found = solve()
    return found, time.perf_counter() - start
