"""Cache of the last few results, identified by the content of their arguments.

A stored result equals a new result to the last bit. Results do not depend on earlier computations
of the process.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Generic, TypeVar

import numpy as np

from fem.plane.geometry import Array, Indices

V = TypeVar("V")
Key = tuple[type | int | Array | Indices, ...]


@dataclass
class Recent(Generic[V]):
    """Cache of at most `most` results with a total size of at most `room`; the latest is first."""

    most: int
    room: float = np.inf
    kept: list[tuple[Key, V, float]] = field(default_factory=list)

    def get(self, key: Key, make: Callable[[], V], size: Callable[[V], float] = lambda _: 0) -> V:
        """Result for the arguments `key`: a stored result, or the result of `make`.

        `size` gives the memory that the result needs.
        """
        for k, entry in enumerate(self.kept):
            if same(entry[0], key):
                self.kept.insert(0, self.kept.pop(k))
                return entry[1]
        value = make()
        taken = size(value)
        if taken > self.room:
            return value
        # the caller may change its arrays in place
        own = tuple(part.copy() if isinstance(part, np.ndarray) else part for part in key)
        self.kept.insert(0, (own, value, taken))
        while len(self.kept) > self.most or sum(entry[2] for entry in self.kept) > self.room:
            self.kept.pop()
        return value

    def clear(self) -> None:
        """Remove all results."""
        self.kept.clear()


def same(one: Key, other: Key) -> bool:
    """True if two keys are equal; arrays are compared by their entries."""
    return len(one) == len(other) and all(
        np.array_equal(a, b) if isinstance(a, np.ndarray) and isinstance(b, np.ndarray) else a == b
        for a, b in zip(one, other, strict=True)
    )
