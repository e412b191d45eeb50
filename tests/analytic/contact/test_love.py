"""Displacement under a uniformly loaded rectangle."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import love

SIDES = {"a": 0.7, "b": 0.2, "E_star": 3.0}
SQUARE = {"a": 1.0, "b": 1.0, "E_star": 2.0}


def by_quadrature(x: float, y: float, *, a: float, b: float, E_star: float) -> float:
    """Boussinesq's 1/(pi E* r): along y in closed form, along x by quadrature."""

    def strip(s: float) -> float:
        d = abs(x - s)
        return float(np.arcsinh((y + b) / d) - np.arcsinh((y - b) / d))

    inside = [x] if abs(x) < a else None
    return quad(strip, -a, a, points=inside, limit=400, epsabs=0, epsrel=1e-12)[0] / (
        np.pi * E_star
    )


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (0.1, 0.05), (0.3, 1.0), (2.0, -0.1), (5.0, 7.0)])
def test_it_is_boussinesqs_point_load_summed_over_the_rectangle(x: float, y: float) -> None:
    found = love.displacement(x, y, **SIDES)
    assert found == pytest.approx(by_quadrature(x, y, **SIDES), rel=1e-10)


def test_centre_and_corner_of_a_square_are_closed_forms() -> None:
    centre = 8 * np.arcsinh(1.0) / (np.pi * 2.0)
    assert love.displacement(0.0, 0.0, **SQUARE) == pytest.approx(centre, rel=1e-14)
    corners = love.displacement([1.0, -1.0, 1.0, -1.0], [1.0, -1.0, -1.0, 1.0], **SQUARE)
    assert corners == pytest.approx(centre / 2, rel=1e-14)


def test_a_square_of_small_squares_sinks_as_one() -> None:
    at = (np.arange(10) - 4.5) / 5
    x, y = np.meshgrid(at, at)
    parts = love.displacement(0.33 - x, -0.21 - y, a=0.1, b=0.1, E_star=2.0).sum()
    assert parts == pytest.approx(love.displacement(0.33, -0.21, **SQUARE), rel=1e-13)


def test_far_away_it_is_a_point_load() -> None:
    force, r = 4 * 0.7 * 0.2, np.hypot(300.0, 400.0)
    point = force / (np.pi * 3.0 * r)
    assert love.displacement(300.0, 400.0, **SIDES) == pytest.approx(point, rel=1e-6)


@pytest.mark.parametrize("cell", [(1.0, 1.0), (3e-6, 35e-6), (35e-6, 3e-6)])
def test_the_table_holds_the_displacement_at_every_distance(cell: tuple[float, float]) -> None:
    table = love.table((150, 200), cell=cell, E_star=2.0)
    x, y = (np.arange(n, dtype=np.longdouble) * h for n, h in zip((150, 200), cell, strict=True))
    corners = [
        s * t * (u * np.arcsinh(v / abs(u)) + v * np.arcsinh(u / abs(v)))
        for s in (-1, 1)
        for t in (-1, 1)
        for u, v in [(x[:, None] + s * cell[0] / 2, y + t * cell[1] / 2)]
    ]  # in extended precision, where corners that cancel leave enough
    exact = sum(corners) / (np.longdouble(np.pi) * 2)
    assert np.abs(table / exact - 1).max() < 2e-11


def test_lengths_and_stresses_scale() -> None:
    scaled = love.displacement(300.0, 50.0, a=700.0, b=200.0, E_star=3e-6)
    assert scaled == pytest.approx(1e9 * love.displacement(0.3, 0.05, **SIDES), rel=1e-13)


@pytest.mark.parametrize("wrong", [{"a": 0.0}, {"b": -1.0}, {"E_star": np.nan}])
def test_sides_and_modulus_must_be_positive(wrong: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="must be positive"):
        love.displacement(0.0, 0.0, **SIDES | wrong)
