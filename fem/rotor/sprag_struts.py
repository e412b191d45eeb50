"""Sprags between two races as struts between rigid hubs, under torque.

The struts are inclined by the wedge angle. Their ends either roll on the races (the line of a strut
has a constant distance from the axis) or are pinned to both races. Each contact is a line contact:
the force is proportional to deflection^(10/9).
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.rotor import struts, struts_kinds

Array = NDArray[np.float64]
POWER = 10 / 9  # exponent of a line contact
START = 1e-3  # rad, initial twist that brings the struts into contact
TURN = (5,)  # component that is free under a torque: rotation about the axis


@dataclass(frozen=True, kw_only=True)
class SpragStruts:
    """Z sprags of the length L [m] under the torque T [N m], on the radii R_i and R_e [m].

    `nu` [rad] is the wedge angle at the inner race. `yields_at_kn` [m] is the total deflection of
    both contacts under 1 kN; the default is Palmgren's value. The first sprag lies (`missing` -
    1)/2 pitches before the x-axis, so that a gap of `missing` sprags is symmetric about the x-axis.
    """

    T: float
    Z: int
    R_i: float
    R_e: float
    nu: float
    L: float
    yields_at_kn: float | None = None
    missing: int = 1

    @property
    def law(self) -> float:
        """Normal force of a sprag divided by (total deflection)^(10/9) [N/m^(10/9)].

        Palmgren's deflection of one contact is 3.84e-5 N^0.9/l^0.8 in newtons and millimetres.

        >>> sprags = SpragStruts(T=1.0, Z=12, R_i=0.01, R_e=0.02, nu=0.05, L=0.01, yields_at_kn=1.0)
        >>> sprags.law
        1000.0
        """
        palmgren = 2 * 3.84e-8 * 1e3**0.9 / (1e3 * self.L) ** 0.8
        yields = palmgren if self.yields_at_kn is None else self.yields_at_kn
        return float(1e3 / yields**POWER)

    @property
    def yields(self) -> float:
        """Total deflection [m] of both contacts of each sprag under T alone."""
        force = self.T / self.Z / self.R_i / math.tan(self.nu)
        return float((force / self.law) ** (1 / POWER))

    def slices(self, psi: Array, count: int) -> tuple[Array, Array]:
        """Angles [rad] and axial positions [m] of the slices of sprags at the angles psi (Z,).

        Each sprag has `count` slices.
        """
        z = self.L * ((np.arange(count) + 0.5) / count - 0.5)
        return np.repeat(psi, count), np.tile(z, psi.size)

    def rolling(
        self, count: int, *, dx: float = 0.0, drop: float = 0.0, gone: int = 0,
        stiffer: float = 1.0,
    ) -> struts.Joint:  # fmt: skip
        """State of struts with rolling ends under T, with the inner hub displaced by `dx` [m].

        Each sprag is modelled by `count` slices. Both contacts have a parabolic crown with the
        `drop` [m] at its ends. The first `gone` sprags are missing. Deflections are divided by
        `stiffer`.
        """
        step = 2 * math.pi / self.Z
        psi = step * (np.arange(gone, self.Z, dtype=float) - (self.missing - 1) / 2)
        angle, z = self.slices(psi, count)
        law = self._power_law(self.law * stiffer**POWER / count)
        crown = -2 * drop * (2 * z / self.L) ** 2 * math.cos(self.nu)
        cams = self._cams(angle, z, crown)
        # start with a twist at which every strut is in contact: larger than offset and drop need
        lost = 2 * drop + abs(dx)
        twist = START + lost / (self.R_i * math.tan(self.nu))
        started = struts.Joint.at_rest(cams, law).moved(np.array([dx, 0, 0, 0, 0, twist]))
        return started.under(self._torque, TURN)

    def tilted(self, count: int, offset: float) -> struts.Joint:
        """State of struts with rolling ends under T, with a displaced and tilted inner hub.

        The first strut lies half a pitch from the x-axis. The hub is displaced in x by `offset` [m]
        at mid-length, by twice this value at one end, and by zero at the other end. At mid-length,
        the displacement is at most a quarter of the deflection, so that every slice stays in
        contact.
        """
        psi = 2 * math.pi * (np.arange(self.Z) + 0.5) / self.Z
        cams = self._cams(*self.slices(psi, count))
        law = self._power_law(self.law / count)
        # the twist is applied first: the remaining rotation about z hardly turns the tilt axis
        twist = self.yields / (self.R_i * math.tan(self.nu))
        twisted = struts.Joint.at_rest(cams, law).moved(np.array([0, 0, 0, 0, 0, twist]))
        dx = min(offset, self.yields / 4)
        held = twisted.moved(np.array([dx, 0, 0, 0, 2 * dx / self.L, 0]))
        return held.under(self._torque, TURN)

    def pinned(self, count: int, *, stiffer: float = 1.0) -> struts.Joint:
        """State of struts that are pinned to both races, under T.

        The pins are at their positions under T; the struts have the shortening due to T.
        """
        psi, z = self.slices(2 * math.pi * np.arange(self.Z) / self.Z, count)
        h = self.R_i * math.sin(self.nu)
        away = psi + self.nu - math.asin(h / self.R_e)
        k = self.law * stiffer**POWER / math.cos(self.nu) ** (POWER + 1)
        held = struts_kinds.Pinned(
            a=np.stack([self.R_i * np.cos(psi), self.R_i * np.sin(psi), z], axis=1),
            b=np.stack([self.R_e * np.cos(away), self.R_e * np.sin(away), z], axis=1),
            s_0=(self.T / (self.Z * h) / k) ** (1 / POWER),
        )
        return struts.Joint.at_rest(held, struts.power_law(k / count, POWER))

    def off_diagonal(self, K: Array) -> float:
        """Largest off-diagonal entry of K [N/m], if rotations are expressed as lengths.

        These lengths are a tilt times L, and the twist times R_i.
        """
        size = np.array([1, 1, 1, self.L, self.L, self.R_i])
        return float(np.abs((K - np.diag(np.diag(K))) / np.outer(size, size)).max())

    @property
    def _torque(self) -> Array:
        return np.array([0, 0, 0, 0, 0, self.T])

    def _cams(self, angle: Array, z: Array, s_0: Array | float = 0.0) -> struts_kinds.Rolling:
        """Struts whose lines are tangents to a circle about the axis."""
        lever, reach = self.R_i * math.sin(self.nu), self.R_i * math.cos(self.nu)
        return struts_kinds.Rolling(angle=angle + self.nu, z=z, lever=lever, reach=reach, s_0=s_0)

    def _power_law(self, k: float) -> struts.Law:
        """Force law of struts that are inclined by nu to normal forces N = k deflection^(10/9)."""
        return struts.power_law(k / math.cos(self.nu) ** (POWER + 1), POWER)
