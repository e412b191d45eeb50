"""Arc-length control, which passes limit points and snap-backs of an equilibrium path.

The arc length of a step is the root mean square of the displacements (divided by the size of the
frame) and rotations of all nodes. The load factor is not included (Crisfield's cylinder). The
equation of the arc length is linearised in each iteration (Ramm, Wriggers & Simo); therefore, no
choice between two roots is necessary. If the direction of a step differs by more than 60° from the
tangent (90° if the frame has additional terms, which can have kinks), the step is repeated with a
smaller size.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from fem.beam.large_balance import ConvergenceError
from fem.beam.large_march import HALVINGS, March
from fem.beam.large_state import BeamState
from fem.beam.section import Array

ITERATIONS = 7  # that steps are sized for
CROSSING = 1 / 32  # over the longest step: longer ones may jump over a turn to another branch


@dataclass(frozen=True)
class Arc:
    """Step control by arc length: the displacement in each step has the norm `size`.

    `weights` (3n,) are the weights of the squared displacements in the squared norm.
    """

    size: float
    weights: Array
    kink = 2.0  # a right angle

    def correct(self, moved: Array, step: Array, push: Array) -> float:
        along = self.weights * moved
        excess = (float(along @ moved) - self.size**2) / 2
        return -(excess + float(along @ step)) / float(along @ push)

    def speed(self, push: Array, moved: Array) -> float:
        along = self.weights * push
        return math.copysign(self.size / math.sqrt(float(along @ push)), float(along @ moved))


def follow(march: March, first: float, largest: float) -> Iterator[BeamState]:
    """States along the equilibrium path, by arc-length control.

    The change `first` of the load factor defines the direction and the size of the first step.
    Step sizes increase up to `largest`, an arc length. Raises ArithmeticError if a step does not
    converge.
    """
    weights = march.balance.weights
    push = march.tangent.push
    start = size = abs(first) * math.sqrt(float(weights * push @ push))
    if not start > 0:
        raise ValueError(
            "along_arc needs loads or displacements that move the frame, and a first step "
            "`first` that is not zero"
        )
    heading, longest = math.copysign(1.0, first) * push, start
    while True:
        before = march.state
        arc = Arc(size, weights)
        try:
            speed = arc.speed(march.tangent.push, heading)
            march.step(speed, arc, crossing=size < CROSSING * longest)
        except ConvergenceError as error:
            size /= 2
            if size < start / 2**HALVINGS:
                raise ArithmeticError(
                    f"no equilibrium was found along the arc beyond factor {before.factor:.6g}: "
                    f"{error}, with steps down to {2 * size / start:.1e} of the first step"
                ) from error
            continue
        longest = max(longest, size)
        heading = (march.state.exact - before.exact).astype(float).ravel()
        yield march.state
        ease = ITERATIONS / len(march.state.residuals)
        size = min(size * float(np.clip(ease, 0.5, 2.0)), max(largest, start))


def collect(
    states: Iterator[BeamState], steps: int, until: Callable[[BeamState], bool] | None
) -> tuple[BeamState, ...]:
    """The first `steps` states, or all states up to the first for which `until` is True."""
    found: list[BeamState] = []
    for state in states:
        found.append(state)
        if until is not None and until(state):
            return tuple(found)
        if len(found) == steps:
            break
    if until is not None:
        raise ArithmeticError(
            f"`until` was True for none of {steps} states; the last state is at the factor "
            f"{found[-1].factor:.6g}: increase steps"
        )
    return tuple(found)
