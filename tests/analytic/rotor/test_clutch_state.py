"""Where a clutch stands: torque and loads are met, from far away, or refused."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from analytic.rotor.clutch import Clutch, even_angles
from analytic.rotor.clutch_state import preload_twist, under_loads, under_torque

fixed = settings(deadline=None, derandomize=True, max_examples=25)
SPRAG = {"R_i": 11.11e-3, "nu": math.radians(3.15), "L": 9e-3, "k_n": 5.7e8}


def clutch(Z=12, *, missing=(), n_s=7, **more):
    return Clutch(psi=even_angles(Z=Z, missing=missing), n_s=n_s, **SPRAG | more)


@fixed
@given(
    st.floats(-2, 3).map(lambda p: 10.0**p),
    st.tuples(*[st.floats(-100e-6, 100e-6)] * 2, *[st.floats(-5e-3, 5e-3)] * 2),
    st.floats(0, 20e-6),
)
def test_the_torque_is_met_at_any_offset_with_any_crown(T, offset, drop):
    one = clutch(missing=(2, 3), crown=lambda x: drop * (x / 4.5e-3) ** 2)
    q = under_torque(one, T=T, offset=offset)
    assert one.loads(q)[4] == pytest.approx(T, rel=1e-9)
    assert tuple(q[:4]) == offset


def test_torques_are_met_all_at_once():
    one = clutch(interference=np.linspace(-2e-6, 2e-6, 12))
    T = np.geomspace(0.01, 100, 7)
    g = preload_twist(one, T=T, offset=(2e-6, 0, 0, 1e-4))
    each = [float(preload_twist(one, T=t, offset=(2e-6, 0, 0, 1e-4))) for t in T]
    assert g == pytest.approx(each, rel=1e-11)
    assert (np.diff(g) > 0).all()


def test_a_sprag_with_interference_bears_more():
    one = clutch(interference=np.eye(12)[3] * 1e-6)
    N = one.forces(under_torque(one, T=15.0)).sum(-1)
    assert N.argmax() == 3
    assert np.delete(N, 3) == pytest.approx(N[0], rel=1e-12)


def test_a_gap_all_around_is_twisted_away_first():
    one = clutch(interference=-50e-6)
    g = preload_twist(one, T=15.0)
    assert g == pytest.approx(preload_twist(clutch(), T=15.0) + 50e-6 / one.d_t, rel=1e-12)


def test_loads_of_a_known_place_lead_back_to_it():
    one = clutch(missing=(1,), crown=lambda x: 1e-6 * (x / 4.5e-3) ** 2)
    q = np.array([3e-6, -2e-6, 2e-4, 3e-4, 0.021])
    found = under_loads(one, one.loads(q))
    assert found == pytest.approx(q, rel=1e-8)


def test_a_free_inner_race_moves_where_a_sprag_is_missing():
    one = clutch(missing=(0,))
    q = under_loads(one, np.array([0, 0, 0, 0, 15.0]))
    assert q[0] > 0  # towards the gap
    assert one.loads(q) == pytest.approx([0, 0, 0, 0, 15.0], abs=1e-7)
    # with q no load is left, so no force on the bearings either
    assert np.abs(one.loads(under_torque(one, T=15.0))[0]) > 1000


def test_one_slice_leaves_the_tilts_alone():
    q = under_loads(clutch(n_s=1), np.array([500.0, 0, 0, 0, 15.0]))
    assert q[2] == q[3] == 0
    assert q[0] > 0


def test_no_equilibrium_is_refused_not_returned():
    # sprags push outwards with N in all, T = Z N d_t: no radial load can be larger than all of N
    most = 15.0 / clutch().d_t
    with pytest.raises(ArithmeticError, match="no equilibrium under F"):
        under_loads(clutch(), np.array([1.1 * most, 0, 0, 0, 15.0]))


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: preload_twist(clutch(), T=0.0), "T must be positive and finite, got 0 N m"),
        (lambda: preload_twist(clutch(), T=[1.0, -2.0]), "got -2 N m"),
        (lambda: preload_twist(clutch(), T=math.nan), "T must be positive"),
        (lambda: preload_twist(clutch(), T=1.0, offset=(0, 0, 0)), "four finite numbers"),
        (lambda: under_loads(clutch(), [0, 0, 0, 0, -1.0]), "the torque positive"),
        (lambda: under_loads(clutch(), [0, 0, 0, 1.0]), "five finite numbers"),
        (lambda: under_loads(clutch(n_s=1), [0, 0, 1.0, 0, 1.0]), "no bending moment"),
    ],
)
def test_loads_without_sense_are_refused_in_words(call, said):
    with pytest.raises(ValueError, match=said):
        call()
