"""A finite line contact by strips: limits, conditions of contact, what strips neglect, readings."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.special import ellipe, ellipkm1

from analytic.contact import hertz_line
from analytic.contact.roller_parts import RollerParts, load_elsewhere
from analytic.contact.strip_error import discretisation, neglected
from analytic.contact.strip_influence import excess, log_part
from analytic.contact.strips import press_strips

# a sprag on its race: Huang 2018, R_1 = 4.02 and R_2 = 11.11 mm, l = 9 mm, steel
P_0 = 1e-3  # of an ellipse, in units of E*
SPRAG = {"length": 9e-3, "R": 2.952e-3, "E_star": 113.2e9}


def centres(n, length=9e-3):
    return ((np.arange(n) + 0.5) / n - 0.5) * length


def barrel(n, *, radius=0.6, tilt=0.0, length=9e-3):
    y = centres(n, length)
    return y**2 / (2 * radius) + tilt * y


def test_a_long_roller_has_hertz_pressure_and_width_in_the_middle():
    """Ends 500 half-widths away: what they take from the middle is of the order (b/l)²."""
    load = 100 * np.pi * 1e-4
    line = {"P": load / 100, "R": 1.0, "E_star": 4.0}
    roller = press_strips(np.zeros(2000), length=100.0, R=1.0, E_star=4.0, load=load)
    q = roller.q[1000]
    hertz = line | {"P": q}
    assert float(roller.mid) == pytest.approx(hertz_line.peak_pressure(**hertz), rel=1e-12)
    width = float(roller.half_width[1000])
    assert width == pytest.approx(hertz_line.half_width(**hertz), rel=1e-12)
    assert q == pytest.approx(load / 100, rel=0.04)  # the ends take q/ln(l/b)/... off the middle


def ellipse(b, n=161):
    """Strips pressed into Hertz's ellipse with semi-axes 1 and b, and its pressure there."""
    K, E = ellipkm1(b**2), ellipe(1 - b**2)
    along = P_0 * b / (1 - b**2) * (K - E)  # 1/(2 R_y), Johnson 1985, Eqs. 4.26 to 4.28
    across = P_0 * b / (1 - b**2) * (E / b**2 - K)
    y = centres(n, 2.2)
    roller = press_strips(
        along * y**2, length=2.2, R=1 / (2 * across), E_star=1.0, load=2 / 3 * np.pi * b * P_0
    )
    return roller, P_0 * np.sqrt(np.maximum(1 - y**2, 0.0)), y


@given(
    radius=st.floats(0.05, 50.0),
    tilt=st.floats(-2e-3, 2e-3),
    load=st.floats(1e-2, 2e4),
    n=st.integers(2, 60),
)
@settings(max_examples=60, deadline=None)
def test_nothing_pulls_and_nothing_overlaps(radius, tilt, load, n):
    """Displacements are computed here strip by strip, from the definition of C."""
    gap = barrel(n, radius=radius, tilt=tilt)
    roller = press_strips(gap, **SPRAG, load=load)
    assert float(roller.q.sum() * 9e-3 / n) == pytest.approx(load, rel=1e-9)
    assert np.all(roller.q >= 0)
    D = 9e-3 / n
    k = roller.carries
    d = np.subtract.outer(centres(n), centres(n))[:, k]

    def F(v):
        size = np.abs(v)
        return np.sign(v) * (excess(np.log(size))[0] + log_part(size))

    C = F((d + D / 2) / roller.half_width[k]) - F((d - D / 2) / roller.half_width[k])
    u = 2 / (np.pi**2 * SPRAG["E_star"]) * C @ roller.q[k]
    left = u + gap - roller.approach
    deepest = u.max()
    assert np.abs(left[k]).max() < 1e-9 * deepest
    assert left.min() > -1e-9 * deepest


def test_a_batch_equals_its_single_cases_with_and_without_workers(monkeypatch):
    """In parts of 100 cases, the last one smaller."""
    monkeypatch.setattr("analytic.contact.strips.AT_ONCE", 5000)
    rng, cases = np.random.default_rng(2), 230
    crown, tilt = rng.uniform(0.02, 3, (cases, 1)), rng.uniform(-1e-3, 1e-3, (cases, 1))
    gap = barrel(50) * crown + centres(50) * tilt
    sizes = {"R": rng.uniform(2e-3, 4e-3, cases), "length": rng.uniform(8e-3, 12e-3, cases),
             "load": 10 ** rng.uniform(1, 3.8, cases)}  # fmt: skip
    batch = press_strips(gap, E_star=1e11, **sizes)
    assert batch.residual.max() <= 1e-10
    for k in range(0, cases, 25):
        alone = press_strips(gap[k], E_star=1e11, **{name: size[k] for name, size in sizes.items()})
        np.testing.assert_allclose(batch.q[k], alone.q, atol=5e-9 * alone.q.max())
        assert float(batch.approach[k]) == pytest.approx(float(alone.approach), rel=1e-9)
    threads = press_strips(gap, E_star=1e11, **sizes, workers=2)
    np.testing.assert_array_equal(threads.q, batch.q)


def test_cases_that_do_not_converge_are_reported(monkeypatch):
    monkeypatch.setattr("analytic.contact.strip_newton.ITERATIONS", 2)
    with pytest.raises(ArithmeticError, match="1 of 1 cases of strips did not converge in 2"):
        press_strips(barrel(30), **SPRAG, load=3400.0)


def F(v):
    v = np.atleast_1d(v)
    return np.squeeze(excess(np.log(v))[0] + log_part(v))


@pytest.mark.parametrize("v", [1e-5, 0.03, 1.0, 7.3, 7.5, 1e6])
def test_the_table_meets_the_defining_integral(v):
    """Substituting x = sin(pi/2 e^-w) takes the logarithm at x = 0 out."""

    def integrand(w):
        angle = np.pi / 2 * np.exp(-w)
        return 2 * np.cos(angle) ** 2 * np.arcsinh(v / np.sin(angle)) * angle

    exact, _ = quad(integrand, 0, 60, epsabs=1e-14, epsrel=1e-12, limit=500)
    assert float(F(v)) == pytest.approx(exact, rel=2e-11)


@pytest.mark.parametrize("b", [0.02, 0.3])
def test_the_estimate_meets_the_deviation_from_hertz_ellipse(b):
    """What is left is of the order of the deviation squared, and of the strips' width."""
    roller, exact, y = ellipse(b)
    estimate = neglected(roller)
    inner = np.abs(y) < 0.8
    deviation = exact[inner] / roller.pressure[inner] - 1
    np.testing.assert_allclose(estimate.pressure[inner], deviation, rtol=0.04)
    assert float(estimate.peak) == pytest.approx(exact.max() / float(roller.peak) - 1, rel=0.04)
    assert float(estimate.mid) == pytest.approx(float(estimate.peak), rel=1e-6)


def test_the_discretisation_estimate_covers_what_more_strips_change():
    coarse, fine, exact = (ellipse(0.1, count)[0] for count in (20, 40, 320))
    for estimate, left in zip(
        discretisation(coarse, fine),
        (fine.peak / exact.peak - 1, fine.mid / exact.mid - 1),
        strict=True,
    ):
        assert abs(float(left)) <= float(estimate) < 5e-3


def test_loads_that_agree_put_nothing_elsewhere_however_they_are_divided():
    fine = 1 + np.linspace(0, 1, 400)
    coarse = fine.reshape(50, 8).mean(axis=1)
    share, error = load_elsewhere(coarse, fine, 3.0)
    assert max(share, error) < 1e-12
    share, _ = load_elsewhere(coarse[::-1], fine, 3.0)
    assert share == pytest.approx(np.abs(coarse - coarse[::-1]).sum() / coarse.sum() / 2)


def parts(p, line=None, d=0.0, length=1.0):
    n = len(p)
    y = ((np.arange(n) + 0.5) / n - 0.5) * length
    line = np.asarray(p if line is None else line, float)
    return RollerParts(y=y, p=np.asarray(p, float), line=line, delta=0.0, length=length, d=d)


@pytest.mark.parametrize("n", [40, 41])
def test_a_peak_at_the_end_counts_only_with_ends_included(n):
    one = parts(np.where(np.arange(n) == n - 1, 5.0, 1.0), d=0.2)
    assert one.p_max == 1.0
    assert one.p_top == 5.0
    assert one.p_mid == one.q_mid == 1.0


def test_a_pressure_that_rises_to_the_ends_is_read_at_their_limit():
    """Centres of the parts 0.5 and 1.5 from mid-length, ends of 1 and 0.75: linear in between."""
    one = parts([3.0, 1.0, 1.0, 3.0], d=1.0, length=4.0)
    assert one.p_max == pytest.approx(2.0, rel=1e-14)
    assert parts([3.0, 1.0, 1.0, 3.0], d=0.75, length=4.0).p_max == pytest.approx(2.5, rel=1e-14)


@pytest.mark.parametrize("n", [1, 2, 51])
def test_load_and_approach_lead_back_to_each_other(n):
    gap = barrel(n, tilt=3e-4)
    by_load = press_strips(gap, **SPRAG, load=3400.0)
    by_approach = press_strips(gap, **SPRAG, approach=by_load.approach)
    assert float(by_approach.load) == pytest.approx(3400.0, rel=1e-8)
    np.testing.assert_allclose(by_approach.q, by_load.q, atol=1e-8 * by_load.q.max())


def test_a_flat_roller_has_no_estimate_at_its_ends_and_nearly_nothing_in_the_middle():
    roller = press_strips(np.zeros(81), length=9e-3, R=3e-3, E_star=1e11, load=3000.0)
    estimate = neglected(roller)
    from_end = (np.arange(81) + 0.5) * 9e-3 / 81
    near = np.minimum(from_end, from_end[::-1]) < 3 * roller.half_width
    assert near.sum() > 2
    np.testing.assert_array_equal(np.isnan(estimate.pressure), near)
    assert np.isnan(estimate.peak)
    assert abs(float(estimate.mid)) < 1e-3
