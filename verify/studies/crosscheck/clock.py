"""Solution times of the project."""

import time
from collections.abc import Callable
from typing import TypeVar

T = TypeVar("T")


def timed(solve: Callable[[], T]) -> tuple[T, float]:
    """Result of `solve`, and the seconds that it took."""
    start = time.perf_counter()
    found = solve()
    return found, time.perf_counter() - start
