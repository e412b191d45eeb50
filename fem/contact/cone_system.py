"""Condensed system of a cone: compliance, rigid motions, friction, and their scales."""

from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from fem.contact.complementarity import Complementarity
from fem.contact.system import directions
from fem.plane.discretisation import Array, Indices

EXACT = 1e-9  # tolerance of the solution, relative to peak pressure and forces
RESISTED = 1e-7  # over the squared displacements: below it, only facets resist the motion
NEUTRAL_SPRING = 1e-2  # over the contact's stiffness: supports motions that only facets resist


@dataclass(frozen=True)
class State:
    """Multipliers (n,) and amplitudes of rigid motions (k,)."""

    multipliers: Array
    motion: Array


@dataclass(frozen=True, kw_only=True)
class Task:
    """Gaps and slips `w_0` (n,), loads `e` (k,), springs `K` (k, k), and `friction` (m,)."""

    w_0: Array
    e: Array
    K: Array
    friction: Array


@dataclass(frozen=True, kw_only=True)
class System:
    """Compliance `B` (n, n) and rigid motions `D` (n, k); the first m rows are normal rows.

    `friction` (m,) is mu of each normal row; `rough` (r,) are the normal rows with friction. Rows m
    to m + r are the tangential rows of `rough`, rows m + r to m + 2 r their rows along z.
    """

    B: Array
    D: Array
    friction: Array
    rough: Indices

    @classmethod
    def of(cls, plane: Complementarity, B_z: Array, D_z: Array) -> Self:
        """System of the plane problem, extended by `B_z` (r, r) and `D_z` (r, k) along z.

        `B_z` is the compliance along z, `D_z` are the shifts along z.
        """
        (n, k), (r, k_z) = plane.D.shape, D_z.shape
        B, D = np.zeros((n + r, n + r)), np.zeros((n + r, k + k_z))
        B[:n, :n], B[n:, n:] = plane.B, B_z
        D[:n, :k], D[n:, k:] = plane.D, D_z
        return cls(B=B, D=D, friction=plane.friction, rough=np.flatnonzero(plane.partner >= 0))

    @cached_property
    def t(self) -> Indices:
        """Rows (r,) of friction along the surface."""
        return self.friction.size + np.arange(self.rough.size)

    @cached_property
    def z(self) -> Indices:
        """Rows (r,) of friction along z."""
        return self.t + self.rough.size

    @cached_property
    def tau(self) -> Indices:
        """Rows (2, r) of friction, along the surface and along z."""
        return np.array([self.t, self.z])

    @cached_property
    def yields(self) -> Array:
        """Diagonal (n,) of the compliance B."""
        return np.diag(self.B).copy()

    @cached_property
    def reach(self) -> Array:
        """Sums (k,) of the movements of all rows under a unit rigid motion; 1 if no row moves."""
        reach = np.abs(self.D).sum(axis=0)
        return np.where(reach > 0, reach, 1.0)

    @cached_property
    def augmentation(self) -> tuple[Array, Array]:
        """Penalty factors c_n (m,) of gaps, and c (r,) of slips.

        They are the pressure that closes a unit gap, and the traction that causes a unit slip.
        """
        yields = self.yields
        return 1 / yields[: self.friction.size], 1 / np.sqrt(yields[self.t] * yields[self.z])

    @cached_property
    def stiffness(self) -> Array:
        """Stiffness (k,) of the contact against rigid motions."""
        return np.asarray((self.D**2 / self.yields[:, None]).sum(axis=0))

    @cached_property
    def _resisted(self) -> Array:
        """Projection (k, k) on motions that the contact resists.

        Only the facets of the mesh resist the other motions.
        """
        rows = directions(self.D)
        size, motions = np.linalg.eigh(rows.T @ rows)
        resisted = motions[:, size > RESISTED * size.max(initial=0.0)]
        return resisted @ resisted.T

    def springs(self, share: float) -> Array:
        """Springs (k, k) on rigid motions, with the stiffness of the contact times `share`.

        Motions that only facets resist have constant springs.
        """
        neutral = np.eye(len(self._resisted)) - self._resisted
        unit = float(self.stiffness.max(initial=0.0))
        return unit * (share * self._resisted + NEUTRAL_SPRING * neutral)

    def utilisation(self, multipliers: Array) -> Array:
        """Friction (r,) relative to mu times the pressure; zero without pressure."""
        friction = np.hypot(multipliers[self.t], multipliers[self.z])
        most = self.friction[self.rough] * multipliers[self.rough]
        pressed = most > EXACT * most.max(initial=0.0)
        return np.where(pressed, friction / np.where(pressed, most, 1.0), 0.0)
