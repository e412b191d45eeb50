"""A roller held in its wedge without friction at work, and let go: where its contacts stick."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.cases.polyhedral.wedge.model import Geometry, Wedge, fem_mesh

if TYPE_CHECKING:
    from fem.contact.solution import Touch

Array = NDArray[np.float64]


class Share(float):
    """T/(mu N), which names a number of the reference: "0_4"."""

    def __str__(self) -> str:
        return f"{self:g}".replace(".", "_")


SHARES = tuple(map(Share, (0.4, 0.6, 0.8)))  # of the rows
GROWTH = np.linspace(0.1, 0.8, 15)  # and of the figure
SWEEP, SWEPT = 50, 0.88  # steps of letting go, and T/(mu N) at their end
TILT, FLATTEST = 0.04, 0.02  # a/(mu R) and a/R at most
STIFFENS = 0.93  # d ln(approach)/d ln(N) of line contacts, about


def small(q: WedgeInputs) -> Geometry:
    """A contact small against R and mu R, where Cattaneo's half planes are the limit.

    Elsewhere the surface on which roller and race meet is inclined by up to a/(2R) at its ends,
    which counts against the angle of friction.
    """
    return Geometry(q.R, q.half, q.R * min(TILT * q.mu, FLATTEST))


def let_go(q: WedgeInputs, level: int) -> tuple[dict[str, float], dict[str, float], Array]:
    """Stick half-widths over a as T grows at the same N, their uncertainties, and the figure's."""
    from fem.contact.partial_slip import smoothed

    geometry = small(q)
    N = math.pi * q.E_star * geometry.a**2 / (4 * q.R)
    wedge = Wedge(geometry, fem_mesh(geometry, level), E=q.E, nu=q.nu, mu=q.mu, normal="between")
    push = N * math.sin(q.half)  # balances the normal force alone
    state, down = wedge.pressed(N, push=push, near=wedge.pressed(N)[1])
    found = []
    for k in np.linspace(0.0, SWEPT, SWEEP + 1)[1:]:
        less = push - k * q.mu * N * math.cos(q.half)
        trial = wedge.forces(wedge.at(down, push=less, after=state))[0]
        down *= (N / trial) ** STIFFENS
        state = wedge.at(down, push=less, after=state)
        normal, tangential = wedge.forces(state)
        found.append((tangential / (q.mu * normal), share_stuck(state.touches[0])))
    k_found, c2 = np.array(found).T
    values, u_it = {}, {}
    for k in SHARES:
        share, u, _ = smoothed(k_found, c2, k)
        values[f"stick_{k}"] = math.sqrt(share)
        u_it[f"stick_{k}"] = u / (2 * math.sqrt(share))
    return values, u_it, np.sqrt([smoothed(k_found, c2, k)[0] for k in GROWTH])


def share_stuck(touch: "Touch") -> float:
    """(c/a)² from the second moment of the traction about the middle of the contact.

    As in `fem.contact.partial_slip`: 4 M_2/(M_0 a²) - 1, about a fixed place, where an odd part of
    the traction drops out: a round body on a flat has one, which pressing alone leaves.
    """
    middle = (0.0, 0.0)  # the roller's centre, below the place where it first touched
    s, load = touch.along(middle), touch.q * touch.weight
    return float(4 * (load @ s**2) / (load.sum() * touch.half_width(middle) ** 2) - 1)
