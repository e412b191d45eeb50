r"""Struts between two rigid hubs: exact shortenings and derivatives as functions of the motion.

The inner hub is at d with the rotation R; the outer hub is fixed. A strut acts along a unit vector
e at a point y of the inner hub, measured from its centre. If d changes to d + u and R to exp(w) R,
the shortening of the strut is, to second order,

.. math:: s(u, w) = s + e \cdot u + (y \times e) \cdot w + \tfrac12 (u, w) H (u, w)^T
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class State:
    """Shortenings (m,) of all struts, and first and second derivatives with respect to (u, w).

    u is the displacement of the inner hub, w a rotation vector.
    """

    s: Array
    J: Array  # (m, 6)
    H: Array | None  # (m, 6, 6), where requested


@dataclass(frozen=True, kw_only=True)
class Pinned:
    """Struts between the points `a` (m, 3) of the inner hub and `b` (m, 3) of the outer hub [m].

    In the reference state they are shortened by `s_0`, one value for each strut or for all struts.
    """

    a: Array
    b: Array
    s_0: Array | float = 0.0

    def __post_init__(self) -> None:
        if self.a.shape != self.b.shape or self.a.shape[1:] != (3,):
            raise ValueError(
                f"ends a and b must have the shape (m, 3), got {self.a.shape} and {self.b.shape}"
            )
        if (np.linalg.norm(self.a - self.b, axis=1) == 0).any():
            raise ValueError("the length of a strut must be above 0 m, but its ends coincide")

    def state(self, d: Array, R: Array, *, second: bool = True) -> State:
        y, at_first = self.a @ R.T, self.a - self.b
        shift = d + self.a @ (R - np.eye(3)).T
        across = at_first + shift
        length = np.linalg.norm(across, axis=1)
        e = -across / length[:, None]
        # a difference of lengths that keeps its digits
        grown = np.einsum("mi,mi->m", shift, at_first + across)
        s = np.asarray(self.s_0 - grown / (length + np.linalg.norm(at_first, axis=1)))
        if not second:
            return State(s, _gradient(e, y), None)
        moved = np.concatenate([np.broadcast_to(np.eye(3), (len(y), 3, 3)), -cross(y)], axis=2)
        plane = np.eye(3) - e[:, :, None] * e[:, None, :]
        bent = np.einsum("mia,mij,mjb->mab", moved, plane, moved) / length[:, None, None]
        return State(s, _gradient(e, y), _turned(e, y) - bent)


@dataclass(frozen=True, kw_only=True)
class Rolling:
    """Involute cams of the inner hub against flat faces of the outer hub.

    The normals of the cams are at the distance `lever` [m] from the axis z of the hub. Faces have
    normals along `angle` (m,) [rad] in the x-y plane and act at the heights `z` (m,) [m]. In the
    reference state, the position of a contact point relative to the axis has the component `reach`
    [m] along the normal, and the shortening is `s_0`.
    """

    angle: Array
    z: Array
    lever: float
    reach: float
    s_0: Array | float = 0.0

    def __post_init__(self) -> None:
        if self.angle.ndim != 1 or self.angle.shape != self.z.shape:
            raise ValueError(
                f"angle and z must have one value per cam, got the shapes {self.angle.shape} and "
                f"{self.z.shape}"
            )

    def state(self, d: Array, R: Array, *, second: bool = True) -> State:
        zero = np.zeros_like(self.angle)
        e = np.stack([np.cos(self.angle), np.sin(self.angle), zero], axis=1)
        shift = e @ (R - np.eye(3))
        seen = e + shift  # normals in the inner hub's frame
        flat = np.hypot(seen[:, 0], seen[:, 1])
        turned = np.arctan2(
            e[:, 0] * shift[:, 1] - e[:, 1] * shift[:, 0],
            e[:, 0] * seen[:, 0] + e[:, 1] * seen[:, 1],
        )
        p = self.reach - self.lever * turned  # support function: p' = -lever, p'' = 0
        normal = np.stack([seen[:, 0] / flat, seen[:, 1] / flat, zero], axis=1)
        tangent = np.stack([-normal[:, 1], normal[:, 0], zero], axis=1)
        touch = p[:, None] * normal - self.lever * tangent
        touch[:, 2] = self.z
        y, t = touch @ R.T, tangent @ R.T
        # flat p - reach, without the digits that cancel: flat^2 = 1 - seen_z^2
        sunk = -self.lever * turned - p * seen[:, 2] ** 2 / (1 + flat)
        s = np.asarray(self.s_0 + e @ d + sunk + self.z * seen[:, 2])
        if not second:
            return State(s, _gradient(e, y), None)
        H = _turned(e, y)
        lean = np.cross(e, t)
        H[:, 3:, 3:] += (p / flat)[:, None, None] * lean[:, :, None] * lean[:, None, :]
        return State(s, _gradient(e, y), H)


def cross(v: Array) -> Array:
    """Matrices (m, 3, 3) of the cross product v x, for v (m, 3)."""
    M = np.zeros((len(v), 3, 3))
    M[:, 0, 1], M[:, 0, 2], M[:, 1, 2] = -v[:, 2], v[:, 1], -v[:, 0]
    return M - M.transpose(0, 2, 1)


def _gradient(e: Array, y: Array) -> Array:
    return np.concatenate([e, np.cross(y, e)], axis=1)


def _turned(e: Array, y: Array) -> Array:
    """Second derivatives (m, 6, 6) of e . y with respect to a rotation w of y: e . w x (w x y)."""
    H = np.zeros((len(e), 6, 6))
    ey = e[:, :, None] * y[:, None, :]
    inner = np.einsum("mi,mi->m", e, y)
    H[:, 3:, 3:] = (ey + ey.transpose(0, 2, 1)) / 2 - inner[:, None, None] * np.eye(3)
    return H
