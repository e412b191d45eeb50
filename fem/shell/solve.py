"""Linear shells in space with nine-node quadrilaterals, with loads by name.

solve_shell(points, cells, thickness=0.25, materials=Elastic(E=4.32e8, nu=0.0),
            boundaries=mesh.boundaries, supports={"diaphragm": "xy", "symmetry": "zab"},
            surface_loads=(0, -90, 0))
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.sparse import coo_array, csc_array

from fem.cholesky import Cholesky
from fem.plane.material import Elastic
from fem.shell.loads import Pressure, Vector, area_forces, edge_forces, node_forces
from fem.shell.reference import NODES, Array, Indices
from fem.shell.solution import ShellSolution
from fem.shell.strains import moduli, operator, unknowns
from fem.shell.supports import (
    Boundaries,
    Named,
    check_rigid_motions,
    held_values,
    reduced_numbers,
    tied_unknowns,
)

MAX_CORRECTIONS = 60
CONVERGED = 1e-24  # relative energy, the square of relative displacements
ROUND_OFF = 1e-18
RESIDUAL_LIMIT = 1e-12


def solve_shell(
    points: Array,
    cells: Indices,
    *,
    thickness: float | Mapping[str, float],
    materials: Elastic | Mapping[str, Elastic],
    supports: Named,
    boundaries: Boundaries | None = None,
    bodies: Mapping[str, Indices] | None = None,
    ties: Mapping[str, str] | None = None,
    edge_loads: Mapping[str, Vector] | None = None,
    pressures: Pressure | Mapping[str, Pressure] = 0.0,
    surface_loads: Vector | Mapping[str, Vector] = (0.0, 0.0, 0.0),
    loads: Mapping[int, Any] | None = None,
) -> ShellSolution:
    """Solve for displacements and rotations of a thin shell, which may have folds and branches.

    Parameters
    ----------
    points, cells
        Nodes (n, 3), and cells (m, 9): four corners, middles of the edges between them, centre.
    thickness, materials
        One value for all cells, or one value for each body.
    supports
        For each boundary name or node number, the components: x, y, z (displacements) and a, b, c
        (rotations about x, y, z). "xyzabc" is clamped; a mapping such as {"x": 1e-3} prescribes
        values.
    boundaries, bodies
        For each boundary name, the edges (k, 3): nodes at both ends and in the middle. For each
        body name, the indices of its cells.
    ties
        For each boundary name, components that are equal at all its nodes: "x" for a rigid line
        that moves along x. If one of the nodes is supported, all of them are.
    edge_loads
        For each boundary name, the force per length: three numbers, or f(x) of points (3, ...).
    pressures, surface_loads
        Pressure along the normals of the cells (right-handed about their corners), and force per
        area. Each is one value for all cells, or one value for each body.
    loads
        For each node, three forces and three couples.

    Raises
    ------
    ValueError
        For unknown names, missing thickness or material, folded cells, supports that contradict
        each other, or possible rigid motions.
    ArithmeticError
        If the energy of the last correction of the linear solver is above 1e-12 of the total.
    """
    points, cells = np.asarray(points, float), np.asarray(cells, int)
    _check_mesh(points, cells)
    boundaries, bodies = boundaries or {}, bodies or {}
    t = np.array(_by_cell(len(cells), thickness, bodies, "thickness"), float)
    if not np.all((t > 0) & np.isfinite(t)):
        raise ValueError(f"thickness must be positive and finite, got {t[~(t > 0)][0]:g}")
    chosen = _by_cell(len(cells), materials, bodies, "material")
    held = held_values(supports, boundaries, len(points))
    pairs = tied_unknowns(ties or {}, boundaries, len(points))
    number, held = reduced_numbers(held, pairs)
    check_rigid_motions(points, cells, held, pairs)
    f = (
        edge_forces(points, boundaries, edge_loads or {})
        + area_forces(points, cells, bodies, pressures, surface_loads)
        + node_forces(len(points), loads or {})
    )
    B, area, tangents = operator(points[cells])
    E, nu = np.array([(m.E, m.nu) for m in chosen]).T
    D = moduli(E, nu, t, area.sum(axis=1))
    u, resultants, energy, internal, residual = _solve(
        B, D, area, unknowns(cells), f.ravel(), np.where(np.isnan(held), 0, held), number
    )
    nodal = u.reshape(-1, 6)
    return ShellSolution(
        points, cells, boundaries, nodal[:, :3], nodal[:, 3:], f, internal.reshape(-1, 6) - f,
        energy, residual, t, resultants[..., :8], tangents,
    )  # fmt: skip


def _check_mesh(points: Array, cells: Indices) -> None:
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise ValueError(
            f"points must have three finite coordinates each, got shape {points.shape}"
        )
    if cells.ndim != 2 or cells.shape[1] != NODES or not len(cells):
        raise ValueError(f"cells must have nine nodes each, got shape {cells.shape}")
    if cells.min() < 0 or cells.max() >= len(points):
        raise ValueError(f"no node {cells.max()}: the shell has nodes 0 to {len(points) - 1}")
    if (idle := np.setdiff1d(np.arange(len(points)), cells)).size:
        raise ValueError(f"every node must belong to a cell, but node {idle[0]} does not")


def _by_cell(count: int, values: Any, bodies: Mapping[str, Indices], what: str) -> list[Any]:
    if not isinstance(values, Mapping):
        return [values] * count
    found: list[Any] = [None] * count
    for name, value in values.items():
        if name not in bodies:
            raise ValueError(f"no body {name!r}; bodies: {', '.join(bodies) or 'none'}")
        for i in bodies[name]:
            found[int(i)] = value
    if missing := sum(value is None for value in found):
        raise ValueError(f"every cell needs a value, but {missing} of {count} cells have no {what}")
    return found


def _solve(B, D, area, dofs, f, u, number):
    """Solve for the unknowns that `number` marks as free, from prescribed values `u`.

    Returns u, stress resultants, strain energy, internal forces and the relative energy of the last
    correction. The strains are sums over the corrections, each with full precision. Strains
    calculated from the total displacement would contain the round-off of the large rigid motion of
    slender shells.
    """
    K, free = _assemble(B, D, area, dofs, number), number >= 0
    factor = _factor(K)
    u, strained = u.copy(), _strains(B, u, dofs)
    change, stiff, correction = np.inf, abs(K), np.zeros_like(u)
    sized = np.zeros(K.shape[0])
    for _ in range(MAX_CORRECTIONS):
        resultants, energy, internal = _forces(B, D, area, dofs, strained, f.size)
        residual = np.bincount(number[free], (f - internal)[free], K.shape[0])
        step = factor(residual)
        correction[free] = step[number[free]]
        u += correction
        strained = strained + _strains(B, correction, dofs)
        sized[number[free]] = abs(u[free])
        before = change
        size = abs(f @ u) + 2 * energy + ROUND_OFF * (sized @ (stiff @ sized))
        change = abs(float(residual @ step)) / size if size else 0.0
        if change < CONVERGED or not change < before / 2:
            break
    if not change < RESIDUAL_LIMIT:
        raise ArithmeticError(
            f"the linear solver did not converge: the energy of the last correction is "
            f"{change:.1e} of the total energy, at most {RESIDUAL_LIMIT:.0e} is allowed"
        )
    resultants, energy, internal = _forces(B, D, area, dofs, strained, f.size)
    return u, resultants, energy, internal, change


def _assemble(B, D, area, dofs, number):
    """Stiffness of the free unknowns; rows of tied unknowns are added to one common row."""
    weighted = np.einsum("mst,mqtv,mq->mqsv", D, B, area, optimize=True)
    m, q, s, n = B.shape
    k = B.reshape(m, q * s, n).transpose(0, 2, 1) @ weighted.reshape(m, q * s, n)
    own = number[dofs]
    rows, columns = np.repeat(own, n, axis=1).ravel(), np.tile(own, (1, n)).ravel()
    keep = (rows >= 0) & (columns >= 0)
    size = number.max() + 1
    return csc_array(coo_array((k.ravel()[keep], (rows[keep], columns[keep])), shape=(size, size)))


def _factor(K):
    """Function that solves K x = residual for the symmetric, positive definite K."""
    if not K.shape[0]:
        return lambda residual: residual
    return Cholesky(K, ordered=False).solve


def _strains(B, u, dofs):
    return np.einsum("mqsu,mu->mqs", B, u[dofs], optimize=True)


def _forces(B, D, area, dofs, strained, size):
    """Stress resultants (m, q, s), strain energy and internal forces (unknowns,)."""
    resultants = np.einsum("mst,mqt->mqs", D, strained)
    energy = float(np.einsum("mqs,mqs,mq->", resultants, strained, area)) / 2
    at = np.einsum("mqsu,mqs,mq->mu", B, resultants, area, optimize=True)
    return resultants, energy, np.bincount(dofs.ravel(), at.ravel(), size)
