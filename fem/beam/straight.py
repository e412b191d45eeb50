"""Plane frames of straight elements with closed-form stiffness (Euler-Bernoulli, Timoshenko).

The solution is exact at the nodes for straight members under nodal loads. Arcs are approximated by
inscribed polygons; the error is of second order in the element length.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.sparse import coo_array, csc_array

from fem.beam.links import Link, divide, ties
from fem.beam.section import (
    Array,
    Bodies,
    FrameSolution,
    Indices,
    Loads,
    Sections,
    Supports,
    check_elements,
    element_sections,
    solve_supported,
)


def solve_frame(
    points: ArrayLike,
    elements: ArrayLike,
    *,
    sections: Sections,
    supports: Supports,
    loads: Loads,
    bodies: Bodies | None = None,
    distributed: Mapping[int, tuple[float, float]] | None = None,
    links: Sequence[Link] = (),
) -> FrameSolution:
    """Solve a plane frame.

    Parameters
    ----------
    points, elements
        Nodes (n, 2), and two nodes for each element (m, 2).
    sections
        One section, or a section for each of `bodies` (name to element numbers).
    supports
        For each node, the fixed components "x", "y", "r", or a mapping to prescribed values.
    loads
        For each node, force (x, y) and couple.
    distributed
        For each element, a uniform force per length (x, y).
    links
        Rigid links between nodes or points inside elements. A linked element is divided at the
        linked point. In the solution, new nodes and elements are numbered after the given ones.

    Raises
    ------
    ValueError
        For unknown nodes or bodies, elements without length, or frames that can move rigidly.
    ArithmeticError
        If the relative error of the linear solution is above 1e-6.
    """
    points, elements = np.asarray(points, float), np.asarray(elements, int)
    check_elements(len(points), elements)
    whole = element_sections(len(elements), sections, bodies)
    for e in distributed or {}:
        if not 0 <= e < len(elements):
            raise ValueError(f"no element {e}: the frame has elements 0 to {len(elements) - 1}")
    cut = divide(points, elements, links)
    points, elements = cut.points, cut.elements
    chosen = [whole[e] for e in cut.parent]
    d = points[elements[:, 1]] - points[elements[:, 0]]
    length = np.hypot(*d.T)
    if length.min() <= 0:
        raise ValueError(f"the length of element {int(length.argmin())} must not be zero")
    EA, EI, GA = np.array([(s.EA, s.EI, s.GA) for s in chosen]).T
    k, T = _stiffness(length, EA, EI, 12 * EI / (GA * length**2)), _rotation(d / length[:, None])
    dofs = (3 * elements[:, :, None] + np.arange(3)).reshape(-1, 6)
    K = _assemble(np.einsum("eki,ekl,elj->eij", T, k, T), dofs, 3 * len(points))
    f = np.zeros(3 * len(points))
    between, fixed_end = 0.0, np.zeros((len(elements), 6))
    for e, given in enumerate(cut.parent):
        if given not in (distributed or {}):
            continue
        L, q = length[e], (distributed or {})[given]
        axial, across = T[e, :2, :2] @ q
        local = np.array([axial, across, across * L / 6, axial, across, -across * L / 6]) * L / 2
        f[dofs[e]] += T[e].T @ local
        fixed_end[e] = local
        between += axial**2 * L**3 / (24 * EA[e])
        between += across**2 * (L**5 / (1440 * EI[e]) + L**3 / (24 * GA[e]))

    tangent, phi = d / length[:, None], 12 * EI / (GA * length**2)
    bend = EI / (length * (1 + phi))

    def strains(u: Array) -> Array:
        return _deformation(u, elements, tangent, length)

    def resultants(strains: Array) -> Array:
        """Axial forces and end couples (3, m), the work conjugates of `strains`."""
        stretch, first, second = strains
        return np.array([
            EA / length * stretch,
            bend * ((4 + phi) * first + (2 - phi) * second),
            bend * ((2 - phi) * first + (4 + phi) * second),
        ])  # fmt: skip

    def forces(strains: Array) -> tuple[float, Array]:
        held = resultants(strains)
        internal = _end_forces(held, elements, tangent, length, len(points))
        return float(np.sum(held * strains)) / 2, internal

    solved, strained = solve_supported(
        points, elements, K, f, supports, loads, strains, forces, ties(len(points), links, cut.ends)
    )
    section_forces = _section_forces(resultants(strained), length, fixed_end)
    return replace(
        solved, strain_energy=solved.strain_energy + between, between_nodes=between,
        stations=points[elements], section_forces=section_forces,
    )  # fmt: skip


def _section_forces(held: Array, L: Array, fixed_end: Array) -> Array:
    """N, V and bending moment (m, 2, 3) at both ends of each element, from N and end couples.

    `fixed_end` (m, 6) are the fixed-end forces of the loads along the elements.
    """
    N, M = held[0], held[1:]
    V = -M.sum(axis=0) / L
    at_nodes = np.column_stack([-N, -V, M[0], N, V, M[1]]) - fixed_end  # nodes on element
    return at_nodes.reshape(-1, 2, 3) * np.array([[-1.0], [1.0]])


def _deformation(u: Array, elements: Indices, tangent: Array, L: Array) -> Array:
    """Elongation, and rotations of both ends relative to the rotated chord (3, m)."""
    step = u[elements[:, 1], :2] - u[elements[:, 0], :2]
    stretch = (step * tangent).sum(axis=1)
    chord = (tangent[:, 0] * step[:, 1] - tangent[:, 1] * step[:, 0]) / L
    return np.array([stretch, *(u[elements, 2].T - chord)])


def _end_forces(held: Array, elements: Indices, tangent: Array, L: Array, nodes: int) -> Array:
    """Nodal forces and couples (nodes, 3) in balance with axial forces and end couples."""
    N, M = held[0], held[1:]
    V = M.sum(axis=0) / L  # the chord's rotation does this work, with the opposite sign
    pull = N[:, None] * tangent - V[:, None] * np.column_stack([-tangent[:, 1], tangent[:, 0]])
    total = np.zeros((nodes, 3))
    np.add.at(total[:, :2], elements[:, 1], pull)
    np.add.at(total[:, :2], elements[:, 0], -pull)
    np.add.at(total[:, 2], elements.T, M)
    return total


def _stiffness(L: Array, EA: Array, EI: Array, phi: Array) -> Array:
    """Local stiffness (m, 6, 6); phi = 12 EI / (GA L^2) is zero without shear."""
    k = np.zeros((L.size, 6, 6))
    a, c = EA / L, EI / (L**3 * (1 + phi))
    k[:, 0, 0] = k[:, 3, 3] = a
    k[:, 0, 3] = k[:, 3, 0] = -a
    k[:, 1, 1] = k[:, 4, 4] = 12 * c
    k[:, 1, 4] = k[:, 4, 1] = -12 * c
    for i, j, sign in ((1, 2, 1), (1, 5, 1), (2, 4, -1), (4, 5, -1)):
        k[:, i, j] = k[:, j, i] = sign * 6 * L * c
    k[:, 2, 2] = k[:, 5, 5] = (4 + phi) * L**2 * c
    k[:, 2, 5] = k[:, 5, 2] = (2 - phi) * L**2 * c
    return k


def _rotation(tangent: Array) -> Array:
    """Rotation matrices (m, 6, 6) from global to local components."""
    c, s = tangent.T
    T = np.zeros((len(tangent), 6, 6))
    for o in (0, 3):
        T[:, o, o] = T[:, o + 1, o + 1] = c
        T[:, o, o + 1], T[:, o + 1, o] = s, -s
        T[:, o + 2, o + 2] = 1
    return T


def _assemble(k: Array, dofs: Indices, size: int) -> csc_array:
    rows = np.repeat(dofs, 6, axis=1).ravel()
    columns = np.tile(dofs, (1, 6)).ravel()
    return csc_array(coo_array((k.ravel(), (rows, columns)), shape=(size, size)))
