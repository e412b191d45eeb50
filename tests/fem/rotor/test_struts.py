"""Struts between rigid hubs: exact kinematics, closed forms, equilibrium or refusal."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

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


def test_a_rotation_vector_turns_as_scipy_s_does():
    for w in ([0.0, 0.0, 0.0], [1e-9, 0, 0], [0.3, -0.7, 1.1], [0, 0, math.pi]):
        expected = Rotation.from_rotvec(w).as_matrix()
        assert rotation(np.array(w)) == pytest.approx(expected, abs=1e-15)


@KINDS
def test_first_derivatives_are_those_of_the_shortening(struts):
    now, h = Joint.at_rest(struts, LAW).moved(SOMEWHERE), 1e-5

    def shortening(step):
        there = now.moved(step)
        return struts.state(there.d, there.R).s

    found = [(shortening(v) - shortening(-v)) / (2 * h) for v in h * np.eye(6)]
    gradient = struts.state(now.d, now.R).J
    assert gradient == pytest.approx(np.array(found).T, abs=1e-9)


@KINDS
def test_second_derivatives_are_those_of_the_shortening(struts):
    now, h = Joint.at_rest(struts, LAW).moved(SOMEWHERE), 1e-3
    steps = h * np.eye(6)

    def shortening(step):
        there = now.moved(step)
        return struts.state(there.d, there.R).s

    found = [
        [(shortening(u + v) - shortening(u - v) - shortening(v - u) + shortening(-u - v))
         / (4 * h**2) for v in steps]
        for u in steps
    ]  # fmt: skip
    expected = np.moveaxis(np.array(found), -1, 0)
    curvature = struts.state(now.d, now.R).H
    assert curvature == pytest.approx(expected, abs=1e-5)  # differences err by h^2 and more


def test_a_radial_strut_presses_with_what_its_law_says():
    one = pinned(a=np.array([[1.0, 0, 0]]), b=np.array([[2.0, 0, 0]]), s_0=0.0)
    now = Joint.at_rest(one, power_law(3.0, 2.0)).moved(np.array([0.1, 0, 0, 0, 0, 0]))
    # shortened by 0.1: 3 * 0.1^2, and a slope of 6 * 0.1; across it gives way by F/l = 0.03/0.9
    assert now.loads() == pytest.approx([0.03, 0, 0, 0, 0, 0], abs=1e-15)
    K = now.tangent()
    assert K[0, 0] == pytest.approx(0.6, rel=1e-13)
    assert K[1, 1] == pytest.approx(-0.03 / 0.9, rel=1e-13)
    # lengthened, it bears nothing
    assert not Joint.at_rest(one, LAW).moved(np.array([-0.1, 0, 0, 0, 0, 0])).loads().any()


def test_a_rolling_strut_keeps_its_lever_at_any_turn_of_the_hub():
    one = rolling()
    for turn in (-1.0, 0.3, 2.0):
        state = one.state(np.zeros(3), rotation(np.array([0, 0, turn])))
        assert state.s == pytest.approx(0.05 + 0.2 * turn, rel=1e-13)
        assert state.J[:, 5] == pytest.approx(0.2, rel=1e-13)
        assert state.H[:, 5, 5] == pytest.approx(0, abs=1e-14)


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
    law = power_law(3.0, 1.5)
    there = Joint.at_rest(struts, law).moved(0.1 * SOMEWHERE)
    free = (0, 1, 5)
    loads = there.loads()
    start = Joint.at_rest(struts, law).moved(0.1 * SOMEWHERE * [0, 0, 1, 1, 1, 0.5])
    found = start.under(loads, free)
    assert found.loads()[list(free)] == pytest.approx(loads[list(free)], rel=1e-10)


def test_each_strut_may_have_its_own_stiffness():
    k = np.arange(1.0, 8.0)
    joint = Joint.at_rest(pinned(s_0=0.1), power_law(k, 1.0))
    assert joint.forces() == pytest.approx(0.1 * k, rel=1e-14)


def test_no_equilibrium_is_refused_not_returned():
    # seven struts push outwards; none of them pulls the hub upwards
    joint = Joint.at_rest(rolling(), LAW)
    with pytest.raises(ArithmeticError, match="no equilibrium of the struts"):
        joint.under(np.array([0, 0, 5.0, 0, 0, 0]), (2,))


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: pinned(b=np.zeros((3, 3))), "ends need"),
        (lambda: Pinned(a=np.ones((1, 3)), b=np.ones((1, 3))), "both its ends coincide"),
        (lambda: rolling(z=np.zeros(3)), "one for each cam"),
    ],
)
def test_struts_without_sense_are_refused_in_words(call, said):
    with pytest.raises(ValueError, match=said):
        call()
