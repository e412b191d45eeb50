"""Statement of a comparison with a second solver, and its results."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

CALCULIX, TAMAAS, ROSS = "calculix", "tamaas", "ROSS"
SOLVERS = (CALCULIX, TAMAAS, ROSS)

Numbers = Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """One number of a comparison: its name, and the row of the case to which it belongs.

    With `beside`, it is another number than that of the row, for the same problem. Both solvers may
    differ by `allowed`, relative; `why` is the reason for a difference of this size.
    """

    name: str
    allowed: float
    why: str
    symbol: str = ""
    unit: str = "1"
    row: str = ""
    beside: bool = False


@dataclass(frozen=True, kw_only=True)
class Posed:
    """A problem solved by the project, ready for the other solver.

    `ours` are the numbers in SI units, `seconds` their time; `write` writes the input file (deck)
    into a folder, and `read` reads the same numbers from a solved deck.
    """

    ours: Numbers
    seconds: float
    unknowns: int
    write: Callable[[Path], Path]
    read: Callable[[Path], Numbers]


@dataclass(frozen=True, kw_only=True)
class Cross:
    """A problem of a case that a second solver can also solve.

    `pose` solves it in this project, on the same mesh as the other solver; it imports meshes and
    fem in its body. `what` describes the problem in one line.
    """

    id: str
    case: str
    solver: str
    what: str
    pose: Callable[[], Posed]
    quantities: tuple[Quantity, ...]

    @property
    def file(self) -> str:
        """Name of the folder that keeps its deck."""
        return self.id.replace(" ", "-").replace(",", "")
