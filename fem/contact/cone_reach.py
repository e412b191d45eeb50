"""Test whether contact forces within their friction cones can balance loads on rigid bodies.

In this test, pressures may have any non-negative values. Loads that cannot be balanced have no
equilibrium; this is a proof. Loads that can be balanced may also have no equilibrium, if elasticity
does not give the necessary pressures.
"""

import numpy as np
from scipy.optimize import nnls

from fem.contact.cone import Cone
from fem.plane.discretisation import Array

UNHELD = 1e-9  # relative to the loads: smaller differences are allowed
BARE = 1e-12  # relative to the largest: forces that act on no rigid motion
MAX_ROUNDS = 60


def missing(cone: Cone, e: Array) -> Array:
    """Part of the loads `e` (k,) on rigid motions and shifts that no contact forces can balance.

    The result is zero if all loads can be balanced. Contact forces are sums of forces along
    edges of the cones. An edge is added as long as the unbalanced loads have a component along it.
    """
    if not np.any(e):
        return np.zeros_like(e)
    m, r = cone.friction.size, cone.rough.size
    normal, across = cone.D[:m], cone.friction[cone.rough, None]
    t, z = across * cone.D[m : m + r], across * cone.D[m + r :]
    scale = np.sqrt((cone.D**2).sum(axis=0))  # shifts and turns, forces and moments
    scale = 1 / np.where(scale > 0, scale, 1.0)
    goal = -scale * e
    smooth = np.setdiff1d(np.arange(m), cone.rough)
    edges = [normal[smooth], normal[cone.rough] + t, normal[cone.rough] - t]
    edges += [normal[cone.rough] + z, normal[cone.rough] - z]
    cone_edges = np.vstack(edges) * scale
    size = np.hypot.reduce(cone_edges, axis=1)
    cone_edges = cone_edges[size > BARE * size.max(initial=0.0)]
    missed = goal
    for _ in range(MAX_ROUNDS):
        unit = cone_edges / np.hypot.reduce(cone_edges, axis=1)[:, None]
        share, _ = nnls(unit.T, goal, maxiter=100 * len(unit))
        missed = goal - unit.T @ share
        if np.linalg.norm(missed) <= UNHELD * np.linalg.norm(goal):
            return np.zeros_like(e)
        pull = np.array([(t * scale) @ missed, (z * scale) @ missed])
        length = np.hypot(*pull)
        d = pull / np.where(length > 0, length, 1.0)
        new = (normal[cone.rough] + d[0][:, None] * t + d[1][:, None] * z) * scale
        gain = new @ missed / np.maximum(np.hypot.reduce(new, axis=1), 1e-300)
        chosen = gain > UNHELD * np.linalg.norm(missed)
        if not np.any(chosen):
            break
        cone_edges = np.vstack([unit[share > 0], new[chosen]])
    return -missed / scale
