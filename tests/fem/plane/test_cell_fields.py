"""Fields of cells: parts about a place, means at nodes, largest shear."""

import numpy as np

from fem.plane.cell_fields import at_nodes, cut_out, largest_shear


def test_values_at_nodes_are_means_of_the_cells_about_them_weighed_by_area():
    points = np.array([[0.0, 0], [1, 0], [4, 0], [0, 1], [1, 1], [4, 1]])
    cells = np.array([[0, 1, 4, 3], [1, 2, 5, 4]])
    at = at_nodes(points, cells, np.array([[8.0, 1.0], [4.0, 1.0]]))
    assert at[:, 0].tolist() == [8.0, 5.0, 4.0, 8.0, 5.0, 4.0]  # areas 1 and 3
    assert np.all(at[:, 1] == 1)


def test_cells_are_cut_out_with_the_points_and_values_that_are_theirs():
    points = np.array([[0.0, 0], [1, 0], [4, 0], [0, 1], [1, 1], [4, 1]])
    whole = {"points": points, "cells": np.array([[0, 1, 4, 3], [1, 2, 5, 4]]),
             "displacement": 2 * points, "stress": np.array([[1.0] * 4, [2.0] * 4]),
             "von_mises": np.array([3.0, 4.0])}  # fmt: skip
    left = cut_out(whole, lambda centre: centre[:, 0] > 1)
    assert left["points"][left["cells"]].tolist() == points[[[1, 2, 5, 4]]].tolist()
    assert np.array_equal(left["displacement"], 2 * left["points"])
    assert left["stress"].tolist() == [[2.0] * 4]
    assert left["von_mises"].tolist() == [4.0]


def test_the_largest_shear_does_not_change_as_the_stress_is_turned():
    xx, yy, xy, t = 3.0, -1.0, 2.0, 0.7
    c, s = np.cos(2 * t), np.sin(2 * t)
    middle, half = (xx + yy) / 2, (xx - yy) / 2
    turned = [middle + half * c + xy * s, middle - half * c - xy * s, xy * c - half * s, 5.0]
    one, other = largest_shear(np.array([[xx, yy, xy, 5.0], turned]))
    assert abs(one - other) < 1e-14
