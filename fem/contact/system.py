"""The condensed contact problem: weighted gaps and slips that depend linearly on tractions.

The unknowns are the multipliers l = (normal, tangential) and the amplitudes a of rigid motions that
supports do not prevent. Weighted gaps and slips are linear in the unknowns. The equilibrium of the
rigid motions completes the system:

    w = w_0 + B l + D a,    e + D' l = 0.

Normal rows: l_n >= 0, w_n >= 0, l_n w_n = 0. Each tangential row belongs to a normal row: |l_t| <=
mu l_n; if |l_t| = mu l_n, l_t opposes w_t.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from scipy.optimize import nnls

from fem.plane.discretisation import Array, Indices

OPEN, STICK, FORWARD, BACKWARD = 0, 1, 2, 3  # slip states by the sign of l_t: + and -
SIGN = np.array([0.0, 0.0, 1.0, -1.0])
STAYING = 1e-2  # relative to the contact's stiffness: springs against neutral motions
FELT = 1e-7  # relative to the squared displacements: below, only facets resist the motion
LOAD_TOLERANCE = 1e-13  # over the forces that would close the gaps: smaller loads are round-off
GAP_TOLERANCE = 1e-14  # over the largest gap or slip: smaller gaps of unloaded bodies are none
BALANCE_TOLERANCE = 1e-9  # relative to the loads on rigid motions: smaller imbalances are allowed
BARE = 1e-12  # relative to the largest: smaller rows act on no rigid motion
ASKEW = 1e-2  # over the loads: so much may act on a neutral motion until surfaces are paired again
OFFSET = 1e-3  # the same for neutral rotations, whose moments refer to points of the mesh


def directions(D: Array) -> Array:
    """Rows of `D` (n, k) scaled to unit length; contact resists the motions that they span.

    Unit rows make the result independent of the compliance. Rows that act on no rigid motion are
    zero.
    """
    length = np.sqrt((D**2).sum(axis=1))
    acts = length > BARE * length.max(initial=0.0)
    return np.asarray(D * (acts / np.where(acts, length, 1.0))[:, None])


@dataclass(frozen=True, kw_only=True)
class ContactSystem:
    """Compliance `B` (n, n) and rigid motions `D` (n, k); the first m rows are normal rows.

    `friction` (m,) is mu of each normal row; `partner` (m,) is the number of its tangential row, or
    -1. `part` (m,) is the number of the surface of each normal row; rows of a surface are in order
    along the surface.
    """

    B: Array
    D: Array
    friction: Array
    partner: Indices
    part: Indices

    @cached_property
    def rough(self) -> Indices:
        """Normal rows with friction."""
        return np.flatnonzero(self.partner >= 0)

    @cached_property
    def compliance(self) -> Array:
        """Diagonal (n,) of the compliance B."""
        return np.diag(self.B).copy()

    @cached_property
    def reach(self) -> Array:
        """Square roots (n,) of the diagonal of B; products of two roots bound the entries of B."""
        return np.sqrt(self.compliance)

    @cached_property
    def arms(self) -> Array:
        """Absolute values of the movements (n, k) of all rows under unit rigid motions."""
        return np.abs(self.D)

    @cached_property
    def scales(self) -> tuple[Array, Array]:
        """Scales of multipliers (n,) and motions (k,) that bring all entries to about one."""
        own = 1 / self.reach
        reactions = np.sqrt(((own[:, None] * self.D) ** 2).sum(axis=0))
        return own, 1 / np.maximum(reactions, BARE * reactions.max(initial=BARE))

    @cached_property
    def stiffness(self) -> float:
        """Stiffness of the contact against the rigid motion that it resists most."""
        own = (self.D**2 / self.compliance[:, None]).sum(axis=0)
        return float(own.max(initial=0.0))

    @cached_property
    def motions(self) -> tuple[Array, Array]:
        """Motions (k, .) that contact resists, and neutral motions (k, .) that it hardly resists.

        An example of a neutral motion is the rotation of a smooth pin in a hole: only facets resist
        it.
        """
        rows = directions(self.D)
        size, motions = np.linalg.eigh(rows.T @ rows)
        resisted = size > FELT * size.max(initial=0.0)
        return motions[:, resisted], motions[:, ~resisted]

    def springs(self, share: float) -> Array:
        """Springs (k, k) on rigid motions, with the stiffness of the contact times `share`.

        Springs on neutral motions do not depend on `share`.
        """
        resisted, neutral = self.motions
        return self.stiffness * (
            share * resisted @ resisted.T + STAYING * neutral @ neutral.T
        )  # fmt: skip

    def loads_at_round_off(self, w_0: Array) -> float:
        """Largest load on a rigid motion that the round-off of `w_0` (n,) causes."""
        closing = float(np.max(np.abs(w_0) / self.compliance, initial=0.0))
        return LOAD_TOLERANCE * closing * float(self.arms.max(initial=0.0))

    def is_unloaded(self, w_0: Array, e: Array) -> bool:
        """True if no load beyond round-off acts on the rigid motions."""
        return float(np.abs(e).max(initial=0.0)) <= self.loads_at_round_off(w_0)

    def without_round_off(self, w_0: Array) -> Array:
        """Gaps and slips `w_0` (n,), with gaps smaller than round-off set to zero."""
        size = self.scales[0] * np.abs(w_0)
        normal = np.arange(w_0.size) < self.friction.size
        return np.where(normal & (size <= GAP_TOLERANCE * size.max(initial=0.0)), 0.0, w_0)

    def missed(self, e: Array, multipliers: Array) -> tuple[float, float]:
        """Largest unbalanced load on a rigid motion, and largest sum of forces on a motion.

        The sum contains the absolute values of loads and contact forces.
        """
        size = np.abs(e) + np.abs(self.D.T) @ np.abs(multipliers)
        missed = np.abs(self.motions[0].T @ (e + self.D.T @ multipliers))
        return float(missed.max(initial=0.0)), float(size.max(initial=0.0))

    def missing(self, e: Array) -> Array:
        """Part of the loads `e` (k,) on rigid motions that no contact forces can balance.

        The result is zero if all loads can be balanced within round-off.
        """
        m, (resisted, neutral) = self.friction.size, self.motions
        if not np.any(e):
            return np.zeros_like(e)
        if np.linalg.norm(neutral.T @ e) > ASKEW * np.linalg.norm(e):
            return neutral @ (neutral.T @ e)
        D = self.D @ resisted
        normal, held = D[:m].T, self.rough
        sideways = self.friction[held] * D[self.partner[held]].T
        cone = np.hstack([normal, normal[:, held] + sideways, normal[:, held] - sideways])
        size = np.abs(cone).max(axis=0, initial=0.0)
        cone = cone[:, size > BARE * size.max(initial=0.0)]
        cone /= np.hypot.reduce(cone, axis=0)
        share, _ = nnls(cone, -resisted.T @ e, maxiter=100 * cone.shape[1])
        missed = resisted @ (resisted.T @ e + cone @ share)
        balanced = np.linalg.norm(missed) <= BALANCE_TOLERANCE * np.linalg.norm(e)
        return np.zeros_like(e) if balanced else missed

    def unfelt(self, e: Array) -> Array:
        """Part of the loads `e` (k,) on neutral motions; zero if this part is small."""
        _, neutral = self.motions
        found = neutral @ (neutral.T @ e)
        return found if np.linalg.norm(found) > OFFSET * np.linalg.norm(e) else np.zeros_like(e)

    def groups(self, group: int) -> Indices:
        """Group number (m,) of each normal row; groups have `group` consecutive rows."""
        along = np.arange(self.part.size) - np.searchsorted(self.part, self.part)
        return np.asarray(np.cumsum(along % group == 0) - 1)

    def smooth(self, group: int = 1) -> Self:
        """System without friction, with `group` rows of a surface combined into one row."""
        if group not in self._smoothed:
            start = np.flatnonzero(np.diff(self.groups(group), prepend=-1))
            m = self.friction.size
            self._smoothed[group] = type(self)(
                B=np.add.reduceat(np.add.reduceat(self.B[:m, :m], start, axis=0), start, axis=1),
                D=np.add.reduceat(self.D[:m], start, axis=0), friction=np.zeros(start.size),
                partner=np.full(start.size, -1), part=self.part[start],
            )  # fmt: skip
        return self._smoothed[group]

    @cached_property
    def _smoothed(self) -> dict[int, Self]:
        """Results of `smooth` for each `group`, stored because every load uses them."""
        return {}
