"""The spring's strip: a narrow one is a beam in plane stress, a wide one in plane strain."""

from math import radians

import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.strip import swept_path
from meshes.spring.centre_line import centre_line
from meshes.spring.path import accordion

E, NU, B = 206e3, 0.3, 0.1  # MPa, mm
STEEL = Elastic(E=E, nu=NU)
SPRING = {"n": 4, "L1": 11.6, "radius": 0.5, "alpha": radians(80)}
FREE, GUIDED = "", "yabc"


def shell_stiffness(path, h, *, head, refined=1, per_leaf=6, material=STEEL, edge=""):
    """Force along x per width over the movement of the head's line, which stays straight."""
    mesh = swept_path(
        path, width=h / 2, per_arc=3 * refined, per_leaf=per_leaf * refined,
        across=1 if edge else 6 * refined, finest=0.08 / refined, leaf_ends=0.1,
    )  # fmt: skip
    s = solve_shell(
        mesh.points, mesh.cells, thickness=B, materials=material,
        boundaries=mesh.boundaries, ties={"head": "x"}, edge_loads={"head": (1.0, 0, 0)},
        supports={"tail": "xyzabc", "middle": "zab", "head": head, "edge": edge},
    )  # fmt: skip
    return -(h / 2) / (2 * s.potential_energy)


def beam_stiffness(*, head, wide):
    line = centre_line(**SPRING, per_arc=12, per_leaf=8)
    modulus = E / (1 - NU**2) if wide else E
    section = Section(EA=modulus * B, EI=modulus * B**3 / 12, GA=5 / 6 * E * B / (2 * (1 + NU)))
    held = {line.nodes["tail"]: "xyr"} | ({line.nodes["head"]: "yr"} if head else {})
    s = solve_curved_frame(
        line.points, line.elements, sections=section, supports=held,
        loads={line.nodes["head"]: (1.0, 0, 0)},
    )  # fmt: skip
    return -1 / (2 * s.potential_energy)


def factor(h, head, **mesh):
    path = accordion(**SPRING, tail="arc")
    return shell_stiffness(path, h, head=head, **mesh) / beam_stiffness(head=head, wide=False)


def test_a_strip_narrower_than_thick_is_a_beam_in_plane_stress():
    assert factor(0.02, FREE) == pytest.approx(1, abs=5e-4)


def test_an_endless_strip_is_a_beam_in_plane_strain():
    head = GUIDED
    limit = beam_stiffness(head=head, wide=True) / beam_stiffness(head=head, wide=False)
    assert limit == pytest.approx(1 / (1 - NU**2), rel=1e-4)  # shear stays as it is
    assert factor(1000.0, head) == pytest.approx(limit, abs=5e-4)
