"""Solution of a contact problem: contact state of its surfaces, and fields in its bodies."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from fem.contact.actions import Action
from fem.contact.along_step import AlongStep
from fem.contact.bodies import Bodies, Response
from fem.contact.complementarity import Rest
from fem.contact.interface import Interface
from fem.contact.mortar import Mortar
from fem.contact.system import OPEN, STICK
from fem.plane.discretisation import Array
from fem.plane.solution import Held, PlaneSolution

STICKING_TOLERANCE = 1e-9  # relative to the normal force: less on sticking nodes is round-off


@dataclass(frozen=True)
class Touch:
    """Contact state of the two surfaces of a pair.

    Values at the m nodes of the slave, in order along the surface: `x` (2, m) positions; `arc` (m,)
    [length] from the start of the surface; `pressure` (m,) [stress]; `traction` (m,) [stress] on
    the master, along t (the normal from slave to master, rotated by +90°); `gap` and `slip` (m,)
    [length]; `closed` and `sticks` (m,); `traction_z` and `slip_z` (m,) along the third axis, zero
    for plane problems. `gap` and `slip` are weighted means about each node; `slip` is the slip
    since the previous step. Values at the n integration points of `mortar`: `p`, `q`, `q_z` (n,)
    [stress] and `weight` (n,) [area].
    """

    x: Array
    arc: Array
    pressure: Array
    traction: Array
    gap: Array
    slip: Array
    traction_z: Array
    slip_z: Array
    closed: NDArray[np.bool_]
    sticks: NDArray[np.bool_]
    mortar: Mortar
    p: Array
    q: Array
    q_z: Array
    turn: bool

    @property
    def weight(self) -> Array:
        return self.mortar.weight

    @property
    def force(self) -> tuple[float, float]:
        """Force (x, y) on the master. The force on the slave is opposite."""
        x, y = self._density() @ self.weight
        return float(x), float(y)

    @property
    def normal_force(self) -> float:
        """Normal force: integral of the pressure."""
        return float(self.p @ self.weight)

    @property
    def friction_force(self) -> float:
        """Friction force on the master: integral of the tangential traction."""
        return float(self.q @ self.weight)

    @property
    def force_z(self) -> float:
        """Force on the master along the third axis."""
        return float(self.q_z @ self.weight)

    @property
    def sticking_share(self) -> float:
        """Fraction of the normal force that acts on sticking nodes, 0 to 1; 0 without contact.

        If it is zero, the whole contact slides.
        """
        load = self.pressure * self.mortar.size
        total = float(load.sum())
        return float(load[self.sticks].sum()) / total if total > 0 else 0.0

    def moment(self, about: tuple[float, float] = (0.0, 0.0), *, on: str = "master") -> float:
        """Moment of the tractions on the "master" or the "slave" about the point `about`."""
        if on not in ("master", "slave"):
            raise ValueError(f"`on` must be 'master' or 'slave', got {on!r}")
        points = self.mortar.points
        at = points.y if on == "master" else points.x
        t = self._density() * (1 if on == "master" else -1)
        arm = at - np.reshape(about, (2, 1))
        return float((arm[0] * t[1] - arm[1] * t[0]) @ self.weight)

    @property
    def peak(self) -> float:
        """Largest pressure at a node."""
        return float(self.pressure.max(initial=0.0))

    def along(self, centre: tuple[float, float] | None = None) -> Array:
        """Coordinates (n,) of the integration points along the tangent at `centre`.

        The default of `centre` is the centre of pressure.
        """
        points, load = self.mortar.points, self.p * self.weight
        share = load / load.sum()
        origin = points.x @ share if centre is None else np.array(centre)
        n = points.n @ share
        t = np.array([-n[1], n[0]]) / np.hypot(*n)
        return t @ (points.x - origin[:, None])

    def half_width(self, centre: tuple[float, float] | None = None) -> float:
        """Half-width of the elliptic pressure that has the moments of `p`; 0 without contact.

        It is 2 sqrt(int p x^2 / int p), with x from `centre` (default: the centre of pressure). For
        a body of revolution, it is the radius sqrt(5/2 int p r^2 / int p) about the axis.
        """
        load = self.p * self.weight
        if not load.sum() > 0:
            return 0.0
        if self.turn:
            return float(np.sqrt(2.5 * (load @ self.mortar.points.x[0] ** 2) / load.sum()))
        return float(2 * np.sqrt(load @ self.along(centre) ** 2 / load.sum()))

    def _density(self) -> Array:
        n = self.mortar.points.n
        return self.p * n + self.q * np.array([-n[1], n[0]])


@dataclass(frozen=True, kw_only=True)
class ContactSolution:
    """Equilibrium in a step of a contact problem.

    `touches` are the contact states of the pairs, in their order in the problem.
    """

    bodies: Bodies
    interface: Interface
    actions: tuple[Action, ...]
    responses: tuple[tuple[float, Response], ...]
    rest: Rest
    e: Array
    w: Array
    slips_before: Array
    along: AlongStep | None = None

    @property
    def states(self) -> NDArray[np.int8]:
        """State of every normal row: open, stick or slip."""
        return self.rest.states

    @property
    def changes(self) -> tuple[int, ...]:
        """Number of nodes that changed between open, stick and slip, in each iteration."""
        return self.rest.changes

    @property
    def is_proven_non_unique(self) -> bool:
        """True if further states of rest under the same loads and history are proven to exist.

        Only for plane problems. False proves nothing. See `Complementarity.is_proven_non_unique`.
        """
        kernel, rest = self.interface.kernel, self.rest
        w_0 = self.w - kernel.B @ rest.multipliers - kernel.D @ rest.motion
        return self.along is None and kernel.is_proven_non_unique(rest, w_0, self.e)

    @property
    def slides(self) -> bool:
        """True if a pair slides as a whole or has lost contact, so that no loaded node sticks."""
        return any(touch.sticking_share <= STICKING_TOLERANCE for touch in self.touches)

    @cached_property
    def slips(self) -> Array:
        """Weighted slips of the rows with friction, accumulated since the undeformed mesh."""
        return self.slips_before + self.w[self.interface.gaps.size :]

    @cached_property
    def touches(self) -> tuple[Touch, ...]:
        """Contact states of all pairs: tractions, gaps and slips."""
        return tuple(self._touch(i) for i in range(len(self.interface.mortars)))

    def _touch(self, i: int) -> Touch:
        m, kernel = self.interface.mortars[i], self.interface.kernel
        own = slice(self.interface.starts[i], self.interface.starts[i + 1])
        partner, states = kernel.partner[own], self.states[own]
        pressure = self.rest.multipliers[own]
        traction, slip, traction_z, slip_z = np.zeros((4, m.size.size))
        if np.any(partner >= 0):
            traction, slip = self.rest.multipliers[partner], self.w[partner] / m.size
            if self.along is not None:
                rows = partner - self.interface.gaps.size
                traction_z, slip_z = self.along.traction[rows], self.along.w[rows] / m.size
        return Touch(
            x=m.x, arc=m.arc, turn=self.bodies.turn, pressure=pressure, traction=traction,
            gap=self.w[own] / m.size, slip=slip, traction_z=traction_z, slip_z=slip_z,
            q_z=m.hats @ traction_z, closed=states != OPEN,
            sticks=(states == STICK) & (partner >= 0), mortar=m, p=m.hats @ pressure,
            q=m.hats @ traction,
        )  # fmt: skip

    @cached_property
    def total(self) -> Response:
        """Response of the bodies to all loads and prescribed displacements, without contact."""
        none, free = np.zeros(self.bodies.count), np.zeros(self.bodies.unknowns.T.shape[1])
        surface = np.zeros(self.bodies.unknowns.surface)
        e = np.zeros(self.bodies.motions.shape[1])
        total = Response(none, none, free, surface, surface, e)
        for share, response in self.responses:
            total = total.plus(response, share)
        return total

    @cached_property
    def yielded(self) -> Array:
        """Displacements (s,) of the surface under the contact forces, without rigid motions."""
        return self.bodies.compliance(self.interface.C.T @ self.rest.multipliers)

    @cached_property
    def displacements(self) -> Array:
        """Displacements of all unknowns: of the mesh, then x, y and rotation of each obstacle."""
        b, i, rest = self.bodies, self.interface, self.rest
        pushed = i.C.T @ rest.multipliers
        surface = self.total.at_rest + self.yielded + b.motions @ rest.motion
        forces = self.total.load.copy()
        forces[b.condensed.surface] += pushed
        q = b.condensed.inside(forces, self.total.on_surface + pushed, surface)
        return b.unknowns.T @ q + self.total.u_0

    @cached_property
    def plane(self) -> PlaneSolution:
        """Displacements, stresses, reactions and energies of the bodies.

        Contact forces are included as loads; reactions are forces of the supports only.
        """
        contact = self.interface.rows.T @ self.rest.multipliers
        return in_plane(self.bodies, self.displacements, self.total.f + contact)

    def motion(self, obstacle: str) -> tuple[float, float, float]:
        """Shift (x, y) and rotation [rad] of an obstacle. Raises ValueError for an unknown name."""
        if obstacle not in self.bodies.obstacles:
            known = ", ".join(self.bodies.obstacles) or "none"
            raise ValueError(f"there is no obstacle {obstacle!r}; obstacles: {known}")
        first = self.bodies.basis.N + 3 * list(self.bodies.obstacles).index(obstacle)
        x, y, r = self.displacements[first : first + 3]
        return float(x), float(y), float(r)

    @property
    def strain_energy(self) -> float:
        """Strain energy of all bodies [force x length], including shear along the third axis."""
        along = 0.0 if self.along is None else self.along.strain_energy
        return self.plane.strain_energy + along

    @property
    def u_z(self) -> Array:
        """Displacements u_z (nodes,) in the order vertices, edge nodes, cell nodes, obstacles.

        They are zero in plane problems.
        """
        if self.along is None:
            return np.zeros(self.bodies.basis.N // 2 + len(self.bodies.obstacles))
        return self.along.u


def in_plane(bodies: Bodies, u: Array, f: Array) -> PlaneSolution:
    """Solution in the plane from displacements `u` (all,) and forces `f` (all,).

    Contact forces are included in `f`; reactions are forces of the supports only.
    """
    n, T = bodies.basis.N, bodies.unknowns.T
    internal = bodies.cells.internal_forces(u[:n])
    elastic = T[:n, : T.shape[1] - bodies.free_obstacles]
    residual = elastic.T @ (f[:n] - internal)
    size = abs(f[:n] @ u[:n]) + abs(internal @ u[:n])
    return PlaneSolution(
        bodies.basis, u[:n], internal, f[:n], bodies.lam, bodies.mu, bodies.ratio,
        bodies.thickness, float(np.abs(residual @ (elastic.T @ u[:n])) / size) if size else 0.0,
        bodies.conditions, bodies.turn, Held(bodies.tied, bodies.mean_rows, bodies.means),
    )  # fmt: skip
