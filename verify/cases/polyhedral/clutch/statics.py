"""Statics of a rigid flat by vectors, which says what the paper's chain should come to.

Pressure between two corners, the hub's force and the roller's are in balance across the flat; the
hub's moment about the axis is that of the rollers' friction. Written without the chain's formulas.
"""

from dataclasses import dataclass

import numpy as np

from verify.cases.polyhedral.clutch.inputs import ClutchInputs
from verify.core.figures import Array


@dataclass(frozen=True)
class Flat:
    """One flat: where the hub's unit force acts, what it is, and which way it is counted."""

    q: ClutchInputs
    at: Array  # [m]
    force: Array
    towards: Array
    touching: float  # pressure [Pa] that reaches the rollers

    @property
    def grip(self) -> float:
        """Friction over normal force of a roller."""
        return self.q.mu if self.q.alpha is None else float(np.tan(self.q.alpha / 2))

    @property
    def side(self) -> float:
        """Force [N] of the unit pressure between two corners."""
        turn = 1j * np.pi / self.q.z
        corners = self.q.ring.d_i / 2 * np.exp(np.array([-turn, turn]))
        return float(abs(corners[1] - corners[0])) * self.q.b

    @property
    def left(self) -> float:
        """Share of a roller's force that pressure must bring."""
        lever = float(abs(self.at[0] * self.force[1] - self.at[1] * self.force[0]))
        return 1 - float(self.force @ self.towards) * self.grip * self.q.D_i / 2 / lever

    def torque(self, p: float) -> float:
        """Torque [N m] of all rollers under the pressure p [Pa]."""
        N = (p - self.touching) * self.side / self.left
        return self.q.z * self.grip * N * self.q.D_i / 2

    def pressure(self, M_t: float) -> float:
        """Pressure [Pa] for the torque M_t [N m]."""
        N = M_t / (self.q.z * self.grip * self.q.D_i / 2)
        return self.touching + max(N * self.left, 0.0) / self.side


def filleted(q: ClutchInputs, touching: float) -> Flat:
    """The flat as it is, touched at a pressure [Pa]: the hub's force counts along its normal."""
    return Flat(q, np.array([q.ring.apothem, q.e]), _leaning(q.phi_1), np.array([1.0, 0.0]),
                touching)  # fmt: skip


def first_design(q: ClutchInputs) -> Flat:
    """Sharp corners, the hub at the radius d_i/2, its force counted along this radius, K = 1."""
    psi = np.arctan2(q.e, q.ring.d_i / 2 * np.cos(np.pi / q.z))
    outward = np.array([np.cos(psi), np.sin(psi)])
    return Flat(q, q.ring.d_i / 2 * outward, _leaning(q.phi_1), outward, _thin(q))


def _leaning(phi_1: float) -> Array:
    """Unit force that leans from the flat's normal towards its middle."""
    return np.array([np.cos(phi_1), -np.sin(phi_1)])


def _thin(q: ClutchInputs) -> float:
    """Pressure [Pa] of a thin round ring that takes up the clearance: wall times hoop stress."""
    ring = q.ring
    return q.delta_1 * q.E * ring.straining / (ring.d_i / 2)
