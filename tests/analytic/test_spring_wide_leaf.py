"""A leaf's width factor: limits, what it depends on, and the two end effects."""

import numpy as np
import pytest

from analytic.spring.wide_leaf import TERMS, width_factor

NU = 0.3
WIDEST = 1 / (1 - NU**2)


def test_a_leaf_stiffens_with_its_width_between_a_beam_and_a_plate():
    f = width_factor(np.geomspace(1e-2, 100, 20), 1.0)
    assert (np.diff(f) > 0).all()
    assert 1 < f[0] < 1.003
    assert WIDEST - 5e-4 < f[-1] < WIDEST


def test_without_poisson_s_ratio_width_does_not_stiffen():
    np.testing.assert_allclose(width_factor([0.1, 1.0, 10.0], 1.0, nu=0.0), 1, atol=1e-13)


def test_width_over_length_counts_alone():
    assert width_factor(56e-3, 12e-3) == pytest.approx(width_factor(56.0, 12.0), rel=1e-12)


def test_more_terms_only_soften():
    for ratio in (0.05, 0.5, 5.0, 30.0):
        f = [width_factor(ratio, 1.0, terms=terms) for terms in (2, 6, 12, TERMS, 32)]
        assert (np.diff(f) < 1e-12).all()
        assert f[-2] == pytest.approx(f[-1], abs=1e-5)


def test_the_two_edges_of_a_wide_leaf_soften_it_independently():
    """Each by what its own strip of a leaf's length lacks: d = c l/h."""
    h = np.array([2.0, 4.0, 8.0])
    lacking = (1 - width_factor(h, 1.0, terms=36) / WIDEST) * h
    np.testing.assert_allclose(lacking, lacking[0], rtol=2e-3)


def test_the_two_ends_of_a_narrow_leaf_stiffen_it_independently():
    """Each by what its own length of a width adds: f - 1 = c h/l, as Saint-Venant has it."""
    h = np.array([0.05, 0.025])
    c = (width_factor(h, 1.0, terms=36) - 1) / h
    assert c[1] == pytest.approx(c[0], rel=0.03)


def deflected(x, y, h, length, coefficients):
    """A deflection that meets the ends: the beam's, and polynomials in both directions."""
    s = x / length
    w = 3 * s**2 - 2 * s**3
    for (i, j), c in coefficients.items():
        w = w + c * (s * (1 - s)) ** 2 * (s - 0.5) ** i * (2 * y / h) ** j
    return w


def test_no_other_deflection_has_less_energy():
    """Curvatures by differences, summed over a grid: an energy in other words."""
    length, h, n = 2.0, 1.4, 100
    x, y = np.meshgrid(
        (np.arange(n) + 0.5) / n * length, ((np.arange(n) + 0.5) / n - 0.5) * h, indexing="ij"
    )
    d = 1e-3

    def energy(coefficients):
        def w(a, b):
            return deflected(x + a * d, y + b * d, h, length, coefficients)

        xx = (w(1, 0) - 2 * w(0, 0) + w(-1, 0)) / d**2
        yy = (w(0, 1) - 2 * w(0, 0) + w(0, -1)) / d**2
        xy = (w(1, 1) - w(1, -1) - w(-1, 1) + w(-1, -1)) / (4 * d**2)
        density = xx**2 + yy**2 + 2 * NU * xx * yy + 2 * (1 - NU) * xy**2
        return density.sum() * (length / n) * (h / n) / (12 * h / length**3) / (1 - NU**2)

    least = width_factor(h, length)
    assert energy({}) == pytest.approx(WIDEST, rel=1e-4)  # a beam that does not curve across
    keys = [(1, 0), (1, 2), (3, 2), (1, 4), (3, 4)]
    units = [{key: 1.0} for key in keys]
    e0, ones = energy({}), [energy(unit) for unit in units]
    pairs = [[energy(a | b) if a != b else energy(dict.fromkeys(a, 2.0)) for b in units]
             for a in units]  # fmt: skip
    K = np.array([[p - ones[i] - ones[j] + e0 for j, p in enumerate(row)]
                  for i, row in enumerate(pairs)])  # fmt: skip
    slope = np.array(ones) - e0 - np.diag(K) / 2
    best = e0 - slope @ np.linalg.solve(K, slope) / 2
    assert least < best < least + 3e-3


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"h": 0.0}, "width and length must be positive"),
        ({"length": -1.0}, "width and length must be positive"),
        ({"h": float("nan")}, "width and length must be positive"),
        ({"nu": 0.6}, "Poisson's ratio must lie in [0, 0.5], got nu=0.6"),
        ({"terms": 0}, "needs a term or more, got 0"),
    ],
)
def test_senseless_input_is_named(wrong, message):
    with pytest.raises(ValueError, match=r".+") as error:
        width_factor(**{"h": 1.0, "length": 1.0} | wrong)
    assert message in str(error.value)
