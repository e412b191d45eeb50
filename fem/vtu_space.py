"""Points, cells and fields of solutions in space, as contents of a VTU file."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Content = tuple[Array, Indices, dict[str, Array], dict[str, Array]]

ROWS, COLUMNS = [0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]  # XX, YY, ZZ, XY, YZ, XZ
HEXAHEDRON = [  # the order of the corners in VTK
    (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1),
]  # fmt: skip


def solid(solution: Any, **_more: Any) -> Content:
    """Displacements at the vertices, and mean stresses of the cells."""
    mesh, cells = solution.mesh, solution.cells
    corners = [tuple(p) for p in mesh.elem.refdom.p.T.astype(int).tolist()]
    order = [corners.index(corner) for corner in HEXAHEDRON]
    stress = _means(cells.stress(solution.u), cells.dx)
    return (
        mesh.doflocs[:, : mesh.nvertices].T, mesh.t[order].T,
        {"displacement": solution.displacement[: mesh.nvertices]},
        {"stress": _six(stress), "von_mises": _von_mises(stress)},
    )  # fmt: skip


def shell(solution: Any, **_more: Any) -> Content:
    """Displacements and rotations at the nodes, and mean stresses of the cells."""
    from fem.shell.reference import POINTS, WEIGHTS, shapes

    slopes = np.einsum("qdi,mic->mqdc", shapes(POINTS).slopes, solution.points[solution.cells])
    normals = np.cross(slopes[:, :, 0], slopes[:, :, 1])
    area = np.linalg.norm(normals, axis=-1) * WEIGHTS
    return (
        solution.points, solution.cells,
        {"displacement": solution.u, "rotation": solution.rotation},
        {
            "membrane_stress": _six(_means(solution.membrane_stress, area)),
            "bending_stress": _six(_means(solution.bending_stress, area)),
            "shear_stress": _means(solution.shear_stress, area),
        },
    )  # fmt: skip


def modes(solution: Any, *, rotor: Any, **_more: Any) -> Content:
    """Displacements of the numbered nodes of a rotor, connected along each shaft."""
    if rotor is None:
        raise ValueError(
            "modes contain no positions of nodes: give the rotor as the argument rotor"
        )
    z, shaft = rotor.z, rotor.shaft_of
    inner = sum(len(s.elements) for s in rotor.shafts) * (rotor.refine - 1)
    if solution.shapes.shape[1] != z.size + inner:
        raise ValueError(
            f"the modes must belong to the rotor, but have {solution.shapes.shape[1]} nodes; the "
            f"rotor has {z.size + inner}"
        )
    first = np.flatnonzero(shaft[1:] == shaft[:-1])
    fields: dict[str, Array] = {}
    for k, shape in enumerate(solution.shapes[:, : z.size, :3], 1):
        fields |= {f"mode_{k}_real": shape.real, f"mode_{k}_imaginary": shape.imag}
    points = np.column_stack([np.zeros((z.size, 2)), z])
    return points, np.column_stack([first, first + 1]), fields, {}


def _means(values: Array, weight: Array) -> Array:
    """Means of `values` (m, points, ...) over each cell, weighted by `weight` (m, points)."""
    total: Array = np.einsum("mq...,mq->m...", values, weight)
    return total / weight.sum(axis=1).reshape(-1, *[1] * (total.ndim - 1))


def _six(tensors: Array) -> Array:
    """Components (m, 6) XX, YY, ZZ, XY, YZ, XZ of symmetric tensors (m, 3, 3)."""
    return tensors[:, ROWS, COLUMNS]


def _von_mises(stress: Array) -> Array:
    deviator = stress - np.trace(stress, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
    return np.sqrt(1.5 * (deviator**2).sum(axis=(1, 2)))
