"""Bodies that stick together and are sheared along z: layers, and rings pressed onto each other.

Anti-plane shear is the linear problem behind the cone: closed forms with logarithms and straight
lines show its stiffness, its contact and its signs.
"""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Flat
from meshes.contact.block import block
from meshes.join import join
from tests.fem.contact.models import HARD, SOFT

G_SOFT, G_HARD = 1.0 / 2.6, 4.0 / 2.4
EXACT = 1e-9


@pytest.mark.parametrize(("cells", "order"), [("quad", 2), ("tri", 1)])
def test_layers_that_stick_shear_evenly(cells, order):
    # a soft layer on a hard one, of heights 0.5, pressed together so that all of it sticks
    make, moved = {"cells": cells, "order": order}, 1e-3
    mesh = join({"up": block(x=(0, 1), y=(0.5, 1), nx=5, ny=3, **make),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=7, ny=2, **make)})  # fmt: skip
    problem = ContactProblem(
        mesh, materials={"up": SOFT, "low": HARD}, assumption="plane strain", thickness=0.3,
        supports={"low.bottom": "xy", "up.top": "xy"},
        along=Along(supports={"low.bottom": 0.0, "up.top": 0.0}),
        contacts=[Pair(slave="up.bottom", master="low.top", friction=10.0)],
    )  # fmt: skip
    s = problem.solve(
        displacements={"up.top": {"x": 0.0, "y": -0.01}}, axial_displacements={"up.top": moved}
    )
    tau = moved / (0.5 / G_SOFT + 0.5 / G_HARD)
    touch = s.touches[0]
    # on the master, which the slave above drags along
    np.testing.assert_allclose(touch.traction_z, tau, rtol=EXACT)
    assert touch.force_z == pytest.approx(0.3 * tau, rel=EXACT)
    assert s.along.reaction("up.top") == pytest.approx(0.3 * tau, rel=EXACT)
    assert s.along.reaction("low.bottom") == pytest.approx(-0.3 * tau, rel=EXACT)
    nodes = s.along.interface.bodies.nodes
    y = s.bodies.basis.doflocs[1, nodes.dofs[0]]
    upper = np.arange(y.size)[np.isin(np.arange(y.size), nodes.cells[s.bodies.lam < 0.7])]
    lower = np.setdiff1d(np.arange(y.size), upper)
    np.testing.assert_allclose(s.u_z[lower], tau / G_HARD * y[lower], atol=EXACT * moved)
    np.testing.assert_allclose(
        s.u_z[upper], moved - tau / G_SOFT * (1 - y[upper]), atol=EXACT * moved
    )
    stress = s.along.stress()
    np.testing.assert_allclose(stress[:, 1], tau, rtol=EXACT)
    np.testing.assert_allclose(stress[:, 0], 0.0, atol=EXACT * tau)
    assert s.along.strain_energy == pytest.approx(0.3 * tau * moved / 2, rel=EXACT)
    assert s.strain_energy == pytest.approx(
        s.plane.strain_energy + s.along.strain_energy, rel=EXACT
    )


@pytest.mark.parametrize("free", [(), ("floor",)], ids=["held", "free"])
def test_an_obstacle_pulls_along_z_or_follows_a_force(free):
    problem = ContactProblem(
        block(x=(0, 1), y=(0, 0.5), nx=5, ny=3), materials=SOFT, assumption="plane strain",
        supports={"top": "xy"}, along=Along(supports={"top": 0.0}, free=free),
        obstacles={"floor": Obstacle(Flat())},
        contacts=[Pair(slave="bottom", master="floor", friction=10.0)],
    )  # fmt: skip
    tau = 1e-3 * G_SOFT / 0.5
    pull = {"axial_forces": {"floor": tau}} if free else {"axial_displacements": {"floor": 1e-3}}
    s = problem.solve(displacements={"top": {"x": 0.0, "y": -0.01}}, **pull)
    assert s.u_z[-1] == pytest.approx(1e-3, rel=EXACT)
    assert s.touches[0].force_z == pytest.approx(-tau, rel=EXACT)
    if not free:
        assert s.along.reaction("floor") == pytest.approx(tau, rel=EXACT)
