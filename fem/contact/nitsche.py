"""Contact by Nitsche's method, for comparison: without multipliers, from stresses of the bodies.

P u is the pressure calculated from the stress of the slave in the direction of contact, g(u) is the
gap. The contact conditions are p = P u and p = [P u - g(u)/gamma]_+, for any gamma > 0. Both
conditions are satisfied if

    J(u) = a(u, u)/2 - f(u) + int gamma/2 ([P u - g(u)/gamma]_+^2 - (P u)^2)

is minimal. Therefore gamma = alpha h/(lambda + 2 mu), with the depth h of a cell, does not reduce
the order of convergence (Chouly and Hild 2013; Chouly, Hild and Renard 2015: theta = 1). J is
convex unless alpha is too large. Coulomb's friction limits P_t u - s(u)/gamma, with the slip s, to
+-mu p. Here p is the pressure of the previous iteration, so that each J is convex (Tresca's
friction).

Pairs, integration points and body stiffness are those of `ContactProblem.solve`. The space of the
tractions, the condensed system and the active sets are not used: tractions are computed at the
integration points, from the sparse system of all unknowns.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np

from fem.contact.actions import Forces
from fem.contact.approach import LARGEST_GAP
from fem.contact.convex import Piecewise
from fem.contact.nitsche_rows import Rows, rows
from fem.contact.nitsche_solution import NitscheSolution, PointTouch, touches_of
from fem.contact.problem import ContactProblem
from fem.plane.discretisation import Array, named_facets
from fem.plane.incompressible import refuse
from fem.plane.loads import Pressure, Vector
from fem.plane.supports import Support

BOUND = 1e-9  # relative to the largest pressure: by how much bounds of friction may change at last
MAX_BOUNDS = 200


def solve_nitsche(
    problem: ContactProblem,
    *,
    alpha: float = 0.05,
    pressures: Mapping[str, Pressure] | None = None,
    tractions: Mapping[str, Vector] | None = None,
    forces: Forces | None = None,
    body_forces: Vector | Mapping[str, Vector] | None = None,
    point_forces: Mapping[tuple[float, float], tuple[float, float]] | None = None,
    displacements: Mapping[str, Support] | None = None,
    after: NitscheSolution | None = None,
) -> NitscheSolution:
    """Equilibrium of `problem`; the loads are given as in `ContactProblem.solve`.

    Parameters
    ----------
    problem
        Each part of a slave's surface opposite a master must belong to one pair only and carry no
        other load. At the edge of contact, the pressure is smoothest if the slave is the softer
        body or has the shorter facets.
    alpha
        Weight of the stress relative to the gap, 0.01 to 0.1. With smaller values, the pressure
        oscillates.
    after
        Previous step, from which friction continues.

    Raises
    ------
    ValueError
        For invalid slaves, loads and names; for nu > 0.45 except in plane stress; and for bodies
        with too large an initial gap.
    ArithmeticError
        If `alpha` is too large, if loads move a body without supports, or if the iteration does not
        converge.
    """
    if not 0 < alpha < np.inf:
        raise ValueError(f"alpha must be positive and finite, got {alpha:g}")
    _check_slaves(problem, {*(pressures or {}), *(tractions or {}), *(forces or {})})
    bodies = problem.bodies
    refuse(bodies.basis.mesh, bodies.lam, bodies.mu, "Nitsche's method needs compressible bodies")
    actions = [
        *problem.loads.actions(
            pressures or {}, tractions or {}, forces or {}, body_forces, point_forces or {}
        ),
        *problem.supports.actions(displacements or {}),
    ]  # fmt: skip
    f, u_0 = np.zeros(bodies.count), np.zeros(bodies.count)
    for action in actions:
        response = action.respond(bodies)
        f, u_0 = f + action.share * response.f, u_0 + action.share * response.u_0
    own = rows(bodies, problem.surfaces, problem.interface, alpha)
    n = own.friction.size
    p, v = np.full(n, np.inf), np.zeros(bodies.unknowns.T.shape[1])
    if after is not None:
        own = replace(own, start=own.start - np.concatenate([np.zeros(n), after.slips]))
        p, v = after.tractions[:n], after.free
    free, found, iterations = _settle(own, own.energy(bodies, f, u_0), p, v)
    u = bodies.unknowns.T @ free + u_0
    mortars = problem.interface.mortars
    touches = touches_of(mortars, own, own.moved(u), found, turn=bodies.turn)
    _check_gap(problem, touches)
    return NitscheSolution(
        bodies=bodies, touches=touches, displacements=u, forces=f + own.forces(u, found),
        tractions=found, slips=(own.motion @ u)[n:], free=free, iterations=iterations,
    )  # fmt: skip


def _settle(own: Rows, energy: Piecewise, p: Array, v: Array) -> tuple[Array, Array, int]:
    """Unknowns, tractions and number of steps, from initial pressures `p` (n,) and unknowns `v`."""
    n, iterations = own.friction.size, 0
    for _ in range(MAX_BOUNDS):
        low, high = own.limits(p)
        bounded = replace(energy, low=low, high=high)
        v, steps = bounded.least(v)
        found, iterations = bounded.cut(v), iterations + steps
        change = np.abs(found[:n] - p)[own.rough].max(initial=0.0)
        p = found[:n]
        if change <= BOUND * p.max(initial=0.0):
            return v, found, iterations
    raise ArithmeticError(
        f"friction did not converge: after {MAX_BOUNDS} iterations the pressure still changes "
        f"by {change:.1e}, largest pressure {p.max():.1e}"
    )


def _check_slaves(problem: ContactProblem, loaded: Iterable[str]) -> None:
    """Raise ValueError if other loads or contacts act on the slave surface of a pair."""
    mesh, surfaces, mortars = problem.bodies.basis.mesh, problem.surfaces, problem.interface.mortars
    others = [(f"a load on {x!r}", named_facets(mesh, x)) for x in loaded if x in mesh.boundaries]
    touching = [
        slave.facets[np.unique(m.points.slave)]
        for slave, m in zip(surfaces.slaves, mortars, strict=True)
    ]
    masters = [
        np.zeros(0, int) if master is None else master.facets[np.unique(m.points.master)]
        for master, m in zip(surfaces.masters, mortars, strict=True)
    ]
    taken = [
        (f"the contact {pair}", np.concatenate(facets))
        for pair, *facets in zip(surfaces.pairs, touching, masters, strict=True)
    ]
    for i, pair in enumerate(surfaces.pairs):
        for what, facets in (*others, *taken[:i], *taken[i + 1 :]):
            if np.intersect1d(facets, touching[i]).size:
                raise ValueError(
                    f"contact {pair}: Nitsche's method needs a slave surface without other "
                    f"loads or contacts, but {what} acts on it"
                )


def _check_gap(problem: ContactProblem, touches: Iterable[PointTouch]) -> None:
    """Raise ValueError if surfaces in contact were paired at too large a distance."""
    s = problem.surfaces
    for pair, slave, master, touch in zip(s.pairs, s.slaves, s.masters, touches, strict=True):
        bend = slave.curvature() + (0.0 if master is None else master.curvature())
        gap = touch.mortar.points.gap[touch.p > 0].min(initial=np.inf)
        if np.isfinite(gap) and gap * bend > LARGEST_GAP:
            raise ValueError(
                f"contact {pair}: the initial gap of {gap:.3g} is too large for Nitsche's "
                "method, which pairs the surfaces only once: reduce the initial gap"
            )
