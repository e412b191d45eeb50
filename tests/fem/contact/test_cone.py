"""Friction cone: layers sheared along z against straight lines; sliding directions of blocks."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.along import Along
from fem.contact.along_problem import AlongProblem
from fem.contact.cone import Cone, Residual, State
from fem.contact.pairs import Obstacle, Pair, Rigid
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.round import full_disc
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


MU, P = 0.2, 8e-3
SLOPE = 0.1


def on_flat(low):
    """A flat block on a wide one."""
    mesh = join({"up": block(x=(0.2, 0.7), y=(0.5, 0.6), nx=6, ny=2),
                 "low": block(x=(0, 1), y=(0, 0.5), nx=11, ny=5)})  # fmt: skip
    return ContactProblem(
        mesh, materials={"up": SOFT, "low": low}, assumption="plane strain",
        supports={"low.bottom": "xy"}, along=Along(supports={"low.bottom": 0.0}),
        contacts=[Pair(slave="up.bottom", master="low.top", friction=MU)],
    )  # fmt: skip


def towards(angle):
    return float(np.cos(np.radians(angle))), float(np.sin(np.radians(angle)))


@pytest.mark.parametrize(
    ("low", "angle"), [(HARD, 30.0), (Rigid(), 200.0)], ids=["elastic", "rigid"]
)
def test_a_block_holds_what_is_within_the_cone_and_no_more(low, angle):
    problem = on_flat(low)
    pressed = problem.solve(forces={"up.top": (0.0, -P)})

    def pulled(share):
        """Drawn in its lowest face, so that nothing tilts it."""
        x, z = (share * MU * P * d for d in towards(angle))
        return problem.solve(
            forces={"up.top": (0.0, -P), "up.bottom": (x, 0.0)}, axial_forces={"up.bottom": z},
            after=pressed,
        )  # fmt: skip

    for share in (0.3, 0.9999):
        s = pulled(share)
        touch = s.touches[0]
        x, z = (share * MU * P * d for d in towards(angle))
        np.testing.assert_allclose(touch.force, (x, -P), atol=1e-9 * P)
        assert touch.force_z == pytest.approx(z, abs=1e-9 * P)
        q = np.hypot(touch.traction, touch.traction_z)
        assert np.all(q <= MU * touch.pressure * (1 + 1e-9))
        assert s.along is not None
        assert s.along.residual.largest < 1e-9
    for share in (1.000001, 50.0):
        with pytest.raises(ValueError, match="no admissible contact forces balance"):
            pulled(share)
    if low is HARD:
        # friction that has turned into the pull all over: it rests after 200 times what it deforms
        with pytest.raises(ArithmeticError, match="with small"):
            pulled(1 - 1e-7)


def wedged(free=()):
    """A disc that friction alone holds between flats, each at SLOPE, that close towards +x."""
    mesh, rim = full_disc(R=1.0, around=64), Circle((0.0, 0.0), 1.0)
    facets = mesh.boundaries["rim"]
    up = mesh.p[1, mesh.facets[:, facets]].mean(axis=0) > 0
    mesh = mesh.with_boundaries({"over": facets[up], "under": facets[~up]})
    x, y = float(np.sin(SLOPE)), float(np.cos(SLOPE))
    flats = {"above": Obstacle(Flat((x, y), (-x, -y))), "below": Obstacle(Flat((x, -y), (-x, y)))}
    fit = {"friction": 0.3, "slave_shape": rim, "interference": 0.02}
    return ContactProblem(
        mesh, materials=Elastic(E=1.0, nu=0.3), assumption="plane strain", obstacles=flats,
        along=Along(free=free),
        contacts=[Pair(slave="over", master="above", **fit),
                  Pair(slave="under", master="below", **fit)],
    )  # fmt: skip


def test_a_disc_in_a_wedge_holds_an_axial_force_within_the_cone():
    mu, tan = 0.3, np.tan(SLOPE)
    problem = wedged(free=("above",))
    pressed = problem.solve()
    N = pressed.touches[0].normal_force
    limit = N * np.sqrt(mu**2 - tan**2)
    for share in (0.5, 0.9):
        s = problem.solve(axial_forces={"above": share * limit}, after=pressed)
        touch = s.touches[0]
        assert touch.force_z == pytest.approx(-share * limit, rel=1e-9)
        used = np.hypot(touch.friction_force, touch.force_z) / (mu * touch.normal_force)
        expected = np.hypot(tan, share * limit / touch.normal_force) / mu
        assert used == pytest.approx(expected, rel=1e-3)
        assert used < 1
        assert touch.normal_force == pytest.approx(N, rel=0.01)
    for share in (1.02, 3.0):
        with pytest.raises(ArithmeticError, match="continues to slide"):
            problem.solve(axial_forces={"above": share * limit}, after=pressed)


@pytest.mark.parametrize(
    ("pressure", "missed"),
    [(0.5, 0.5), (1.0, 0.0), (1.5, 0.5)],
    ids=["bodies overlap", "bodies touch", "a gap carries pressure"],
)
def test_a_pressure_that_its_gap_contradicts_counts_as_a_miss_on_both_sides(pressure, missed):
    cone = Cone(
        B=np.eye(3), D=np.zeros((3, 0)), friction=np.array([0.5]), rough=np.array([0])
    )  # a node that overlaps by 1 and yields 1 per unit pressure
    at = State(np.array([pressure, 0.0, 0.0]), np.zeros(0))
    residual, _, w = cone.judged(np.array([-1.0, 0.0, 0.0]), np.zeros(0), at)
    assert w[0] == pressure - 1
    assert residual.complementarity == pytest.approx(missed)


@pytest.mark.parametrize(
    "violations", [(3e-9, 1e-12, 2e-10), (1e-12, 3e-9, 2e-10), (0.0, 0.0, 3e-9)]
)
def test_the_residual_is_the_largest_violation_of_a_law(violations):
    assert Residual(*violations).largest == 3e-9


def test_a_surface_with_an_open_gap_is_displaced_by_tractions_at_other_nodes():
    compliance = np.array([[1.0, 0.5], [0.5, 1.0]])
    interface = SimpleNamespace(
        cone=SimpleNamespace(B=compliance, rough=np.array([0, 1])), C=np.zeros((2, 1))
    )
    problem = SimpleNamespace(bodies=SimpleNamespace(shifts=np.zeros((1, 1))))
    step = SimpleNamespace(traction=np.array([-0.4, 0.0]), shift=np.zeros(1))
    # the gap of row 1 closes at a quarter of the step; row 0 touches and carries -0.4
    found = AlongProblem._closing(
        problem, interface, np.array([0.3, 0.3]), np.zeros(2), (None, step),
        (np.array([1]), np.array([0.25])),
    )  # fmt: skip
    assert found == pytest.approx([0.0, 0.25 * (0.3 - 0.5 * 0.4)])
