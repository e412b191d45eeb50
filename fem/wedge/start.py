"""Position of a strut between its races from coarse meshes, as initial position for the fine mesh.

Coarse meshes give the position of the strut and the widths of its contacts. States on finer meshes
begin with these values, all at the same rotation of the strut.
"""

import math
from dataclasses import dataclass, replace
from typing import Generic, Protocol, Self, TypeVar

from fem.contact.errors import NotFoundError
from fem.wedge.races import Sector, State, Struts
from fem.wedge.races_place import Place
from fem.wedge.rest import Drags

COARSE = 3  # cells on the half-width of the meshes that locate the contacts
SETTLED = 1e-4  # of both overlaps: allowed remaining movement of pole and contacts
MOST = 20  # steps
STICKS = 5.0  # friction over tan(nu): well above what the strut needs


class TurnedPlace(Place, Protocol):
    """Position of a strut rotated by `alpha` [rad]; `strut` is (nu, omega) [rad]."""

    @property
    def alpha(self) -> float: ...
    @property
    def strut(self) -> tuple[float, float]: ...
    def turned(self, alpha: float) -> tuple[Self, float]: ...


P = TypeVar("P", bound=TurnedPlace)


@dataclass(frozen=True)
class Start(Generic[P]):
    """Approximate state of struts: position, half-widths and surface displacements `drags` [m]."""

    struts: Struts
    place: P
    widths: tuple[float, float]
    drags: Drags = (0.0, 0.0)

    @classmethod
    def after(cls, state: State[P]) -> "Start[P]":
        """Approximate state from the equilibrium of `state`."""
        return cls(state.sector.q, state.place, state.widths, state.drags)

    def turned(self, alpha: float) -> "Start[P]":
        """Approximate state at the rotation `alpha` [rad], with scaled half-widths and drags."""
        place, share = self.place.turned(alpha)
        root = math.sqrt(share)
        return replace(
            self, place=place, widths=(root * self.widths[0], root * self.widths[1]),
            drags=(share * self.drags[0], share * self.drags[1]),
        )  # fmt: skip

    def state(self, cells: int, mu: float | None = None) -> State[P]:
        """Equilibrium state; by default, friction is sufficient for sticking."""
        if mu is None:
            mu = STICKS * math.tan(self.place.strut[0])
        return Sector(self.struts, self.place, self.widths, cells, mu=mu).rest(self.drags)

    def settled(self) -> tuple["Start[P]", State[P]]:
        """Approximate state with the strut in equilibrium, and the last coarse state.

        Raises NotFoundError without equilibrium.
        """
        start = self
        for _ in range(MOST):
            state = start.state(COARSE)
            start, before = Start.after(state), start
            now, last = start.place, before.place
            moved = now.D - last.D, now.OA - last.OA, now.OB - last.OB
            if max(map(abs, moved)) <= SETTLED * now.H:
                return start, state
        raise NotFoundError(
            f"no equilibrium of the sprag was found at the rotation {self.place.alpha:.4g} rad"
        )
