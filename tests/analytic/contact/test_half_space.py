"""Half-spaces and rollers on them: closed forms, conditions of contact, tilt, readings."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from analytic.contact.crown_again import logarithmic, lundberg
from analytic.contact.half_space import HalfSpace, press_half_space
from analytic.contact.half_space_contact import HalfSpaceContact, centres
from analytic.contact.half_space_ridge import press_ridge
from analytic.contact.half_space_roller import press_roller

E_STAR, R, A = 1e11, 1e-2, 1e-4  # Pa, m and m: a sphere with this half-width of contact
LOAD = 4 * E_STAR * A**3 / (3 * R)  # Johnson, Contact Mechanics, Eqs. 4.22 to 4.24
PEAK = 2 * E_STAR * A / (np.pi * R)
APPROACH = A**2 / R


def paraboloid(n: int) -> tuple[np.ndarray, float]:
    """Gap of a sphere, and the side of the n by n cells."""
    side = 2.4 * A / n
    x = centres(n, side)
    return (x[:, None] ** 2 + x**2) / (2 * R), side


def sphere(n: int, **asked: float) -> HalfSpaceContact:
    gap, side = paraboloid(n)
    return press_half_space(gap, cell=(side, side), E_star=E_STAR, **(asked or {"load": LOAD}))


def off_hertz(found: HalfSpaceContact) -> float:
    """Distance of the pressure from Hertz's, in the mean square."""
    r = np.hypot(found.x[:, None], found.y)
    hertz = PEAK * np.sqrt(np.maximum(1 - (r / A) ** 2, 0.0))
    return float(np.linalg.norm(found.pressure - hertz) / np.linalg.norm(hertz))


def rough(seed: int, shape: tuple[int, int] = (24, 20)) -> np.ndarray:
    return 1e-6 * np.random.default_rng(seed).standard_normal(shape)


def assert_in_contact(found: HalfSpaceContact, tolerance: float = 1e-10) -> None:
    """No pull, no overlap, and pressure only where there is no gap."""
    most = tolerance * max(found.displacement.max(), abs(found.approach))
    assert found.pressure.min() >= 0
    assert found.gap.min() >= -most
    assert np.abs(found.gap[found.carries]).max(initial=0.0) <= most
    # the mean of those gaps by pressure, over the displacement alone
    assert found.complementarity <= most / found.displacement.max()


def test_a_sphere_converges_to_hertzs_pressure_area_and_approach() -> None:
    counts = np.array([16, 32, 64, 128])
    spheres = [sphere(n) for n in counts]
    norms = [off_hertz(found) for found in spheres]
    order = -np.polyfit(np.log(counts), np.log(norms), 1)[0]
    assert 0.8 < order < 1.4, f"{order}, errors {norms}"  # a stepped rim, sqrt(r) within: 1
    assert norms[-1] < 5e-3
    finest = spheres[-1]
    assert finest.pressure.max() == pytest.approx(PEAK, rel=1e-3)
    assert finest.approach == pytest.approx(APPROACH, rel=1e-4)
    assert finest.carries.sum() * finest.area == pytest.approx(np.pi * A**2, rel=1e-2)
    assert_in_contact(finest)


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.floats(-2, 3), st.booleans())
def test_rough_bodies_meet_the_conditions_of_contact(seed: int, decade: float, thin: bool) -> None:
    gap = rough(seed, (2, 90) if thin else (24, 20))
    cell = (1e-7, 2e-6) if thin else (1e-6, 2e-6)
    found = press_half_space(gap, cell=cell, E_star=E_STAR, load=10**decade)
    assert_in_contact(found)
    assert found.load == pytest.approx(10**decade, rel=1e-12)


def test_a_series_of_loads_gives_what_each_alone_gives() -> None:
    gap, side = paraboloid(48)
    loads = [0.1 * LOAD, LOAD, 0.5 * LOAD]
    grid = HalfSpace((48, 48), cell=(side, side), E_star=E_STAR)
    for load, found in zip(loads, grid.press_each(gap, loads), strict=True):
        alone = press_half_space(gap, cell=(side, side), E_star=E_STAR, load=load)
        assert found.pressure == pytest.approx(alone.pressure, abs=1e-7 * PEAK)
        assert found.load == pytest.approx(load, rel=1e-12)


def test_failed_convergence_is_reported() -> None:
    with pytest.raises(ArithmeticError, match=r"residual is .* after 3 iterations"):
        press_half_space(rough(9), cell=(1e-6, 2e-6), E_star=E_STAR, load=5.0, limit=3)


ROLLER = {"R": 2.95e-3, "length": 9e-3, "E_star": 113e9}  # a sprag's on its race
DESIGN = {"load": 3407.0, "length": 9e-3, "E_star": 113e9}


def test_a_tilt_loads_the_end_of_a_roller_where_the_gap_closes() -> None:
    crown = logarithmic(K_1=1.0, K_2=0.7, z_m=1e-5, **DESIGN)
    up, down = (
        press_roller(crown, **ROLLER, load=3407.0, cells=(32, 128), tilt=t) for t in (3e-4, -3e-4)
    )
    assert up.contact.moments[0] < -0.1 * 3407.0 * 1e-3
    assert up.contact.moments[0] == pytest.approx(-down.contact.moments[0], rel=1e-6)
    assert up.line_load == pytest.approx(down.line_load[::-1], abs=1e-6 * up.line_load.max())
    hertz = np.sqrt(up.line_load[64] * 113e9 / (np.pi * 2.95e-3))
    assert up.mid_pressure == pytest.approx(hertz, rel=0.01)
    left, right = up.end_load(9e-3 / 3)[0], up.end_load(9e-3 * 2 / 3)[1]
    assert left + right == pytest.approx(3407.0, rel=1e-12)


def test_an_even_load_is_symmetric_and_has_hertz_s_pressure_and_width() -> None:
    even = press_ridge(lundberg(**DESIGN), across=8, along=128, load=3407.0, d=0.5e-3, **ROLLER)
    q = 3407.0 / 9e-3
    found = even.values
    assert found["p_mid"] == pytest.approx(np.sqrt(q * 113e9 / (np.pi * 2.95e-3)), rel=0.01)
    assert found["b_mid"] == pytest.approx(np.sqrt(4 * q * 2.95e-3 / (np.pi * 113e9)), rel=0.01)
    assert found["q_mid"] == pytest.approx(q, rel=0.01)
    assert even.unevenness < 0.02
    assert abs(found["balance"]) < 1e-8 * 3407.0
    assert found["F_low"] == pytest.approx(found["F_high"], rel=1e-6)
    assert found["F_d"] == found["F_low"] + found["F_high"]
    assert abs(found["M"]) < 1e-6 * 3407.0 * 9e-3
    assert even.beyond(0.5e-3).max() <= found["p_max"] <= found["p_top"] * (1 + 1e-12)


def test_each_load_of_a_series_starts_from_the_solution_before() -> None:
    grid = HalfSpace((24, 20), cell=(1e-6, 2e-6), E_star=E_STAR)
    found = grid.press_each(rough(4), [5.0, 50.0, 50.5])
    assert found[2].iterations < found[1].iterations - 2
    assert grid.press(rough(4), load=50.0, start=found[1].pressure).iterations == 0


def test_the_patch_for_an_approach_does_not_depend_on_the_unit_of_length():
    """Roller of R = 10 mm, 2 mm long, approach 1 um: in m and in um."""
    found = [
        press_roller(R=1e-2 * k, length=2e-3 * k, approach=1e-6 * k, E_star=1.0, cells=(16, 16))
        for k in (1.0, 1e6)
    ]
    in_m, in_um = (one.contact.cell[0] for one in found)
    assert in_um / 1e6 == pytest.approx(in_m, rel=1e-9)
    assert found[1].mid_pressure == pytest.approx(found[0].mid_pressure, rel=1e-6)
