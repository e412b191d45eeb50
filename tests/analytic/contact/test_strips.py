"""A finite line contact by strips: limits, contact conditions, batches, refusals."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import dblquad
from scipy.special import ellipe, ellipkm1

from analytic.contact import hertz_line, strip_newton
from analytic.contact.strip_influence import excess, log_part
from analytic.contact.strip_newton import solve
from analytic.contact.strips import press

# a sprag on its race: Huang 2018, R_1 = 4.02 and R_2 = 11.11 mm, l = 9 mm, steel
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
    roller = press(np.zeros(2000), length=100.0, R=1.0, E_star=4.0, load=load)
    q = roller.q[1000]
    assert float(roller.mid) == pytest.approx(
        hertz_line.peak_pressure(**line | {"P": q}), rel=1e-12
    )
    assert float(roller.half_width[1000]) == pytest.approx(
        hertz_line.half_width(**line | {"P": q}), rel=1e-12
    )
    assert q == pytest.approx(load / 100, rel=0.04)  # the ends take q/ln(l/b)/... off the middle


def test_one_strip_sinks_as_its_pressure_integrated_over_a_half_space():
    """Its u is 1/(pi E*) times the integral of p/r, straight from the point load."""
    roller = press([0.0], length=3.0, R=1.0, E_star=4.0, load=2.0)
    b, p = float(roller.half_width[0]), float(roller.pressure[0])

    def over_r(y, angle):  # x = b sin(angle)
        return b * np.cos(angle) ** 2 / np.hypot(b * np.sin(angle), y)

    quarter, _ = dblquad(over_r, 0, np.pi / 2, 0, 1.5, epsabs=1e-9)
    assert float(roller.approach) == pytest.approx(4 * p * quarter / (4 * np.pi), rel=1e-6)
    assert float(roller.load) == pytest.approx(np.pi / 2 * p * b * 3.0, rel=1e-12)


def test_two_strips_sink_each_other_by_what_their_distance_leaves():
    """Far apart a strip is a point load: q D/(pi E* d), here with D/d = 1/40."""
    gap = np.full(41, 1.0)
    gap[[0, 40]] = 0.0
    roller = press(gap, length=4.1, R=1e-3, E_star=4.0, load=2e-6)
    alone = press([0.0], length=0.1, R=1e-3, E_star=4.0, load=1e-6)
    extra = float(roller.approach - alone.approach)
    assert extra == pytest.approx(1e-6 / (np.pi * 4.0 * 4.0), rel=1e-4)


def test_lundbergs_profile_is_pressed_evenly():
    """Even line load but for the last strips, where the profile's logarithm is cut into strips."""
    n, load = 160, 3400.0
    y = centres(n)
    z = -load / (np.pi * SPRAG["length"] * SPRAG["E_star"]) * np.log(1 - (2 * y / 9e-3) ** 2)
    roller = press(z, **SPRAG, load=load)
    inner = np.abs(y) < 0.45 * 9e-3
    assert np.ptp(roller.q[inner]) < 0.02 * load / 9e-3


@pytest.mark.parametrize(("slimness", "error"), [(0.1, 0.006), (0.05, 0.002), (0.02, 0.0005)])
def test_a_strongly_crowned_roller_meets_hertz_ellipse(slimness, error):
    """Exact solution with semi-axes 1 and b (Johnson 1985, Eqs. 4.26 to 4.28)."""
    b, p_0 = slimness, 1e-3
    K, E = ellipkm1(b**2), ellipe(1 - b**2)
    along = p_0 * b / (1 - b**2) * (K - E)  # 1/(2 R_y)
    across = p_0 * b / (1 - b**2) * (E / b**2 - K)  # 1/(2 R_x)
    y = centres(161, 2.2)
    roller = press(
        along * y**2, length=2.2, R=1 / (2 * across), E_star=1.0, load=2 / 3 * np.pi * b * p_0
    )
    assert float(roller.peak) == pytest.approx(p_0, rel=error)
    assert float(roller.approach) == pytest.approx(p_0 * b * K, rel=error)
    assert np.abs(y[roller.carries]).max() == pytest.approx(1.0, abs=2.2 / 161)


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
    roller = press(gap, **SPRAG, load=load)
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


@pytest.mark.parametrize("n", [1, 2, 7, 50, 51])
def test_load_and_approach_lead_back_to_each_other(n):
    gap = barrel(n, tilt=3e-4)
    by_load = press(gap, **SPRAG, load=3400.0)
    by_approach = press(gap, **SPRAG, approach=by_load.approach)
    assert float(by_approach.load) == pytest.approx(3400.0, rel=1e-8)
    np.testing.assert_allclose(by_approach.q, by_load.q, atol=1e-8 * by_load.q.max())


def test_an_approach_that_reaches_nothing_gives_no_load():
    roller = press(barrel(20) + 1e-6, **SPRAG, approach=[-1.0, 0.0, 0.9e-6])
    np.testing.assert_array_equal(roller.load, 0.0)
    np.testing.assert_array_equal(roller.approach, [-1.0, 0.0, 0.9e-6])
    assert not roller.carries.any()


def test_a_gap_all_round_is_added_to_the_approach_alone():
    near, far = press(barrel(30) + np.array([[0.0], [2e-5]]), **SPRAG, load=2000.0).approach
    assert float(far - near) == pytest.approx(2e-5, rel=1e-10)


def test_a_mirrored_roller_has_mirrored_loads_and_a_symmetric_one_symmetric_ones():
    gap = barrel(40, tilt=5e-4)
    there, back = press(np.stack([gap, gap[::-1]]), **SPRAG, load=1000.0).q
    np.testing.assert_allclose(there, back[::-1], atol=1e-8 * there.max())
    even = press(barrel(41), **SPRAG, load=1000.0).q
    np.testing.assert_allclose(even, even[::-1], atol=1e-8 * even.max())


def test_a_light_load_on_a_tilted_roller_rests_on_one_strip():
    roller = press(barrel(50, tilt=1e-2), **SPRAG, load=1e-6)
    assert roller.carries.sum() == 1
    assert float(roller.load) == pytest.approx(1e-6, rel=1e-12)


def test_units_don_t_matter():
    si = press(barrel(30, tilt=1e-4), **SPRAG, load=3400.0)
    mm = press(
        1e3 * barrel(30, tilt=1e-4), length=9.0, R=2.952, E_star=113.2e3, load=3400.0
    )  # N, mm, MPa
    np.testing.assert_allclose(mm.q, 1e-3 * si.q, rtol=1e-8)
    np.testing.assert_allclose(mm.pressure, 1e-6 * si.pressure, rtol=1e-8)
    assert float(mm.approach) == pytest.approx(1e3 * float(si.approach), rel=1e-9)


def test_a_batch_says_what_its_cases_say_alone_and_workers_change_nothing(monkeypatch):
    """In parts of 100 cases, the last one smaller."""
    monkeypatch.setattr("analytic.contact.strips.AT_ONCE", 5000)
    rng = np.random.default_rng(2)
    cases = 430
    gap = barrel(50) * rng.uniform(0.02, 3, (cases, 1)) + centres(50) * rng.uniform(
        -1e-3, 1e-3, (cases, 1)
    )
    given = {
        "R": rng.uniform(2e-3, 4e-3, cases),
        "length": rng.uniform(8e-3, 12e-3, cases),
        "E_star": 1e11,
        "load": 10 ** rng.uniform(1, 3.8, cases),
    }
    batch = press(gap, **given)
    assert batch.residual.max() <= 1e-10
    for k in range(0, cases, 25):
        alone = press(
            gap[k], E_star=1e11, **{name: given[name][k] for name in ("R", "length", "load")}
        )
        np.testing.assert_allclose(batch.q[k], alone.q, atol=5e-9 * alone.q.max())
        assert float(batch.approach[k]) == pytest.approx(float(alone.approach), rel=1e-9)
    threads = press(gap, **given, workers=2)
    np.testing.assert_array_equal(threads.q, batch.q)


def test_crowned_and_tilted_rollers_take_ten_iterations_at_most():
    """What 100 000 cases take depends on it: each iteration leaves about a hundredth."""
    tilt = np.linspace(-1e-3, 1e-3, 50)[:, None]
    D = 9e-3 / 50
    h = (barrel(50) + tilt * centres(50)) * 2 * np.pi * SPRAG["R"] / D**2
    assert solve(h, tolerance=1e-10, total=np.linspace(2.0, 30.0, 50)).iterations <= 10


def test_a_loose_tolerance_costs_what_it_says():
    gap = barrel(50) * np.linspace(0.05, 3, 40)[:, None] + 3e-4 * centres(50)
    tight = press(gap, **SPRAG, load=3400.0)
    loose = press(gap, **SPRAG, load=3400.0, tolerance=1e-8)
    np.testing.assert_allclose(loose.q, tight.q, atol=1e-7 * tight.q.max())


def test_cases_broadcast_and_an_empty_batch_is_empty():
    roller = press(barrel(12), **SPRAG | {"R": [[2e-3], [3e-3]]}, load=[10.0, 100.0, 1000.0])
    assert roller.q.shape == (2, 3, 12)
    assert roller.peak.shape == (2, 3)
    np.testing.assert_allclose(roller.load, [[10.0, 100.0, 1000.0]] * 2)
    assert press(np.zeros((0, 5)), **SPRAG, load=1.0).q.shape == (0, 5)


def test_mid_pressure_is_that_of_the_middle_for_even_and_odd_numbers_of_strips():
    even, odd = (press(barrel(n), **SPRAG, load=500.0).mid for n in (80, 81))
    assert float(even) == pytest.approx(float(odd), rel=1e-3)


@pytest.mark.parametrize("width", [1e-5, 1e-3, 0.1, 0.4])
def test_strips_much_wider_and_much_narrower_than_the_contact_converge(width):
    """b/l from 1e-5 (strips 1700 b wide) to 0.4 (24 strips a half-width)."""
    load = np.pi * width**2  # b = width for R = l = 1, E* = 4
    roller = press(np.zeros(60), length=1.0, R=1.0, E_star=4.0, load=load)
    assert float(roller.residual) <= 1e-10
    assert float(roller.half_width[30]) == pytest.approx(width, rel=0.3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"load": 0.0}, r"load must be positive and finite, got 0\.0 N"),
        ({"load": np.nan}, "load must be positive and finite"),
        ({"R": -1.0}, "relative radius must be positive"),
        ({"length": np.inf}, "length must be positive"),
        ({"E_star": 0.0}, r"contact modulus must be positive.* Pa"),
        ({"load": None}, r"either the load \[N\] or the approach \[m\]"),
        ({"approach": 1e-6}, r"either the load \[N\] or the approach \[m\]"),
        ({"load": None, "approach": np.nan}, "approach must be finite"),
        ({"gap": 0.0}, "strips along its last axis"),
        ({"gap": np.zeros((3, 0))}, "strips along its last axis"),
        ({"gap": [0.0, np.nan]}, "gap must be finite"),
        ({"gap": np.zeros((3, 5)), "load": [1.0, 2.0]}, "must broadcast"),
        ({"load": 1e9}, "longer than wide.*got b/l"),
        ({"load": None, "approach": 1.0}, "longer than wide.*got b/l"),
        ({"tolerance": 0.0}, "tolerance must lie in"),
    ],
)
def test_input_that_makes_no_sense_is_refused_in_one_line(change, message):
    sound = {"gap": barrel(10), **SPRAG, "load": 100.0} | change
    with pytest.raises(ValueError, match=message) as refusal:
        press(sound.pop("gap"), **sound)
    assert "\n" not in str(refusal.value)


def test_cases_that_do_not_converge_say_so(monkeypatch):
    monkeypatch.setattr("analytic.contact.strip_newton.ITERATIONS", 2)
    with pytest.raises(ArithmeticError, match="1 of 1 cases did not converge in 2 iterations"):
        press(barrel(30), **SPRAG, load=3400.0)


def test_what_overlaps_without_a_load_is_no_solution():
    """A strip that carries nothing must not be entered: by 0.1 of the 2 that bodies approach."""
    s, h, level = np.array([[1.0, 0.0]]), np.array([[0.0, 1.0]]), np.array([2.0])
    apart, within = np.array([[0.0, 0.1]]), np.array([[0.0, -0.1]])
    assert strip_newton._residual(s, apart, h, level, None).tolist() == [0.0]
    assert strip_newton._residual(s, within, h, level, None) == pytest.approx(0.05)
    lifted = np.array([[0.1, 0.1]])  # nor may one that carries be apart
    assert strip_newton._residual(s, lifted, h, level, None) == pytest.approx(0.05)
