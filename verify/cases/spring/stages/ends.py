"""End conditions under which the stages of the accordion spring are compared."""

from itertools import product
from typing import NamedTuple

from analytic.spring.loops import Normal, Tail
from analytic.spring.stages import Head


class Ends(NamedTuple):
    """How both ends are held, and the direction in which tip and leaf press.

    `key` is the suffix of its numbers, `words` the suffix of its rows.
    """

    head: Head
    tail: Tail
    normal: Normal = "force"

    @property
    def key(self) -> str:
        across = "" if self.normal == "force" else "_normal"
        return f"{self.head}_{self.tail.replace('-', '_')}{across}"

    @property
    def words(self) -> str:
        across = "" if self.normal == "force" else ", normal of the leaf"
        return f"head {self.head}, tail at {self.tail}{across}"


HEADS: tuple[Head, ...] = ("guided", "free", "hinged")
TAILS: tuple[Tail, ...] = ("mid-leaf", "arc")
ENDS = (*(Ends(h, t) for h, t in product(HEADS, TAILS)), Ends("guided", "mid-leaf", "leaf"))
# ends with tips that touch in succession
LATER = (Ends("hinged", "mid-leaf"), Ends("guided", "arc"), Ends("free", "arc"))
