"""Start values of a roller between flat and race, and the search for the state under a load."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from fem.contact.errors import NotFoundError
from fem.wedge.flat import Sector, State
from fem.wedge.flat_place import Pitch, Place

COARSE = 3  # cells on the half-width of the meshes that locate the contacts
STICKS = 2.0  # friction over tan(alpha): well above what the roller needs
FIRST = 16.0  # overlap over N/(L E'), about
SPLIT = 0.33  # part of the contact with flats inside, about
MOST = 12  # steps of a search
Pair = tuple[float, float]


@dataclass(frozen=True)
class Start:
    """Approximate state: overlaps of both contacts [m], half-widths [m] and drags [m]."""

    d: Pair
    widths: Pair
    drags: Pair

    @classmethod
    def guessed(cls, q: Pitch, whole: float, *, inner: float, flatter: float) -> "Start":
        """Start for an overlap of both contacts [m]; `inner` is the share of the inner contact.

        `flatter` is the approximate r d/a² of the inner contact, 3 for a race inside.
        """
        d = inner * whole, (1 - inner) * whole
        return cls(d, (math.sqrt(q.r * d[0] / flatter), math.sqrt(q.r * d[1] / 3)), (0.0, 0.0))

    def scaled(self, share: float) -> "Start":
        """Start for overlaps that are `share` of these."""
        root = math.sqrt(share)
        return Start(
            (share * self.d[0], share * self.d[1]),
            (root * self.widths[0], root * self.widths[1]),
            (share * self.drags[0], share * self.drags[1]),
        )

    def state(self, q: Pitch, cells: int) -> State:
        """The state that overlaps like this."""
        place = Place.overlapping(q, *self.d)
        sector = Sector(place, self.widths, cells, mu=STICKS * math.tan(place.psi / 2))
        return sector.rest(self.drags)


def after(state: State) -> Start:
    """A start with the total overlap of `state`, divided between contacts as at its equilibrium."""
    start, rest = state.start, state.place
    share = (start.d_i + start.d_o) / (rest.d_i + rest.d_o)
    return Start((share * rest.d_i, share * rest.d_o), state.widths, state.drags)


def overlap(q: Pitch, P: float) -> float:
    """Approximate overlap [m] of both contacts under a normal force P [N/m]."""
    return FIRST * P * (1 - q.nu**2) / q.E


def rigid_force(q: Pitch, T: float) -> float:
    """N_0 = T/(z R tan(alpha_0)) [N], the normal force of a rigid clutch."""
    cos = (q.flat + q.sense * q.r) / (q.race - q.sense * q.r)
    return T / (q.z * q.race) * math.sqrt((1 + cos) / (1 - cos))


def guessed_inside(q: Pitch, P: float) -> Start:
    """With flats inside under a normal force P [N/m], about."""
    return Start.guessed(q, overlap(q, P), inner=SPLIT, flatter=2)


def loaded(
    q: Pitch, now: Start, share: Callable[[State], float], *, power: float, near: float, what: str
) -> Start:
    """State from `now`, by coarse meshes, at which `share` is within `near` of 1.

    `share` is the target over the load of a state; overlaps grow with its `power`. NotFoundError if
    the steps do not converge; the message contains `what`.
    """
    for _ in range(MOST):
        state = now.state(q, COARSE)
        by = share(state)
        now = after(state).scaled(by**power)
        if abs(by - 1) < near:
            return now
    raise NotFoundError(f"{what} is not reached: difference {by - 1:.1%}")
