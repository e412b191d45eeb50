"""Statics of a rigid flat by vectors, as a second form of the paper's chain of equations.

Pressure between two corners, the hub's force and the roller's are in balance across the flat; the
hub's moment about the axis equals the moment of the rollers' friction.
"""

from dataclasses import dataclass
from math import tan

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class FlatParts:
    """Parts that load the z flats of a ring: SI, angles in rad.

    d_i through the corners, `apothem` of the flats, width b; the race D_i, friction mu on the
    rollers or their wedge angle alpha; the hub at e from mid-flat, its angle of friction phi_1.
    """

    z: int
    d_i: float
    D_i: float
    b: float
    e: float
    apothem: float
    mu: float
    phi_1: float
    alpha: float | None = None

    @property
    def grip(self) -> float:
        """Friction over normal force of a roller."""
        return self.mu if self.alpha is None else tan(self.alpha / 2)

    @property
    def arc(self) -> float:
        """Arc of a side over its chord."""
        return arc_of_side(self.d_i, self.z)


@dataclass(frozen=True)
class Flat:
    """One flat: point and direction of the hub's unit force, and direction of displacements."""

    parts: FlatParts
    at: Array  # [m]
    force: Array
    towards: Array
    touching: float  # pressure [Pa] that reaches the rollers

    @property
    def side(self) -> float:
        """Force [N] of the unit pressure between two corners."""
        return chord(self.parts.d_i, self.parts.z) * self.parts.b

    @property
    def left(self) -> float:
        """Share of a roller's force that pressure must bring."""
        lever = float(abs(self.at[0] * self.force[1] - self.at[1] * self.force[0]))
        counted = float(self.force @ self.towards)
        return 1 - counted * self.parts.grip * self.parts.D_i / 2 / lever

    def torque(self, p: float) -> float:
        """Torque [N m] of all rollers under the pressure p [Pa]."""
        N = (p - self.touching) * self.side / self.left
        return self.parts.z * self.parts.grip * N * self.parts.D_i / 2

    def pressure(self, M_t: float) -> float:
        """Pressure [Pa] for the torque M_t [N m]."""
        N = M_t / (self.parts.z * self.parts.grip * self.parts.D_i / 2)
        return self.touching + max(N * self.left, 0.0) / self.side


def filleted(parts: FlatParts, touching: float) -> Flat:
    """The flat in contact at a pressure [Pa]; the force of the hub acts along its normal."""
    at, normal = np.array([parts.apothem, parts.e]), np.array([1.0, 0.0])
    return Flat(parts, at, _leaning(parts.phi_1), normal, touching)


def first_design(parts: FlatParts, *, d_m: float, wall: float, j_D: float, E: float) -> Flat:
    """Sharp corners, the hub at the radius d_i/2, its force counted along this radius, K = 1.

    A thin round ring of mean diameter d_m that closes the clearance j_D: wall times hoop stress.
    """
    psi = np.arctan2(parts.e, parts.d_i / 2 * np.cos(np.pi / parts.z))
    outward = np.array([np.cos(psi), np.sin(psi)])
    thin = wall * E * (j_D / d_m) / (parts.d_i / 2)
    return Flat(parts, parts.d_i / 2 * outward, _leaning(parts.phi_1), outward, thin)


def chord(d_i: float, z: int) -> float:
    """Distance [length] of two neighbours of z corners on the diameter d_i.

    >>> round(chord(2.0, 6), 12)
    1.0
    """
    turn = 1j * np.pi / z
    corners = d_i / 2 * np.exp(np.array([-turn, turn]))
    return float(abs(corners[1] - corners[0]))


def arc_of_side(d_i: float, z: int) -> float:
    """Arc over chord between two neighbours of z corners on the diameter d_i.

    >>> round(arc_of_side(2.0, 6), 6)
    1.047198
    """
    return float(np.pi * d_i / z / chord(d_i, z))


def roller_force(
    *, p: float, touch: float, d_i: float, z: int, R_b: float = 0.0, tan_phi: float = 0.0
) -> float:
    """Force [force per length] of a roller on a rigid flat.

    Pressure p beyond `touch` pushes on the chord of two corners, the hub's force R_b per length
    along the flat's normal; tan_phi is its friction.
    """
    return max(p - touch, 0.0) * chord(d_i, z) + R_b / float(np.hypot(1, tan_phi))


def _leaning(phi_1: float) -> Array:
    """Unit force that leans from the flat's normal towards its middle."""
    return np.array([np.cos(phi_1), -np.sin(phi_1)])
