"""An invalid problem of harmonics is refused, and the message names the error."""

import numpy as np
import pytest
from skfem import MeshQuad1

from fem.fourier.compliance import harmonics, surface_compliance
from fem.fourier.contact import NarrowPatchError, patch_contact
from fem.fourier.solid import FourierSolid
from fem.plane.material import Elastic

STEEL = Elastic(E=206.0, nu=0.3)


def bar(left=0.0, height=0.5):
    mesh = MeshQuad1.init_tensor(np.linspace(left, left + 2, 5), np.linspace(0, height, 3))
    return mesh.with_boundaries({
        "axis": lambda x: x[0] == left, "rim": lambda x: x[0] == left + 2,
        "start": lambda x: x[1] == 0, "end": lambda x: x[1] == height,
    }).with_subdomains({"core": lambda x: x[0] < left + 1})  # fmt: skip


def two():
    apart = bar(3.0).translated((0.0, 2.0))
    mesh = bar() + apart
    return mesh.with_boundaries({"start": lambda x: x[1] == 0, "rim": lambda x: x[0] == 5})


def solid(**changed):
    problem = {"mesh": bar(), "materials": STEEL, "supports": {"start": "z"}, "degree": 2}
    return FourierSolid(**(problem | changed))


def compliance(**changed):
    asked = {"stations": np.array([0.0, 0.25, 0.5]), "orders": harmonics(places=2, highest=40)}
    return surface_compliance(solid(), "rim", **(asked | changed))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: solid(supports={"start": "x"}), "support 'start': components must be r, t or"),
        (lambda: solid(supports={"base": "z"}), "no boundary 'base'"),
        (lambda: solid(materials={"core": STEEL}), "4 of 8 cells have no material"),
        (lambda: solid(materials={"shell": STEEL}), "no body 'shell'"),
        (lambda: solid(degree=3), "degree 1 or 2, got degree=3"),
        (lambda: solid(mesh=bar(-0.5)), "reaches r = -0.5"),
        (lambda: solid().harmonic(-1), "whole number >= 0, got -1"),
        (lambda: solid(supports={}).harmonic(0), "harmonic 0: body 1 of 1 .* rigidly along z:"),
        (lambda: solid().harmonic(0, antisymmetric=True), "rigidly about z:"),
        (lambda: solid(supports={"start": "rt"}).harmonic(1), "rigidly about y:"),
        (lambda: solid().harmonic(1), "rigidly along x:"),
        (lambda: solid(supports={}).harmonic(1, antisymmetric=True), "along y and about x:"),
        (lambda: solid(mesh=two()).harmonic(0), "body 2 of 2 can move rigidly along z"),
        (lambda: solid().harmonic(2).solve({"axis": (1, 0, 0)}), "'axis' has no area"),
        (lambda: solid().harmonic(2).solve({"rim": (1, 0)}), r"3 amplitudes \(r, t, z\), got 2"),
        (lambda: solid().harmonic(2).solve({"rim": (1, 0, np.nan)}),
         "the traction on 'rim' must be finite"),
        (lambda: solid().harmonic(2).solve({"side": (1, 0, 0)}), "no boundary 'side'"),
        (lambda: solid().harmonic(2).solve({}).amplitudes_at(np.zeros(2)), "shape \\(2, m\\)"),
        (lambda: solid().harmonic(2).solve({}).amplitudes_at(np.array([[9.0], [0.0]])), "outside"),
        (lambda: compliance(stations=np.array([0.0, 0.2])),
         "the boundary 'rim' must have a node at"),
        (lambda: compliance(stations=np.array([0.5, 0.0])),
         "stations must be two or more values rising"),
        (lambda: compliance(orders=np.array([0, 2, 3, 4, 6])), "multiples of places=2"),
        (lambda: surface_compliance(solid(), "end", stations=np.array([0.5, 0.6]),
                                    orders=np.array([0, 2, 4, 6, 8])), "'end' must be a cylinder"),
    ],
)  # fmt: skip
def test_the_message_names_the_rule_and_the_value(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"load": 0.0}, "load must be positive and finite, got load=0 N"),
        ({"across": np.array([0.0, 0.1])}, "across must rise from 0 over at least two"),
        ({"across": np.array([0.0, np.nan, 0.3])}, "across must rise from 0 over at least two"),
        ({"across": np.array([0.0, 1.0, 2.0])}, "narrower than both radii"),
        ({"crown": lambda z: np.nan * z}, "the crown must be finite on 0 <= z <= 0.5 m"),
    ],
)
def test_a_contact_that_makes_no_sense_is_refused(changed, message):
    body = compliance()
    asked = {"across": np.linspace(0, 0.2, 9), "load": 0.2, "crown": None}
    with pytest.raises(ValueError, match=message):
        patch_contact((body, body), **(asked | changed))


def test_bodies_must_agree_and_be_narrower_than_their_patch():
    body, asked = compliance(), {"across": np.linspace(0, 0.2, 9), "load": 0.2}
    short = compliance(stations=np.array([0.0, 0.25]))
    third = compliance(orders=harmonics(places=3, highest=40), places=3)
    with pytest.raises(ValueError, match="same stations along z"):
        patch_contact((body, short), **asked)
    with pytest.raises(ValueError, match="both bodies must have the same number of"):
        patch_contact((body, third), **asked)
    with pytest.raises(NarrowPatchError, match=r"as wide as its patch, \|s\| <= 0.2 m"):
        patch_contact((body, body), **asked | {"load": 5.0})
