"""Balance, scaling, rigid motions and messages of solids."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.solid.solve import solve_solid
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

STEEL = Elastic(E=206e3, nu=0.3)  # N/mm^2
QUARTER = Piece("arc", 0.0, 0.0, pi / 2, 0.5 * pi / 2, -pi / 2, 1)
LEAF = Piece("leaf", 0.5, 0.5, 0.0, 3.0, 0.0, 1)
PULL = (3.0, -2.0, 1.5)  # any


def hook():
    return solid_strip(
        [QUARTER, LEAF], b=0.1, width=1.0, through=1, per_arc=3, per_leaf=4, across=2, grading=3.0
    )


def bent(mesh=None, **changed):
    given = {"materials": STEEL, "supports": {"tail": "xyz"}, "tractions": {"head": PULL}}
    return solve_solid(hook() if mesh is None else mesh, **given | changed)


def test_the_reaction_balances_tractions_weight_and_forces():
    force, moment = bent().reaction("tail")
    load = 0.1 * 1.0 * np.array(PULL)
    assert force == pytest.approx(-load)
    assert moment == pytest.approx(-np.cross((0.0, 0.0, 0.5), load), rel=1e-7)
    force, moment = bent(tractions={}, body_force=(0.0, -2.0, 0.0)).reaction("tail")
    weight = 2.0 * 0.1 * 1.0 * (0.5 * pi / 2 + 3.0)
    assert force == pytest.approx([0.0, weight, 0.0], abs=1e-4)  # the arc is made of parabolas
    assert moment[0] == pytest.approx(-0.5 * weight, rel=1e-4)
    solved = bent(tractions={}, forces={(0.0, 0.0, 1.0): (1.0, 0.0, 0.0)})
    work = solved.displacement_at((0.0, 0.0, 1.0))[0]
    assert work > 0
    assert -2 * solved.potential_energy == pytest.approx(work)


def test_a_uniform_line_moves_as_one_and_its_forces_cancel():
    line = (0.0, 0.0, None)
    solved = bent(uniform={line: "x"})
    nodes = np.flatnonzero(np.all(abs(solved.mesh.doflocs[:2]) < 1e-9, axis=0))
    assert nodes.size == 5
    assert np.ptp(solved.displacement[nodes, 0]) < 1e-12
    assert np.ptp(solved.displacement[nodes, 1]) > 1e-6
    force, moment = solved.reaction(line)
    assert force == pytest.approx(np.zeros(3), abs=1e-9)
    assert moment[1] != pytest.approx(0, abs=1e-6)
    held = solved.reaction("tail")[1]
    load = np.cross((0.0, 0.0, 0.5), 0.1 * np.array(PULL))
    assert held + moment == pytest.approx(-load, rel=1e-6)
    assert solved.strain_energy < bent().strain_energy
    # of points in x and y, it holds against turning as well
    hinged = bent(supports=HINGED, uniform={(3.5, 0.5, None): "xy"})
    assert hinged.reaction((0.0, 0.0, 0.0))[0][2] == pytest.approx(-0.1 * PULL[2])


LINE = (0.0, 0.0, None)
HINGED = {(0.0, 0.0, 0.0): "xyz", (-0.05, 0.0, 0.0): "y"}


def folded():
    mesh = hook()
    at = mesh.doflocs.copy()
    at[:, mesh.t[:4, 0]] = at[:, mesh.t[[3, 2, 1, 0], 0]]
    return replace(mesh, doflocs=at)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"mesh": folded()}, r"cell .* of 14, about .*, is folded or flat"),
        ({"materials": {"arcs": STEEL}}, "8 of 14 cells have no material"),
        ({"uniform": {"tail": "x"}}, "must not be supported and move uniformly"),
        ({"uniform": {"head": "x", LINE: "x"}}, "uniformly with one group only"),
        ({"supports": HINGED, "uniform": {(3.5, 0.5, None): "x"}}, "can move rigidly"),
        ({"tractions": {"head": (np.nan, 0.0, 0.0)}}, "traction on 'head': load vectors must be"),
        ({"pressures": {"head": np.inf}}, "the pressure on 'head' must be finite"),
        ({"forces": {"head": (1.0, 2.0)}}, "the force at 'head' must have three finite"),
    ],
)
def test_bodies_and_loads_that_do_not_fit_get_one_line(changed, words):
    with pytest.raises(ValueError, match=words):
        bent(**changed)


@pytest.mark.parametrize(
    ("supports", "words"),
    [
        ({}, "body 1 of 1 can move rigidly"),
        ({"tail": "yz"}, r"can move rigidly \([+-]1 x\)"),
        ({"tail": "xz"}, r"can move rigidly \([+-]1 y\)"),
        ({"tail": "xy"}, r"can move rigidly \([+-]1 z\)"),
        # about a line that is held
        ({(None, 0.5, 0.0): "xyz"}, r"rigidly \([^ ]+ y, [^ ]+ z, [^ ]+ about x\)"),
        ({(3.5, None, 0.0): "xyz"}, r"rigidly \([^ ]+ x, [^ ]+ z, [^ ]+ about y\)"),
        ({(0.0, 0.0, None): "xyz"}, r"rigidly \([^ ]+ x, [^ ]+ y, [^ ]+ about z\)"),
        ({"tial": "xyz"}, "no boundary 'tial'; its boundaries: edge, head, left"),
        ({"tail": "xw"}, "support 'tail': components must be x, y or"),
        ({"tail": "xyz", "middle": {"z": 1e-3}}, r"at \(3.5, 0.\d+, 0\), along z: two supports"),
        ({"tail": {"x": np.nan}}, "support 'tail': the displacement along x"),
        ({(9.0, 0.0, None): "x"}, r"no node at \(9.0, 0.0, None\): the distance"),
        ({(None, None, None): "x"}, "a point must have x, y and z, of which"),
    ],
)
def test_supports_that_do_not_hold_or_do_not_fit_get_one_line(supports, words):
    with pytest.raises(ValueError, match=words):
        bent(supports=supports)
