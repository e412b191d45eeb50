"""Equilibrium states of a sector of a sprag clutch, for given rotations or normal forces."""

import math
from functools import lru_cache

from fem.contact.errors import NotFoundError
from fem.wedge.races import Struts
from fem.wedge.start import Start
from meshes.sprag.wedged import Place, Races
from verify.cases.sprag.inputs import WedgeInputs

WIDE = 0.4  # half-width over sqrt(r d), about
SOFT = 15.0  # total deflection over N/E', about
NEAR, MOST = 1e-3, 20  # relative tolerance of the force, largest number of steps


def races(q: WedgeInputs) -> Races:
    """Geometry of sprags and races."""
    return Races(
        R_id=q.R_id, R_i=q.R_i, R_e=q.R_e, R_ed=q.R_ed, r_i=q.r_i, nu_0=q.nu_0, z=q.z, b=q.b
    )


def struts(q: WedgeInputs) -> Struts:
    """Geometry and material of the sprags, as input of the finite elements."""
    return Struts(z=q.z, b=q.b, E=q.E, nu=q.nu)


def guessed(q: WedgeInputs, alpha: float) -> Start[Place]:
    """Initial iterate at the rotation `alpha` [rad].

    Raises ValueError if the sprag does not overlap both races.
    """
    place = Place.overlapping(races(q), alpha)
    d_i, d_e = place.overlaps
    if not min(d_i, d_e) > 0:
        raise ValueError(
            f"a sprag rotated by {alpha:.4g} rad does not touch both races: increase the rotation"
        )
    r_e = place.q.sprag.r_e
    bends = 1 / q.r_i + 1 / q.R_i, 1 / r_e - 1 / q.R_e
    widths = WIDE * math.sqrt(d_i / bends[0]), WIDE * math.sqrt(d_e / bends[1])
    return Start(struts(q), place, widths)


@lru_cache(256)
def at_rotation(q: WedgeInputs, alpha: float) -> Start[Place]:
    """Equilibrium state at the sprag rotation `alpha` [rad], on coarse meshes."""
    return guessed(q, alpha).settled()[0]


@lru_cache(256)
def at_force(q: WedgeInputs, P: float) -> Start[Place]:
    """Equilibrium state with a force of about `P` [N/m] on the inner contact, on coarse meshes.

    Raises NotFoundError if the force is not reached in MOST steps.
    """
    start = guessed(q, _rotation(q, SOFT * P * (1 - q.nu**2) / q.E))
    for _ in range(MOST):
        start, state = start.settled()
        share = P / state.N[0]
        if abs(share - 1) <= NEAR:
            return start
        # forces grow a little faster than deflections, deflections about as the rotation
        start = start.turned(start.place.alpha * share**0.9)
    raise NotFoundError(
        f"no sprag rotation was found that gives the force {P:.4g} N/m: this force differs by "
        f"{share - 1:.1%} from the force of the last iterate"
    )


def _rotation(q: WedgeInputs, H: float) -> float:
    """Approximate rotation [rad] at the total deflection `H` [m], extrapolated from 0.01 rad."""
    small = 0.01
    return small * H / Place.overlapping(races(q), small).H
