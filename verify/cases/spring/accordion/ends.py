"""End conditions under which the accordion spring is compared."""

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

from analytic.spring import frame

HEADS: tuple[frame.Head, ...] = ("free", "hinged", "guided")
TAILS: tuple[frame.Tail, ...] = ("arc", "mid-leaf")
HOLDS: tuple[frame.Hold, ...] = ("clamped", "hinged")


class Ends(NamedTuple):
    """End conditions of head and tail; if `inner`, arcs have the inner radius, as in Eqs. 1-9.

    `key` is the suffix of names of values, `words` is the suffix of names of rows.
    """

    key: str
    words: str
    head: frame.Head = "free"
    tail: frame.Tail = "arc"
    hold: frame.Hold = "clamped"
    inner: bool = False

    def named(self, name: str) -> str:
        """Key of a value: `name`, with the key of these end conditions appended."""
        return f"{name}_{self.key}" if self.key else name


def _combined() -> Iterator[Ends]:
    for head, tail, hold in product(HEADS, TAILS, HOLDS):
        if (head, hold) == ("free", "hinged"):  # a mechanism
            continue
        hinged, how = ("", " clamped") if hold == "clamped" else ("_hinged", " hinged")
        key = f"{head}_{tail.replace('-', '_')}{hinged}".replace("free_arc", "")
        yield Ends(key, f"head {head}, tail{how} at {tail}", head, tail, hold)


PAPER = Ends("paper", "paper's centre line", inner=True)  # the shape that Eqs. 1-9 speak of
FIVE = Ends("five", "paper's centre line, five segments", inner=True)  # an odd number of them
COMBINED = tuple(_combined())  # on the true centre line, the free head with its arc held first
