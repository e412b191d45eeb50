"""Readings of contacts: another reading fails against finite elements or the half-space."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import (
    crown,
    hertz_line,
    partial_slip,
    press_fit,
    slice_compliance,
    slices,
)
from tests.verify.cases.readings import given, times
from verify.cases.contact.line.ring import RING
from verify.cases.contact.press_fit import formulas as fits
from verify.cases.contact.press_fit.case import PRESS_FIT
from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.inputs import Tilt
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.contact.slip.case import SLIP

PEAK, MID = "largest pressure outside the end zones d", "pressure at mid-length"


def one_radius(_):
    """The overlap's pressure with one radius for both walls."""
    return lambda inner, outer, **k: press_fit.contact_pressures(
        [replace(inner, r_o=26.23e-3), replace(outer, r_i=26.23e-3)], inner.r_o - outer.r_i, **k
    )[0]


def alone(d, D, b):
    return np.where(d == 0, slice_compliance.love(d, D, b), 0.0)


READINGS = [
    pytest.param(RING, hertz_line, "relative_radius", given(R_2=lambda k: -k["R_2"]),
                 "peak pressure, Hertz", id="the bore's curvature is added"),
    pytest.param(PRESS_FIT, fits, "pressure_of_overlap", one_radius,
                 "mean contact pressure, rings that overlap by the interference, plane strain",
                 id="one radius for walls that overlap"),
    pytest.param(SLIP, hertz_line, "relative_radius", lambda _: lambda *, R_1, R_2: np.asarray(R_1),
                 "stick half-width at Q_max", id="one roller on a flat"),
    pytest.param(SLIP, partial_slip, "stick_half_width",
                 lambda _: lambda *, Q, P, mu, a: np.asarray(a * (1 - Q / (mu * P))),
                 "L2 error of the traction below 3 %, Q/(μP) = 0.4", id="c/a = 1 - Q/(μP)"),
    pytest.param(ROLLER, crown, "_scale", times(0.5), f"{PEAK}, strips", id="E' of Eq. 1 is 4 E*"),
    pytest.param(UNCROWNED, slices.press_slices, "__kwdefaults__",
                 lambda defaults: defaults | {"kernel": alone}, f"{MID}, slices",
                 id="w deflects its slice only"),
    pytest.param(TILTED, Tilt, "gap",
                 lambda f: lambda self, y: f(self, y) + self.theta * self.L / 2,
                 "approach, strips", id="tilt about the end"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)
