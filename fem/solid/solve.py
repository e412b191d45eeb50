"""Linear elasticity in space: -div sigma = b on any mesh of hexahedra, loads and all by name.

solve_solid(mesh, materials=Elastic(E=210e9, nu=0.3), supports={"tail": "xyz", "middle": "z"},
            tractions={"head": (1e6, 0.0, 0.0)})
"""

from collections.abc import Mapping

import numpy as np
from skfem.mesh import Mesh3D

from fem.cholesky import Cholesky
from fem.plane.material import Elastic
from fem.plane.solve import CONVERGED, MAX_CORRECTIONS, RESIDUAL_LIMIT, ROUND_OFF
from fem.solid.cells import Cells
from fem.solid.geometry import check_unfolded, degree
from fem.solid.loads import (
    Pressure,
    Vector,
    body_load,
    moduli,
    node_load,
    pressure_load,
    traction_load,
)
from fem.solid.ordering import nested_dissection
from fem.solid.places import Place
from fem.solid.rigid import check_rigid_motions
from fem.solid.solution import SolidSolution
from fem.solid.supports import Support, collect, free_directions


def solve_solid(
    mesh: Mesh3D,
    *,
    materials: Elastic | Mapping[str, Elastic],
    supports: Mapping[Place, Support],
    uniform: Mapping[Place, str] | None = None,
    tractions: Mapping[str, Vector] | None = None,
    pressures: Mapping[str, Pressure] | None = None,
    forces: Mapping[Place, tuple[float, float, float]] | None = None,
    body_force: Vector | None = None,
    points: tuple[int, int, int] | None = None,
) -> SolidSolution:
    """Solve for the displacements of one or several solids.

    Parameters
    ----------
    mesh
        scikit-fem hexahedra of 8 or 27 nodes; displacements have the mesh's degree.
    materials
        One material, or one for each body named in `mesh.subdomains`; every cell needs one.
        The elements have the displacement form and lock if nearly incompressible: with four cells
        through the wall of a thick sphere, the radial stress is off by 4 % of the pressure (27
        nodes) or 37 % (8 nodes) at nu = 0.45, by 19 % or 156 % at nu = 0.49 (root mean square).
    supports
        Place to components: "xyz", or a mapping such as {"x": 1e-3} or {"x": f}, where f takes
        points (3, m) and returns (m,) [length]. A place is a boundary's name, or coordinates where
        None means all: (0.0, 0.0, None) are the nodes on a line along z.
    uniform
        Place to components that are equal at all its nodes, of whatever size: a rigid guide.
    tractions
        Boundary name to traction vector [stress]; three numbers or f(x) of shape (3, ...).
    pressures
        Boundary name to pressure on it, positive inwards [stress]; number or f(x).
    forces
        Place to the total force on it [force], in equal parts on its nodes: for single nodes and
        for places that move uniformly.
    body_force
        Force per volume; three numbers or f(x) of shape (3, ...).
    points
        Gauss points along each reference direction of a cell, by default 3 each (27 nodes) or 2.
        (2, 3, 3) frees cells that are long in the first direction from shear locking.

    Raises
    ------
    ValueError
        For unknown names, missing materials, contradicting supports, folded cells, unsupported
        bodies.
    ArithmeticError
        If the last correction of the linear solve holds more than 1e-12 of the energy.
    """
    n = degree(mesh) + 1
    check_unfolded(mesh)
    lam, mu = moduli(mesh, materials)
    cells = Cells.of(mesh, lam, mu, points or (n, n, n))
    f = traction_load(mesh, cells, tractions or {}) + pressure_load(mesh, cells, pressures or {})
    f += body_load(mesh, cells, body_force) + node_load(mesh, forces or {})
    conditions = collect(mesh, supports, uniform or {})
    check_rigid_motions(mesh, conditions)
    T, u0 = free_directions(conditions, nested_dissection(mesh))
    u, internal, residual = _solve(cells, f, T, u0)
    return SolidSolution(mesh, cells, u, internal, f, residual, conditions)


def _solve(cells, f, T, u0):
    """Solve u = T q + u0, T'(f - internal forces) = 0.

    Returns u, its internal forces, and the relative energy of the last correction. The residual
    comes from the stresses of u, cell by cell: in slender bodies the rounding of K u, which holds
    their large rigid motion, would exceed it. K only steers the corrections.
    """
    K = cells.stiffness()
    factor = Cholesky(T.T @ K @ T)
    u, change, stiff, internal = u0.copy(), np.inf, abs(K), cells.internal_forces(u0)
    for _ in range(MAX_CORRECTIONS):
        residual = T.T @ (f - internal)
        step = factor.solve(residual)
        u, before = u + T @ step, change
        internal = cells.internal_forces(u)
        # energies: of the correction; of loads and prescribed movements; scale of round-off
        size = abs(f @ u) + abs(internal @ u) + ROUND_OFF * (abs(u) @ (stiff @ abs(u)))
        change = abs(float(residual @ step)) / size if size else 0.0
        if change < CONVERGED or not change < before / 2:
            break
    if not change < RESIDUAL_LIMIT:
        raise ArithmeticError(
            f"the linear solver did not converge: the last correction contains {change:.1e} "
            f"of the energy, allowed {RESIDUAL_LIMIT:.0e}"
        )
    return u, internal, change
