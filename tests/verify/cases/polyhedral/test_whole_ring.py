"""Readings common to formulas and finite elements of the polyhedral cases, by a third model.

A whole ring is driven as a clutch is: the hub pushes every flat on one side of its middle, the
rollers press and drag. It distinguishes the direction of the hub's friction, the lever of the
rollers' friction, diameters and radii, and where K and the clearance are taken.
"""

from cmath import rect
from functools import cache
from math import pi, sqrt

import pytest
from scipy.optimize import brentq

from tests.verify.cases.polyhedral.whole_ring import WholeRing
from verify.cases.polyhedral.clutch.case import CLUTCH
from verify.cases.polyhedral.ring.case import RING, PolyhedralRing

CLOSE = 2e-3


@cache
def ring():
    return WholeRing(PolyhedralRing())


def test_k_is_taken_at_the_rollers_in_the_mean_and_at_the_corners():
    q, model = PolyhedralRing(), ring()
    v, u = RING.analytic(q), model.solve(model.pressed())
    thin = 4e-9 * q.delta_1 * q.E / ((q.d_e - 2 * q.delta_1) * (q.d_e - q.delta_1))  # MPa/mm
    mid, corner = model.growth(u), model.growth(u, rect(1, pi / q.z))
    for key, growth in (("mid", mid), ("mean", model.mean_growth(u)), ("corner", corner)):
        assert 1 / (thin * growth) == pytest.approx(v[f"K_{key}"], rel=CLOSE), key
    assert 500e6 * q.j_D / mid == pytest.approx(v["p_1r"], rel=CLOSE)


def test_a_hub_on_one_side_lifts_the_rollers_as_its_mirrored_halves_do():
    q, model = PolyhedralRing(), ring()
    lift = model.growth(model.solve(model.driven(q.tan_phi)[0]))
    assert q.R_b * lift / 1e6 == pytest.approx(RING.analytic(q)["hub_e_mid"], rel=1e-3)


def test_the_torque_is_that_of_rollers_and_hub_in_balance():
    q, model = CLUTCH.inputs(), ring()
    v, (turning, moment) = CLUTCH.analytic(q), model.driven(q.tan_phi)
    p, lever, gap = q.p_t / 1e6, 500 * q.D_i, 500 * (q.D_i - q.d_e - 2 * q.d)
    pressed = model.growth(model.solve(model.pressed()))
    lift = q.mu * lever / moment * model.growth(model.solve(turning))

    def left(N):
        a = sqrt(4e6 * N / (pi * q.E * (2e-3 / q.d + 2e-3 / q.d_e)))
        return (
            p * pressed + N * (lift + model.growth(model.solve(model.rolled(a, inwards=1)))) - gap
        )

    N = brentq(left, 100, 500, rtol=1e-5)
    assert 1e6 * gap / pressed == pytest.approx(v["p_1r"], rel=CLOSE)
    assert q.z * q.b * q.mu * lever * N == pytest.approx(v["M_rigid"], rel=CLOSE)
