"""Sharpness of an edge's pressure against the characteristic equation in closed form."""

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.contact.edge import edge_exponent


@pytest.mark.parametrize("angle", [np.pi / 2, 1.8, 2.2, 2.7, 3.0])
def test_wedge_and_half_plane_open_alike(angle):
    # a wedge's loaded face gives way as (sin 2pa + p sin 2a)/(sin² pa - p² sin² a), which is
    # 2 cot(p pi) for the half-plane
    def sum_of_both(p):
        wedge = (np.sin(2 * p * angle) + p * np.sin(2 * angle)) / (
            np.sin(p * angle) ** 2 - (p * np.sin(angle)) ** 2
        )
        return wedge + 2 / np.tan(p * np.pi)

    exact = brentq(sum_of_both, 0.5 + 1e-12, 0.95)
    assert edge_exponent(angle) == pytest.approx(exact - 1, abs=1e-10)


def test_a_right_angle_has_the_exponent_of_dundurs_and_lee():
    assert edge_exponent(np.pi / 2) == pytest.approx(-0.226, abs=5e-4)


def test_the_flatter_the_edge_the_nearer_to_a_half_space():
    exponents = [edge_exponent(a) for a in np.linspace(np.pi / 2, 3.1, 12)]
    assert np.all(np.diff(exponents) < 0)
    assert exponents[-1] == pytest.approx(-0.5, abs=1e-4)


@pytest.mark.parametrize("angle", [1.5, np.pi, 4.0, np.nan])
def test_other_edges_are_refused(angle):
    with pytest.raises(ValueError, match=r"edge's angle must lie in \[pi/2, pi\), got .* rad"):
        edge_exponent(angle)
