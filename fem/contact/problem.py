"""Contact of any number of elastic and rigid bodies in the plane, with Coulomb friction.

    problem = ContactProblem(
        mesh, materials=Elastic(E=210e9, nu=0.3), assumption="plane strain",
        supports={"block.bottom": "xy", "disc.axis": "x"},
        contacts=[Pair(slave="disc.rim", master="block.top", friction=0.2)],
    )
    pressed = problem.solve(forces={"disc.top": (0, -1e5)})
    pushed = problem.solve(forces={"disc.top": (1e4, -1e5)}, after=pressed)

Displacements are small: surfaces meet where they face each other in the mesh, and slide by little
against the sizes of the bodies.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np
from skfem import Basis
from skfem.mesh import Mesh2D

from fem.contact.complementarity import Complementarity
from fem.contact.condensation import condense
from fem.contact.mortar import Mortar, mortar
from fem.contact.pairing import Points, pair, pair_with_shape
from fem.contact.shapes import Circle, Flat
from fem.contact.solution import ContactSolution
from fem.contact.trace import Trace, trace_of
from fem.contact.unknowns import Obstacle, Rigid, prescribed, unknowns
from fem.plane.cells import Cells
from fem.plane.discretisation import Array, Indices, named_cells, vector_basis
from fem.plane.loads import (
    Pressure,
    Vector,
    body_load,
    force_load,
    moduli,
    point_load,
    surface_load,
)
from fem.plane.material import Assumption, Elastic
from fem.plane.rigid import free_motions
from fem.plane.supports import Anchors, Support, collect

UNHELD = 1e-9  # of the loads, or of a rigid motion: below, it is none
ROUND_OFF = 1e-9  # of a body's extent: overlaps that say nothing


@dataclass(frozen=True, kw_only=True)
class Pair:
    """Two surfaces that may touch, by boundary name; the master may be an obstacle's.

    The traction is carried by the slave's vertices: let the slave have the finer mesh or the
    smaller surface. `friction` is Coulomb's coefficient. The shapes are exact ones of the meshed
    boundaries, so that facets do not enter the gap. `interference` [length] is taken off the gap
    everywhere; `press_fit` accepts surfaces that overlap in the mesh.
    """

    slave: str
    master: str
    friction: float = 0.0
    slave_shape: Flat | Circle | None = None
    master_shape: Flat | Circle | None = None
    interference: float = 0.0
    press_fit: bool = False

    def __post_init__(self) -> None:
        if not 0 <= self.friction < np.inf:
            raise ValueError(
                f"contact {self}: friction must be 0 or more and finite, got {self.friction:g}"
            )
        if not np.isfinite(self.interference):
            raise ValueError(f"contact {self}: interference must be finite")
        if self.slave == self.master:
            raise ValueError(f"contact {self}: a boundary cannot touch itself")

    def __str__(self) -> str:
        return f"{self.slave!r} on {self.master!r}"


class ContactProblem:
    """Bodies, supports and contact pairs, factorised once; `solve` takes loads, step by step."""

    def __init__(
        self,
        mesh: Mesh2D,
        *,
        materials: Elastic | Mapping[str, Elastic | Rigid],
        assumption: Assumption,
        contacts: Sequence[Pair],
        supports: Mapping[str, Support] | None = None,
        anchors: Anchors | None = None,
        obstacles: Mapping[str, Obstacle] | None = None,
        thickness: float = 1.0,
        degree: int | None = None,
    ) -> None:
        """Set the problem up.

        Parameters
        ----------
        mesh
            All bodies in one mesh, not joined where they touch; names in `mesh.boundaries` and
            `mesh.subdomains`.
        materials
            One material, or one for each body named in `mesh.subdomains`, `Rigid()` among them.
        assumption
            "plane strain", "plane stress" or "axisymmetric" (x is the radius, y the axis).
        contacts
            Pairs of boundaries; a boundary may appear in several.
        supports, anchors
            As for `solve_plane`. Bodies may lack supports where contact and loads hold them.
        obstacles
            Rigid surfaces without a mesh, by name.
        thickness
            Out-of-plane length; forces refer to it.
        degree
            Degree of the displacements, 1 or 2; by default that of the mesh.

        Raises
        ------
        ValueError
            For unknown names, wrong values, surfaces that overlap unasked or do not face each
            other, folded cells, and bodies that neither supports nor contact hold.
        """
        if assumption not in get_args(Assumption):
            known = ", ".join(map(repr, get_args(Assumption)))
            raise ValueError(f"assumption is one of {known}, got {assumption!r}")
        self.turn = assumption == "axisymmetric"
        if not thickness > 0 or (self.turn and thickness != 1):
            raise ValueError(f"thickness must be positive, 1 around a turn, got {thickness:g}")
        if not contacts:
            raise ValueError("a contact problem needs a pair of surfaces, got none")
        self.contacts, self.thickness = tuple(contacts), thickness
        self.supports, self.anchors = dict(supports or {}), dict(anchors or {})
        self.obstacles = dict(obstacles or {})
        self._check_obstacles(mesh)
        self.basis = vector_basis(mesh, degree, turn=self.turn)
        self.lam, self.mu, self.ratio, rigid_cells = _moduli(mesh, materials, assumption)
        self.cells = Cells.of(self.basis, thickness * self.lam, thickness * self.mu, turn=self.turn)
        self.rigid = [_pairs_of(self.basis, cells) for cells in rigid_cells]
        self.conditions = collect(self.basis, self.supports, self.anchors, turn=self.turn)
        self.slaves = [trace_of(self.basis, c.slave, c.slave_shape) for c in self.contacts]
        self.masters = [
            None if c.master in self.obstacles else trace_of(self.basis, c.master, c.master_shape)
            for c in self.contacts
        ]
        self.mortars = [self._mortar(i) for i in range(len(self.contacts))]
        self._condense()

    def _check_obstacles(self, mesh: Mesh2D) -> None:
        for name, obstacle in self.obstacles.items():
            if name in (mesh.boundaries or {}):
                raise ValueError(f"obstacle {name!r} has the name of a boundary: rename it")
            if self.turn and set(obstacle.free) - {"y"}:
                raise ValueError(f"obstacle {name!r}: around a turn only y is free")

    def _mortar(self, i: int) -> Mortar:
        """Pair the surfaces of contact `i`."""
        contact, slave, master = self.contacts[i], self.slaves[i], self.masters[i]
        total = self.basis.N + 3 * len(self.obstacles)
        if master is None:
            obstacle = self.obstacles[contact.master]
            points = pair_with_shape(slave, obstacle.shape)
            first = self.basis.N + 3 * list(self.obstacles).index(contact.master)
            at = first, obstacle.centre
        else:
            own, other = self._plane_modulus(slave), self._plane_modulus(master)
            share = 0.5 if own == other == np.inf else 1.0 if own == np.inf else own / (own + other)
            if other == np.inf and own != np.inf:
                share = 0.0
            points, at = pair(slave, master, share), (0, (0.0, 0.0))
        if not points.s.size:
            raise ValueError(f"contact {contact}: the surfaces do not face each other anywhere")
        if not contact.press_fit:
            self._check_overlap(contact, slave, master, points)
        depth = np.full(points.s.size, self.thickness)
        if self.turn:
            depth = 2 * np.pi * points.x[0]
        return mortar(slave, master, points, unknowns=total, depth=depth, obstacle=at)

    def _plane_modulus(self, trace: Trace) -> float:
        """E/(1 - nu^2), or E in plane stress, of the cells behind a surface."""
        lam, mu = self.lam[trace.cells], self.mu[trace.cells]
        if np.any(mu == 0):
            return np.inf
        return float(np.mean(4 * mu * (lam + mu) / (lam + 2 * mu)))

    def _check_overlap(
        self, contact: Pair, slave: Trace, master: Trace | None, points: Points
    ) -> None:
        allowed = slave.sag()[points.slave] + ROUND_OFF * np.ptp(self.basis.mesh.p, axis=1).max()
        if master is not None:
            allowed = allowed + master.sag()[points.master]
        worst = int(np.argmin(points.gap + allowed))
        if points.gap[worst] < -allowed[worst]:
            x, y = points.x[:, worst]
            raise ValueError(
                f"contact {contact}: the surfaces overlap by {-points.gap[worst]:.3g} at "
                f"({x:.5g}, {y:.5g}) before any load: move them apart, or ask for press_fit=True"
            )

    def _condense(self) -> None:
        total = self.basis.N + 3 * len(self.obstacles)
        surface = np.unique(np.concatenate([
            t.dofs.ravel() for t in (*self.slaves, *self.masters) if t is not None
        ]))  # fmt: skip
        free = unknowns(
            self.basis, self.conditions, surface=surface, rigid=self.rigid,
            obstacles=list(self.obstacles.values()), turn=self.turn,
        )  # fmt: skip
        self.T = free.T
        K = self.cells.stiffness()
        K.resize((total, total))
        self.condensed = condense((self.T.T @ K @ self.T).tocsr(), free.surface)
        self.Z, self.words = self._motions(free.surface)
        S = self.condensed.S
        scale = np.trace(S) / len(S) if np.trace(S) > 0 else 1.0
        self.S_inverse = np.linalg.inv(S + scale * self.Z @ self.Z.T)
        self.gaps = np.concatenate([
            m.weighted(m.points.gap - c.interference)
            for m, c in zip(self.mortars, self.contacts, strict=True)
        ])  # fmt: skip
        normal = [m.weighted(m.normal) for m in self.mortars]
        rough = [i for i, c in enumerate(self.contacts) if c.friction > 0]
        tangential = [self.mortars[i].weighted(self.mortars[i].tangential) for i in rough]
        from scipy.sparse import vstack

        self.rows = vstack([*normal, *tangential]).tocsr()
        self.C = (self.rows @ self.T)[:, -free.surface :].toarray()
        counts = [m.size.size for m in self.mortars]
        self.starts = np.concatenate([[0], np.cumsum(counts)])
        friction = np.repeat([c.friction for c in self.contacts], counts)
        partner = np.full(friction.size, -1)
        at = self.starts[-1]
        for i in rough:
            partner[self.starts[i] : self.starts[i + 1]] = at + np.arange(counts[i])
            at += counts[i]
        self.kernel = Complementarity(
            B=self.C @ self.S_inverse @ self.C.T, D=self.C @ self.Z, friction=friction,
            partner=partner,
        )  # fmt: skip
        if self.Z.shape[1]:
            _, s, v = np.linalg.svd(self.kernel.D, full_matrices=True)
            s = np.concatenate([s, np.zeros(self.Z.shape[1] - s.size)])
            if s[-1] < UNHELD * max(s[0], 1e-300):
                worst = int(np.argmax(np.abs(v[-1])))
                raise ValueError(f"{self.words[worst]}: neither supports nor contact hold it")

    def _motions(self, surface: int) -> tuple[Array, tuple[str, ...]]:
        """Orthonormal rigid motions (surface unknowns, k) that are left, and their words."""
        found = free_motions(self.basis, self.conditions, turn=self.turn)
        fields = np.vstack(
            [found.fields, np.zeros((3 * len(self.obstacles), found.fields.shape[1]))]
        )
        q = (self.T.T @ fields)[-surface:]
        words = list(found.words)
        held = np.hypot.reduce(q, axis=0) < UNHELD * np.hypot.reduce(found.fields, axis=0)
        if np.any(held):
            raise ValueError(f"{words[int(np.argmax(held))]}: neither supports nor contact hold it")
        free = sum(len(o.free) for o in self.obstacles.values())
        q = np.hstack([q, np.eye(surface)[:, surface - free :]])
        words += [
            f"obstacle {name!r} can move ({c})"
            for name, o in self.obstacles.items()
            for c in o.free
        ]
        Z, _ = np.linalg.qr(q)
        return Z, tuple(words)

    def solve(
        self,
        *,
        pressures: Mapping[str, Pressure] | None = None,
        tractions: Mapping[str, Vector] | None = None,
        forces: Mapping[str, tuple[float, ...]] | None = None,
        body_forces: Vector | Mapping[str, Vector] | None = None,
        point_forces: Mapping[tuple[float, float], tuple[float, float]] | None = None,
        displacements: Mapping[str, Support] | None = None,
        after: ContactSolution | None = None,
    ) -> ContactSolution:
        """The equilibrium under these loads, which replace those of the step `after`.

        Parameters
        ----------
        pressures, tractions, body_forces, point_forces
            As for `solve_plane`.
        forces
            Boundary name to the total force on it, spread evenly; obstacle name to (x, y) or
            (x, y, moment about its centre).
        displacements
            New values of supports, by boundary, with the components that these hold; motions of
            obstacles such as {"anvil": {"y": -1e-5}}.
        after
            The step before, from which friction continues.

        Raises
        ------
        ValueError
            For unknown names, and loads that the contact cannot balance: they pull bodies apart.
        ArithmeticError
            Where the contact does not converge.
        """
        f = self._forces(pressures, tractions, forces, body_forces, point_forces)
        u_0 = self._prescribed(displacements or {})
        moved = np.any(u_0 != 0)
        internal = np.zeros(self.T.shape[0])
        if moved:
            internal[: self.basis.N] = self.cells.internal_forces(u_0[: self.basis.N])
        load = self.T.T @ (f - internal)
        on_surface = self.condensed.load(load)
        e = self.Z.T @ on_surface
        at_rest = self.S_inverse @ (on_surface - self.Z @ e)
        w_0 = self.C @ at_rest
        if moved:
            w_0 += self.rows @ u_0
        w_0[: self.gaps.size] += self.gaps
        if after is not None:
            w_0[self.gaps.size :] -= after.slips
        self._check_balance(e)
        found = self.kernel.solve(w_0, e, None if after is None else after.states)
        v = at_rest + self.S_inverse @ (self.C.T @ found.multipliers) + self.Z @ found.motion
        slips = (self.C @ v + self.rows @ u_0)[self.gaps.size :]
        return ContactSolution(
            problem=self, multipliers=found.multipliers, states=found.states, slips=slips,
            changes=found.changes, surface=v, load=load, f=f, u_0=u_0, after=after,
        )  # fmt: skip

    def _forces(self, pressures, tractions, forces, body_forces, point_forces) -> Array:
        on_mesh = {n: (v[0], v[1]) for n, v in (forces or {}).items() if n not in self.obstacles}
        f = self.thickness * (
            surface_load(self.basis, pressures or {}, tractions or {}, turn=self.turn)
            + body_load(self.basis, body_forces, turn=self.turn)
        )
        f += force_load(self.basis, on_mesh, turn=self.turn)
        f += point_load(self.basis, point_forces or {}, turn=self.turn)
        own = np.zeros((len(self.obstacles), 3))
        for i, name in enumerate(self.obstacles):
            given = (forces or {}).get(name, ())
            own[i, : len(given)] = given
        return np.concatenate([f, own.ravel()])

    def _prescribed(self, displacements: Mapping[str, Support]) -> Array:
        held: dict[str, Support] = dict(self.supports)
        motions: dict[str, Mapping[str, float]] = {}
        for name, value in displacements.items():
            if name in self.obstacles:
                motions[name] = {c: float(v) for c, v in dict(value).items()}  # type: ignore[arg-type]
                continue
            if name not in held or set(value) != set(held[name]):
                holds = sorted(held[name]) if name in held else "nothing"
                raise ValueError(
                    f"displacements of {name!r}: supports are set up with the problem, and only "
                    f"their values change; it holds {holds}"
                )
            held[name] = value
        conditions = collect(self.basis, held, self.anchors, turn=self.turn)
        return prescribed(self.basis, conditions, self.rigid, self.obstacles, motions, self.turn)

    def _check_balance(self, e: Array) -> None:
        if not e.size or not np.any(e):
            return
        missing = self.kernel.unbalanced(e)
        if np.linalg.norm(missing) > UNHELD * np.linalg.norm(e):
            worst = int(np.argmax(np.abs(missing)))
            raise ValueError(
                f"{self.words[worst]}, and the loads do move it: contact can only push, "
                "and no contact force balances them"
            )


def _moduli(
    mesh: Mesh2D, materials: Elastic | Mapping[str, Elastic | Rigid], assumption: Assumption
) -> tuple[Array, Array, Array, list[Indices]]:
    """Moduli of every cell, zero in rigid bodies, and the cells of each of these."""
    if isinstance(materials, Elastic):
        return *moduli(mesh, materials, assumption), []
    rigid = [named_cells(mesh, body) for body, m in materials.items() if isinstance(m, Rigid)]
    stand_in = Elastic(E=1.0, nu=0.0)
    elastic = {b: m if isinstance(m, Elastic) else stand_in for b, m in materials.items()}
    lam, mu, ratio = moduli(mesh, elastic, assumption)
    for cells in rigid:
        lam[cells] = mu[cells] = ratio[cells] = 0.0
    return lam, mu, ratio, rigid


def _pairs_of(basis: Basis, cells: Indices) -> Indices:
    """Unknowns of the nodes of `cells`, in pairs x, y."""
    first = np.unique(np.asarray(basis.element_dofs)[::2, cells])
    second = np.unique(np.asarray(basis.element_dofs)[1::2, cells])
    return np.array([first, second]).T.ravel()
