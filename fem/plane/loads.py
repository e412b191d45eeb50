"""Materials of the bodies of a plane mesh, and loads on cells and boundaries, by name.

Loads are forces (unknowns,) per unit thickness or, with `turn`, for the full circumference about
the y axis; x is then the radius.
"""

from collections.abc import Callable, Mapping

import numpy as np
from skfem import Basis, LinearForm
from skfem.helpers import dot
from skfem.mesh import Mesh2D

from fem.plane.axis import depth, has_area, on_axis
from fem.plane.discretisation import (
    Array,
    Indices,
    facet_basis,
    named_cells,
    named_facets,
    outer_facets,
)
from fem.plane.material import Assumption, Elastic
from fem.plane.supports import nearest_node
from fem.plane.traces import Trace

Pressure = float | Callable[[Array], Array]
Vector = tuple[float, float] | Callable[[Array], Array]


@LinearForm
def pull(v, w):
    return dot(w.t, v)


def push(side: Trace, p: Array) -> Array:
    """Forces (unknowns,) of the load `p` (m, q) per unit length of facets, directed inwards."""
    return -side.load(p * np.asarray(side.normals))


def moduli(
    mesh: Mesh2D, materials: Elastic | Mapping[str, Elastic], assumption: Assumption
) -> tuple[Array, Array, Array]:
    """Moduli lambda, mu and the ratio sigma_zz/(sigma_xx + sigma_yy) of every cell.

    Raises ValueError for cells without a material.
    """
    table = np.full((3, mesh.nelements), np.nan)
    named = {None: materials} if isinstance(materials, Elastic) else materials
    for body, material in named.items():
        cells = slice(None) if body is None else named_cells(mesh, body)
        constants = *material.lame_constants(assumption), material.normal_stress_ratio(assumption)
        table[:, cells] = np.reshape(constants, (3, 1))
    if bare := int(np.isnan(table[0]).sum()):
        raise ValueError(
            f"every cell needs a material, but {bare} of {mesh.nelements} cells have no material: "
            "give every body of the mesh a name and a material"
        )
    return table[0], table[1], table[2]


def surface_load(
    basis: Basis,
    pressures: Mapping[str, Pressure],
    tractions: Mapping[str, Vector],
    *,
    turn: bool = False,
) -> Array:
    """Forces (unknowns,) of `pressures` (positive inwards) and `tractions` on named boundaries."""
    f = np.zeros(basis.N)
    for name, pressure in pressures.items():
        side = _wall(basis, name, outer_facets(basis.mesh, name), turn)
        x = np.asarray(side.global_coordinates())
        p = pressure(x) if callable(pressure) else pressure
        if not np.all(np.isfinite(p)):
            raise ValueError(f"the pressure on {name!r} must be finite")
        f += push(side, p * depth(x, turn))
    for name, traction in tractions.items():
        side = _wall(basis, name, named_facets(basis.mesh, name), turn)
        x = np.asarray(side.global_coordinates())
        f += side.load(_vector(traction, x) * depth(x, turn))
    return f


def force_load(
    basis: Basis, forces: Mapping[str, tuple[float, float]], *, turn: bool = False
) -> Array:
    """Forces (unknowns,) of total `forces` on named boundaries, each distributed uniformly.

    Each total force acts on the whole thickness or circumference. Raises ValueError for a radial
    force on a body of revolution, because radial loads around the axis have no resultant.
    """
    f = np.zeros(basis.N)
    for name, force in forces.items():
        if turn and force[0] != 0:
            raise ValueError(
                f"the force on {name!r} has the radial component {force[0]:g}, but a radial force "
                "has no resultant on a body of revolution: use tractions or pressures"
            )
        side = _wall(basis, name, named_facets(basis.mesh, name), turn)
        x = np.asarray(side.global_coordinates())
        around = depth(x, turn)
        area = float((side.dx * around).sum())
        f += side.load(_vector((force[0] / area, force[1] / area), x) * around)
    return f


def body_load(
    basis: Basis, forces: Vector | Mapping[str, Vector] | None, *, turn: bool = False
) -> Array:
    """Forces (unknowns,) of `forces` per volume [force / length^3], on all cells or by body."""
    f = np.zeros(basis.N)
    if forces is None:
        return f
    named = forces if isinstance(forces, Mapping) else {None: forces}
    for body, force in named.items():
        part = basis
        if body is not None:
            cells = named_cells(basis.mesh, body)
            part = Basis(
                basis.mesh, basis.elem, quadrature=basis.quadrature, elements=cells, dofs=basis.dofs
            )
        x = np.asarray(part.global_coordinates())
        f += pull.assemble(part, t=_vector(force, x) * depth(x, turn))
    return f


def point_load(
    basis: Basis,
    forces: Mapping[tuple[float, float], tuple[float, float]],
    *,
    turn: bool = False,
) -> Array:
    """Forces (unknowns,) of point forces at nodes; the nodes are given by their coordinates.

    With `turn`, a node is a ring, and each force is the total on the ring. Raises ValueError if
    there is no node at the point, and for a radial force on the axis.
    """
    f = np.zeros(basis.N)
    for point, force in forces.items():
        if turn and force[0] != 0 and on_axis(basis.mesh, np.array(point)):
            raise ValueError(
                f"the point force at {tuple(point)} must be axial, because the point is on the "
                f"axis, but it has the radial component {force[0]:g}"
            )
        f[nearest_node(basis, point)] += force
    return f


def _wall(basis: Basis, name: str, facets: Indices, turn: bool) -> Trace:
    """Basis on the `facets` of boundary `name`.

    Raises ValueError if all facets are on the axis of revolution, where they have no area.
    """
    if turn and not has_area(basis.mesh, facets):
        raise ValueError(
            f"boundary {name!r} has no area for a load, because it lies on the axis, r = 0"
        )
    return facet_basis(basis, facets)


def _vector(value: Vector, x: Array) -> Array:
    given = value(x) if callable(value) else np.reshape(value, (2, 1, 1))
    if not np.all(np.isfinite(given)):
        raise ValueError(f"a load vector must be finite, got {value}")
    return np.broadcast_to(np.asarray(given, float), x.shape).copy()
