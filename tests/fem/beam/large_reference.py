"""Independent references of large displacement: elliptic integrals, and shooting.

Shooting integrates Reissner's ordinary differential equations with an error-controlled method.
"""

from math import cos, sin, sqrt

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, root
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc


def cantilever(force, angle):
    """Tip (x, y) and rotation of a cantilever of length 1 and EI = 1 along x; inextensible.

    The dead end force makes `angle` with x, between 0 and 180 deg. With omega = angle - theta,
    cos(omega / 2) = k sin(phi), the equation EI theta'' = -force sin(omega) becomes
    phi' = sqrt(force) sqrt(1 - k^2 sin^2 phi), with phi = pi/2 at the tip.
    """
    a, start = sqrt(force), cos(angle / 2)

    def length(k):
        return ellipk(k * k) - ellipkinc(np.arcsin(min(start / k, 1.0)), k * k) - a

    k = brentq(length, start * (1 + 1e-15), 1 - 1e-14, xtol=1e-15)
    phi = np.arcsin(start / k)
    along = a - 2 * (ellipe(k * k) - ellipeinc(phi, k * k))
    across = 2 * k * cos(phi)
    tip = np.array([cos(angle), sin(angle)]) * along + np.array([sin(angle), -cos(angle)]) * across
    return *(tip / a), angle - 2 * np.arccos(k)


def integrate(pieces, start, force, loads, section):
    """End (x, y, rotation, M) and internal force of a chain of members by Reissner's equations.

    `pieces` are (length, heading): a function of the arc length, along the member; `start` is
    (x, y, rotation, M) and `force` the internal force at the first section; loads[i] acts
    between piece i and the next. Also the state at each joint.
    """
    state, force, joints = np.asarray(start, float), np.asarray(force, float), []
    for i, (length, heading) in enumerate(pieces):

        def rate(s, y, heading=heading, force=force):
            theta = heading(s) + y[2]
            c, d = cos(theta), sin(theta)
            N, V = force[0] * c + force[1] * d, -force[0] * d + force[1] * c
            e, g = 1 + N / section.EA, V / section.GA
            dx, dy = e * c - g * d, e * d + g * c
            return [dx, dy, y[3] / section.EI, dy * force[0] - dx * force[1]]

        state = solve_ivp(rate, (0, length), state, method="DOP853", rtol=1e-11, atol=1e-12).y[
            :, -1
        ]
        joints.append(state)
        if i < len(loads):
            force = force - np.asarray(loads[i], float)
    return state, force, joints


def shoot(residual, guess):
    """Root of `residual`, to round-off."""
    found = root(residual, guess, method="hybr", tol=1e-12)
    assert np.linalg.norm(found.fun) < 1e-8 * (1 + np.linalg.norm(guess)), found.message
    return found.x
