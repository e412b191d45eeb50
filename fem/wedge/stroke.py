"""States of a strut through its stroke, with interpolation, and half-widths of its contacts."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from fem.wedge.course import Course

if TYPE_CHECKING:
    from fem.contact.solution import Touch

Array = NDArray[np.float64]


class Stroke(Course):
    """States of z struts, with normal force N [N] and total deflection H [m] of one strut.

    T [N m] is the total torque, `U` [J] the energy of one pitch. Splines over ln N interpolate
    between the states.
    """

    z: int

    def turn_by_energy(self, T: Array) -> Array:
        """Wind-up of the races [rad] at the torques T [N m]: the integral of z dU/T."""
        U, z = self.logarithm("U", "T"), self.z
        return self.integral(lambda t: z * np.exp(U(t) - t) * U(t, 1), "T", np.log(T))

    def work(self, N: Array) -> Array:
        """Work [J] of one strut up to the normal forces N [N]: the integral of N dH."""
        H = self.logarithm("H", "N")
        return self.integral(lambda t: np.exp(H(t) + t) * H(t, 1), "N", np.log(N))


def half_width(touch: "Touch") -> float:
    """Half-width [m] of a contact, from the mean distance of its pressure from the centre.

    It is the half-width of the elliptic pressure that has the same mean distance, weighted with the
    pressure. A half-width from squared distances would be twice as sensitive to the position of the
    contact edge in a cell.
    """
    load = touch.p * touch.weight
    return float(3 * math.pi / 4 * (load @ np.abs(touch.along())) / load.sum())
