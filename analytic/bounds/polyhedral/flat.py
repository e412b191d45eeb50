"""Statics of a rigid flat by vectors: second formulation of the equations of the paper.

The pressure between two corners, the hub force and the roller force are in equilibrium along the
normal of the flat. The moment of the hub about the axis equals that of the friction of the rollers.
"""

from dataclasses import dataclass
from math import tan

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class FlatParts:
    """Dimensions and friction of the parts that load the z flats of a ring; SI units, rad.

    d_i is the diameter through the corners, `apothem` the distance of the flats from the axis, b
    the width, D_i the diameter of the race. mu is the friction of the rollers, alpha their wedge
    angle (or None). The hub acts at the distance e from mid-flat with the friction angle phi_1.
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
        """Ratio of tangential to normal force of a roller."""
        return self.mu if self.alpha is None else tan(self.alpha / 2)

    @property
    def arc(self) -> float:
        """Ratio of arc to chord of one side."""
        return arc_of_side(self.d_i, self.z)


@dataclass(frozen=True)
class Flat:
    """One flat: point and direction of the hub force, and direction on which it is projected."""

    parts: FlatParts
    at: Array  # [m]
    force: Array
    towards: Array
    touching: float  # pressure [Pa] that reaches the rollers

    @property
    def side(self) -> float:
        """Force [N] of a unit pressure on the chord between two neighbouring corners."""
        return chord(self.parts.d_i, self.parts.z) * self.parts.b

    @property
    def left(self) -> float:
        """Fraction of a roller force that the pressure causes; the hub force causes the rest."""
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
    """Flat with filleted corners, which touches the rollers at the pressure `touching` [Pa].

    The hub force is projected on the normal of the flat.
    """
    at, normal = np.array([parts.apothem, parts.e]), np.array([1.0, 0.0])
    return Flat(parts, at, _leaning(parts.phi_1), normal, touching)


def first_design(parts: FlatParts, *, d_m: float, wall: float, j_D: float, E: float) -> Flat:
    """Flat of the first design: sharp corners, hub at the radius d_i/2, K = 1.

    The hub force is projected on the radius through its contact. The flat touches the rollers at
    the pressure at which a thin round ring of mean diameter d_m closes the clearance j_D. This
    pressure is wall times hoop stress over d_i/2.
    """
    psi = np.arctan2(parts.e, parts.d_i / 2 * np.cos(np.pi / parts.z))
    outward = np.array([np.cos(psi), np.sin(psi)])
    thin = wall * E * (j_D / d_m) / (parts.d_i / 2)
    return Flat(parts, parts.d_i / 2 * outward, _leaning(parts.phi_1), outward, thin)


def chord(d_i: float, z: int) -> float:
    """Distance [length] of neighbouring corners of a polygon with z corners on the diameter d_i.

    >>> round(chord(2.0, 6), 12)
    1.0
    """
    turn = 1j * np.pi / z
    corners = d_i / 2 * np.exp(np.array([-turn, turn]))
    return float(abs(corners[1] - corners[0]))


def arc_of_side(d_i: float, z: int) -> float:
    """Ratio of arc to chord between neighbouring corners, for z corners on the diameter d_i.

    >>> round(arc_of_side(2.0, 6), 6)
    1.047198
    """
    return float(np.pi * d_i / z / chord(d_i, z))


def roller_force(
    *, p: float, touch: float, d_i: float, z: int, R_b: float = 0.0, tan_phi: float = 0.0
) -> float:
    """Force [force per length] of a roller on a rigid flat.

    The pressure p above `touch` acts on the chord of two corners. The hub force R_b per length acts
    with its component along the normal of the flat; tan_phi is its friction coefficient.
    """
    return max(p - touch, 0.0) * chord(d_i, z) + R_b / float(np.hypot(1, tan_phi))


def _leaning(phi_1: float) -> Array:
    """Unit force that is inclined by phi_1 from the normal of the flat towards its middle."""
    return np.array([np.cos(phi_1), -np.sin(phi_1)])
