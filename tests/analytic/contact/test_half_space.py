"""Half-spaces in contact: closed forms, conditions of contact, Love's displacements."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from analytic.contact import love
from analytic.contact.half_space import HalfSpace, press
from analytic.contact.half_space_contact import HalfSpaceContact, centres

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
    return press(gap, cell=(side, side), E_star=E_STAR, **(asked or {"load": LOAD}))


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


def test_a_sphere_has_hertzs_pressure_area_and_approach() -> None:
    found = sphere(128)
    assert found.pressure.max() == pytest.approx(PEAK, rel=1e-3)
    assert found.approach == pytest.approx(APPROACH, rel=1e-4)
    assert found.carries.sum() * found.area == pytest.approx(np.pi * A**2, rel=1e-2)
    assert off_hertz(found) < 5e-3
    assert_in_contact(found)


def test_errors_of_a_sphere_fall_with_the_cell() -> None:
    counts = np.array([16, 32, 64, 128])
    norms = [off_hertz(sphere(n)) for n in counts]
    order = -np.polyfit(np.log(counts), np.log(norms), 1)[0]
    assert 0.8 < order < 1.4, f"{order}, errors {norms}"  # a stepped rim, sqrt(r) within: 1


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6), st.floats(-2, 3), st.booleans())
def test_rough_bodies_meet_the_conditions_of_contact(seed: int, decade: float, thin: bool) -> None:
    gap = rough(seed, (2, 90) if thin else (24, 20))
    cell = (1e-7, 2e-6) if thin else (1e-6, 2e-6)
    found = press(gap, cell=cell, E_star=E_STAR, load=10**decade)
    assert_in_contact(found)
    assert found.load == pytest.approx(10**decade, rel=1e-12)


def test_a_series_of_loads_gives_what_each_alone_gives() -> None:
    gap, side = paraboloid(48)
    loads = [0.1 * LOAD, LOAD, 0.5 * LOAD]
    grid = HalfSpace((48, 48), cell=(side, side), E_star=E_STAR)
    for load, found in zip(loads, grid.press_each(gap, loads), strict=True):
        alone = press(gap, cell=(side, side), E_star=E_STAR, load=load)
        assert found.pressure == pytest.approx(alone.pressure, abs=1e-7 * PEAK)
        assert found.load == pytest.approx(load, rel=1e-12)


def test_what_does_not_converge_says_so() -> None:
    with pytest.raises(ArithmeticError, match=r"does not converge: residual .* after 3 iterations"):
        press(rough(9), cell=(1e-6, 2e-6), E_star=E_STAR, load=5.0, limit=3)


@pytest.mark.parametrize(("x", "y"), [(0.1, 0.05), (2.0, -0.1)])
def test_loves_displacement_is_boussinesqs_over_the_rectangle(x: float, y: float) -> None:
    """1/(pi E* r): along y in closed form, along x by quadrature."""
    a, b, E_star = 0.7, 0.2, 3.0

    def strip(s: float) -> float:
        d = abs(x - s)
        return float(np.arcsinh((y + b) / d) - np.arcsinh((y - b) / d))

    total, _ = quad(strip, -a, a, points=[x] if abs(x) < a else None, epsrel=1e-12)
    found = love.displacement(x, y, a=a, b=b, E_star=E_star)
    assert found == pytest.approx(total / (np.pi * E_star), rel=1e-9)
