"""Tangential load paths of two bodies under constant normal load: first loading, and a cycle."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import cumulative_trapezoid

from fem.contact.driven_discs import DrivenDiscs
from fem.contact.partial_slip import smoothed, stick_share
from fem.contact.solution import ContactSolution
from fem.plane.discretisation import Array

Value = tuple[float, float]  # and its standard uncertainty, from the slip of single nodes


@dataclass(frozen=True)
class Push:
    """First tangential loading under constant normal load; all arrays are (n,).

    `k` is Q/(mu P), `stick` the squared ratio (c/a)² of the stick zone, `x` are displacements [m].
    """

    k: Array
    stick: Array
    x: Array

    def stick_half_width(self, share: float, a: float) -> Value:
        """Half-width [m] of the stick zone at Q/(mu P) = `share`, and its standard uncertainty."""
        c2, u, _ = smoothed(self.k, self.stick, share)
        c = a * np.sqrt(c2)
        return float(c), float(u * c / (2 * c2))

    def growth(self, shares: Array) -> Array:
        """Ratios c/a at the values `shares` (m,) of Q/(mu P)."""
        return np.sqrt([smoothed(self.k, self.stick, share)[0] for share in shares])

    def beyond_chord(self, share: float, chord: float) -> Value:
        """Displacement [m] at `share`, minus the value on the chord of the curve from 0 to `chord`.

        `share` and `chord` are values of Q/(mu P). The second result is the standard uncertainty.
        """
        far, u_far, _ = smoothed(self.k, self.x, chord)
        x, u, _ = smoothed(self.k, self.x, share)
        part = share / chord
        return x - part * far, float(np.hypot(u, part * u_far))

    def loop_jitter(self, share: float) -> float:
        """Scatter [m] of (loop area)/(mu P), for a loop up to Q/(mu P) = `share`.

        By Masing's rule, each branch of a cycle is the first loading curve, enlarged by a factor of
        2.
        """
        area = 8 * cumulative_trapezoid(self.k, self.x, initial=0.0) - 4 * self.k * self.x
        return smoothed(self.k, area, share)[2]


def push(discs: DrivenDiscs, to: float, *, limit: float, steps: int) -> Push:
    """First loading in equal steps to a displacement `to` [m]; `limit` is mu P [N/m]."""
    state, cut = discs.pressed
    found = []
    for x in np.linspace(0.0, to, steps + 1)[1:]:
        state = discs.at(np.array([x, cut[1]]), state)
        touch = state.touches[0]
        found.append((touch.friction_force / limit, stick_share(touch), x))
    return Push(*np.array(found).T)


@dataclass(frozen=True)
class Swing:
    """Cycle from a state to the opposite state and back: x [m] and Q [N/m] of each step (2n + 1,).

    `work` [J/m] is the work of friction; `opposite` and `last` are the states in the middle and at
    the end.
    """

    x: Array
    Q: Array
    work: float
    opposite: ContactSolution
    last: ContactSolution

    @property
    def half(self) -> tuple[Array, Array]:
        """Displacements x and forces Q of the first half of the cycle, (n + 1,)."""
        n = self.x.size // 2 + 1
        return self.x[:n], self.Q[:n]


def swing(discs: DrivenDiscs, first: ContactSolution, top: Array, Q: float, steps: int) -> Swing:
    """Cycle that begins in the state `first`, with the force Q [N/m] and displacement `top` [m].

    `top` has the components x and y and belongs to the upper section.
    """
    there = np.linspace(1.0, -1.0, steps + 1)[1:]
    state, work, found = first, 0.0, [(top[0], Q)]
    opposite = first
    for x in top[0] * np.concatenate([there, -there]):
        state = discs.at(np.array([x, top[1]]), state)
        touch = state.touches[0]
        work += float(np.abs(touch.traction * touch.slip) @ touch.mortar.size)
        found.append((x, touch.friction_force))
        if len(found) == steps + 1:
            opposite = state
    x, force = np.array(found).T
    return Swing(x, force, work, opposite, state)
