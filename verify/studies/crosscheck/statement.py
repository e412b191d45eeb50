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

    With `beside` it is another number than the row's, of the same problem. Both solvers may differ
    by `allowed`, relative, and `why` says what makes so much of a difference.
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
    """A problem that the project has solved, ready for the other solver.

    `ours` in SI units and the `seconds` that they took; `write` puts the problem's file, the deck,
    into a folder, and `read` finds the same numbers beside a deck that was solved.
    """

    ours: Numbers
    seconds: float
    unknowns: int
    write: Callable[[Path], Path]
    read: Callable[[Path], Numbers]


@dataclass(frozen=True, kw_only=True)
class Cross:
    """A problem of a case that a second solver takes too.

    `pose` solves it here, on the very mesh that the other solver is given; it imports meshes and
    fem inside its body. `what` says in a line what is solved.
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
