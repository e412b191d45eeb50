"""Equilibrium of a wedged body that does not move from its position in the mesh.

Adjacent surfaces are rotated until the body is at rest in this position.

In the theory of small displacements, forces act at the positions of the nodes in the mesh. If a
body moved or rotated until friction stopped it, its contacts would not be at these positions.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from fem.contact.errors import NotFoundError

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]
Drags = tuple[float, float]  # m, tangential displacements of inner and outer surface

STILL = 1e-5  # of both overlaps: allowed movement of a body
CORE = 0.05  # relative to a body's size: where its motion is read


class Solved(Protocol):
    """State of bodies in contact."""

    @property
    def solution(self) -> "ContactSolution": ...


S = TypeVar("S", bound=Solved)


class Touching:
    """State of a body with an inner and an outer contact, evaluated from its `solution`."""

    solution: "ContactSolution"

    @property
    def widths(self) -> tuple[float, float]:
        """Half-widths of both contacts [m], from the moments of the pressure."""
        inner, outer = self.solution.touches
        return inner.half_width(), outer.half_width()

    @property
    def peaks(self) -> tuple[float, float]:
        """Largest pressures [Pa] of both contacts."""
        inner, outer = self.solution.touches
        return inner.peak, outer.peak


class Unrest(NamedTuple):
    """Displacement `moves` [m] of a body, and the total overlap `size` [m] of its contacts.

    `drags` [m] are the corrected tangential displacements of the adjacent surfaces.
    """

    moves: float
    size: float
    drags: Drags


def at_rest(
    at: Callable[[Drags], S], drags: Drags, unrest: Callable[[S], Unrest], *, body: str,
    most: int, still: float | None = None,
) -> S:  # fmt: skip
    """First state in which the `body` moves by at most `still` times the total overlap.

    `at` solves with surfaces displaced by `drags`; each correction compensates the motion of the
    body. Raises NotFoundError if the body does not come to rest in `most` steps.
    """
    limit = STILL if still is None else still
    for _ in range(most):
        state = at(drags)
        moves, size, drags = unrest(state)
        if moves <= limit * size:
            return state
    slips = ", and every node of a contact slips" if state.solution.slides else ""
    raise NotFoundError(
        f"no equilibrium was found: the {body} still moves by {moves:.1e} m after {most} "
        f"steps{slips}"
    )


def core_motion(
    solution: "ContactSolution", centre: tuple[float, float], size: float
) -> tuple[Array, float]:
    """Displacements (2, 4) [m] of four points of a body, and rotation [rad] about `centre`.

    The points are to the right, to the left, above and below the centre, at the distance CORE x
    `size` [m]. The rotation is positive anticlockwise.
    """
    near = CORE * size
    points = np.array([[centre[0]], [centre[1]]]) + near * np.array([[1, -1, 0, 0], [0, 0, 1, -1]])
    u = solution.plane.at(points).u
    right, left, up, down = u.T
    return u, float((right[1] - left[1] - up[0] + down[0]) / (4 * near))
