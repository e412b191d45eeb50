"""Materials of the bodies of a plane mesh, loads on its cells and boundaries, by name.

Loads are forces (unknowns,) for unit thickness or, with `turn`, for the full circumference about
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
    """Forces (unknowns,) of the pressure `p` (m, q) on facets, per length of them."""
    return -side.load(p * np.asarray(side.normals))


def moduli(
    mesh: Mesh2D, materials: Elastic | Mapping[str, Elastic], assumption: Assumption
) -> tuple[Array, Array, Array]:
    """lambda, mu and sigma_zz/(sigma_xx + sigma_yy) of every cell; ValueError for bare cells."""
    table = np.full((3, mesh.nelements), np.nan)
    named = {None: materials} if isinstance(materials, Elastic) else materials
    for body, material in named.items():
        cells = slice(None) if body is None else named_cells(mesh, body)
        constants = *material.lame_constants(assumption), material.normal_stress_ratio(assumption)
        table[:, cells] = np.reshape(constants, (3, 1))
    if bare := int(np.isnan(table[0]).sum()):
        raise ValueError(f"{bare} of {mesh.nelements} cells have no material: name every body")
    return table[0], table[1], table[2]


def surface_load(
    basis: Basis,
    pressures: Mapping[str, Pressure],
    tractions: Mapping[str, Vector],
    *,
    turn: bool = False,
) -> Array:
    """Forces of `pressures` (positive inwards) and `tractions` [stress] on named boundaries."""
    f = np.zeros(basis.N)
    for name, pressure in pressures.items():
        side = _wall(basis, name, outer_facets(basis.mesh, name), turn)
        x = np.asarray(side.global_coordinates())
        p = pressure(x) if callable(pressure) else pressure
        if not np.all(np.isfinite(p)):
            raise ValueError(f"the pressure on {name!r} is not finite")
        f += push(side, p * depth(x, turn))
    for name, traction in tractions.items():
        side = _wall(basis, name, named_facets(basis.mesh, name), turn)
        x = np.asarray(side.global_coordinates())
        f += side.load(_vector(traction, x) * depth(x, turn))
    return f


def force_load(
    basis: Basis, forces: Mapping[str, tuple[float, float]], *, turn: bool = False
) -> Array:
    """Totals `forces` [force] on named boundaries, each uniformly distributed over its boundary.

    A total acts on the whole thickness or circumference. ValueError for a radial total on a body of
    revolution, which has no resultant.
    """
    f = np.zeros(basis.N)
    for name, force in forces.items():
        if turn and force[0] != 0:
            raise ValueError(
                f"the force on {name!r} has the radial part {force[0]:g}, but a radial force has "
                "no resultant on a body of revolution: use tractions or pressures"
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
    """Forces of `forces` per volume [force / length^3], on all cells or by body."""
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
    """Forces at nodes, by coordinates; with `turn`, totals on rings.

    ValueError if there is no node at the point, and for a radial force on the axis.
    """
    f = np.zeros(basis.N)
    for point, force in forces.items():
        if turn and force[0] != 0 and on_axis(basis.mesh, np.array(point)):
            raise ValueError(
                f"the point force at {tuple(point)} has the radial part {force[0]:g}: on the axis "
                "a force can only be axial"
            )
        f[nearest_node(basis, point)] += force
    return f


def _wall(basis: Basis, name: str, facets: Indices, turn: bool) -> Trace:
    """`basis` on the `facets` of boundary `name`; ValueError if they have no area by rotation."""
    if turn and not has_area(basis.mesh, facets):
        raise ValueError(f"a load on {name!r} has no area to act on: it lies on the axis, r = 0")
    return facet_basis(basis, facets)


def _vector(value: Vector, x: Array) -> Array:
    given = value(x) if callable(value) else np.reshape(value, (2, 1, 1))
    if not np.all(np.isfinite(given)):
        raise ValueError(f"a load vector is not finite: {value}")
    return np.broadcast_to(np.asarray(given, float), x.shape).copy()
