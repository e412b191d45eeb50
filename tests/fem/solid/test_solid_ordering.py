"""Nested dissection keeps the factors of solids small."""

from math import pi

import numpy as np
from scipy.sparse import csr_array, eye_array
from scipy.sparse.linalg import splu

from fem.plane.factors import SUPERLU
from fem.solid.ordering import nested_dissection
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

FOLDED = (
    Piece("leaf", 0.0, 0.0, pi / 2, 5.0, 0.0, 1),
    Piece("arc", 0.0, 5.0, pi / 2, 0.5 * pi / 2, -pi / 2, 1),
    Piece("arc", 0.5, 5.5, 0.0, 0.5 * pi / 2, -pi / 2, 1),
    Piece("leaf", 1.0, 5.0, -pi / 2, 5.0, 0.0, 1),
)


def fold():
    return solid_strip(FOLDED, b=0.1, width=3.0, through=1, per_arc=6, per_leaf=20, across=5)


def fill(mesh, place, **order):
    """Entries of the factor of a matrix that couples all nodes of a cell, in the given order."""
    nodes = place[np.asarray(mesh.dofs.element_dofs)]
    size, cells = nodes.shape
    of_cell = np.tile(np.arange(cells), size)
    share = csr_array((np.ones(nodes.size), (nodes.ravel(), of_cell)), (place.size, cells))
    return splu((share @ share.T + 100 * eye_array(place.size)).tocsc(), **SUPERLU | order).L.nnz


def test_factors_are_about_as_small_as_by_minimum_degree():
    mesh = fold()
    place = nested_dissection(mesh)
    assert np.array_equal(np.sort(place), np.arange(mesh.doflocs.shape[1]))
    ours = fill(mesh, place)
    least = fill(mesh, np.arange(mesh.doflocs.shape[1]), permc_spec="MMD_AT_PLUS_A")
    assert ours < 1.3 * least
