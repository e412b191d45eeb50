"""Violation of the contact laws by multipliers and motions; each residual is dimensionless."""

from dataclasses import dataclass

import numpy as np

from fem.contact.system import ContactSystem
from fem.plane.discretisation import Array

CLOSING_SHARE = 1e-3  # over the forces that close overlaps: scale if all loads are zero
TRAVEL_SHARE = 1e-5  # round-off of a gap relative to gaps and travel


@dataclass(frozen=True)
class Residual:
    """Largest violation of each contact law, dimensionless.

    Forces are relative to the largest contact force. If no load acts on the bodies, the scale is at
    least a fraction of the forces that would close the overlaps, because the bodies may separate.
    `gap`: overlap, relative to the elastic approach of a row under the largest contact force.
    `complementarity`: pressure across an open gap, relative to the largest contact force.
    `friction`: difference between the tangential traction and its projection on Coulomb's limits,
    relative to the largest contact force. `balance`: loads on rigid motions that contact does not
    balance, relative to all forces on them.
    """

    gap: float
    complementarity: float
    friction: float
    balance: float

    @property
    def laws(self) -> float:
        """Largest residual of gap, complementarity and friction."""
        found = (self.gap, self.complementarity, self.friction)
        return max(found) if np.all(np.isfinite(found)) else np.inf

    @property
    def largest(self) -> float:
        """Largest of the four residuals; infinite if one of them is not a number."""
        return max(self.laws, self.balance) if np.isfinite(self.balance) else np.inf


def residual(
    system: ContactSystem, w_0: Array, e: Array, multipliers: Array, motion: Array
) -> Residual:
    """Residual of `multipliers` (n,) and `motion` (k,) for gaps `w_0` (n,), loads `e` (k,)."""
    m, rough, B = system.friction.size, system.rough, system.compliance
    w, normal = w_0 + system.B @ multipliers + system.D @ motion, multipliers[:m]
    overlap = np.maximum(-w_0[:m], 0.0) / B[:m]
    force = float(normal.max(initial=0.0))
    missed, size = system.missed(e, multipliers)
    if system.is_unloaded(w_0, e):
        force = max(force, CLOSING_SHARE * float(overlap.max(initial=0.0)))
        size = max(size, force * float(system.arms.max(initial=0.0)))
    force = force or 1.0
    travel = TRAVEL_SHARE * (np.abs(w_0) + system.arms @ np.abs(motion))
    share = w / np.maximum(B * force, travel)  # of a row's elastic approach
    t, p = system.partner[rough], normal[rough] / force
    bound, traction = system.friction[rough] * p, multipliers[t] / force
    projected = np.clip(traction - share[t], -np.maximum(bound, 0.0), np.maximum(bound, 0.0))
    return Residual(
        gap=float(np.maximum(-share[:m], 0.0).max(initial=0.0)),
        complementarity=float(np.abs(np.minimum(normal / force, share[:m])).max(initial=0.0)),
        friction=float(np.abs(traction - projected).max(initial=0.0)),
        balance=missed / size if missed > 0 else 0.0,
    )
