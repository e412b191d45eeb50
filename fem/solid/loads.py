"""Materials of the bodies of a solid, and loads on its cells and boundaries, by name."""

from collections.abc import Callable, Mapping

import numpy as np
from skfem.mesh import Mesh3D

from fem.plane.discretisation import named_cells, named_facets
from fem.plane.material import Elastic
from fem.solid.cells import Cells
from fem.solid.geometry import Array, Faces, faces
from fem.solid.places import Place, nodes_at

Vector = tuple[float, float, float] | Callable[[Array], Array]
Pressure = float | Callable[[Array], Array]


def moduli(mesh: Mesh3D, materials: Elastic | Mapping[str, Elastic]) -> tuple[Array, Array]:
    """Lamé's lambda and mu (cells,) [stress]. Raises ValueError for cells without a material."""
    table = np.full((2, mesh.nelements), np.nan)
    named = {None: materials} if isinstance(materials, Elastic) else materials
    for body, material in named.items():
        cells = slice(None) if body is None else named_cells(mesh, body)
        # the constants of plane strain are those of space
        table[:, cells] = np.reshape(material.lame_constants("plane strain"), (2, 1))
    if bare := int(np.isnan(table[0]).sum()):
        raise ValueError(
            f"every cell needs a material, but {bare} of {mesh.nelements} cells have no material: "
            "give a material for every body of the mesh"
        )
    return table[0], table[1]


def traction_load(mesh: Mesh3D, cells: Cells, tractions: Mapping[str, Vector]) -> Array:
    """Nodal forces (unknowns,) due to `tractions` [stress] on named boundaries."""
    f = np.zeros(3 * cells.count)
    for name, traction in tractions.items():
        for side in faces(mesh, named_facets(mesh, name)):
            size = np.linalg.norm(side.area, axis=-1, keepdims=True)
            f += _on_faces(cells, side, _vectors(traction, side.x, f"traction on {name!r}") * size)
    return f


def pressure_load(mesh: Mesh3D, cells: Cells, pressures: Mapping[str, Pressure]) -> Array:
    """Nodal forces (unknowns,) due to inward `pressures` [stress] on named outer boundaries."""
    f = np.zeros(3 * cells.count)
    for name, pressure in pressures.items():
        facets = named_facets(mesh, name)
        if np.any(mesh.f2t[1, facets] >= 0):
            raise ValueError(
                f"boundary {name!r} lies inside the mesh and has no outward normal: use tractions"
            )
        for side in faces(mesh, facets):
            p = pressure(side.x.transpose(2, 0, 1)) if callable(pressure) else pressure
            if not np.all(np.isfinite(p)):
                raise ValueError(f"the pressure on {name!r} must be finite")
            f -= _on_faces(cells, side, np.asarray(p, float)[..., None] * side.area)
    return f


def body_load(mesh: Mesh3D, cells: Cells, force: Vector | None) -> Array:
    """Nodal forces (unknowns,) due to `force` [force / length^3] on all cells."""
    if force is None:
        return np.zeros(3 * cells.count)
    x = cells.N @ mesh.doflocs.T[cells.nodes]
    return cells.body_force(_vectors(force, x, "body force"))


def node_load(mesh: Mesh3D, forces: Mapping[Place, tuple[float, float, float]]) -> Array:
    """Nodal forces (unknowns,): `forces` [force], divided equally between the nodes of a place."""
    f = np.zeros((mesh.doflocs.shape[1], 3))
    for place, force in forces.items():
        if np.shape(force) != (3,) or not np.all(np.isfinite(force)):
            raise ValueError(
                f"the force at {place!r} must have three finite components, got {force}"
            )
        nodes = nodes_at(mesh, place)
        f[nodes] += np.asarray(force) / nodes.size
    return f.ravel()


def _on_faces(cells: Cells, side: Faces, force: Array) -> Array:
    """Nodal forces (unknowns,) due to `force` (faces, points, 3) at the points of `side`."""
    parts = side.N.T @ force
    return np.array([
        np.bincount(side.nodes.ravel(), parts[..., i].ravel(), cells.count) for i in range(3)
    ]).T.ravel()  # fmt: skip


def _vectors(value: Vector, x: Array, what: str) -> Array:
    """Load vectors (m, q, 3) at the points `x` (m, q, 3)."""
    given = value(x.transpose(2, 0, 1)) if callable(value) else np.reshape(value, (3, 1, 1))
    if not np.all(np.isfinite(given)):
        raise ValueError(f"{what}: load vectors must be finite")
    return np.broadcast_to(np.asarray(given, float), (3, *x.shape[:2])).transpose(1, 2, 0)
