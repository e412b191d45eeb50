"""The spring's strip: a narrow one is a beam in plane stress, a wide one in plane strain."""

from math import radians

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.strip import swept_path
from meshes.spring.centre_line import centre_line
from meshes.spring.path import Piece, accordion

E, NU, B = 206e3, 0.3, 0.1  # MPa, mm
STEEL = Elastic(E=E, nu=NU)
# of which a plate with held edges bends as one of steel in plane stress
PLANE_STRESS = Elastic(E=E * (1 + 2 * NU) / (1 + NU) ** 2, nu=NU / (1 + NU))
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


@pytest.mark.parametrize("head", [FREE, GUIDED])
@pytest.mark.parametrize(("material", "wide"), [(PLANE_STRESS, False), (STEEL, True)])
def test_with_held_edges_the_shell_is_the_curved_beam(material, wide, head):
    path = accordion(**SPRING, tail="arc")
    held = shell_stiffness(path, 2.0, head=head, refined=2, material=material, edge="zab")
    assert held == pytest.approx(beam_stiffness(head=head, wide=wide), rel=1e-5)


@pytest.mark.parametrize("head", [FREE, GUIDED])
def test_a_strip_narrower_than_thick_is_a_beam_in_plane_stress(head):
    assert factor(0.02, head) == pytest.approx(1, abs=5e-4)


@pytest.mark.parametrize("head", [FREE, GUIDED])
def test_an_endless_strip_is_a_beam_in_plane_strain(head):
    limit = beam_stiffness(head=head, wide=True) / beam_stiffness(head=head, wide=False)
    assert limit == pytest.approx(1 / (1 - NU**2), rel=1e-4)  # shear stays as it is
    assert factor(1000.0, head) == pytest.approx(limit, abs=5e-4)


def test_a_strip_stiffens_with_its_width_between_both():
    widths = (0.5, 5.0, 56.0)
    factors = [1.0, *(factor(h, GUIDED) for h in widths), 1 / (1 - NU**2)]
    assert (np.diff(factors) > 2e-3).all()


def test_two_meshes_agree_on_the_printed_width():
    assert factor(56.0, GUIDED) == pytest.approx(factor(56.0, GUIDED, refined=2), abs=2e-4)


def test_a_leaf_s_factor_depends_on_its_width_over_its_length_alone():
    def of_leaf(length, h):
        leaf = Piece("leaf", 0.0, 0.0, np.pi / 2, length, 0.0, 1)
        shear = length / (5 / 6 * E / (2 * (1 + NU)) * B)
        alone = 1 / (length**3 / (E * B**3) + shear)
        return shell_stiffness([leaf], h, head=GUIDED, per_leaf=12) / alone

    short, long = of_leaf(10.0, 10.0), of_leaf(40.0, 40.0)
    assert short == pytest.approx(long, abs=2e-3)
    assert of_leaf(40.0, 4.0) < 1.04 < short < 1 / (1 - NU**2)
