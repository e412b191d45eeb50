"""Struts between rigid hubs: exact kinematics, closed forms, equilibrium or refusal."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from fem.rotor.sprag_struts import SpragStruts
from fem.rotor.struts import Joint, power_law, rotation
from fem.rotor.struts_kinds import Pinned, Rolling

PSI = 2 * np.pi * np.arange(7) / 7
Z = np.array([0.1, -0.2, 0.3, 0.0, -0.1, 0.25, -0.3])


def pinned(**more):
    a = np.stack([np.cos(PSI), np.sin(PSI), Z], axis=1)
    b = np.stack([2 * np.cos(PSI + 0.3), 2 * np.sin(PSI + 0.3), Z + 0.1], axis=1)
    return Pinned(**{"a": a, "b": b, "s_0": 0.05} | more)


def rolling(**more):
    return Rolling(**{"angle": PSI + 0.1, "z": Z, "lever": 0.2, "reach": 0.9, "s_0": 0.05} | more)


KINDS = pytest.mark.parametrize("struts", [pinned(), rolling()], ids=["pinned", "rolling"])
LAW = power_law(3.0, 1.5)
SOMEWHERE = np.array([0.02, -0.03, 0.01, 0.2, -0.1, 0.3])


@KINDS
def test_derivatives_are_those_of_the_shortening_and_turns_are_scipy_s(struts):
    for w in ([0.0, 0.0, 0.0], [1e-9, 0, 0], [0.3, -0.7, 1.1], [0, 0, math.pi]):
        expected = Rotation.from_rotvec(w).as_matrix()
        assert rotation(np.array(w)) == pytest.approx(expected, abs=1e-15)
    now = Joint.at_rest(struts, LAW).moved(SOMEWHERE)

    def shortening(step):
        there = now.moved(step)
        return struts.state(there.d, there.R).s

    state, h = struts.state(now.d, now.R), 1e-5
    found = [(shortening(v) - shortening(-v)) / (2 * h) for v in h * np.eye(6)]
    assert pytest.approx(np.array(found).T, abs=1e-9) == state.J
    h = 1e-3
    found = [
        [(shortening(u + v) - shortening(u - v) - shortening(v - u) + shortening(-u - v))
         / (4 * h**2) for v in h * np.eye(6)]
        for u in h * np.eye(6)
    ]  # fmt: skip
    expected = np.moveaxis(np.array(found), -1, 0)
    assert pytest.approx(expected, abs=1e-5) == state.H  # differences err by h^2 and more


def test_a_radial_strut_has_the_force_of_its_law():
    one = pinned(a=np.array([[1.0, 0, 0]]), b=np.array([[2.0, 0, 0]]), s_0=0.0)
    now = Joint.at_rest(one, power_law(3.0, 2.0)).moved(np.array([0.1, 0, 0, 0, 0, 0]))
    # shortened by 0.1: 3 * 0.1^2, and a slope of 6 * 0.1; across the stiffness is -F/l = -0.03/0.9
    assert now.loads() == pytest.approx([0.03, 0, 0, 0, 0, 0], abs=1e-15)
    K = now.tangent()
    assert K[0, 0] == pytest.approx(0.6, rel=1e-13)
    assert K[1, 1] == pytest.approx(-0.03 / 0.9, rel=1e-13)
    k = np.arange(1.0, 8.0)  # each strut may have another stiffness
    joint = Joint.at_rest(pinned(s_0=0.1), power_law(k, 1.0))
    assert joint.forces() == pytest.approx(0.1 * k, rel=1e-14)
    # lengthened, it carries nothing
    assert not Joint.at_rest(one, LAW).moved(np.array([-0.1, 0, 0, 0, 0, 0])).loads().any()


def test_a_shortening_keeps_its_digits_where_it_is_tiny():
    step = np.array([3e-12, 0, 0, 0, 0, 2e-12])
    found = Joint.at_rest(rolling(s_0=0.0), LAW).moved(step)
    s = rolling(s_0=0.0).state(found.d, found.R).s
    assert s == pytest.approx(3e-12 * np.cos(PSI + 0.1) + 0.2 * 2e-12, rel=1e-9, abs=1e-25)
    ends = pinned(s_0=0.0)
    e = (ends.b - ends.a) / np.linalg.norm(ends.b - ends.a, axis=1)[:, None]
    expected = e @ step[:3] + np.cross(ends.a, e)[:, 2] * 2e-12
    assert ends.state(found.d, found.R).s == pytest.approx(expected, rel=1e-9, abs=1e-22)


@KINDS
def test_loads_of_a_known_place_lead_back_to_it(struts):
    there = Joint.at_rest(struts, LAW).moved(0.1 * SOMEWHERE)
    free = (0, 1, 5)
    loads = there.loads()
    start = Joint.at_rest(struts, LAW).moved(0.1 * SOMEWHERE * [0, 0, 1, 1, 1, 0.5])
    found = start.under(loads, free)
    assert found.loads()[list(free)] == pytest.approx(loads[list(free)], rel=1e-10)
    # seven struts push outwards; none of them pulls the hub upwards
    with pytest.raises(ArithmeticError, match="no equilibrium of the struts"):
        Joint.at_rest(rolling(), LAW).under(np.array([0, 0, 5.0, 0, 0, 0]), (2,))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: pinned(b=np.zeros((3, 3))), "ends a and b must have the shape"),
        (
            lambda: Pinned(a=np.ones((1, 3)), b=np.ones((1, 3))),
            "length of a strut must be above 0 m",
        ),
        (lambda: rolling(z=np.zeros(3)), "one value per cam"),
    ],
)
def test_struts_without_sense_are_refused_in_words(call, message):
    with pytest.raises(ValueError, match=message):
        call()


SPRAGS = SpragStruts(T=25.0, Z=12, R_i=0.011, R_e=0.0194, nu=0.055, L=0.008)


def test_sprags_carry_their_torque_with_equal_forces():
    force = SPRAGS.T / (SPRAGS.Z * SPRAGS.R_i * math.sin(SPRAGS.nu))  # along a sprag
    even = SPRAGS.rolling(3)
    assert even.forces() == pytest.approx(force / 3, rel=1e-9)
    assert even.loads()[5] == pytest.approx(SPRAGS.T, rel=1e-9)
    # all sprags deflect equally: the inner race turns by about the deflection over R_i tan(nu)
    turn = math.asin(even.R[1, 0])
    assert turn == pytest.approx(SPRAGS.yields / (SPRAGS.R_i * math.tan(SPRAGS.nu)), rel=1e-2)


@pytest.mark.parametrize(("offset", "aside"), [(1e-7, 1e-7), (1.0, SPRAGS.yields / 4)])
def test_a_tilted_race_is_aside_in_its_middle_and_twice_as_far_at_one_end(offset, aside):
    held = SPRAGS.tilted(4, offset)
    assert held.loads()[5] == pytest.approx(SPRAGS.T, rel=1e-9)
    x = [(held.d + held.R @ [0, 0, z])[0] for z in (-SPRAGS.L / 2, 0.0, SPRAGS.L / 2)]
    assert x == pytest.approx([0.0, aside, 2 * aside], abs=1e-3 * aside)
    assert np.all(held.forces() > 0)
