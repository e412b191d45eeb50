"""Mean motions of boundaries that deform freely, against closed forms, virtual work and statics."""

from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.means import Mean
from fem.plane.solve import solve_plane
from fem.plane.ties import Tie
from tests.fem.cyclic_rings import KINDS, ring, sector

MATERIAL = Elastic(E=1000.0, nu=0.3)
SAME = 1e-9
every_element = pytest.mark.parametrize("kind", KINDS)


def solved(mesh, **given):
    given = {"supports": {"bore": "xy"}, "assumption": "plane strain"} | given
    return solve_plane(mesh, materials=MATERIAL, **given)


def cyclic(z):
    return Tie(leader="first cut", follower="last cut", angle=2 * pi / z)


def shear(x):
    """A traction on one side of the ring only."""
    return np.array([0.3 * x[1] ** 2 * (x[0] > 0), 0.1 + 0 * x[0]])


@every_element
def test_a_rim_turned_on_the_average_is_in_pure_torsion(kind):
    # tractions along the arm are even shear on a circle, so that the rim stays one: see
    # u_phi = a r + b/r in the bore 0 and at the rim v, couple 4 pi mu b
    v, mu = 1e-3, MATERIAL.E / 2.6
    couple = 4 * pi * mu * v / (1 - 1 / 1.6**2)
    errors = []
    for through in (3, 6):
        mesh = sector(kind, 5, around=2 * through, through=through)
        s = solved(mesh, ties=[cyclic(5)], means={"rim": Mean({"r": v})})
        moment = 5 * s.mean_reaction("rim")["r"]
        assert 5 * s.reaction("bore")[2] == pytest.approx(-moment, rel=SAME)
        errors.append(moment / couple - 1)
    order = 2 * (1 if kind in ("tri3", "quad4") else 2)
    assert np.log2(abs(errors[0] / errors[1])) == pytest.approx(order, abs=0.3), errors


@every_element
def test_means_are_what_they_are_prescribed_to_be_and_hold_with_forces_in_balance(kind):
    about = (0.4, -0.2)
    held = {"x": 2e-3, "y": -1e-3, "r": 5e-4}
    s = solved(
        ring(kind, 5), supports={}, tractions={"bore": shear}, thickness=0.7,
        means={"rim": Mean(held, about=about)},
    )  # fmt: skip
    rim = s.on_boundary("rim")
    arm = rim.x - np.reshape(about, (2, 1))
    turn = rim.mean(arm[0] * rim.u[1] - arm[1] * rim.u[0]) / rim.mean((arm**2).sum(axis=0))
    shift = [rim.mean(u) for u in rim.u]
    assert (*shift, turn) == pytest.approx(tuple(held.values()), rel=1e-8)
    # the mean's tractions have these resultants, x and y evenly, r growing with the arm
    f = s.internal - s.f
    x, y = s.basis.doflocs[:, ::2]
    force = s.mean_reaction("rim")
    size = rim.mean((arm**2).sum(axis=0))
    mean_arm = [rim.mean(a) for a in arm]
    assert f[::2].sum() == pytest.approx(force["x"] - force["r"] * mean_arm[1] / size, rel=1e-8)
    assert f[1::2].sum() == pytest.approx(force["y"] + force["r"] * mean_arm[0] / size, rel=1e-8)
    moment = ((x - about[0]) * f[1::2] - (y - about[1]) * f[::2]).sum()
    assert moment == pytest.approx(
        force["r"] + force["y"] * mean_arm[0] - force["x"] * mean_arm[1], rel=1e-8
    )


HELD = "supports or another mean hold already"


@pytest.mark.parametrize(
    ("supports", "means", "message"),
    [
        ({"bore": "xy"}, {"bore": Mean({"x": 0.0})}, HELD),
        ({"bore": "xy"}, {"rim": Mean({"r": 0.0}), "again": Mean({"r": 1.0})}, HELD),
        ({"bore": "t"}, {"bore": Mean({"r": 0.0})}, HELD),
        ({"bore": "xy"}, {"edge": Mean({"r": 0.0})}, "no boundary 'edge'"),
        ({}, {"rim": Mean({"x": 0.0, "y": 0.0})}, "rotation"),
    ],
)
def test_means_that_are_held_already_or_hold_too_little_are_refused(supports, means, message):
    mesh = ring("quad9", 4)
    mesh = mesh.with_boundaries({"again": mesh.boundaries["rim"]})
    with pytest.raises(ValueError, match=message):
        solved(mesh, supports=supports, means=means)


def test_wrong_means_are_named():
    for held, words in (
        ({"z": 0.0}, "mean motions are of x, y and r, got z"), ({}, "got none"),
        ({"r": np.inf}, "must be finite"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=words):
            Mean(held)
    s = solved(ring("tri3", 4), means={"rim": Mean({"r": 0.0})})
    with pytest.raises(ValueError, match="no mean motion of 'bore' is held; held are those of"):
        s.mean_reaction("bore")
