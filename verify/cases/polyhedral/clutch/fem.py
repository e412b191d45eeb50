"""Finite-element model of the driven ring: the hub force is proportional to the roller force."""

from typing import TYPE_CHECKING

import numpy as np

from verify.cases.polyhedral.clutch.inputs import ClutchInputs
from verify.cases.polyhedral.locking.fem import locked_fem

if TYPE_CHECKING:
    from fem.contact.driven import DrivenSector
    from fem.contact.locked import LockedSector

THICK = 0.15  # wall over outer diameter above which a mesh is twice as fine
THIN = 0.02  # the same at the rollers, below which it is so: contacts end near the vertices


def driven_fem(q: ClutchInputs, level: int, *, elastic: bool) -> "DrivenSector":
    """Model of half a sector with its roller at the friction limit, in balance with the hub."""
    from fem.contact.driven import DrivenSector

    slim = q.d_e / 2 - q.ring.apothem < THIN * q.d_e
    refine = 2 * level if slim or q.delta_1 > THICK * q.d_e else level

    def mesh(fine: bool, p: float, hub: tuple[float, float]) -> "LockedSector":
        return locked_fem(
            q.ring, refine if fine else 1, d=q.d, e=q.e, p=p, hub=hub, elastic=elastic
        )

    turn = np.hypot(q.e, q.ring.apothem) * np.sin(q.psi + q.phi_1)
    kappa = q.grip * q.D_i / 2 / turn  # moments of roller and hub about the axis
    return DrivenSector(mesh, kappa, q.phi_1, q.p_t)
