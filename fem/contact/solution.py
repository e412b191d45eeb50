"""A solved contact problem: what happens along its surfaces, and the fields in its bodies."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from fem.contact.complementarity import OPEN, STICK
from fem.contact.mortar import Mortar
from fem.plane.discretisation import Array
from fem.plane.solution import PlaneSolution

if TYPE_CHECKING:
    from fem.contact.problem import ContactProblem


@dataclass(frozen=True)
class Touch:
    """What happens between the two surfaces of a pair.

    At the slave's m vertices: `x` (2, m), `pressure`, `traction` (m,) [stress] (along the normal
    from slave to master turned by +90 deg, as it acts on the master), `gap`, `slip` (m,) [length]
    (weighted means about each vertex; slip since the step before), `closed`, `sticks` (m,).
    At the integration points: `points`, `p`, `q` (n,) and `weight` (n,) [area].
    """

    x: Array
    pressure: Array
    traction: Array
    gap: Array
    slip: Array
    closed: NDArray[np.bool_]
    sticks: NDArray[np.bool_]
    mortar: Mortar
    p: Array
    q: Array

    @property
    def weight(self) -> Array:
        return self.mortar.weight

    @property
    def force(self) -> tuple[float, float]:
        """Force (x, y) on the master; on the slave it is the opposite."""
        x, y = self._density() @ self.weight
        return float(x), float(y)

    @property
    def normal_force(self) -> float:
        """Integral of the pressure."""
        return float(self.p @ self.weight)

    @property
    def friction_force(self) -> float:
        """Integral of the tangential traction on the master."""
        return float(self.q @ self.weight)

    def moment(self, about: tuple[float, float] = (0.0, 0.0), *, on: str = "master") -> float:
        """Moment of the tractions on the "master", or on the "slave", about a point."""
        if on not in ("master", "slave"):
            raise ValueError(f"a moment acts on 'master' or 'slave', got {on!r}")
        points = self.mortar.points
        at = points.y if on == "master" else points.x
        t = self._density() * (1 if on == "master" else -1)
        arm = at - np.reshape(about, (2, 1))
        return float((arm[0] * t[1] - arm[1] * t[0]) @ self.weight)

    @property
    def peak(self) -> float:
        """The largest pressure at a vertex."""
        return float(self.pressure.max(initial=0.0))

    def along(self, centre: tuple[float, float] | None = None) -> Array:
        """Coordinate (n,) of the integration points along the surface from `centre`.

        The centre of pressure by default; the direction is the tangent there.
        """
        points, load = self.mortar.points, self.p * self.weight
        share = load / load.sum()
        origin = points.x @ share if centre is None else np.array(centre)
        n = points.n @ share
        t = np.array([-n[1], n[0]]) / np.hypot(*n)
        return t @ (points.x - origin[:, None])

    def half_width(self, centre: tuple[float, float] | None = None) -> float:
        """Half-width 2 sqrt(int p x^2 / int p) of an elliptic pressure with the same moments."""
        load = self.p * self.weight
        if not load.sum() > 0:
            return 0.0
        return float(2 * np.sqrt(load @ self.along(centre) ** 2 / load.sum()))

    def _density(self) -> Array:
        n = self.mortar.points.n
        return self.p * n + self.q * np.array([-n[1], n[0]])


@dataclass(frozen=True, kw_only=True)
class ContactSolution:
    """A step of a contact problem in equilibrium.

    `touches` follow the problem's pairs. `changes` lists how many vertices changed between open,
    stick and slip, iteration by iteration.
    """

    problem: ContactProblem
    multipliers: Array
    states: NDArray[np.int8]
    slips: Array
    changes: tuple[int, ...]
    surface: Array
    load: Array
    f: Array
    u_0: Array
    after: ContactSolution | None

    @cached_property
    def touches(self) -> tuple[Touch, ...]:
        problem = self.problem
        displaced = problem.rows @ self.u_0 + problem.C @ self.surface
        gaps = problem.gaps + displaced[: problem.gaps.size]
        since = self.slips if self.after is None else self.slips - self.after.slips
        found = []
        for i, m in enumerate(problem.mortars):
            own = slice(problem.starts[i], problem.starts[i + 1])
            partner = problem.kernel.partner[own]
            tangential, slip = np.zeros(m.size.size), np.zeros(m.size.size)
            if np.any(partner >= 0):
                tangential = self.multipliers[partner]
                slip = since[partner - problem.gaps.size] / m.size
            pressure, states = self.multipliers[own], self.states[own]
            found.append(
                Touch(
                    x=m.x, pressure=pressure, traction=tangential,
                    gap=gaps[own] / m.size, slip=slip, closed=states != OPEN,
                    sticks=(states == STICK) & (partner >= 0), mortar=m, p=m.hats @ pressure,
                    q=m.hats @ tangential,
                )
            )  # fmt: skip
        return tuple(found)

    @cached_property
    def _everything(self) -> Array:
        problem = self.problem
        forces = self.load + problem.T.T @ (problem.rows.T @ self.multipliers)
        return problem.T @ problem.condensed.inside(forces, self.surface) + self.u_0

    @cached_property
    def plane(self) -> PlaneSolution:
        """Displacements, stresses, reactions and energies of the bodies.

        Contact forces count among its loads: reactions are those of the supports alone.
        """
        p = self.problem
        n = p.basis.N
        u = self._everything[:n]
        internal = p.cells.internal_forces(u)
        f = (self.f + p.rows.T @ self.multipliers)[:n]
        residual = p.T[:n].T @ (f - internal)
        size = abs(f @ u) + abs(internal @ u)
        return PlaneSolution(
            p.basis, u, internal, f, p.lam, p.mu, p.ratio, p.thickness,
            float(np.abs(residual).max() * np.abs(u).max() / size) if size else 0.0,
            p.conditions, p.turn,
        )  # fmt: skip

    def motion(self, obstacle: str) -> tuple[float, float, float]:
        """Shift (x, y) and rotation [rad] of an obstacle."""
        at = self.problem.basis.N + 3 * list(self.problem.obstacles).index(obstacle)
        x, y, r = self._everything[at : at + 3]
        return float(x), float(y), float(r)

    @property
    def strain_energy(self) -> float:
        """Of all bodies [force x length]."""
        return self.plane.strain_energy
