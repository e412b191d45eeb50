"""Free vibration of a rotor at a given speed."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.rotor.blocks import Complex
from fem.rotor.branches import branches, check_count, check_speeds, damping_ratios
from fem.rotor.elements import Array
from fem.rotor.model import Rotor
from fem.rotor.parts import UNKNOWNS

SAME_SIZE = 1e-9  # over the largest: equal displacements of a symmetric shape differ by round-off


@dataclass(frozen=True)
class Modes:
    """Modes by ascending frequency: eigenvalues lambda (k,) and mode shapes (k, nodes, 6).

    The motion is proportional to e^(lambda t). `whirl` (k,) is 1 for forward whirl, in the sense of
    a positive speed, -1 for backward whirl, and 0 for motion in a line (or only torsion or axial
    motion).
    """

    eigenvalues: Complex
    shapes: Complex
    whirl: NDArray[np.int64]

    @property
    def frequencies(self) -> Array:
        """Damped natural frequencies Im lambda (k,) [rad/s]."""
        return np.asarray(self.eigenvalues.imag)

    @property
    def damping(self) -> Array:
        """Damping ratios -Re lambda/|lambda| (k,); negative for a growing motion."""
        return damping_ratios(self.eigenvalues)


def modes(rotor: Rotor, speed: float = 0.0, count: int = 6, plane: str = "bending") -> Modes:
    """Modes with the `count` lowest frequencies at `speed` [rad/s].

    `plane` is "bending", "torsion", "axial" or "all"; motions that a link couples to these are
    included. The largest displacement of a shape is 1 (or its largest rotation, if it has no
    displacement). Inner nodes of refined elements follow the numbered nodes. The rigid motions of a
    rotor without supports are modes of frequency zero.
    """
    found = branches(rotor, check_speeds(speed), check_count(count), plane)
    values = np.concatenate([b.values[0] for b in found])
    shapes = np.concatenate([b.shapes[0] for b in found])
    order = np.argsort(values.imag, kind="stable")[:count]
    return Modes(
        values[order],
        normalised(shapes[order]),
        np.concatenate([b.sense[0] for b in found])[order],
    )


def normalised(shapes: Complex) -> Complex:
    """Shapes (k, nodes, 6) from shapes (k, n), scaled so that the largest displacement is 1.

    The phase is chosen so that this displacement is real. A shape with rotations only is scaled by
    its largest rotation.
    """
    nodes = shapes.reshape(shapes.shape[0], -1, UNKNOWNS)
    moved = nodes[:, :, :3].reshape(len(nodes), -1)
    turned = nodes[:, :, 3:].reshape(len(nodes), -1)
    still = abs(moved).max(axis=1) <= 1e-9 * abs(turned).max(axis=1)
    chosen = np.where(still[:, None], turned, moved)
    size = abs(chosen)
    first = (size >= (1 - SAME_SIZE) * size.max(axis=1, keepdims=True)).argmax(axis=1)
    largest = np.take_along_axis(chosen, first[:, None], axis=1)
    return np.asarray(nodes / largest[:, :, None])
