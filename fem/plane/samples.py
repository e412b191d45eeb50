"""Displacements and stresses of a plane solution at points, with integration weights."""

from dataclasses import dataclass

import numpy as np

from fem.plane.discretisation import Array


@dataclass(frozen=True)
class Samples:
    """Values at quadrature points: `x`, `u` (2, m), `stress` (4, m) and `weight` (m,).

    Stress rows are xx, yy, xy, zz; the last row is the hoop stress of a body of revolution.
    `normal` (2, m) is the outward normal on outer boundaries, otherwise empty. The sum of the
    weights is the area of the cells or the length of the boundary; for a body of revolution, it is
    the volume of the cells or the area of the boundary.
    """

    x: Array
    u: Array
    stress: Array
    weight: Array
    normal: Array

    def mean(self, values: Array) -> float:
        """Mean of `values` (m,) over the cells or the boundary."""
        return float(self.weight @ values / self.weight.sum())

    def traction(self) -> Array:
        """Traction sigma . n (2, m) on a boundary."""
        xx, yy, xy, _ = self.stress
        n_x, n_y = self.normal
        return np.array([xx * n_x + xy * n_y, xy * n_x + yy * n_y])

    def polar(self, centre: tuple[float, float] = (0.0, 0.0)) -> tuple[Array, Array, Array, Array]:
        """Radial displacement, and radial, hoop and shear stress, each (m,), about `centre`."""
        d = self.x - np.reshape(centre, (2, 1))
        c, s = d / np.hypot(*d)
        xx, yy, xy, _ = self.stress
        radial = xx * c * c + yy * s * s + 2 * xy * s * c
        hoop = xx * s * s + yy * c * c - 2 * xy * s * c
        shear = (yy - xx) * s * c + xy * (c * c - s * s)
        return self.u[0] * c + self.u[1] * s, radial, hoop, shear
