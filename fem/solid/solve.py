"""Linear elasticity in space: -div sigma = b on any mesh of hexahedra, with loads by name.

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
        Hexahedra of scikit-fem with 8 or 27 nodes; displacements have the degree of the mesh.
    materials
        One material for all cells, or one material for each body named in `mesh.subdomains`. The
        unknowns are displacements only, so that nearly incompressible cells lock. Example: a thick
        sphere with four cells through its wall. The root mean square error of the radial stress is
        4 % of the pressure (27 nodes) or 37 % (8 nodes) at nu = 0.45, and 19 % or 156 % at nu =
        0.49.
    supports
        For each place, the components: "xyz", or a mapping such as {"x": 1e-3} or {"x": f}, where f
        takes points (3, m) and returns values (m,) [length]. A place is the name of a boundary, or
        coordinates, where None means all values: (0.0, 0.0, None) are the nodes on a line along z.
    uniform
        For each place, components with equal, unknown values at all its nodes: a rigid guide.
    tractions
        For each boundary name, the traction [stress]: three numbers, or f(x) of points (3, ...).
    pressures
        For each boundary name, the pressure, positive inwards [stress]: a number or f(x).
    forces
        For each place, the total force [force], divided equally between its nodes. It is intended
        for single nodes and for places with uniform displacement.
    body_force
        Force per volume: three numbers, or f(x) of points (3, ...).
    points
        Number of Gauss points along each reference direction of a cell. The default is 3 for 27
        nodes, and 2 for 8 nodes. The value (2, 3, 3) prevents shear locking of cells that are long
        in the first direction.

    Raises
    ------
    ValueError
        For unknown names, missing materials, supports that contradict each other, folded cells, or
        unsupported bodies.
    ArithmeticError
        If the energy of the last correction of the linear solver is above 1e-12 of the total.
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

    Returns u, its internal forces, and the relative energy of the last correction. The residual is
    computed from the stresses of u, cell by cell. In slender bodies, the round-off of K u, which
    contains large rigid motions, would exceed the residual. K is used only for the corrections.
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
            f"the linear solver did not converge: the energy of the last correction is "
            f"{change:.1e} of the total energy, at most {RESIDUAL_LIMIT:.0e} is allowed"
        )
    return u, internal, change
