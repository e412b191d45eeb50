"""Linear elasticity, plane or axisymmetric: -div sigma = b on any mesh, with loads by name.

solve_plane(mesh, materials=Elastic(E=210e9, nu=0.3), assumption="plane strain",
            supports={"x=0": "x", "y=0": "y"}, pressures={"bore": 100e6})
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import get_args

import numpy as np
from skfem.mesh import Mesh2D

from fem.plane.factors import factorised, short
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
from fem.plane.means import Mean, held_means, mean_rows
from fem.plane.mixed import basis_for, cells_of
from fem.plane.rigid import check_rigid_motions
from fem.plane.solution import Held, PlaneSolution
from fem.plane.supports import Anchors, Support, collect
from fem.plane.ties import Tie, tied

MAX_CORRECTIONS = 60
CONVERGED = 1e-24  # relative energy, the square of relative displacements
ROUND_OFF = 1e-18
RESIDUAL_LIMIT = 1e-12


def solve_plane(
    mesh: Mesh2D,
    *,
    materials: Elastic | Mapping[str, Elastic],
    assumption: Assumption,
    supports: Mapping[str, Support],
    pressures: Mapping[str, Pressure] | None = None,
    tractions: Mapping[str, Vector] | None = None,
    forces: Mapping[str, tuple[float, float]] | None = None,
    body_forces: Vector | Mapping[str, Vector] | None = None,
    point_forces: Mapping[tuple[float, float], tuple[float, float]] | None = None,
    anchors: Anchors | None = None,
    ties: Sequence[Tie] = (),
    means: Mapping[str, Mean] | None = None,
    thickness: float = 1.0,
    degree: int | None = None,
) -> PlaneSolution:
    """Solve for the displacements of plane bodies or bodies of revolution.

    Parameters
    ----------
    mesh
        Triangles or quadrilaterals of scikit-fem, straight or quadratic, with names in
        `mesh.boundaries` and `mesh.subdomains`.
    materials
        One material, or a material for each body named in `mesh.subdomains`; every cell needs one.
    assumption
        "plane strain", "plane stress" or "axisymmetric". If axisymmetric, x is the radius r >= 0
        and y the axial coordinate, nodes at r = 0 stay on the axis, and all integrals, forces and
        reactions are those of the full circumference.
    supports
        For each boundary name, the components: "xy", "n" (a frictionless guide), or a mapping such
        as {"x": 1e-3} or {"n": f}, where f takes points (2, m) and returns values (m,) [length].
    pressures
        For each boundary name, the pressure, positive inwards [stress]: a number or f(x).
    tractions
        For each boundary name, the traction [stress]: two numbers, or f(x) of shape (2, ...).
    forces
        For each boundary name, the total force [force], distributed uniformly; if axisymmetric,
        its radial component must be zero.
    body_forces
        Force per volume on all bodies, or by body: two numbers, or f(x) of shape (2, ...).
    point_forces, anchors
        Forces and supports at mesh nodes, by coordinates. The displacement under a point force (or
        under a total force on a ring around the axis) is infinite in the exact solution: evaluate
        displacements at other points.
    ties
        Boundaries that follow other boundaries: cuts of cyclic sectors and periodic cells.
    means
        For each boundary name, mean motions that are prescribed while the boundary deforms freely.
    thickness
        Length out of the plane; energies, reactions and point forces refer to this length.
    degree
        Degree of the displacements, 1 or 2; by default the degree of the mesh.

    Raises
    ------
    ValueError
        For unknown names, missing materials, displacements of degree 1 with nu > 0.45, supports
        that contradict each other, or unsupported bodies; for a body of revolution also for r < 0,
        a thickness other than 1, and radial forces on the axis.
    ArithmeticError
        If the energy of the last correction of the linear solver is above 1e-12 of the total.

    Examples
    --------
    A quarter of a large plate with a hole under unit tension along x; Kirsch's stress at the edge
    of the hole is 3:

    >>> from meshes.ring import quarter_ring
    >>> plate = solve_plane(
    ...     quarter_ring(r_i=1.0, r_o=40.0, refine=4), materials=Elastic(E=210e3, nu=0.3),
    ...     assumption="plane stress", supports={"x=0": "x", "y=0": "y"},
    ...     tractions={"rim": lambda x: np.array([x[0] / np.hypot(*x), 0 * x[0]])},
    ... )
    >>> print(f"{plate.at(np.array([[0.0], [1.0]])).stress[0, 0]:.1f}")
    3.0
    """
    if assumption not in get_args(Assumption):
        known = ", ".join(map(repr, get_args(Assumption)))
        raise ValueError(f"assumption must be one of {known}, got {assumption!r}")
    if not thickness > 0:
        raise ValueError(f"thickness must be positive, got {thickness:g}")
    turn = assumption == "axisymmetric"
    if turn and thickness != 1:
        raise ValueError(
            f"the thickness of a body of revolution must be 1, the default, got {thickness:g}"
        )
    lam, mu, ratio = moduli(mesh, materials, assumption)
    basis = basis_for(mesh, lam, mu, degree, turn=turn)
    cells = cells_of(basis, thickness * lam, thickness * mu, turn=turn)
    f = thickness * (
        surface_load(basis, pressures or {}, tractions or {}, turn=turn)
        + body_load(basis, body_forces, turn=turn)
    )
    f += force_load(basis, forces or {}, turn=turn)
    f += point_load(basis, point_forces or {}, turn=turn)

    held = tied(basis, ties, turn=turn)
    conditions = collect(basis, supports, anchors or {}, turn=turn, tied=held)
    C = mean_rows(basis, means or {}, turn=turn)
    check_rigid_motions(basis, conditions, held, C, turn=turn)
    T, u0 = held.free_directions(basis, conditions, np.arange(basis.N))
    if means:
        T, lift = held_means(T, C)
        u0 = u0 + lift @ (np.concatenate([[*m.held.values()] for m in means.values()]) - C @ u0)
    u, internal, residual = _solve(cells, f, T, u0)
    return PlaneSolution(
        basis, u, internal, f, lam, mu, ratio, thickness, residual, conditions, turn,
        Held(held, C, means or {}),
    )  # fmt: skip


def _solve(cells, f, T, u0):
    """Solve u = T q + u0, T'(f - internal forces) = 0.

    Returns u, its internal forces, and the relative energy of the last correction. The residual is
    computed from the stresses of u, cell by cell. In slender bodies, u contains large rigid
    motions, and the round-off of K u would exceed the residual. K is used only for the corrections.
    """
    scale = float(cells.mu.max())
    steering = replace(cells, lam=short(cells.lam / scale), mu=short(cells.mu / scale))
    factor = factorised(steering.reduced(T))
    u, change, internal = u0.copy(), np.inf, cells.internal_forces(u0)
    stiff = np.sqrt(cells.diagonal())
    for _ in range(MAX_CORRECTIONS):
        residual = T.T @ (f - internal)
        step = factor.solve(residual) / scale
        u, before = u + T @ step, change
        internal = cells.internal_forces(u)
        # energies: of the correction; of loads and prescribed movements; scale of round-off
        most = (stiff * abs(u[cells.dofs])).sum(axis=(1, 2))  # |u| |K| |u| is at most its square
        size = abs(f @ u) + abs(internal @ u) + ROUND_OFF * (most @ most)
        change = abs(float(residual @ step)) / size if size else 0.0
        if change < CONVERGED or not change < before / 2:
            break
    if not change < RESIDUAL_LIMIT:
        raise ArithmeticError(
            f"the linear solver did not converge: the energy of the last correction is "
            f"{change:.1e} of the total energy, at most {RESIDUAL_LIMIT:.0e} is allowed"
        )
    return u, internal, change
