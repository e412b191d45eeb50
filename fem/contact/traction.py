"""Tractions on a contact surface, calculated from the stresses of the body."""

import numpy as np
from scipy.sparse import csr_array

from fem.contact.bodies import Bodies
from fem.contact.pairing import Points
from fem.contact.trace import Trace
from fem.plane.discretisation import Array
from fem.plane.geometry import shapes


def traction_rows(bodies: Bodies, slave: Trace, points: Points, direction: Array) -> csr_array:
    """Rows (m, unknowns) of -direction . sigma(u) n_1 [stress] at the slave's `points`.

    n_1 is the outward normal of the facets, `direction` (2, m) are unit vectors. For the direction
    of contact, the result is the pressure. The stress is that of the cell behind each point.
    """
    basis, cells = bodies.basis, slave.cells[points.slave]
    X = _cell_points(bodies, slave, points)
    nodes = basis.mesh.doflocs[:, np.asarray(basis.mesh.dofs.element_dofs)[:, cells]]
    edges = np.einsum("inm,jnm->mij", nodes - nodes[:, :1], shapes(basis.mesh.elem(), X)[1])
    N, slope = shapes(basis.elem.elem, X)
    slope = np.einsum("jnm,mji->inm", slope, np.linalg.inv(edges))
    tangent = slave.tangents(points.slave, points.s)
    n = np.array([tangent[1], -tangent[0]]) / np.hypot(*tangent)
    lam, mu, along = bodies.lam[cells], bodies.mu[cells], (direction * n).sum(axis=0)
    # direction . (lambda div u I + mu (grad u + grad u')) n for u = N in direction i
    stress = lam * along * slope
    stress += mu * np.einsum("im,jnm,jm->inm", direction, slope, n)
    stress += mu * np.einsum("im,jnm,jm->inm", n, slope, direction)
    if bodies.turn:
        stress[0] += lam * along * N / slave.places(points.slave, points.s)[0]
    dofs = np.asarray(basis.element_dofs)[:, cells].reshape(len(N), 2, -1).swapaxes(0, 1)
    rows = np.broadcast_to(np.arange(cells.size), dofs.shape)
    at = rows.ravel(), dofs.ravel()
    return csr_array((-stress.ravel(), at), (cells.size, bodies.count))


def _cell_points(bodies: Bodies, slave: Trace, points: Points) -> Array:
    """Positions (2, m) of the points in their reference cells."""
    mesh, k = bodies.basis.mesh, points.slave
    corners, reference = mesh.t[:, slave.cells[k]], mesh.elem.refdom.p
    a, b = (reference[:, np.argmax(corners == end, axis=0)] for end in slave.ends[:, k])
    return np.asarray(a * (1 - points.s) + b * points.s)
