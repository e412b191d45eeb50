"""Bodies of a contact problem, elastic and rigid, condensed to their contact surfaces."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from typing import get_args

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.sparse import csr_array
from skfem import Basis
from skfem.mesh import Mesh2D

from fem.contact.condensation import Condensed, condense
from fem.contact.pairs import Obstacle, Rigid
from fem.contact.unknowns import Unknowns, unknowns
from fem.plane.discretisation import Array, Indices, named_cells
from fem.plane.loads import moduli
from fem.plane.material import Assumption, Elastic
from fem.plane.means import Mean, mean_rows
from fem.plane.mixed import basis_for, cells_of
from fem.plane.rigid import free_motions
from fem.plane.supports import Conditions
from fem.plane.ties import Tie, tied

UNHELD = 1e-9  # relative to a rigid motion: below, the surface does not resist it


@dataclass(frozen=True)
class Response:
    """Response of bodies, linear in the loads `f` and the prescribed displacements `u_0` (all,).

    `load` (n,) are the forces on the free unknowns; the equivalent forces on the surface are
    `on_surface` (s,). `at_rest` (s,) are the displacements of the surface without contact and
    without rigid motions. `e` (k,) are the forces of the load on the rigid motions.
    """

    f: Array
    u_0: Array
    load: Array
    on_surface: Array
    at_rest: Array
    e: Array

    def plus(self, other: "Response", share: float) -> "Response":
        return Response(*(
            getattr(self, x.name) + share * getattr(other, x.name) for x in fields(self)
        ))  # fmt: skip


class Bodies:
    """Stiffness and rigid motions of all bodies, condensed to the contact surfaces.

    `motions` (s, k) are the orthonormal rigid motions that supports permit; `words` describes them.
    """

    def __init__(
        self,
        mesh: Mesh2D,
        materials: Elastic | Mapping[str, Elastic | Rigid],
        assumption: Assumption,
        thickness: float,
        degree: int | None,
        obstacles: Mapping[str, Obstacle],
        ties: Sequence[Tie] = (),
        means: Mapping[str, Mean] | None = None,
    ) -> None:
        if assumption not in get_args(Assumption):
            known = ", ".join(map(repr, get_args(Assumption)))
            raise ValueError(f"assumption must be one of {known}, got {assumption!r}")
        self.turn = assumption == "axisymmetric"
        if not 0 < thickness < np.inf or (self.turn and thickness != 1):
            raise ValueError(
                f"thickness must be positive and finite, and 1 if axisymmetric, got {thickness:g}"
            )
        for name, obstacle in obstacles.items():
            if name in (mesh.boundaries or {}):
                raise ValueError(
                    f"obstacle {name!r} must not have the name of a boundary: rename it"
                )
            if self.turn and set(obstacle.free) - {"y"}:
                raise ValueError(f"obstacle {name!r}: if axisymmetric, only y can be free")
        self.obstacles, self.thickness = dict(obstacles), thickness
        self.lam, self.mu, self.ratio, self.rigid = _moduli(mesh, materials, assumption)
        self.basis: Basis = basis_for(mesh, self.lam, self.mu, degree, turn=self.turn)
        self.tied, self.means = tied(self.basis, ties, turn=self.turn), dict(means or {})
        self.mean_rows = mean_rows(self.basis, self.means, turn=self.turn)
        self.cells = cells_of(self.basis, thickness * self.lam, thickness * self.mu, turn=self.turn)

    @property
    def free_obstacles(self) -> int:
        """Number of free unknowns of obstacles; they are the last of the free unknowns."""
        return sum(len(o.free) for o in self.obstacles.values())

    @property
    def count(self) -> int:
        """Number of unknowns of the mesh and of obstacles, free or not."""
        return int(self.basis.N) + 3 * len(self.obstacles)

    def plane_modulus(self, cells: Indices) -> float:
        """Mean E/(1 - nu^2) of `cells`, or mean E in plane stress; infinite for a rigid body."""
        lam, mu = self.lam[cells], self.mu[cells]
        if np.any(mu == 0):
            return np.inf
        return float(np.mean(4 * mu * (lam + mu) / (lam + 2 * mu)))

    def condense(self, conditions: Conditions, surface: Indices) -> None:
        """Factorise the stiffness, with the unknowns of the contact surfaces (s,) last."""
        self.conditions = conditions
        rigid = [_pairs(self.basis, cells) for cells in self.rigid]
        self.unknowns: Unknowns = unknowns(
            self.basis, conditions, surface=surface, rigid=rigid,
            obstacles=list(self.obstacles.values()), tied=self.tied, means=self.mean_rows,
            turn=self.turn,
        )  # fmt: skip
        self.motions, self.words = self._free_motions()
        self.condensed: Condensed = condense(self._stiffness(), self.unknowns.surface)

    def _stiffness(self) -> csr_array:
        """Stiffness matrix T' K T (n, n).

        If T only selects unknowns, K is assembled directly in the order of T.
        """
        T = self.unknowns.T
        if np.all(T.data == 1) and np.all(np.diff(T.indptr) <= 1) and not self.rigid:
            place = np.full(self.count, -1)
            place[np.diff(T.indptr) == 1] = T.indices
            elastic = place[: self.basis.N]
            K = self.cells.stiffness(elastic)
            K.resize((T.shape[1], T.shape[1]))
            return K
        K = self.cells.stiffness()
        K.resize((self.count, self.count))
        return (T.T @ K @ T).tocsr()

    def _free_motions(self) -> tuple[Array, tuple[str, ...]]:
        found = free_motions(self.basis, self.conditions, self.tied, self.mean_rows, turn=self.turn)
        T, s = self.unknowns.T, self.unknowns.surface
        q = (T[: self.basis.N].T @ found.fields)[T.shape[1] - s :]
        unfelt = np.hypot.reduce(q, axis=0) < UNHELD * np.hypot.reduce(found.fields, axis=0)
        if np.any(unfelt):
            self.refuse(found.words[int(np.argmax(unfelt))])
        free = [(n, c) for n, o in self.obstacles.items() for c in o.free]
        q = np.hstack([q, np.eye(s)[:, s - len(free) :]])
        words = *found.words, *(f"obstacle {n!r} can move ({c})" for n, c in free)
        self._fields = q / np.hypot.reduce(q, axis=0)
        return np.linalg.qr(q)[0], words

    def named(self, amplitudes: Array) -> str:
        """Description of the rigid motion that is nearest to the `amplitudes` (k,)."""
        return self.words[int(np.argmax(np.abs(self._fields.T @ (self.motions @ amplitudes))))]

    def refuse(self, words: str) -> None:
        raise ValueError(
            f"{words}: neither supports nor contact prevent this motion; add a support"
        )

    @cached_property
    def _factor(self) -> tuple[Array, bool]:
        # springs on the rigid motions: loads in equilibrium cause no force in them
        S = self.condensed.S
        size = np.trace(S) / len(S) or 1.0
        return cho_factor(S + size * self.motions @ self.motions.T, check_finite=False)

    def compliance(self, forces: Array) -> Array:
        """Displacements (s, ...) of the surface under `forces` (s, ...), without rigid motions."""
        return np.asarray(cho_solve(self._factor, forces, check_finite=False))

    def respond(self, f: Array, u_0: Array) -> Response:
        """Response to forces (all,) and prescribed displacements (all,)."""
        T, internal = self.unknowns.T, np.zeros(self.count)
        if np.any(u_0):
            internal[: self.basis.N] = self.cells.internal_forces(u_0[: self.basis.N])
        load = T.T @ (f - internal)
        on_surface = self.condensed.load(load)
        e = self.motions.T @ on_surface
        at_rest = self.compliance(on_surface - self.motions @ e)
        return Response(f, u_0, load, on_surface, at_rest, e)


def _moduli(
    mesh: Mesh2D, materials: Elastic | Mapping[str, Elastic | Rigid], assumption: Assumption
) -> tuple[Array, Array, Array, list[Indices]]:
    """Lamé's lambda, mu and a stress ratio of every cell (0 if rigid); cells of each rigid body.

    The ratio is sigma_zz/(sigma_xx + sigma_yy).
    """
    if isinstance(materials, Elastic):
        return *moduli(mesh, materials, assumption), []
    if not isinstance(materials, Mapping):
        raise ValueError(
            f"materials must be Elastic, or a mapping of bodies to materials, got {materials!r}"
        )
    for body, material in materials.items():
        if not isinstance(material, Elastic | Rigid):
            raise ValueError(f"the material of {body!r} must be Elastic or Rigid, got {material!r}")
    rigid = [named_cells(mesh, body) for body, m in materials.items() if isinstance(m, Rigid)]
    stand_in = Elastic(E=1.0, nu=0.0)
    elastic = {b: m if isinstance(m, Elastic) else stand_in for b, m in materials.items()}
    lam, mu, ratio = moduli(mesh, elastic, assumption)
    for cells in rigid:
        lam[cells] = mu[cells] = ratio[cells] = 0.0
    return lam, mu, ratio, rigid


def _pairs(basis: Basis, cells: Indices) -> Indices:
    """Unknowns of the nodes of `cells`, in order x, y for each node."""
    x, y = (np.unique(np.asarray(basis.element_dofs)[i::2, cells]) for i in (0, 1))
    return np.array([x, y]).T.ravel()
