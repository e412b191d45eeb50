"""Polyhedral clutches: values, warnings, and finite elements in balance on coarse meshes."""

import math

import numpy as np
import pytest

from fem.contact.wedged import Geometry, Wedge
from tests.verify.cases.own import state
from verify.cases.polyhedral.clutch.case import CLUTCH
from verify.cases.polyhedral.locking.case import LockedPolyhedralRing
from verify.cases.polyhedral.locking.fem import locked_fem
from verify.cases.polyhedral.wedge.case import WedgedRoller
from verify.cases.polyhedral.wedge.mesh import fem_mesh
from verify.core.case import Context

LOCKS = {"M_20", "M_20_printed", "T", "F_s", "R", "N_16"}
FIRST = {"M_21", "M_21_printed"}
NEEDED = {"p_20", "p_17_printed", "p_need", "N_need", "fillet_need"} | {
    "p_17",
    "p_17_arc",
    "p_block",
}
ENDLESS = LOCKS | FIRST | {"N_el", "M_el", "M_rigid", "M_wide", "margin"}


@pytest.mark.parametrize(
    ("change", "left_out", "words"),
    [
        pytest.param({"z": 12, "e": "5 mm"}, set(), "", id="twelve rollers"),
        pytest.param({"mu": 0.22}, LOCKS, "Eqs. 17 to 20 give no limit", id="locks by Eq. 20"),
        pytest.param({"mu": 0.3}, LOCKS | FIRST, "the hub force is 1.42", id="and by Eq. 21"),
        pytest.param({"mu": 0.6}, ENDLESS, "strength limits", id="all lock"),
        pytest.param({"alpha": "10 deg"}, NEEDED, "expelled", id="expelled rollers"),
        pytest.param({"p_t": "15 MPa"}, set(), "the torque is zero", id="not touched"),
        pytest.param({"p_t": "20.4 MPa"}, set(), "which requires p_t = ", id="hardly touched"),
        pytest.param({"p_t": "100 MPa", "R_p": "900 MPa"}, set(), "the ring yields", id="crushed"),
        pytest.param({"M_t": "5000 N m"}, set(), "ISO 76", id="too much required"),
    ],
)  # fmt: skip
def test_a_clutch_leaves_out_what_has_no_value_and_warns_of_its_state(change, left_out, words):
    q, v, warned = state(CLUTCH, **change)
    assert {output.key for output in CLUTCH.outputs} - set(v) == left_out
    always = ("require a wedge angle of", "b/δ_1 = ")  # true of nearly every clutch of this kind
    others = [line for line in warned if not any(part in line for part in always)]
    assert any(words in line for line in others) if words else not others
    known = {"M_el", "M_20", "M_21", "M_rigid"} & set(v)
    assert bool(CLUTCH.figures(Context(CLUTCH.id, q, v, [], False))) == bool(known)


def test_a_narrow_ring_carries_little_torque_and_needs_a_wedge_angle():
    q, v, warned = state(CLUTCH, b="5 mm")
    assert v["alpha_need"] == pytest.approx(2 * math.atan(q.mu))
    assert v["M_ring"] < 0.02 * v["M_el"]
    assert any("require a wedge angle of 9.15°" in line for line in warned)
    assert not any("b/δ_1" in line for line in warned)
    *_, warned = state(CLUTCH)
    assert any("b/δ_1" in line for line in warned)


def wedge(q, mu):
    geometry = Geometry(q.R, q.half, q.a)
    return Wedge(geometry, fem_mesh(geometry, 6), E=q.E, nu=q.nu, mu=mu, caged=False)


def test_forces_on_half_a_sector_are_in_balance_with_the_ring_s_hoop_force_alone():
    q = LockedPolyhedralRing()
    hub = (2e5, 1e4)
    ring = locked_fem(q, 1, d=q.d, e=q.e, p=q.p_t, hub=hub)
    rest_x, rest_y, hoop = ring.balance(q.p_t, hub)
    side = q.p_t * q.d_i * np.sin(q.half_angle)
    assert max(abs(rest_x), abs(rest_y)) < 1e-8 * side
    assert abs(hoop) > 0.1 * side  # what Eq. 16 leaves out


def test_the_roller_leaves_to_the_wide_end_where_friction_is_too_low():
    q = WedgedRoller()
    _, down = wedge(q, q.mu).pressed(q.line_load)
    slippery = wedge(q, 0.5 * math.tan(q.half))
    gone = slippery.at(down)
    assert slippery.forces(gone)[0] < 1e-6 * q.line_load
    x, _ = gone.plane.displacement_at((0.0, 0.0))
    assert x < -0.5 * down / math.tan(q.half)
