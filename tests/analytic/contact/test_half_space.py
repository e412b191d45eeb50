"""Half-spaces in contact against closed forms, conditions of contact and each other's runs."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ellipe, ellipk

from analytic.contact import love
from analytic.contact.half_space import HalfSpace, press
from analytic.contact.half_space_contact import HalfSpaceContact, centres
from analytic.contact.half_space_convolution import Convolution

E_STAR, R, A = 1e11, 1e-2, 1e-4  # Pa, m and m: a sphere with this half-width of contact
LOAD = 4 * E_STAR * A**3 / (3 * R)  # Johnson, Contact Mechanics, Eqs. 4.22 to 4.24
PEAK = 2 * E_STAR * A / (np.pi * R)
APPROACH = A**2 / R


def paraboloid(n: int, *, across: float = 1.2, R_y: float = R) -> tuple[np.ndarray, float]:
    """Gap of a sphere or, with R_y, less round body, and the side of the n by n cells."""
    side = 2 * across * A / n
    x = centres(n, side)
    return x[:, None] ** 2 / (2 * R) + x**2 / (2 * R_y), side


def sphere(n: int, **asked: float) -> HalfSpaceContact:
    gap, side = paraboloid(n)
    return press(gap, cell=(side, side), E_star=E_STAR, **(asked or {"load": LOAD}))


def rough(seed: int, shape: tuple[int, int] = (24, 20)) -> np.ndarray:
    return 1e-6 * np.random.default_rng(seed).standard_normal(shape)


def assert_in_contact(found: HalfSpaceContact, tolerance: float = 1e-10) -> None:
    """No pull, no overlap, and pressure only where there is no gap."""
    most = tolerance * max(found.displacement.max(), abs(found.approach))
    assert found.pressure.min() >= 0
    assert found.gap.min() >= -most
    assert np.abs(found.gap[found.carries]).max(initial=0.0) <= most
    assert found.complementarity <= tolerance


def test_a_sphere_has_hertzs_pressure_area_and_approach() -> None:
    found = sphere(128)
    r = np.hypot(found.x[:, None], found.y)
    hertz = PEAK * np.sqrt(np.maximum(1 - (r / A) ** 2, 0.0))
    assert found.pressure.max() == pytest.approx(PEAK, rel=1e-3)
    assert found.approach == pytest.approx(APPROACH, rel=1e-4)
    assert found.carries.sum() * found.area == pytest.approx(np.pi * A**2, rel=1e-2)
    assert np.linalg.norm(found.pressure - hertz) < 5e-3 * np.linalg.norm(hertz)
    assert_in_contact(found)


def test_errors_of_a_sphere_fall_with_the_cell() -> None:
    counts = np.array([16, 32, 64, 128, 256])
    norms = []
    for n in counts:
        found = sphere(int(n))
        r = np.hypot(found.x[:, None], found.y)
        hertz = PEAK * np.sqrt(np.maximum(1 - (r / A) ** 2, 0.0))
        norms.append(np.linalg.norm(found.pressure - hertz) / np.linalg.norm(hertz))
    order = -np.polyfit(np.log(counts), np.log(norms), 1)[0]
    assert 0.8 < order < 1.4, f"{order}, errors {norms}"  # a stepped rim, sqrt(r) within: 1


def test_an_elliptic_contact_has_hertzs_pressure_and_approach() -> None:
    a, b, n = A, A / 4, 128  # Johnson, Eqs. 4.28 to 4.32, from half-axes and peak to all others
    m = 1 - (b / a) ** 2
    unit = PEAK / E_STAR * b / (a**2 * m)
    flat, sharp = unit * (ellipk(m) - ellipe(m)), unit * (ellipe(m) * (a / b) ** 2 - ellipk(m))
    cell = (2.4 * b / n, 2.4 * a / n)
    gap = sharp * centres(n, cell[0])[:, None] ** 2 + flat * centres(n, cell[1]) ** 2
    found = press(gap, cell=cell, E_star=E_STAR, load=2 * np.pi * a * b * PEAK / 3)
    assert found.pressure.max() == pytest.approx(PEAK, rel=1e-3)
    assert found.approach == pytest.approx(PEAK / E_STAR * b * ellipk(m), rel=2e-4)
    assert np.ptp(found.y[found.carries.any(axis=0)]) == pytest.approx(2 * a, rel=0.03)
    assert np.ptp(found.x[found.carries.any(axis=1)]) == pytest.approx(2 * b, rel=0.03)


def test_a_round_punch_is_as_stiff_as_closed_form_and_peaks_at_its_rim() -> None:
    stiffness, middle = [], []
    for n in (64, 128, 256):
        x = centres(n, 2.1 * A / n)
        gap = np.where(np.hypot(x[:, None], x) < A, 0.0, A)
        found = press(gap, cell=(2.1 * A / n,) * 2, E_star=E_STAR, approach=A / 100)
        stiffness.append(found.load / (2 * E_STAR * A * A / 100) - 1)
        centre = found.pressure[n // 2, n // 2] / (found.load / (2 * np.pi * A**2)) - 1
        middle.append(centre)
        peak = np.unravel_index(found.pressure.argmax(), gap.shape)
        assert np.hypot(x[peak[0]], x[peak[1]]) > 0.9 * A
    assert abs(stiffness[-1]) < 3e-3, stiffness
    assert abs(middle[-1]) < 6e-3, middle
    assert abs(stiffness[-1]) < 0.6 * abs(stiffness[0])


def test_one_cell_sinks_by_loves_formula() -> None:
    found = press([[0.0]], cell=(2.0, 6.0), E_star=5.0, load=24.0)
    assert found.approach == pytest.approx(
        2.0 * float(love.displacement(0.0, 0.0, a=1.0, b=3.0, E_star=5.0)), rel=1e-13
    )


@pytest.mark.parametrize("shape", [(6, 8), (7, 9), (1, 5), (2, 30)])
@pytest.mark.parametrize("mirrored", [(False, False), (True, False), (False, True), (True, True)])
def test_transforms_sum_what_every_cell_does_to_every_other(
    shape: tuple[int, int], mirrored: tuple[bool, bool]
) -> None:
    if any(m and n % 2 for m, n in zip(mirrored, shape, strict=True)):
        return  # a middle cell has no half
    p = np.random.default_rng(3).random(shape)
    for axis in (0, 1):
        p = p + np.flip(p, axis) if mirrored[axis] else p
    x, y = centres(shape[0], 1.0), centres(shape[1], 0.3)
    pairs = x[:, None, None, None] - x[:, None], y[:, None, None] - y
    summed = np.einsum("ijkl,kl", love.displacement(*pairs, a=0.5, b=0.15, E_star=2.0), p)
    K = Convolution(shape, cell=(1.0, 0.3), E_star=2.0, mirrored=mirrored)
    assert K.whole(K.displacement(K.half(p))) == pytest.approx(summed, rel=1e-13)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.floats(-2, 3), st.booleans())
def test_rough_bodies_meet_the_conditions_of_contact(seed: int, decade: float, thin: bool) -> None:
    gap = rough(seed, (2, 90) if thin else (24, 20))
    cell = (1e-7, 2e-6) if thin else (1e-6, 2e-6)
    found = press(gap, cell=cell, E_star=E_STAR, load=10**decade)
    assert_in_contact(found)
    assert found.load == pytest.approx(10**decade, rel=1e-12)


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 10**6), st.floats(-2, 3))
def test_load_and_approach_give_back_each_other(seed: int, decade: float) -> None:
    gap, cell = rough(seed), (1e-6, 2e-6)
    by_load = press(gap, cell=cell, E_star=E_STAR, load=10**decade)
    by_approach = press(gap, cell=cell, E_star=E_STAR, approach=by_load.approach)
    assert by_approach.load == pytest.approx(by_load.load, rel=1e-7)
    scale = by_load.pressure.max()
    assert by_approach.pressure == pytest.approx(by_load.pressure, abs=1e-6 * scale)


def test_work_on_the_way_is_the_energy_in_the_end() -> None:
    assert sphere(128).energy == pytest.approx(0.4 * LOAD * APPROACH, rel=1e-3)


def test_two_pressures_do_the_same_work_on_each_other() -> None:
    K = Convolution((9, 14), cell=(1e-6, 3e-6), E_star=E_STAR)
    p, q = np.random.default_rng(7).random((2, 9, 14))
    work = np.vdot(q, K.displacement(p))
    assert np.vdot(p, K.displacement(q)) == pytest.approx(work, rel=1e-13, abs=0)


def test_the_preconditioner_is_symmetric_and_definite() -> None:
    for shape, side in itertools.product(((9, 14), (3, 200), (1, 40)), (1e-10, 3e-6, 1e-2)):
        K = Convolution(shape, cell=(side, 3e-6), E_star=E_STAR)
        p, q = np.random.default_rng(7).standard_normal((2, *shape))
        assert np.vdot(p, K.precondition(q)) == pytest.approx(
            np.vdot(q, K.precondition(p)), rel=1e-10
        )
        assert np.vdot(p, K.precondition(p)) > 0
        assert K._inverse.min() > 0


@pytest.mark.parametrize("axis", [0, 1])
def test_mirrored_gaps_have_mirrored_pressures(axis: int) -> None:
    gap = rough(5)
    one, other = (
        press(g, cell=(1e-6, 2e-6), E_star=E_STAR, load=5.0) for g in (gap, np.flip(gap, axis))
    )
    assert np.flip(other.pressure, axis) == pytest.approx(
        one.pressure, abs=1e-7 * one.pressure.max()
    )


@pytest.mark.parametrize("axes", [(0,), (1,), (0, 1)])
def test_halves_give_what_the_whole_gives(axes: tuple[int, ...]) -> None:
    gap = rough(6)
    for axis in axes:
        gap = gap + np.flip(gap, axis)
    half = press(gap, cell=(1e-6, 2e-6), E_star=E_STAR, load=5.0)
    nearly = gap + 1e-11 * np.ptp(gap) * rough(7) / 1e-6  # no mirror image any more
    whole = press(nearly, cell=(1e-6, 2e-6), E_star=E_STAR, load=5.0)
    assert half.pressure == pytest.approx(whole.pressure, abs=1e-7 * half.pressure.max())


def test_a_tilt_moves_the_load_to_where_the_gap_is_smaller() -> None:
    gap, side = paraboloid(96)
    moved = 0.1 * A  # a paraboloid that is tilted is one that is moved by R theta
    tilted = gap - moved / R * centres(96, side)
    found = press(tilted, cell=(side, side), E_star=E_STAR, load=LOAD)
    about_x, about_y = found.moments
    assert about_x == pytest.approx(LOAD * moved, rel=1e-3)
    assert abs(about_y) < 1e-9 * LOAD * A


def test_pressures_follow_the_scales_of_length_and_stress() -> None:
    gap, cell = rough(8), (1e-6, 2e-6)
    m = press(gap, cell=cell, E_star=E_STAR, load=5.0)
    mm = press(1e3 * gap, cell=(1e-3, 2e-3), E_star=1e-6 * E_STAR, load=5.0)
    assert mm.pressure == pytest.approx(1e-6 * m.pressure, rel=1e-7, abs=1e-15 * E_STAR)
    assert mm.approach == pytest.approx(1e3 * m.approach, rel=1e-9)


def test_a_series_of_loads_gives_what_each_alone_gives() -> None:
    gap, side = paraboloid(48)
    loads = [0.1 * LOAD, LOAD, 0.5 * LOAD]
    grid = HalfSpace((48, 48), cell=(side, side), E_star=E_STAR)
    for load, found in zip(loads, grid.press_each(gap, loads), strict=True):
        alone = press(gap, cell=(side, side), E_star=E_STAR, load=load)
        assert found.pressure == pytest.approx(alone.pressure, abs=1e-7 * PEAK)
        assert found.load == pytest.approx(load, rel=1e-12)


def test_each_of_a_series_starts_from_the_one_before() -> None:
    grid = HalfSpace((24, 20), cell=(1e-6, 2e-6), E_star=E_STAR)
    found = grid.press_each(rough(4), [5.0, 50.0, 50.5])
    assert found[2].iterations < found[1].iterations - 2
    assert grid.press(rough(4), load=50.0, start=found[1].pressure).iterations == 0


def test_a_finer_tolerance_is_met() -> None:
    gap, side = paraboloid(48)
    found = press(gap, cell=(side, side), E_star=E_STAR, load=LOAD, tolerance=1e-13)
    assert found.residual <= 1e-13
    assert_in_contact(found, 2e-13)


def test_an_approach_that_reaches_nothing_loads_nothing() -> None:
    found = sphere(16, approach=-1e-6)
    assert found.load == 0
    assert not found.carries.any()
    assert np.array_equal(found.gap, paraboloid(16)[0] + 1e-6)


def test_bodies_that_just_touch_bear_nothing() -> None:
    assert press([[0.0, 1.0]], cell=(1.0, 1.0), E_star=1.0, approach=0.0).load == 0
    lifted = press([[0.0, 1.0]], cell=(1.0, 1.0), E_star=1.0, approach=-1.0, start=[[1.0, 1.0]])
    assert lifted.load == 0


def test_what_does_not_converge_says_so() -> None:
    with pytest.raises(ArithmeticError, match=r"does not converge: residual .* after 3 iterations"):
        press(rough(9), cell=(1e-6, 2e-6), E_star=E_STAR, load=5.0, limit=3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"load": 0.0}, "load must be positive"),
        ({"load": float("nan")}, "load must be positive"),
        ({"load": None}, "either load or approach"),
        ({"approach": 1e-6}, "either load or approach"),
        ({"load": None, "approach": float("inf")}, "approach must be finite"),
        ({"E_star": -1.0}, "contact modulus must be positive"),
        ({"cell": (1.0, 0.0)}, "sides of a cell must be positive"),
        ({"cell": (1.0,)}, "a cell has two sides"),
        ({"gap": [0.0, 1.0]}, "nx by ny values"),
        ({"gap": [[0.0, float("nan")]]}, "gap must be finite"),
        ({"gap": np.zeros((0, 3))}, "whole numbers from 1"),
        ({"start": [[1.0]]}, "starting pressure needs a value a cell"),
        ({"tolerance": 0.0}, "tolerance must be positive"),
    ],
)
def test_wrong_input_is_refused_by_name(change: dict[str, object], message: str) -> None:
    right = {"gap": [[0.0, 0.0]], "cell": (1.0, 1.0), "E_star": 1.0, "load": 1.0}
    with pytest.raises(ValueError, match=message):
        press(**right | change)  # type: ignore[arg-type]


def test_a_gap_of_another_grid_is_refused() -> None:
    with pytest.raises(ValueError, match=r"gap needs a value a cell, \(4, 4\)"):
        HalfSpace((4, 4), cell=(1.0, 1.0), E_star=1.0).press(np.zeros((4, 5)), load=1.0)
