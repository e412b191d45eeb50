"""Decks for calculix: their contents, and a patch under uniform stress."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from verify.studies.crosscheck.calculix import reading
from verify.studies.crosscheck.calculix.obstacles import strip_of
from verify.studies.crosscheck.calculix.plane import PlaneDeck, Spin
from verify.studies.crosscheck.calculix.running import executable, run_deck

STEEL = Elastic(E=200e9, nu=0.25)
PRINTED = 6e-6  # of the largest displacement: half a unit of six digits
installed = pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")


def square(turn=0.0):
    """Two by two cells on the unit square, turned by `turn` [rad], with names for its sides."""
    mesh = MeshQuad().refined(1)
    mesh = mesh.with_boundaries({
        "left": lambda x: x[0] == 0, "right": lambda x: x[0] == 1,
        "bottom": lambda x: x[1] == 0, "top": lambda x: x[1] == 1,
    })  # fmt: skip
    c, s = np.cos(turn), np.sin(turn)
    return replace(mesh, doflocs=np.array([[c, -s], [s, c]]) @ mesh.doflocs)


def pulled(turn=0.0, assumption="plane strain", **more):
    """A square between two guides under an even pull of 1 MPa on the other sides."""
    return solve_plane(
        square(turn), materials=STEEL, assumption=assumption, degree=2,
        supports={"left": "n", "bottom": "n"}, pressures={"right": -1e6}, **more,
    )  # fmt: skip


def deck_of(solution, assumption="plane strain", **more):
    return PlaneDeck(solution=solution, materials=STEEL, assumption=assumption, **more)


def test_a_deck_has_nodes_cells_material_supports_and_loads(tmp_path):
    def text(**more):
        return deck_of(pulled(), **more).write(tmp_path / "deck.inp").read_text("ascii")

    deck = text()
    lines = deck.splitlines()
    first = lines.index("*NODE, NSET=ALL")
    # 9 vertices and 12 middles of edges: centres of cells are none
    assert lines.index("*ELEMENT, TYPE=CPE8, ELSET=BODY") - first - 1 == 21
    assert f"*ELASTIC\n{200e9:.12e},{0.25:.12e}\n" in deck
    forces = deck.partition("*CLOAD\n")[2].partition("*")[0].splitlines()
    assert sum(float(line.split(",")[2]) for line in forces) == pytest.approx(1e6)
    assert {line.split(",")[1] for line in forces} == {"1"}
    # pressures and spins are left to calculix
    deck = text(pressures={"right": -1e6})
    assert "*CLOAD" not in deck
    assert deck.partition("*DLOAD\n")[2].count(",P") == 2
    deck = text(spin=Spin(rho=7850.0, omega=100.0))
    assert f"EVERY,CENTRIF,{1e4:.12e}" in deck
    assert "*DENSITY" in deck


@pytest.mark.parametrize("hollow", [False, True])
def test_an_obstacle_s_strip_faces_the_slave(hollow):
    from fem.contact.pairs import Obstacle
    from fem.contact.shapes import Circle

    slave = np.array([[-0.1, 0.0, 0.1], [0.0, 0.0, 0.0]])
    centre = (0.0, 2.0) if hollow else (0.0, -2.0)
    strip = strip_of(Obstacle(Circle(centre, 2.0, hollow)), slave)
    on = strip.x[np.unique(strip.cells[:, [0, 1, 4]])]
    np.testing.assert_allclose(np.hypot(*(on - centre).T), 2.0, rtol=1e-6)
    beyond = strip.x[np.unique(strip.cells[:, [2, 3]])]
    assert np.all(beyond[:, 1] < on[:, 1].max())  # both bodies lie below
    corners = strip.x[strip.cells[:, :3]]
    (a, b), (c, d) = (corners[:, 1] - corners[:, 0]).T, (corners[:, 2] - corners[:, 0]).T
    assert np.all(a * d - b * c > 0)


def test_readers_find_the_last_increment(tmp_path):
    frd = tmp_path / "deck.frd"
    row = " -1         1 1.00000E+00-2.00000E+00 3.00000E+00\n"
    frd.write_text(f" -4  DISP        4    1\n{row} -3\n -4  DISP        4    1\n"
                   f"{row.replace('1.00000E+00-', '7.00000E+00-')} -3\n")  # fmt: skip
    np.testing.assert_array_equal(reading.displacements(frd), [[7.0, -2.0]])
    with pytest.raises(LookupError, match=r"deck\.frd has no field STRESS"):
        reading.nodal(frd, "STRESS")


@installed
@pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])
def test_a_patch_under_an_even_pull_is_stressed_evenly_in_calculix(assumption, tmp_path):
    solution = pulled(turn=0.3, assumption=assumption, thickness=0.5)
    posed = deck_of(solution, assumption)
    deck = posed.write(tmp_path / "deck.inp")
    run = run_deck(deck)
    here = solution.u[posed.numbering.dofs].T
    np.testing.assert_allclose(run.u[: len(here)], here, atol=PRINTED * np.abs(here).max())
    share = posed.depth / solution.thickness
    energy = reading.strain_energy(deck.with_suffix(".dat")) / share
    assert energy == pytest.approx(solution.strain_energy, rel=1e-6)
    sigma = reading.nodal(deck.with_suffix(".frd"), "STRESS")[: len(here), :2].sum(axis=1)
    np.testing.assert_allclose(sigma, 1e6, rtol=1e-4)  # from single precision
