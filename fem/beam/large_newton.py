"""Newton's method for a geometrically exact frame with one load factor.

The geometric stiffness uses the section forces predicted by the last iteration, not the section
forces of the new displacements (mixed integration points, Magisano, Leonetti & Garcea 2017). The
solution is the same, but larger steps converge if the frame has stiff members, whose axial force is
sensitive to finite rotations.
"""

import math
from typing import Protocol

from fem.beam.large_balance import Balance, ConvergenceError, Response
from fem.beam.large_elements import Extended
from fem.beam.large_state import BeamState
from fem.beam.section import Array

TOLERANCE = 1e-10  # residual, relative to the forces between nodes and elements
ROUND_OFF = 1e-7  # residual that is accepted if steps are round-off
FLICKER = 1e-8  # residual that is accepted if points alternate between open and closed
STALL = 4  # iterations without progress
STILL = 1e-14  # a step that is round-off, relative to the size of the frame
MAX_ITERATIONS = 25
MAX_SETTLEMENTS = 40
MAX_TURN = 1.5  # rotation in one iteration [rad] beyond which the tangent is not valid


class Control(Protocol):
    """Condition besides equilibrium: a given load factor, or a given arc length.

    `kink` is the permitted squared deviation of a step from its prediction, relative to the squared
    length of the prediction. It applies if the frame has additional terms, which can have kinks.
    """

    kink: float

    def correct(self, moved: Array, step: Array, push: Array) -> float:
        """Change of the load factor in an iteration; all arrays have the shape (3n,).

        `moved` is the displacement since the start of the step, `step` the next displacement at
        constant factor, and `push` the displacement per unit factor.
        """
        ...

    def speed(self, push: Array, moved: Array) -> float:
        """Change of the load factor in a step of full size along the tangent `push`.

        `push` is the displacement per unit factor. In arc-length control, the change has the sign
        for which the step leads in the direction of the displacement `moved`.
        """
        ...


def equilibrium(
    balance: Balance, start: BeamState, step: Array, change: float, stress: Array, control: Control
) -> tuple[Extended, float, Response, tuple[float, ...]]:
    """Displacements, factor and response in equilibrium, and the residuals of the iterations.

    The iteration begins with the predicted `step` and `change` of the factor. Raises
    ConvergenceError if it does not converge.
    """
    u, factor = start.exact + step.reshape(-1, 3), start.factor + change
    history: list[float] = []
    noise = balance.elements.noise * balance.length
    settlements, since, last = 0, 0, MAX_ITERATIONS
    while len(history) < last:
        found = balance.respond(u, factor, stress)
        size = balance.measure(found.residual.reshape(-1, 3))
        history.append(size / found.size if found.size else 0.0)
        still = _moved(balance, step) < STILL and size < max(ROUND_OFF * found.size, noise)
        if history[-1] < TOLERANCE or still or (balance.terms and _stalled(history[since:])):
            if not _unsettled(balance, u):
                return u, factor, found, tuple(history)
            settlements, last = settlements + 1, len(history) + MAX_ITERATIONS
            since = len(history)
            if settlements > MAX_SETTLEMENTS:
                raise ConvergenceError(
                    f"the contact terms do not converge in {MAX_SETTLEMENTS} corrections"
                )
            found = balance.respond(u, factor)
        if not math.isfinite(history[-1]):
            break
        tangent = balance.factorise(u, found.K)
        step = tangent.solve(found.residual)
        more = control.correct((u - start.exact).astype(float).ravel(), step, tangent.push)
        step = step + more * tangent.push
        if not float(abs(step[2::3]).max()) < MAX_TURN:
            break
        stress = found.predict(step)
        u, factor = u + step.reshape(-1, 3), factor + more
    tried = len(history)
    raise ConvergenceError(f"the relative residual is {history[-1]:.1e} after {tried} iterations")


def _unsettled(balance: Balance, u: Extended) -> bool:
    asked = [term.settle(balance.positions(u)) for term in balance.terms]  # every one of them
    return any(asked)


def _stalled(history: list[float]) -> bool:
    """True if a small residual no longer decreases, for example if points touch without force."""
    before, late = history[:-STALL], history[-STALL:]
    return bool(before) and history[-1] < FLICKER and min(late) > min(before) / 2


def _moved(balance: Balance, step: Array) -> float:
    x, y, turn = abs(step).reshape(-1, 3).max(axis=0)
    return max(float(max(x, y)) / balance.length, float(turn))
