"""The sector of a sprag clutch through its stroke: states at rest at rotations or forces.

Coarse meshes say where the sprag lies and how wide its contacts are; states on finer meshes start
from there, all at the same rotation.
"""

import math
from dataclasses import dataclass, replace
from functools import lru_cache

from fem.contact.errors import NotFoundError
from fem.wedge.races import Sector, State, Struts
from meshes.sprag.wedged import Place, Races
from verify.cases.sprag.inputs import WedgeInputs

COARSE = 3  # cells on the half-width of the meshes that say where contacts lie
SETTLED = 1e-4  # of both overlaps, what pole and contacts may still move by; steps
STICKS = 5.0  # friction over tan(nu): well above what the sprag needs
WIDE = 0.4  # half-width over sqrt(r d), about
SOFT = 15.0  # all that yields over N/E', about
NEAR, MOST = 1e-3, 20  # how near the force is met, and in how many steps


def races(q: WedgeInputs) -> Races:
    """The geometry of sprags and races."""
    return Races(
        R_id=q.R_id, R_i=q.R_i, R_e=q.R_e, R_ed=q.R_ed, r_i=q.r_i, nu_0=q.nu_0, z=q.z, b=q.b
    )


def struts(q: WedgeInputs) -> Struts:
    """The sprags as finite elements take them."""
    return Struts(z=q.z, b=q.b, E=q.E, nu=q.nu)


@dataclass(frozen=True)
class Start:
    """Where a state of sprags lies: its place, half-widths [m] and drags [m]."""

    sprags: Struts
    place: Place
    widths: tuple[float, float]
    drags: tuple[float, float] = (0.0, 0.0)

    @classmethod
    def guessed(cls, q: WedgeInputs, alpha: float) -> "Start":
        """At the rotation `alpha` [rad]; ValueError where the sprag does not overlap the races."""
        place = Place.overlapping(races(q), alpha)
        d_i, d_e = place.overlaps
        if not min(d_i, d_e) > 0:
            raise ValueError(f"a sprag turned by {alpha:.4g} rad touches no race: it needs more")
        r_e = place.q.sprag.r_e
        bends = 1 / q.r_i + 1 / q.R_i, 1 / r_e - 1 / q.R_e
        widths = WIDE * math.sqrt(d_i / bends[0]), WIDE * math.sqrt(d_e / bends[1])
        return cls(struts(q), place, widths)

    @classmethod
    def after(cls, state: State[Place]) -> "Start":
        """Where `state` came to rest."""
        return cls(state.sector.q, state.place, state.widths, state.drags)

    def turned(self, alpha: float) -> "Start":
        """About the same at another rotation [rad]."""
        place = self.place
        far = Place.overlapping(place.q, alpha)
        share, (b_i, b_e) = far.H / place.H, place.bends
        # as the overlaps of both contacts share the whole
        D = far.D + share * place.overlaps[1] - far.overlaps[1]
        root = math.sqrt(share)
        return replace(
            self,
            place=replace(place, alpha=alpha, D=D, bends=(share * b_i, share * b_e)),
            widths=(root * self.widths[0], root * self.widths[1]),
            drags=(share * self.drags[0], share * self.drags[1]),
        )

    def state(self, cells: int, mu: float | None = None) -> State[Place]:
        """The state at rest; by default friction lets the sprag stick."""
        if mu is None:
            mu = STICKS * math.tan(self.place.strut[0])
        return Sector(self.sprags, self.place, self.widths, cells, mu=mu).rest(self.drags)

    def settled(self) -> tuple["Start", State[Place]]:
        """Where the sprag comes to rest, and the last coarse state."""
        start = self
        for _ in range(MOST):
            state = start.state(COARSE)
            start, before = Start.after(state), start
            now, last = start.place, before.place
            moved = now.D - last.D, now.OA - last.OA, now.OB - last.OB
            if max(map(abs, moved)) <= SETTLED * now.H:
                return start, state
        raise NotFoundError(f"the sprag at {self.place.alpha:.4g} rad finds no place")


@lru_cache(256)
def at_rotation(q: WedgeInputs, alpha: float) -> Start:
    """Where the sprag lies turned by `alpha` [rad]."""
    return Start.guessed(q, alpha).settled()[0]


@lru_cache(256)
def at_force(q: WedgeInputs, P: float) -> Start:
    """Where the sprag lies whose inner contact bears about `P` [N/m] on coarse meshes."""
    start = Start.guessed(q, _rotation(q, SOFT * P * (1 - q.nu**2) / q.E))
    for _ in range(MOST):
        start, state = start.settled()
        share = P / state.N[0]
        if abs(share - 1) <= NEAR:
            return start
        # forces grow a little faster than yields, and these about as the rotation
        start = start.turned(start.place.alpha * share**0.9)
    raise NotFoundError(f"the force {P:.4g} N/m is missed by {share - 1:.1%}")


def _rotation(q: WedgeInputs, H: float) -> float:
    """At which the races yield by `H` [m], about: as in the first hundredth of a radian."""
    small = 0.01
    return small * H / Place.overlapping(races(q), small).H
