"""The series of two discs against a solver of another kind, and what its terms are needed for."""

import numpy as np
import pytest

from analytic.contact import pair_series
from analytic.contact.disc import disc_in_contact
from analytic.contact.partial_slip import dundurs_beta
from analytic.contact.shear_series import GOLDEN, tilted_shear_excess

# Discs by Fourier modes in plane stress, both directions coupled: R_1, R_2, E_1, nu_1, E_2, nu_2;
# Hertz's half-width, excess of the peak pressure, excess of the moments' half-width. Four digits.
SOLVED = [
    ((1, 2.76, 1, 0.3, 1, 0.3), 0.2022, 4.145e-3, -5.381e-3),
    ((1, 2.76, 1, 0.3, 2.5, 0.3), 0.1003, 1.537e-3, -2.003e-3),
    ((2, 1, 1, 0.1, 4, 0.4), 0.0993, -6.64e-3, 5.73e-3),
    ((1, 3, 20, 0, 1, 0), 0.0992, -1.505e-2, 1.370e-2),
]
PRINTED = 1e-5  # of the excess, and of a_H: half a digit of 2000


def given(discs, a):
    names = ("R_1", "R_2", "E_1", "nu_1", "E_2", "nu_2")
    return dict(zip(names, discs, strict=True)) | {"a": a, "assumption": "plane stress"}


def misfits():
    """Distance of every solved excess from the series over what that may be off by."""
    found = []
    for discs, a, *solved in SOLVED:
        series = pair_series.excess(**given(discs, a))
        allowed = pair_series.left_out(**given(discs, a)) + PRINTED
        found += [
            abs(one.total - other) / allowed for one, other in zip(series, solved, strict=True)
        ]
    return found


def test_the_series_of_two_discs_meets_an_independent_solver():
    assert max(misfits()) < 1


def changed(which, change):
    """The series with `change(discs, p, w)` added to the terms (first or second) of p_0 and w."""
    right = pair_series.excess

    def wrong(**kwargs):
        more = {k: v for k, v in kwargs.items() if k not in ("a", "R_1", "R_2")}
        kappa = pair_series.meeting_curvature(R_1=kwargs["R_1"], R_2=kwargs["R_2"], **more)
        s = pair_series.shares(**more)
        both = right(**kwargs)
        offs = change(kwargs, kappa, s)
        orders = [{which: getattr(x, which) + off} for x, off in zip(both, offs, strict=True)]
        return tuple(pair_series.Excess(**(vars(x) | o)) for x, o in zip(both, orders, strict=True))

    return wrong


def inclined(g, kappa, _):
    return -(kappa**2) / 3 * g["a"] ** 2, (2 / 3 - 1 / 2) * kappa**2 * g["a"] ** 2


def stretched(g, kappa, s):
    term = kappa * (s[0] / g["R_1"] - s[1] / g["R_2"]) / 2 * g["a"] ** 2
    return term, -term


def askew(g, kappa, s):
    R = 1 / (1 / g["R_1"] + 1 / g["R_2"])
    return 0.0, -kappa * (s[0] - s[1]) / (8 * R) * g["a"] ** 2


@pytest.mark.parametrize("change", [inclined, stretched, askew])
def test_every_term_of_the_second_order_is_needed(change, monkeypatch):
    monkeypatch.setattr(pair_series, "excess", changed("second", change))
    assert max(misfits()) > 1


@pytest.mark.parametrize("factor", [-7.0, -1.0, 0.0, 0.9], ids=lambda f: f"beta times {f}")
def test_the_coupling_of_unlike_materials_is_needed(factor, monkeypatch):
    right = dundurs_beta
    monkeypatch.setattr(pair_series, "dundurs_beta", lambda **k: factor * right(**k))
    true = pair_series.left_out
    monkeypatch.setattr(pair_series, "left_out", lambda **k: true(**k) / max(1, factor**2))
    assert max(misfits()) > 1


@pytest.mark.parametrize("place", [0, 1], ids=["peak pressure", "half-width"])
def test_neither_excess_may_vanish(place, monkeypatch):
    right = pair_series.excess

    def wrong(**k):
        both = list(right(**k))
        both[place] = pair_series.Excess(first=both[place].first, second=0.0)
        return tuple(both)

    monkeypatch.setattr(pair_series, "excess", wrong)
    assert max(misfits()) > 1


@pytest.mark.parametrize("a", [0.05, 0.1, 0.2])
def test_equal_discs_leave_out_less_than_is_said(a):
    like = given((1, 1, 1, 0.3, 1, 0.3), a)
    disc = disc_in_contact(a=a, R=1.0, E_plane=1.0)
    hertz = np.sqrt(4 * disc.P / np.pi)
    p, w = pair_series.excess(**like | {"a": hertz})
    allowed = 1.05 * pair_series.left_out(**like | {"a": hertz})  # 0.129 and the order beyond
    assert abs(disc.p_0 / (hertz / 2) - 1 - p.total) < allowed
    assert abs(disc.moment_width / hertz - 1 - w.total) < allowed


def test_inclined_pressure_adds_flamant_s_share_to_the_largest_shear():
    """Tangential loads kappa x p towards the axis, each with its radial stress, one by one."""
    x, weight = np.polynomial.chebyshev.chebgauss(2000)
    p = (1 - x**2) * weight  # the weight lacks sqrt(1 - x²) twice
    z = GOLDEN**-0.5
    r = np.hypot(x, z)
    radial = -2 / np.pi * (-x * p) * (-x / r) / r  # of the load -x p along x, seen from (0, z)
    shear = np.sum(radial * (x**2 - z**2) / r**2) / 2
    assert tilted_shear_excess(1.0) == pytest.approx(shear * GOLDEN**2.5, rel=1e-6)
    assert tilted_shear_excess(1.0) == pytest.approx(0.0928, abs=5e-5)
