"""Statement of a comparison with a second solver, and its results."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

CALCULIX, TAMAAS, ROSS = "calculix", "tamaas", "ROSS"
SOLVERS = (CALCULIX, TAMAAS, ROSS)

Numbers = Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """One quantity of a comparison, and the row of the case to which it belongs.

    With `beside`, the row judges a different quantity of the same problem. `allowed` is the
    permissible relative difference between both solvers, and `why` the reason for a difference of
    this size.
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
    """A problem that the project has solved and that is ready for the second solver.

    `ours` are the results of the project in SI units, and `seconds` the solution time. `write`
    writes the input file (deck) into a folder. `read` reads the same quantities from a solved deck.
    """

    ours: Numbers
    seconds: float
    unknowns: int
    write: Callable[[Path], Path]
    read: Callable[[Path], Numbers]


@dataclass(frozen=True, kw_only=True)
class Cross:
    """A problem of a case that a second solver can also solve.

    `pose` solves the problem in this project, on the same mesh as the other solver; it imports
    meshes and fem in its body. `what` describes the problem in one line.
    """

    id: str
    case: str
    solver: str
    what: str
    pose: Callable[[], Posed]
    quantities: tuple[Quantity, ...]

    @property
    def file(self) -> str:
        """Name of the folder that contains the deck of the comparison."""
        return self.id.replace(" ", "-").replace(",", "")
