"""Pressed frames whose head is let go: stiffness of the head, loads and places, to rounding."""

import numpy as np
import pytest

from fem.beam import released
from fem.beam.pressed import PressedFrame
from fem.beam.released import gives_way, linear_load
from fem.beam.section import Section
from meshes.spring.centre_line import centre_line

PATH = {"n": 10, "L1": 11.6e-3, "radius": 0.5e-3, "alpha": np.radians(80), "tail": "arc"}


def spring(path, *, b, h, E, nu, per_arc, per_leaf):
    line = centre_line(**path, per_arc=per_arc, per_leaf=per_leaf)
    EA = E * b * h
    section = Section(EA=EA, EI=EA * b**2 / 12, GA=5 / 6 * EA / (2 * (1 + nu)))
    head, tail = line.nodes["head"], line.nodes["tail"]
    return PressedFrame(line.points, line.elements, section, head, tail)


SLENDER = {"b": 5e-5, "h": 0.056, "E": 206e9, "nu": 0.3, "per_arc": 4, "per_leaf": 2}


@pytest.fixture
def thin():
    """A strip half as thick as the paper's, whose stiff and soft directions are furthest apart."""
    return spring(PATH, **SLENDER)


def test_the_head_s_stiffness_is_symmetric_though_nothing_makes_it_so(thin):
    state = thin.compressed([1e-3])[0]
    S, rounding = thin.head_stiffness(state)
    assert (rounding / np.sqrt(abs(np.outer(np.diag(S), np.diag(S))))).max() < 1e-11


def test_where_a_head_gives_way_does_not_depend_on_where_the_search_began(thin, monkeypatch):
    found = []
    for near in (0.8, 0.85, 0.9):
        monkeypatch.setattr(released, "NEAR", near)
        found.append(gives_way(thin, 5e-3)[0])
    assert found == pytest.approx([found[0]] * 3, rel=1e-11)


def test_the_linear_load_of_a_strut_that_is_hardly_bent_is_euler_s():
    """Clamped and free: pi^2 EI/(4 L^2)."""
    cells, L, section = 8, 1.0, Section(EA=1e6, EI=1.0, GA=1e6)
    x = np.linspace(0.0, L, 2 * cells + 1)
    first = 2 * np.arange(cells)
    strut = PressedFrame(
        np.column_stack([x, 1e-3 * x**2]), np.column_stack([first, first + 2, first + 1]),
        section, head=0, tail=2 * cells,
    )  # fmt: skip
    load, rounding = linear_load(strut)
    assert load == pytest.approx(np.pi**2 / 4 * section.EI / L**2, rel=1e-3)
    assert rounding < 1e-8 * load
