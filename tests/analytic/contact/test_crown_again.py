"""Crowns are written twice: for the formulas and for the reference. They agree."""

import numpy as np
import pytest

from analytic.contact import crown, crown_again

SAME = 1e-12  # of the drop, and as much of A, in which logarithms near 1 are rounded
RNG = np.random.default_rng(11)
PRINTED = ((1, 0.7, 10e-6), (5, 0.7, 15e-6), (1, 0.4, 10e-6), (3, 0.4, 10e-6), (1, 0.5, 8e-6),
           (5, 0.5, 15e-6), (2.1507, 0.6763, 12.1e-6), (2.80, 0.7, 11.8e-6))  # fmt: skip
DRAWN = tuple(zip(RNG.uniform(0.1, 10, 20), RNG.uniform(0.05, 1, 20), RNG.uniform(1e-7, 5e-5, 20),
                  strict=True))  # fmt: skip
SIZES = {"length": 9e-3, "E_star": 206e9 / (2 * 0.91)}
WIDTH = 0.13e-3
y = np.linspace(-SIZES["length"] / 2, SIZES["length"] / 2, 4001)


def scale(load):
    return load / (np.pi * SIZES["length"] * SIZES["E_star"])


def same(one, other, A):
    return np.all(np.abs(one - other) <= SAME * (np.abs(one) + A))


@pytest.mark.parametrize("load", [1.0, 3407.0])
@pytest.mark.parametrize("design", [*PRINTED, *DRAWN, (1, 1, 1e-3)], ids=str)
def test_both_writings_of_eq_1_agree(design, load):
    K_1, K_2, z_m = design
    A = K_1 * scale(load)
    law = {"K_1": K_1, "K_2": K_2, "z_m": min(z_m, 500 * A), "load": load, **SIZES}
    # at the very end z_m alone is left of the reference's argument of the logarithm
    inner = np.abs(y) < 0.999 * SIZES["length"] / 2 if law["z_m"] > 15 * A else np.full(y.shape, 1)
    inner = inner.astype(bool)
    written = crown.logarithmic(y, **law)[inner]
    assert same(crown_again.logarithmic(**law)(y)[inner], written, A)


def test_both_writings_of_lundberg_s_crown_agree():
    inside = y[1:-1]
    written = crown.lundberg(inside, load=3407.0, **SIZES)
    assert same(crown_again.lundberg(load=3407.0, **SIZES)(inside), written, scale(3407.0))


@pytest.mark.parametrize("load", [1.0, 3407.0, 30e3])
def test_johns_and_gohar_s_constant_is_the_one_that_they_print(load):
    A, law = scale(load), {"load": load, "half_width": WIDTH, **SIZES}
    written, again = crown.johns_gohar(y, **law), crown_again.johns_gohar(**law)(y)
    assert abs(crown.END - 0.3033) <= 5e-5
    assert np.abs(again - written).max() <= 5e-5 / 0.3033 * A  # the logarithm of the constant
    assert same(again[y == 0], written[y == 0], A)
