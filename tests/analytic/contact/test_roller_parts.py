"""Readings of pressures along a roller, of pressures that are known."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.roller_parts import Parts, load_elsewhere, vertex


def parts(p, line=None, d=0.0, length=1.0):
    n = len(p)
    y = ((np.arange(n) + 0.5) / n - 0.5) * length
    return Parts(y=y, p=np.asarray(p, float), line=np.asarray(p if line is None else line, float),
                 delta=0.0, length=length, d=d)  # fmt: skip


def test_the_top_of_a_parabola_is_found_between_its_parts():
    y = np.linspace(-1, 1, 9)
    p = 3 - 2 * (y - 0.07) ** 2
    assert vertex(p, int(np.argmax(p))) == pytest.approx(3, rel=1e-12)
    rising = np.array([1.0, 2.0, 3.0])
    assert vertex(rising, 2) == 3.0  # at an end nothing says where it stops


@pytest.mark.parametrize("n", [40, 41])
def test_a_peak_at_the_end_counts_only_with_ends_included(n):
    one = parts(np.where(np.arange(n) == n - 1, 5.0, 1.0), d=0.2)
    assert one.p_max == 1.0
    assert one.p_top == 5.0
    assert one.p_mid == one.q_mid == 1.0


@pytest.mark.parametrize("d", [0.0, 0.1, 0.123, 0.25])
def test_an_even_load_puts_on_an_end_what_its_length_says(d):
    one = parts(np.full(37, 4.0), length=2.0)
    low, high = replace(one, d=d).ends
    assert low == high == pytest.approx(4.0 * d, rel=1e-12, abs=1e-15)


def test_a_leaning_load_lies_more_on_one_end():
    n = 50
    low, high = parts(1 + np.linspace(-0.5, 0.5, n), d=0.1).ends
    assert low < high
    assert low + high == pytest.approx(0.2, rel=1e-12)


def test_loads_that_agree_put_nothing_elsewhere_however_they_are_divided():
    fine = 1 + np.linspace(0, 1, 400)
    coarse = fine.reshape(50, 8).mean(axis=1)
    share, error = load_elsewhere(coarse, fine, 3.0)
    assert max(share, error) < 1e-12
    share, _ = load_elsewhere(coarse[::-1], fine, 3.0)
    assert share == pytest.approx(np.abs(coarse - coarse[::-1]).sum() / coarse.sum() / 2)
