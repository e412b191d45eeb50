"""Readings of contacts: another one fails beside the finite elements or the half-space."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import (
    crown,
    hertz_line,
    palmgren,
    partial_slip,
    press_fit,
    slice_compliance,
    slices,
)
from tests.verify.cases.readings import given, times
from verify.cases.contact.line.ring import RING
from verify.cases.contact.press_fit import formulas as fits
from verify.cases.contact.press_fit.case import PRESS_FIT
from verify.cases.contact.roller import inputs
from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.inputs import Tilt
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.slip.case import SLIP

PEAK, MID = "largest pressure outside the end zones d", "pressure at mid-length"
FIT = "contact pressure, mean, rings, plane stress"


def one_radius(_):
    """The overlap's pressure with one radius for both walls."""
    return lambda inner, outer, **k: press_fit.contact_pressures(
        [replace(inner, r_o=26.23e-3), replace(outer, r_i=26.23e-3)], inner.r_o - outer.r_i, **k
    )[0]


def from_the_end(right):
    """Eq. 5's count of y: |y| from one end, up to half the length."""

    def wrong(y, *, length, **more):
        return right(np.minimum(np.asarray(y) + length / 2, length / 2), length=length, **more)

    return wrong


def one_end(right):
    """Eq. 1 as printed, without the bars."""
    return lambda y, **more: np.where(np.asarray(y) > 0, right(y, **more), 0.0)


def straight_by_z_m(right):
    """A crowned part that grows with z_m, about the paper's."""

    def wrong(y, *, K_2, z_m, **more):
        return right(y, K_2=np.minimum(K_2 * (1 + z_m / 50e-6), 1.0), z_m=z_m, **more)

    return wrong


def kernel(weights):
    """Other weights in Eq. 3."""
    return lambda defaults: defaults | {"kernel": weights}


def alone(d, D, b):
    return np.where(d == 0, slice_compliance.love(d, D, b), 0.0)


READINGS = [
    pytest.param(RING, hertz_line, "relative_radius", given(R_2=lambda k: -k["R_2"]),
                 "peak pressure, Hertz", id="the bore's curvature is added"),
    pytest.param(PRESS_FIT, fits, "contact_pressures",
                 lambda f: lambda pair, delta, **k: f(pair, delta / 2, **k), FIT,
                 id="interference of the diameters"),
    pytest.param(PRESS_FIT, fits, "pressure_of_overlap", one_radius,
                 "contact pressure, mean, rings drawn with overlap, plane strain",
                 id="one radius for walls that overlap"),
    pytest.param(SLIP, hertz_line, "relative_radius", lambda _: lambda *, R_1, R_2: np.asarray(R_1),
                 "stick half-width at Q_max", id="one roller on a flat"),
    pytest.param(SLIP, partial_slip, "stick_half_width",
                 lambda _: lambda *, Q, P, mu, a: np.asarray(a * (1 - Q / (mu * P))),
                 "traction within 3 % in L2, Q/(μP) = 0.4", id="c/a = 1 - Q/(μP)"),
    pytest.param(ROLLER, crown, "_scale", times(0.5), f"{PEAK}, strips", id="E' of Eq. 1 is 4 E*"),
    pytest.param(ROLLER, inputs, "logarithmic", from_the_end, f"{PEAK}, strips",
                 id="y counts from the end"),
    pytest.param(TILTED, inputs, "logarithmic", one_end, "tilting moment, strips within 1%",
                 id="a crown at one end"),
    pytest.param(CROWNS, inputs, "logarithmic", straight_by_z_m,
                 "the straight middle follows K_2, not z_m", id="straight part depends on z_m"),
    pytest.param(ROLLER, palmgren, "compliance", given(length=lambda k: k["length"] / 2),
                 f"{PEAK}, slices", id="s of half the length"),
    pytest.param(UNCROWNED, slices.press, "__kwdefaults__", kernel(alone), f"{MID}, slices",
                 id="w deflects none but its own slice"),
    pytest.param(TILTED, Tilt, "gap",
                 lambda f: lambda self, y: f(self, y) + self.theta * self.L / 2,
                 "approach, strips", id="tilt about the end"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)
