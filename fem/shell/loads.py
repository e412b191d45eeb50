"""Loads on a shell: pressures, forces per area, forces per length of an edge, nodal forces."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from fem.shell.reference import POINTS, WEIGHTS, Array, Indices, gauss
from fem.shell.strains import Frame
from fem.shell.supports import Boundaries, nodes_of

Vector = tuple[float, float, float] | Callable[[Array], Any]
Pressure = float | Callable[[Array], Any]
_X, _W = gauss(3)
_N = np.array([(1 - _X) * (1 - 2 * _X), _X * (2 * _X - 1), 4 * _X * (1 - _X)]).T
_dN = np.array([4 * _X - 3, 4 * _X - 1, 4 - 8 * _X]).T


def edge_points(corners: Array) -> tuple[Array, Array]:
    """Points (m, 3, 3) and lengths ds (m, 3) at the Gauss points of edges (m, 3 nodes, 3)."""
    at = np.einsum("qi,mic->mqc", _N, corners)
    return at, np.linalg.norm(np.einsum("qi,mic->mqc", _dN, corners), axis=-1) * _W


def edge_average(points: Array, edges: Indices, values: Array) -> Array:
    """Mean of nodal values (nodes, c) over the length of edges (m, 3)."""
    _, ds = edge_points(points[edges])
    return np.asarray(np.einsum("mq,qi,mic->c", ds, _N, values[edges]) / ds.sum())


def edge_forces(points: Array, boundaries: Boundaries, loads: Mapping[str, Vector]) -> Array:
    """Nodal forces (nodes, 6) from forces per length along named edges."""
    f = np.zeros((len(points), 6))
    for name, load in loads.items():
        nodes_of(name, boundaries, len(points))
        edges = boundaries[name]
        at, ds = edge_points(points[edges])
        forces = np.einsum("mq,qi,mqc->mic", ds, _N, _vectors(load, at, name))
        np.add.at(f[:, :3], edges, forces)
    return f


def area_forces(
    points: Array,
    cells: Indices,
    bodies: Mapping[str, Indices],
    pressures: Pressure | Mapping[str, Pressure],
    surface_loads: Vector | Mapping[str, Vector],
) -> Array:
    """Nodal forces (nodes, 6) from pressures along the normals and from forces per area."""
    at = Frame.of(points[cells], POINTS)
    x = np.einsum("qi,mic->mqc", at.N, points[cells])
    density = np.zeros_like(x)
    for own, pressure in _by_body(pressures, bodies, len(cells)):
        value = pressure(np.moveaxis(x[own], -1, 0)) if callable(pressure) else pressure
        density[own] += np.broadcast_to(value, x[own].shape[:-1])[..., None] * at.n[own]
    for own, load in _by_body(surface_loads, bodies, len(cells)):
        density[own] += _vectors(load, x[own], "surface load")
    f = np.zeros((len(points), 6))
    forces = np.einsum("mq,q,qi,mqc->mic", at.area, WEIGHTS, at.N, density)
    np.add.at(f[:, :3], cells, forces)
    return f


def node_forces(count: int, loads: Mapping[int, Any]) -> Array:
    """Forces and couples (nodes, 6) from loads given for single nodes."""
    f = np.zeros((count, 6))
    for node, load in loads.items():
        nodes_of(node, {}, count)
        if np.shape(load) != (6,):
            raise ValueError(f"node {node}: a load must have 3 forces and 3 couples, got {load}")
        f[node] += load
    return f


def _vectors(load: Vector, at: Array, name: str) -> Array:
    """Values (..., 3) of a constant load or a load function at points (..., 3)."""
    value = np.asarray(load(np.moveaxis(at, -1, 0)) if callable(load) else load, float)
    if callable(load):
        value = np.moveaxis(value, 0, -1)
    if value.shape[-1:] != (3,):
        raise ValueError(f"{name!r}: a load must have three components, got shape {value.shape}")
    return np.broadcast_to(value, at.shape)


def _by_body(loads: Any, bodies: Mapping[str, Indices], count: int) -> list[tuple[Indices, Any]]:
    if not isinstance(loads, Mapping):
        return [(np.arange(count), loads)]
    for name in loads:
        if name not in bodies:
            raise ValueError(f"no body {name!r}; bodies: {', '.join(bodies) or 'none'}")
    return [(np.asarray(bodies[name]), load) for name, load in loads.items()]
