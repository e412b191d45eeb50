"""Half a roller on an inclined race under a normal force: free, held by a cage, or released.

The bisector of the wedge is the x axis; the wedge becomes narrower towards +x. By symmetry, the
section y = 0 of the roller remains straight. The race is displaced along its normal. The caller
chooses the tangential displacement of the race, and the force at the middle of the roller.
"""

import math
from typing import NamedTuple

import numpy as np
from skfem.mesh import Mesh2D

from fem.contact.errors import NotFoundError
from fem.contact.pairs import Normal, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.contact.solution import ContactSolution
from fem.plane.discretisation import Array
from fem.plane.material import Elastic

HIT = 1e-12  # relative to the normal force, within which it is met
UNCHANGED = 1e-6  # relative change of the error of N: it does not depend on the race's position
MOST = 40


class Geometry(NamedTuple):
    """Radius R [m], half of the wedge angle [rad], and contact half-width a [m] for the mesh."""

    R: float
    half: float
    a: float

    @property
    def normal(self) -> Array:
        """Outward unit normal of the roller at the contact."""
        return np.array([math.sin(self.half), math.cos(self.half)])

    @property
    def tangent(self) -> Array:
        """Unit tangent to the race at the contact, directed into the wedge."""
        return np.array([math.cos(self.half), -math.sin(self.half)])


class Wedge:
    """Roller in a wedge, held along the bisector by its contacts only, or by a cage."""

    def __init__(
        self, geometry: Geometry, mesh: Mesh2D, *, E: float, nu: float, mu: float,
        caged: bool = False, normal: Normal = "master",
    ) -> None:  # fmt: skip
        self.geometry = geometry
        self.problem = wedge_problem(geometry, mesh, E, nu, mu, caged=caged, normal=normal)

    def at(
        self, down: float, *, along: float = 0.0, push: float = 0.0,
        after: ContactSolution | None = None, steps: int = 1,
    ) -> ContactSolution:  # fmt: skip
        """Contact state for race displacements `down` and `along` [m] and the force `push` [N/m].

        The race moves by `down` towards the roller and by `along` into the wedge. `push` acts at
        the middle of half a roller and is positive into the wedge.
        """
        x, y = along * self.geometry.tangent - down * self.geometry.normal
        forces = {"roller.inner": (push, 0.0)} if push else None
        moved = {"race.bottom": {"x": float(x), "y": float(y)}}
        return self.problem.solve(displacements=moved, forces=forces, after=after, steps=steps)

    def forces(self, state: ContactSolution) -> tuple[float, float]:
        """Normal force, and tangential force on the roller (positive into the wedge) [N/m]."""
        force = np.array(state.touches[0].force)
        return float(force @ self.geometry.normal), float(-force @ self.geometry.tangent)

    def pressed(
        self, N: float, *, along: float = 0.0, push: float = 0.0, near: float | None = None
    ) -> tuple[ContactSolution, float]:
        """Contact state under the normal force N [N/m], and the displacement of the race for N.

        The search begins at the displacement `near` [m], or at about half of Hertz's approach.
        """
        now = near or self.geometry.a**2 / self.geometry.R
        before = now / 2 if near is None else 0.99 * near
        missing = self._missing(self.at(before, along=along, push=push), N)
        for _ in range(MOST):
            state = self.at(now, along=along, push=push)
            more = self._missing(state, N)
            if abs(more) <= HIT:
                return state, now
            if abs(more - missing) <= UNCHANGED * abs(more):  # slips: the push alone makes N
                step = -math.copysign(now / 2, more)
            else:
                step = -more * (now - before) / (more - missing)
            before, now, missing = now, now + step, more
        raise NotFoundError(f"the normal force N was not reached: relative error {more:.1e}")

    def _missing(self, state: ContactSolution, N: float) -> float:
        return self.forces(state)[0] / N - 1


def wedge_problem(
    geometry: Geometry, mesh: Mesh2D, E: float, nu: float, mu: float, *, caged: bool,
    normal: Normal,
) -> ContactProblem:  # fmt: skip
    """Contact problem of a roller on a race, with friction and with supports.

    Supports act on the section of the roller and on the far side of the race. The bodies are
    "roller" (boundary "surface", and "inner", "outer" on its section) and "race" ("surface",
    "bottom"). A cage acts on the inner part of the section.
    """
    (x, y), (n_x, n_y) = geometry.R * geometry.normal, -geometry.normal
    return ContactProblem(
        mesh,
        materials=Elastic(E=E, nu=nu),
        assumption="plane strain",
        supports={"race.bottom": "xy", "roller.outer": "y", "roller.inner": "xy" if caged else "y"},
        contacts=[
            Pair(slave="roller.surface", master="race.surface", friction=mu, normal=normal,
                 slave_shape=Circle((0.0, 0.0), geometry.R),
                 master_shape=Flat((float(x), float(y)), (float(n_x), float(n_y))))
        ],
    )  # fmt: skip
