"""A sprag clutch must not notice whether it is told in m and Pa or in mm and MPa."""

import numpy as np
import pytest

from analytic.sprag import closure, course, limits, start
from analytic.sprag.clutch import Clutch
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import Parts

MM, MPA = 1e3, 1e-6  # from SI; forces stay in N, torques are N mm


def made(k, s):
    sprag = LogSprag(R_i=11.11e-3 * k, R_e=19.44e-3 * k, m=0.09, r_i=4.02e-3 * k)
    parts = Parts(
        sprag=sprag, n_s=12, l=9e-3 * k, b=4e-3 * k, R_id=7.21e-3 * k, R_ed=26.23e-3 * k,
        E=206e9 * s, nu=0.3, rho=7850.0 * s / k**2, omega=500.0,
    )  # fmt: skip
    return parts, Clutch(sprag=sprag, n_s=12, compliance=parts.plane())


CASES = {
    **{
        name: (lambda k, s, name=name: getattr(closure.wedged(made(k, s)[1], 900.0), name), factor)
        for name, factor in (
            ("T", MM), ("alpha", 1.0), ("nu", 1.0), ("OA", MM), ("OB", MM), ("OC_e", MM),
            ("rho", MM), ("OC_g", MM), ("gamma", 1.0), ("b_i", MM), ("h_e", MM), ("N_e", 1.0))
    },
    "turn": (lambda k, s: course.rolled(made(k, s)[1], 900.0), 1.0),
    "energy": (lambda k, s: course.energy(made(k, s)[1], 900.0), MM),
    "load": (lambda k, s: closure.at_torque(made(k, s)[1], 20.0 * k).N, 1.0),
    "end": (lambda k, s: limits.limits(made(k, s)[1], mu=0.1, theta_max=0.2).end_of_cam, MM),
    "start": (lambda k, s: start.spring_equilibrium(
        made(k, s)[1], K_r=0.01 * k, alpha_max=0.5)[0].N, 1.0),
    "pressure": (lambda k, s: limits.pressures(
        made(k, s)[0], closure.wedged(made(k, s)[1], 900.0))[0], MPA),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_formula_is_dimensionally_homogeneous(name):
    formula, factor = CASES[name]
    assert float(np.asarray(formula(MM, MPA))) == pytest.approx(
        factor * float(formula(1.0, 1.0)), rel=1e-8
    )
