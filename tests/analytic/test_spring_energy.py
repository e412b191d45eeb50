"""Eqs. 1 to 9 of the accordion spring, each against its moments or a limit."""

import math

import numpy as np
import pytest

from analytic.spring import energy, garbled
from analytic.spring.energy import flexibility
from analytic.spring.moments import moment_diagram

SHAPE = {"L1": 11.6, "r": 0.45, "b": 0.1, "alpha": math.radians(80)}
STRIP = {"E": 206e3, "h": 56.0}  # N, mm
GAUSS, WEIGHT = np.polynomial.legendre.leggauss(30)
GAUSS, WEIGHT = (GAUSS + 1) / 2, WEIGHT / 2


def squared(length, moment, scale=1.0):
    """Integral of a moment's square over a length, by Gauss points."""
    return float(scale * length * (WEIGHT @ moment(length * GAUSS) ** 2))


def test_head_integrates_the_moments_of_eq_1():
    a, r = 5.8, 0.45
    expected = squared(a, lambda x: x) + squared(math.pi / 2, lambda t: a + r * np.sin(t), scale=r)
    assert float(energy.head_flexibility(L1=11.6, r=r)) == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("i", [2, 3], ids=["even unit", "odd unit"])
def test_units_integrate_the_moments_of_eq_3(i):
    r, alpha, T = 0.45, SHAPE["alpha"], 6.25 if i == 2 else -6.27
    s = 1 if i % 2 else -1
    L2, A = float(energy.leaf_length(**SHAPE)), r * (1 - math.cos(alpha))
    end = T + s * (A + L2 * math.sin(alpha))
    expected = (
        squared(alpha, lambda t: T + s * r * (1 - np.cos(t)), scale=r)
        + squared(L2, lambda x: T + s * (A + x * math.sin(alpha)))
        + squared(alpha, lambda t: end + s * r * (np.cos(alpha - t) - math.cos(alpha)), scale=r)
    )
    assert float(energy.unit_flexibility(i, T, **SHAPE)) == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize(("n", "sign"), [(10, -1), (9, 1)], ids=["even n", "odd n"])
def test_tail_integrates_the_moment_of_eq_5(n, sign):
    T, r = -sign * 6.25, 0.45
    expected = squared(math.pi / 2, lambda t: T + sign * r * (1 - np.cos(t)), scale=r)
    assert float(energy.tail_flexibility(n, T, r=r)) == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("n", [3, 6, 10])
def test_the_adopted_reading_by_quadrature_is_the_closed_form(n):
    a, r, alpha = SHAPE["L1"] / 2, SHAPE["r"], SHAPE["alpha"]
    L2 = float(energy.leaf_length(**SHAPE))
    if n % 2:  # the quadrature has the tail of Eq. 5, which is that of an even number
        T = energy.apex_moments(n=n, **SHAPE)[-1]
        change = energy.tail_flexibility(n + 1, T, r=r) - energy.tail_flexibility(n, T, r=r)
    else:
        change = 0.0
    found = garbled.flexibility(n, a, r, L2, alpha, "alternating", 1.0)
    assert found == pytest.approx(float(flexibility(n=n, **SHAPE) + change), rel=1e-13)


@pytest.mark.parametrize("n", [9, 10], ids=["odd n", "even n"])
def test_an_odd_spring_s_tail_takes_the_other_sign(n):
    """The couple falls on both tails: from the apex the arc runs back towards the force."""
    T = energy.apex_moments(n=n, **SHAPE)[-1]
    level = energy.tail_flexibility(n, T, r=0.45)
    flat = math.pi / 2 * 0.45 * float(T) ** 2  # the couple of the apex all along
    assert float(level) < flat


def test_deflection_is_the_derivative_of_the_energy():
    """Castigliano: dV/dF; V is quadratic, so that the central difference is exact."""
    spring = {"n": 10, **SHAPE, **STRIP}
    up, down = (float(energy.strain_energy(F=F, **spring)) for F in (3.0, 1.0))
    assert (up - down) / 2 == pytest.approx(float(energy.deflection(F=2.0, **spring)), rel=1e-14)
    assert float(energy.stiffness(**spring)) == pytest.approx(
        2.0 / float(energy.deflection(F=2.0, **spring)), rel=1e-14
    )


def test_bending_stress_is_the_apex_couple_over_the_section_modulus():
    # 6 * 11 N * 6.25 mm / (56 mm * 0.01 mm²) by hand, for a bar that is nearly straight
    stress = float(energy.bending_stress(F=11.0, b=0.1, h=56.0, r=0.45, L1=11.6))
    factor = float(energy.curvature_factor(b=0.1, r=0.45))
    assert stress / factor == pytest.approx(736.607, rel=1e-6)
    assert 1 < factor < 1 + 0.1 / 0.45  # of the order b/3R above a straight one


SPRINGS = [
    {"n": 10, "L1": 11.6, "r": 0.45, "b": 0.1, "alpha": np.radians(80)},
    {"n": 7, "L1": 4.0, "r": 0.6, "b": 0.2, "alpha": np.radians(55)},
]


@pytest.mark.parametrize("spring", SPRINGS)
def test_its_square_integrates_to_the_flexibility(spring):
    s, m = (a.reshape(-1, 65) for a in moment_diagram(**spring, per_piece=65))
    simpson = np.ones(65)
    simpson[1:-1:2], simpson[2:-1:2] = 4, 2
    integral = ((s[:, 1] - s[:, 0]) / 3 * (m**2 @ simpson)).sum()
    assert integral == pytest.approx(float(flexibility(**spring)), rel=1e-8)


@pytest.mark.parametrize("start", [0.0, 1.0])
def test_the_arc_of_the_tail_has_the_closed_form_at_any_angle(start):
    """Integral of (c + r cos t)^2 from 0 to beta, c the couple per force at the apex less r."""
    a, r, beta = 5.8, 0.45, 1.1
    c = a + (start - 1) * r
    head = a**3 / 3 + r * (a**2 * math.pi / 2 + 2 * a * r + r**2 * math.pi / 4)
    tail = c**2 * beta + 2 * c * r * math.sin(beta)
    tail += r**2 * (2 * beta + math.sin(2 * beta)) / 4
    ends = (math.pi / 2, beta)
    found = garbled.flexibility(2, a, r, 1.0, SHAPE["alpha"], "alternating", start, ends)
    assert found == pytest.approx(head + r * tail, rel=1e-13)
