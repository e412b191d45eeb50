"""Contact of any number of elastic and rigid bodies in the plane, with Coulomb friction.

    problem = ContactProblem(
        mesh, materials=Elastic(E=210e9, nu=0.3), assumption="plane strain",
        supports={"block.bottom": "xy", "disc.axis": "x"},
        contacts=[Pair(slave="disc.rim", master="block.top", friction=0.2)],
    )
    pressed = problem.solve(forces={"disc.top": (0, -1e5)})
    pushed = problem.solve(forces={"disc.top": (1e4, -1e5)}, after=pressed)

Strains and rotations must be small. Bodies with an initial gap are first moved together rigidly;
after that, surfaces may only slide by distances that are small relative to their radii. Nearly
incompressible bodies (nu above 0.45, except in plane stress) require displacements of degree 2;
they are solved in a mixed form, see `fem.plane.mixed`.

With `along=Along(supports={"block.bottom": 0.0})`, bodies in plane strain also move along the third
axis z, by u_z(x, y) under `axial_forces={"disc.top": 1e4}`. The resultant of both components of
friction is then limited by mu times the pressure.
"""

from collections.abc import Hashable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from skfem.mesh import Mesh2D

from fem.contact.actions import Action, Forces, Loads, Supports
from fem.contact.along import Along, Pull
from fem.contact.along_problem import AlongProblem
from fem.contact.approach import approached
from fem.contact.bodies import Bodies, Response
from fem.contact.complementarity import Rest
from fem.contact.errors import NoEquilibriumError, NotFoundError
from fem.contact.interface import ROUND_OFF, Interface, Surfaces
from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.solution import ContactSolution
from fem.contact.system import OPEN
from fem.plane.discretisation import Array, Indices
from fem.plane.loads import Pressure, Vector
from fem.plane.material import Assumption, Elastic
from fem.plane.means import Mean
from fem.plane.supports import Anchors, Prescribed, Support
from fem.plane.ties import Tie

MAX_APPROACHES = 8
RUNAWAY = 100.0  # times elastic displacements and closed gaps: larger motions are unsupported
LIGHT = 1e-6  # the part of the loads that brings bodies together and hardly deforms them
GAP_TOLERANCE = 1e-13  # relative to the mesh's extent: less is round-off of the places of nodes


class ContactProblem:
    """Contact problem with bodies, supports and pairs, factorised once; `solve` applies loads.

    A steel roller of 10 mm radius on a flat under 800 N/mm; Hertz's peak pressure is 1714 MPa:

    >>> from fem.contact import Circle, Flat
    >>> from meshes import join_meshes
    >>> from meshes.contact import half_block, quarter_disc
    >>> fine = {"zone": 0.5, "refine": 1}
    >>> flat = half_block(width=80.0, depth=80.0, **fine)
    >>> problem = ContactProblem(
    ...     join_meshes({"roller": quarter_disc(R=10.0, **fine), "flat": flat}),
    ...     materials=Elastic(E=210e3, nu=0.3), assumption="plane strain",
    ...     supports={"roller.axis": "x", "flat.axis": "x", "flat.bottom": "y"},
    ...     contacts=[Pair(
    ...         slave="roller.surface", master="flat.surface",
    ...         slave_shape=Circle((0.0, 10.0), 10.0), master_shape=Flat(),
    ...     )],
    ... )
    >>> half = problem.solve(forces={"roller.middle": (0.0, -400.0)})
    >>> print(f"{half.touches[0].peak:.0f} MPa")
    1724 MPa
    """

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
        ties: Sequence[Tie] = (),
        means: Mapping[str, Mean] | None = None,
        along: Along | None = None,
        thickness: float = 1.0,
        degree: int | None = None,
    ) -> None:
        """Set up and factorise the problem.

        Parameters
        ----------
        mesh
            All bodies in one mesh, not joined at the contacts, with names in `mesh.boundaries` and
            `mesh.subdomains`.
        materials
            One material, or a material for each body named in `mesh.subdomains`; `Rigid()` is
            possible.
        assumption
            "plane strain", "plane stress" or "axisymmetric" (x is the radius, y the axis).
        contacts
            Pairs of boundaries; a boundary may appear in several pairs.
        supports, anchors
            See `solve_plane`. Bodies in equilibrium under loads and contact need no supports.
        obstacles
            Rigid surfaces without a mesh, by name.
        ties, means
            See `solve_plane`: ties between sections of cyclic sectors; boundaries with a prescribed
            mean motion that deform freely.
        along
            Supports along the third axis z; necessary if bodies may move along z (by u_z(x, y), in
            plane strain only). Friction then has one limit, for the resultant of both components.
        thickness
            Length out of the plane; all forces refer to this length.
        degree
            Degree of the displacements, 1 or 2; by default the degree of the mesh.

        Raises
        ------
        ValueError
            For unknown names, wrong values, folded cells, surfaces that overlap without `press_fit`
            or do not face each other, and bodies without sufficient supports or contacts.
        """
        if not contacts:
            raise ValueError("a contact problem needs at least one pair of surfaces, got none")
        seen: set[frozenset[str]] = set()
        for pair in contacts:
            sides = frozenset((pair.slave, pair.master))
            if sides in seen:
                raise ValueError(f"contact {pair}: these two surfaces must be paired only once")
            seen.add(sides)
        self.bodies = Bodies(
            mesh, materials, assumption, thickness, degree, obstacles or {}, ties, means
        )
        self.surfaces = Surfaces(self.bodies, contacts)
        self.supports = Supports(self.bodies, supports or {}, anchors or {})
        self.bodies.condense(self.supports.conditions, self.surfaces.unknowns)
        self.bodies.unknowns.displaced(self.supports.values({}))
        self.interface = Interface(self.bodies, self.surfaces)
        self.interface.check_held(self.surfaces)
        self.along: AlongProblem | None = None
        if along is not None:
            self.along = AlongProblem(self.bodies, along, self.surfaces, self.interface, assumption)
        self.loads = Loads(self.bodies)
        self._responses: dict[Hashable, Response] = {}
        self._shifts: dict[Hashable, Array] = {}

    def solve(
        self,
        *,
        pressures: Mapping[str, Pressure] | None = None,
        tractions: Mapping[str, Vector] | None = None,
        forces: Forces | None = None,
        body_forces: Vector | Mapping[str, Vector] | None = None,
        point_forces: Mapping[tuple[float, float], tuple[float, float]] | None = None,
        displacements: Mapping[str, Support] | None = None,
        axial_forces: Mapping[str, float] | None = None,
        axial_displacements: Mapping[str, Prescribed] | None = None,
        after: ContactSolution | None = None,
        steps: int = 1,
    ) -> ContactSolution:
        """Equilibrium under the given loads, which replace all loads of the step `after`.

        Parameters
        ----------
        pressures, tractions, body_forces, point_forces
            See `solve_plane`.
        forces
            For each boundary name, the total uniform force; for each obstacle name, (x, y) or (x,
            y, moment about its centre).
        displacements
            New values of components that supports already prescribe, by boundary; motions of
            obstacles such as {"anvil": {"y": -1e-5}}; mean motions such as {"rim": {"r": 1e-3}}.
            Supports that are not named have their original values.
        axial_forces, axial_displacements
            Only with `along`: total uniform forces along the third axis on boundaries, or on
            obstacles that are free along this axis; and new values of supports along this axis.
        after
            Previous step, from which friction continues.
        steps
            Number of equal increments in which all loads change from those of `after`, or from
            zero. Friction depends on the load path: pressing bodies of different materials together
            requires about 20 steps, or as many calls of `solve`. Where a gap closes, slip is
            measured from the closure of the gap.

        Raises
        ------
        ValueError
            For unknown names and wrong values.
        NoEquilibriumError
            If it is proven that no contact forces balance the loads, so that a body moves. This
            error is also a ValueError.
        NotFoundError
            If no equilibrium was found. This proves nothing about the bodies.
        """
        actions = [
            *self.loads.actions(
                pressures or {}, tractions or {}, forces or {}, body_forces, point_forces or {}
            ),
            *self.supports.actions(displacements or {}),
        ]  # fmt: skip
        if after is not None and after.bodies is not self.bodies:
            raise ValueError("the step `after` must belong to the same contact problem")
        if steps < 1:
            raise ValueError(f"steps must be 1 or more, got {steps}")
        before = () if after is None else after.actions
        pull = self._pull(axial_forces or {}, axial_displacements or {})
        pulled = None if after is None or after.along is None else after.along.pull
        for share in np.arange(1, steps + 1) / steps:
            ramped = [replace(a, share=share * a.share) for a in actions]
            ramped += [replace(a, share=(1 - share) * a.share) for a in before if share < 1]
            now = None if pull is None else pull.after(pulled, share)
            after = self._step(ramped, now, after)
        assert after is not None
        return after

    def _pull(
        self, forces: Mapping[str, float], displacements: Mapping[str, Prescribed]
    ) -> Pull | None:
        if self.along is not None:
            return self.along.bodies.pull(forces, displacements)
        if forces or displacements:
            raise ValueError("axial forces and displacements need a problem with along=Along(...)")
        return None

    def _step(
        self, actions: list[Action], pull: Pull | None, after: ContactSolution | None
    ) -> ContactSolution:
        """Equilibrium under `actions`; bodies with an initial gap are paired where they touch."""
        interface = self.interface if after is None else after.interface
        found = self._equilibrium(actions, pull, interface, after)
        for _ in range(MAX_APPROACHES):
            bases = approached(found, self.surfaces)
            if bases is None:
                self._refuse(found.interface.kernel.unfelt(found.e))
                return found
            moved = Interface(self.bodies, self.surfaces, bases)
            found = self._equilibrium(actions, pull, moved, after)
        raise NotFoundError(
            "no equilibrium was found: bodies with an initial gap still move after "
            f"{MAX_APPROACHES} attempts to bring their surfaces together"
        )

    def _equilibrium(
        self, actions: list[Action], pull: Pull | None, interface: Interface,
        after: ContactSolution | None,
    ) -> ContactSolution:  # fmt: skip
        kernel, m = interface.kernel, interface.gaps.size
        w, e = np.zeros(interface.rows.shape[0]), np.zeros(self.bodies.motions.shape[1])
        responses = [(a.share, self._response(a)) for a in actions]
        for action, (share, response) in zip(actions, responses, strict=True):
            w += share * self._shift(interface, action.key, response)
            e += share * response.e
        self._refuse(kernel.missing(e))
        slips = self._touching(interface, w, e) if after is None else after.slips
        w[:m] += interface.gaps
        closing = self._closes(interface, w, after)
        slips = slips + self._closing(interface, w, slips, after, closing)
        w[m:] -= slips

        def in_plane() -> Rest:
            return kernel.solve(w, e, None if after is None else after.states)

        along = None
        if self.along is None or pull is None:
            rest = in_plane()
        else:
            before = None if after is None or after.along is None else (after.rest, after.along)
            rest, along = self.along.solve(interface, w, e, pull, before, closing, in_plane)
        found = ContactSolution(
            bodies=self.bodies, interface=interface, actions=tuple(actions),
            responses=tuple(responses), rest=rest, slips_before=slips, along=along,
            e=e, w=w + kernel.B @ rest.multipliers + kernel.D @ rest.motion,
        )  # fmt: skip
        self._check_small(found, after)
        return found

    def _no_gap(self, interface: Interface) -> Array:
        """Weighted gaps (m,) below which surfaces touch, within round-off."""
        extent = float(np.ptp(self.bodies.basis.mesh.p, axis=1).max())
        return GAP_TOLERANCE * extent * interface.sizes

    @staticmethod
    def _trial(interface: Interface, w: Array, after: ContactSolution | None) -> Array:
        """Gaps and slips: `w`, changed by the contact forces and motions of the step `after`."""
        kernel = interface.kernel
        if after is None:
            return w
        return w + kernel.B @ after.rest.multipliers + kernel.D @ after.rest.motion

    def _closes(
        self, interface: Interface, w: Array, after: ContactSolution | None
    ) -> tuple[Indices, Array]:
        """Normal rows with friction whose gaps close, and the fraction of the load at closure.

        It is assumed that other contact forces are constant and that the rest of `w` grows
        linearly. Two kinds of nodes are excluded: nodes of a pair that already touches, and nodes
        of bodies without sufficient supports, whose motion is not known in advance. These nodes
        stick or slip from their present positions.
        """
        kernel, m = interface.kernel, interface.gaps.size
        gaps, touching = interface.gaps, interface.gaps <= self._no_gap(interface)
        if after is not None:
            gaps, touching = after.w[:m], after.states != OPEN
        trial = self._trial(interface, w, after)
        held = np.abs(kernel.D[:m]).sum(axis=1) == 0
        apart = held & ~np.isin(kernel.part, kernel.part[touching])
        closes = np.flatnonzero((kernel.partner >= 0) & apart & (gaps > 0) & (trial[:m] < 0))
        return closes, gaps[closes] / (gaps[closes] - trial[closes])

    def _closing(
        self, interface: Interface, w: Array, slips: Array, after: ContactSolution | None,
        closing: tuple[Indices, Array],
    ) -> Array:  # fmt: skip
        """Additional slips of surfaces until their gaps close; zero for other nodes."""
        kernel, m, (closes, share) = interface.kernel, interface.gaps.size, closing
        rows = kernel.partner[closes]
        found = np.zeros(slips.size)
        found[rows - m] = share * (self._trial(interface, w, after)[rows] - slips[rows - m])
        return found

    def _touching(self, interface: Interface, w: Array, e: Array) -> Array:
        """Weighted slips (r - m,) of bodies that the loads `w`, `e` bring into contact.

        Friction begins to act in this state; sliding before contact requires no force. Bodies that
        overlap initially, or that no load moves, stick at their positions.
        """
        kernel, m, smooth = interface.kernel, interface.gaps.size, interface.kernel.smooth()
        slips = np.zeros(w.size - m)
        driven = np.linalg.norm(kernel.D.T @ (w / np.diag(kernel.B)))
        moved = np.linalg.norm(e) > ROUND_OFF * driven
        overlap = np.any(interface.gaps < -self._no_gap(interface))
        if overlap or not (slips.size and moved) or np.any(smooth.missing(e)):
            return slips
        try:
            rest = smooth.solve(interface.gaps + LIGHT * w[:m], LIGHT * e)
        except NoEquilibriumError:
            return slips
        return LIGHT * w[m:] + kernel.B[m:, :m] @ rest.multipliers + kernel.D[m:] @ rest.motion

    def _response(self, action: Action) -> Response:
        if action.key is None:
            return action.respond(self.bodies)
        if action.key not in self._responses:
            self._responses[action.key] = action.respond(self.bodies)
        return self._responses[action.key]

    def _shift(self, interface: Interface, key: Hashable, response: Response) -> Array:
        if key is None or interface is not self.interface:
            return interface.shift(response)
        if key not in self._shifts:
            self._shifts[key] = interface.shift(response)
        return self._shifts[key]

    def _check_small(self, found: ContactSolution, after: ContactSolution | None) -> None:
        """Raise NotFoundError if bodies move by much more than their deformations and closed gaps.

        Only the facets of the mesh stop such motions, and the assumption of small motions is
        violated. Motions are measured from the previous step; deformations are those of both steps.
        """
        rest = found.rest
        if not (rest.motion.size and np.any(rest.multipliers)):
            return  # where nothing touches, bodies rest in any place
        size, motion = self._deformation(found), rest.motion
        if after is not None and after.interface is found.interface:
            size = max(size, self._deformation(after))
            motion = motion - after.rest.motion
        moved = float(np.abs(self.bodies.motions @ motion).max())
        if moved > RUNAWAY * size:
            raise NotFoundError(
                f"no equilibrium with small motions was found: {self.bodies.named(motion)}; in the "
                f"solution, this motion is {moved:.3g}, while surfaces deform by only {size:.3g}"
            )

    def _deformation(self, found: ContactSolution) -> float:
        """Largest elastic displacement of surfaces plus the largest gap that was closed."""
        elastic = found.yielded + sum(share * one.at_rest for share, one in found.responses)
        closed = np.flatnonzero(found.rest.states)
        gaps = found.interface.gaps[closed] / found.interface.sizes[closed]
        size = np.abs(elastic).max() + np.abs(gaps).max(initial=0.0)
        return float(size + ROUND_OFF * np.ptp(self.bodies.basis.mesh.p, axis=1).max())

    def _refuse(self, missing: Array) -> None:
        """Raise NoEquilibriumError if loads on rigid motions need contact forces `missing` (k,)."""
        if np.any(missing):
            raise NoEquilibriumError(
                f"{self.bodies.named(missing)}, and the loads cause this motion: contact can only "
                "push, and no admissible contact forces balance the loads; add a support, or "
                "change the loads"
            )
