"""States of a strut through its stroke, interpolation between them, and widths of its contacts."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from fem.wedge.course import Course

if TYPE_CHECKING:
    from fem.contact.solution import Touch

Array = NDArray[np.float64]


class Stroke(Course):
    """States of z struts with total torque T [N m]; N [N] and total deflection H [m] of one strut.

    `U` [J] is the energy of one pitch; splines over ln N interpolate between the states.
    """

    z: int

    def turn_by_energy(self, T: Array) -> Array:
        """Relative rotation of the races [rad] up to torques T [N m]: the integral of n_s dU/T."""
        U, z = self.logarithm("U", "T"), self.z
        return self.integral(lambda t: z * np.exp(U(t) - t) * U(t, 1), "T", np.log(T))

    def work(self, N: Array) -> Array:
        """Work [J] of one strut up to normal forces N [N]: the integral of N dH."""
        H = self.logarithm("H", "N")
        return self.integral(lambda t: np.exp(H(t) + t) * H(t, 1), "N", np.log(N))


def half_width(touch: "Touch") -> float:
    """Half-width [m] of an elliptic pressure with the same mean distance from its centre.

    That of the squares is twice as sensitive to the position of the contact edge in a cell.
    """
    load = touch.p * touch.weight
    return float(3 * math.pi / 4 * (load @ np.abs(touch.along())) / load.sum())
