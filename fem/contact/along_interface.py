"""All contact pairs with friction as one system along z: slips and the compliance of the bodies."""

import numpy as np
from scipy.sparse import csr_array, diags_array, vstack

from fem.contact.along import Pull
from fem.contact.along_bodies import AlongBodies
from fem.contact.cone import Cone
from fem.contact.interface import LEAST, Interface
from fem.contact.mortar import Mortar
from fem.plane.discretisation import Array, Indices

UNHELD = 1e-9  # relative to a shift: below, no surface with friction resists it


class AlongInterface:
    """Weighted slips along z, s_i = int phi_i (u_z,m - u_z,s), at the nodes that carry friction.

    `rows` (r, nodes) have the order of the tangential rows of the plane problem. `cone` is the
    system of the rows of the plane problem and these rows.
    """

    def __init__(self, bodies: AlongBodies, plane: Interface) -> None:
        self.bodies = bodies
        rough = [m for m, p in zip(plane.mortars, plane.pairs, strict=True) if p.friction > 0]
        none = csr_array((0, bodies.nodes.count))
        self.rows: csr_array = vstack(
            [none, *(_slips(m, bodies.nodes.columns) for m in rough)]
        ).tocsr()
        self.C = (self.rows @ bodies.surface).toarray()
        B = self.C @ bodies.compliance(self.C.T)
        if rough:
            # as in the plane: points fixed on both sides get the smallest traction
            area = np.concatenate([m.size for m in rough])
            B[np.diag_indices(len(B))] += LEAST * np.mean(np.diag(B) / area**2) * area**2
        self.cone = Cone.of(plane.kernel, (B + B.T) / 2, self.C @ bodies.shifts)

    def loaded(self, pull: Pull) -> tuple[Array, Array]:
        """Slips (r,) due to `pull` at zero shifts, and forces (k,) of `pull` on the shifts."""
        bodies = self.bodies
        _, on_surface = bodies.load(pull)
        e = bodies.shifts.T @ on_surface
        at_rest = bodies.compliance(on_surface - bodies.shifts @ e)
        return self.C @ at_rest + self.rows @ pull.u_0, e

    def check_held(self) -> None:
        """Raise ValueError if neither supports nor friction prevent a shift of a body along z."""
        resistance = np.abs(self.C @ self.bodies.shifts).max(axis=0, initial=0.0)
        own = np.abs(self.C).max(initial=0.0)
        if np.any(resistance <= UNHELD * own):
            self.bodies.refuse(self.bodies.words[int(np.argmin(resistance))])


def _slips(mortar: Mortar, columns: Indices) -> csr_array:
    """Rows of the weighted slip u_z,m - u_z,s along z.

    The weights are those of the displacement along x in the plane; these follow from the normal and
    tangential rows.
    """
    n = mortar.points.n
    along_x = diags_array(n[0]) @ mortar.normal - diags_array(n[1]) @ mortar.tangential
    rows = mortar.weighted(along_x.tocsr()[:, columns])
    assert isinstance(rows, csr_array)
    return rows
