r"""Normal force and friction of points in contact: penalty method with Lagrange multipliers.

The normal force is the positive part of z = multiplier - stiffness x gap, smoothed where |z| is
less than the onset e = stiffness x ROUNDING x thickness. Therefore Newton's method encounters no
kink:

.. math:: N = \frac{(z + e)^2}{4 e}\ (|z| < e), \qquad N = z\ (z \ge e)

Points in contact stick with a tangential penalty and slide at |T| = friction x N. During Newton's
method, the state of each point and its direction of sliding are constant. After convergence,
`settle` corrects the states. It also transfers both forces to the multipliers until penetration and
elastic slip are below `allowed`.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.beam.section import Array
from fem.beam.touching_touch import Touch, outer

ROUNDING = 1e-4  # relative to the thickness
ALLOWED = 1e-4  # relative to the thickness: penetration and elastic slip that need no settling
DEEP = 0.05  # of the thickness: only an iterate is so deep, and its huge force must not turn
STICKS = 2.0  # besides -1 and 1, the directions of sliding, and 0, not known yet
SLACK = 1e-9  # relative, of the friction's limit and of the allowed slip
TANGENTIAL = 0.002  # share of the normal stiffness


@dataclass(frozen=True)
class Answer:
    """Results of the contact law for k contacts with m unknowns each.

    `energy` is the sum over all contacts; `force` is (k, m), `tangent` (k, m, m). `normal` and
    `tangential` (k,) are the forces N and T; `sticking` (k,) is True without sliding.
    """

    energy: float
    force: Array
    tangent: Array
    normal: Array
    tangential: Array
    sticking: NDArray[np.bool_]


class Law:
    """Contact law of all possible contacts (slots); normal `stiffness` (slots,) [force / length].

    The tangential stiffness of sticking contacts is a constant fraction of `firm` (slots,) [force /
    length]: the normal stiffness without the reduction for long probes.
    """

    def __init__(self, stiffness: Array, firm: Array, friction: float, thickness: float) -> None:
        self.stiffness, self.friction = stiffness, friction
        self.sticking = TANGENTIAL * firm
        self.onset = stiffness * ROUNDING * thickness
        self.allowed, self.deep = ALLOWED * thickness, DEEP * thickness
        self.start()

    def start(self) -> None:
        self.normal, self.tangential, self.way = np.zeros((3, self.stiffness.size))
        self.kept = self.normal, self.tangential, self.way

    def pressing(self, slot: NDArray[np.int64], gap: Array) -> NDArray[np.bool_]:
        """True where a gap is small enough for a contact force."""
        return self.normal[slot] - self.stiffness[slot] * gap > -self.onset[slot]

    def answer(self, touch: Touch) -> Answer:
        """Energy, forces and tangents of the contacts."""
        k, e = self.stiffness[touch.slot], self.onset[touch.slot]
        z = self.normal[touch.slot] - k * touch.gap
        round_ = z < e
        N = np.where(round_, (z + e) ** 2 / (4 * e), z)
        hard = k * np.where(round_, (z + e) / (2 * e), 1.0)
        energy = float((_energy(z, e) / k).sum() - self._multiplied().sum())
        force = -N[:, None] * touch.opening
        turning = np.where(touch.gap < -self.deep, 0.0, N)
        K = hard[:, None, None] * outer(touch.opening, touch.opening)
        K -= turning[:, None, None] * touch.turning
        if not self.friction:
            none = np.zeros_like(N)
            return Answer(energy, force, K, N, none, none > 0)
        way = self.way[touch.slot]
        stick = way == STICKS
        way = np.where(stick, 0.0, way)
        T = np.where(stick, self._trial(touch), way * self.friction * N)
        dT = np.where(
            stick[:, None],
            self.sticking[touch.slot, None] * touch.slipping,
            -(way * self.friction * hard)[:, None] * touch.opening,
        )
        force += T[:, None] * touch.sliding
        K += outer(touch.sliding, dT)
        K += np.where(touch.gap < -self.deep, 0.0, T)[:, None, None] * touch.swerving
        return Answer(energy, force, K, N, T, stick)

    def settle(self, touch: Touch, answer: Answer) -> bool:
        """Correct friction states and multipliers; return True if one of them was changed."""
        off = np.abs(touch.gap)[answer.normal > self.onset[touch.slot]].max(initial=0.0)
        crept = np.where(answer.sticking, np.abs(touch.slip), 0.0).max(initial=0.0)
        mended = self.friction > 0 and self._mend(touch, answer)
        if off >= self.allowed:
            self.normal, _ = self._placed(touch, answer)
        if crept >= self.allowed and not mended:
            _, self.tangential = self._placed(touch, answer)
        return mended or max(off, crept) >= self.allowed

    def _mend(self, touch: Touch, answer: Answer) -> bool:
        """Correct the friction states; return True if one of them was changed.

        The states of three kinds of points are corrected: points that stick with more than the
        friction limit, points that slide against their direction, and new points.
        """
        before = self.way[touch.slot]
        trial, limit = self._trial(touch), self.friction * answer.normal
        over = np.abs(trial) > limit * (1 + SLACK)
        free = np.where(over, np.sign(trial), STICKS)
        back = before * touch.slip < -SLACK * self.allowed
        slides = (before != 0) & (before != STICKS)
        found = np.where(slides, np.where(back, STICKS, before), free)
        self.way = np.zeros_like(self.way)
        self.way[touch.slot] = found
        return bool((found != before).any())

    def _trial(self, touch: Touch) -> Array:
        return self.tangential[touch.slot] + self.sticking[touch.slot] * touch.slip

    def accept(self, touch: Touch, answer: Answer) -> float:
        """Accept the step and return its friction work; later slip is measured from this state."""
        before = self.kept[1][touch.slot]
        slid = np.abs(self.kept[2][touch.slot]) == 1
        # places that begin to slide do so at the end's force: sticking was a small part of the slip
        mean = np.where(slid | answer.sticking, (answer.tangential + before) / 2, answer.tangential)
        work = float(mean @ touch.slip)
        _, self.tangential = self._placed(touch, answer)
        pressed = np.zeros(self.stiffness.size, bool)
        pressed[touch.slot] = True
        # a place that presses at rest has no direction yet: it sticks until it is pulled
        known = np.where((self.way == 0) & (self.friction > 0), STICKS, self.way)
        self.normal, self.way = np.where(pressed, [self.normal, known], 0.0)
        self.kept = self.normal, self.tangential, self.way
        return work

    def reject(self) -> None:
        self.normal, self.tangential, self.way = self.kept

    def _placed(self, touch: Touch, answer: Answer) -> tuple[Array, Array]:
        N, T = np.zeros((2, self.stiffness.size))
        N[touch.slot], T[touch.slot] = answer.normal, answer.tangential
        return N, T

    def _multiplied(self) -> Array:
        """Energy at zero gap due to the multipliers, subtracted from the energy of the contacts."""
        held = self.normal > 0
        return _energy(self.normal[held], self.onset[held]) / self.stiffness[held]


def _energy(z: Array, e: Array) -> Array:
    """Integral of the normal force over z."""
    return np.where(z < e, (z + e) ** 3 / (12 * e), z**2 / 2 + e**2 / 6)
