"""Rigid motions of the plane: rotations about the origin, then shifts."""

import cmath
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Place = TypeVar("Place", complex, NDArray[np.complex128])


@dataclass(frozen=True)
class Move:
    """Rotation by `angle` [rad], then a `shift` [length]; positions and shifts are x + iy."""

    angle: float = 0.0
    shift: complex = 0.0

    @classmethod
    def about(cls, centre: complex, angle: float, shift: complex = 0.0) -> "Move":
        """Rotation about `centre`, then a `shift`."""
        return cls(angle, centre + shift - cmath.rect(1, angle) * centre)

    def of(self, place: Place) -> Place:
        """Position of a point at `place` after the motion."""
        return cmath.rect(1, self.angle) * place + self.shift

    def after(self, first: "Move") -> "Move":
        """Combined motion: the `first` motion, then this motion."""
        return Move(self.angle + first.angle, self.of(first.shift))

    @property
    def back(self) -> "Move":
        return Move(-self.angle, -cmath.rect(1, -self.angle) * self.shift)
