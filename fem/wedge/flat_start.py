"""Initial values for a roller between flat and race, and search for the state under a load."""

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
    """Approximate state of both contacts: overlaps `d`, half-widths, surface displacements [m]."""

    d: Pair
    widths: Pair
    drags: Pair

    @classmethod
    def guessed(cls, q: Pitch, whole: float, *, inner: float, flatter: float) -> "Start":
        """Approximate state for the total overlap `whole` [m] of both contacts.

        `inner` is the share of the inner contact. `flatter` is the approximate r d/a² of the inner
        contact: 3 for an inner race.
        """
        d = inner * whole, (1 - inner) * whole
        return cls(d, (math.sqrt(q.r * d[0] / flatter), math.sqrt(q.r * d[1] / 3)), (0.0, 0.0))

    def scaled(self, share: float) -> "Start":
        """Approximate state: overlaps and drags times `share`, widths times its square root."""
        root = math.sqrt(share)
        return Start(
            (share * self.d[0], share * self.d[1]),
            (root * self.widths[0], root * self.widths[1]),
            (share * self.drags[0], share * self.drags[1]),
        )

    def state(self, q: Pitch, cells: int) -> State:
        """Equilibrium state with the overlaps `d`."""
        place = Place.overlapping(q, *self.d)
        sector = Sector(place, self.widths, cells, mu=STICKS * math.tan(place.psi / 2))
        return sector.rest(self.drags)


def after(state: State) -> Start:
    """Approximate state: the total overlap of `state.start`, divided as in equilibrium."""
    start, rest = state.start, state.place
    share = (start.d_i + start.d_o) / (rest.d_i + rest.d_o)
    return Start((share * rest.d_i, share * rest.d_o), state.widths, state.drags)


def overlap(q: Pitch, P: float) -> float:
    """Approximate total overlap [m] of both contacts under a normal force P [N/m]."""
    return FIRST * P * (1 - q.nu**2) / q.E


def rigid_force(q: Pitch, T: float) -> float:
    """Normal force of a rigid clutch N_0 = T/(z R tan(alpha_0)) [N]."""
    cos = (q.flat + q.sense * q.r) / (q.race - q.sense * q.r)
    return T / (q.z * q.race) * math.sqrt((1 + cos) / (1 - cos))


def guessed_inside(q: Pitch, P: float) -> Start:
    """Approximate state of an inner cam under a normal force P [N/m]."""
    return Start.guessed(q, overlap(q, P), inner=SPLIT, flatter=2)


def loaded(
    q: Pitch, now: Start, share: Callable[[State], float], *, power: float, near: float, what: str
) -> Start:
    """Approximate state, on coarse meshes, whose load differs from its target by at most `near`.

    The search begins with `now`. `share` is the ratio of the target to the load of a state. Each
    step multiplies the overlaps by this ratio to the power `power`. Raises NotFoundError if the
    steps do not converge; the message contains `what`.
    """
    for _ in range(MOST):
        state = now.state(q, COARSE)
        by = share(state)
        now = after(state).scaled(by**power)
        if abs(by - 1) < near:
            return now
    raise NotFoundError(
        f"{what} was not reached: the last step still changed the load by {by - 1:.1%} of its value"
    )
