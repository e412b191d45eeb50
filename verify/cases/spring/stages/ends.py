"""End conditions under which the stages of the accordion spring are compared."""

from itertools import product
from typing import NamedTuple

from analytic.spring.loops import Normal, Tail
from analytic.spring.stages import Head


class Ends(NamedTuple):
    """End conditions of head and tail, and the normal along which tips transmit contact forces.

    `key` is the suffix of names of values, `words` is the suffix of names of rows.
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
        across = "" if self.normal == "force" else ", contact force normal to the leaf"
        return f"head {self.head}, tail clamped at {self.tail}{across}"


HEADS: tuple[Head, ...] = ("guided", "free", "hinged")
TAILS: tuple[Tail, ...] = ("mid-leaf", "arc")
ENDS = (*(Ends(h, t) for h, t in product(HEADS, TAILS)), Ends("guided", "mid-leaf", "leaf"))
# ends with tips that touch in succession
LATER = (Ends("hinged", "mid-leaf"), Ends("guided", "arc"), Ends("free", "arc"))
