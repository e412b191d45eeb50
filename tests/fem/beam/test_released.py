"""Compressed frames: release of the head, paths against the linear stiffness, parts of paths."""

import numpy as np
import pytest

from fem.beam import released
from fem.beam.part import part_stiffness
from fem.beam.pressed import PressedFrame
from fem.beam.pressed_path import both_paths, drifts, free_force, slanted_force, stable_forces
from fem.beam.released import buckling_state, linear_load
from fem.beam.section import Section
from meshes.spring.centre_line import centre_line


def spring(b, h, **path):
    """An accordion spring of steel, `b` thick and `h` wide."""
    line = centre_line(**path, tail="arc", per_arc=4, per_leaf=2)
    EA = 206e9 * b * h
    section = Section(EA=EA, EI=EA * b**2 / 12, GA=5 / 6 * EA / 2.6)
    head, tail = (int(line.nodes[name]) for name in ("head", "tail"))
    return PressedFrame(line.points, line.elements, section, head, tail)


def test_where_a_head_buckles_does_not_depend_on_where_the_search_began(monkeypatch):
    # half as thick as the paper's: its stiff and soft directions differ most
    thin = spring(5e-5, 0.056, n=10, L1=11.6e-3, radius=0.5e-3, alpha=np.radians(80))
    S, rounding = thin.head_stiffness(thin.compressed([1e-3])[0])
    assert (rounding / np.sqrt(abs(np.outer(np.diag(S), np.diag(S))))).max() < 1e-11  # symmetric
    found = []
    for near in (0.8, 0.85, 0.9):
        monkeypatch.setattr(released, "NEAR", near)
        found.append(buckling_state(thin, 5e-3)[0])
    assert found == pytest.approx([found[0]] * 3, rel=1e-11)


def strip(cells, L):
    x = np.linspace(0.0, L, 2 * cells + 1)
    ends = 2 * np.arange(cells)
    points = np.column_stack([x, 0.0 * x])
    return points, np.column_stack([ends, ends + 2, ends + 1])


def test_the_linear_load_of_a_strut_that_is_hardly_bent_is_euler_s():
    """Clamped and free: pi^2 EI/(4 L^2)."""
    cells, L, section = 8, 1.0, Section(EA=1e6, EI=1.0, GA=1e6)
    points, elements = strip(cells, L)
    points[:, 1] = 1e-3 * points[:, 0] ** 2
    strut = PressedFrame(points, elements, section, head=0, tail=2 * cells)
    load, rounding = linear_load(strut)
    assert load == pytest.approx(np.pi**2 / 4 * section.EI / L**2, rel=1e-3)
    assert rounding < 1e-8 * load


LENGTH = 6.3e-3


@pytest.fixture(scope="module")
def accordion():
    return spring(0.2e-3, 10e-3, n=6, L1=8e-3, radius=0.8e-3, alpha=1.4)


def test_a_free_head_that_hardly_moves_is_linear(accordion):
    half, whole = drifts(accordion, 1e-6 * accordion.stiffness * LENGTH, (0.5, 1.0))
    assert whole == pytest.approx(2 * half, rel=1e-4)
    U = 1e-5 * LENGTH
    assert free_force(accordion, np.array([U])) == pytest.approx(accordion.stiffness * U, rel=1e-3)


def test_a_straight_path_is_the_guided_one(accordion):
    (guided,) = stable_forces(accordion, LENGTH, (0.02,))
    F_x, _ = slanted_force(accordion, 0.02 * LENGTH, 0.0)
    assert F_x == pytest.approx(guided, rel=1e-9)
    assert guided > accordion.stiffness * 0.02 * LENGTH  # the guide stiffens it


def test_paths_begin_with_the_determinants_at_rest(accordion):
    paths = both_paths(accordion, LENGTH, 0.1)
    assert paths["free"][0, 3] == pytest.approx(1.0, abs=0.1)
    assert paths["guided"][0, 3] == pytest.approx(1.0, abs=0.1)
    assert paths["free"][0, 1] == pytest.approx(0.01 * LENGTH)
    assert paths["free_shape"].shape == (len(accordion.elements), 3, 2)


def test_a_straight_strip_has_the_stiffnesses_of_its_ends_about_its_middle():
    """Across, the moment changes its sign in the middle: L^3/(12 E I) and shear."""
    L, STRIP = 2.0, Section(EA=300.0, EI=5.0, GA=70.0)
    points, elements = strip(4, L)
    found = part_stiffness(points, elements, STRIP, (0.0, 0.0), (L, 0.0))
    assert found["turn"] == pytest.approx(STRIP.EI / L, rel=1e-9)
    assert found["axial"] == pytest.approx(STRIP.EA / L, rel=1e-9)
    across = L**3 / (12 * STRIP.EI) + L / STRIP.GA
    assert found["lateral"] == pytest.approx(1 / across, rel=1e-6)
    # elements outside the part do not count
    half = part_stiffness(points, elements[:2], STRIP, (0.0, 0.0), (L / 2, 0.0))
    assert half["turn"] == pytest.approx(2 * STRIP.EI / L, rel=1e-9)
