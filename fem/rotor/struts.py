r"""Two rigid hubs joined by nonlinear struts, with exact kinematics of finite rotations.

Each strut transmits F(s). Its shortening s is a function of the positions of the hubs only:

- `Pinned`: both ends are fixed in the hubs, :math:`s = s_0 + l_0 - |d + R a - b|`;
- `Rolling`: a face on the outer hub, and a cam on the inner hub in a plane normal to its axis; the
  contact point moves as the hub rotates. The cam is an involute: its normal has a constant distance
  from the axis of the hub, nearly as for a logarithmic spiral.

J and H are the first and second derivatives of the shortenings. The loads are :math:`\sum F J`, and
the tangent stiffness is :math:`\sum F' J J^T + F H`.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from fem.rotor.struts_kinds import Pinned, Rolling, cross

Array = NDArray[np.float64]
Law = Callable[[Array], tuple[Array, Array]]
LARGEST_TURN = 0.1  # rad of one step
STEPS = 100
HALVINGS = 40


def power_law(k: Array | float, n: float) -> Law:
    """Function that returns F = k <s>^n and its derivative.

    `k` [N/m^n] is one value for each strut, or a single value for all struts.
    """

    def law(s: Array) -> tuple[Array, Array]:
        pressed = np.where(s > 0, s, 1.0)
        force = np.where(s > 0, k * pressed**n, 0.0)
        return force, np.where(s > 0, k * n * pressed ** (n - 1), 0.0)

    return law


@dataclass(frozen=True, kw_only=True)
class Joint:
    """Hubs joined by `struts` with the `law`; the inner hub is at d (3,) [m], rotated by R (3, 3).

    Loads and moments (6,) act on the inner hub at its centre.
    """

    struts: Pinned | Rolling
    law: Law
    d: Array
    R: Array

    @classmethod
    def at_rest(cls, struts: Pinned | Rolling, law: Law) -> "Joint":
        """Joint in its reference state."""
        return cls(struts=struts, law=law, d=np.zeros(3), R=np.eye(3))

    def moved(self, step: Array) -> "Joint":
        """Joint after a displacement and a rotation vector `step` (6,) [m, rad]."""
        return replace(self, d=self.d + step[:3], R=rotation(step[3:]) @ self.R)

    def forces(self) -> Array:
        """Forces (m,) [N] of the struts."""
        return self.law(self.struts.state(self.d, self.R, second=False).s)[0]

    def loads(self) -> Array:
        """Force and moment (6,) [N, N m] that hold the inner hub."""
        state = self.struts.state(self.d, self.R, second=False)
        return np.asarray(self.law(state.s)[0] @ state.J)

    def tangent(self) -> Array:
        """Tangent stiffness (6, 6): exact, symmetric derivatives of the loads."""
        state = self.struts.state(self.d, self.R)
        assert state.H is not None
        force, slope = self.law(state.s)
        K = np.einsum("m,ma,mb->ab", slope, state.J, state.J)
        return np.asarray(K + np.einsum("m,mab->ab", force, state.H))

    def under(self, loads: Array, free: tuple[int, ...], *, tolerance: float = 1e-12) -> "Joint":
        """Joint moved in the components `free` until it is in equilibrium with `loads` (6,).

        All other components of displacement and rotation are fixed. The method is Newton's; steps
        are halved until the residual decreases. `tolerance` is relative to the largest load, with
        moments divided by the size of the inner hub.

        Raises
        ------
        ArithmeticError
            If no equilibrium is found.
        """
        now, at = self, list(free)
        levers = self.struts.state(self.d, self.R, second=False).J[:, 3:]
        size = np.repeat([1.0, np.abs(levers).max()], 3)[at]
        bound = tolerance * np.abs(loads[at] / size).max()
        for _ in range(STEPS):
            off = (now.loads()[at] - loads[at]) / size
            if np.abs(off).max() <= bound:
                return now
            K = now.tangent()[np.ix_(at, at)] / np.outer(size, size)
            step = np.zeros(6)
            step[at] = -np.linalg.lstsq(K, off, rcond=1e-13)[0] / size
            step *= min(1.0, LARGEST_TURN / max(np.abs(step[3:]).max(), 1e-300))
            for _ in range(HALVINGS):
                tried = now.moved(step)
                if np.linalg.norm((tried.loads()[at] - loads[at]) / size) < np.linalg.norm(off):
                    break
                step /= 2
            else:
                break
            now = tried
        raise ArithmeticError(
            f"no equilibrium of the struts was found under the loads {loads[at]} N, N m"
        )


def rotation(w: Array) -> Array:
    """Rotation matrix (3, 3) of the rotation vector w (3,) [rad] (Rodrigues)."""
    angle = float(np.linalg.norm(w))
    W = cross(w[None])[0]
    # sin(a)/a and (1 - cos a)/a^2, which have limits
    return np.asarray(
        np.eye(3) + np.sinc(angle / np.pi) * W + 0.5 * np.sinc(angle / 2 / np.pi) ** 2 * W @ W
    )
