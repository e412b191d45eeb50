"""Readings of contacts: another one fails beside the finite elements or the half-space."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import (
    crown,
    hertz_line,
    hertz_point,
    palmgren,
    partial_slip,
    press_fit,
    slice_compliance,
    slices,
    tangential_cycle,
)
from tests.verify.cases.readings import given, times
from tests.verify.cases.rows import failed
from verify.cases.contact.line import flat, pair
from verify.cases.contact.line.flat import FLAT
from verify.cases.contact.line.pair import PAIR
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
from verify.cases.contact.sphere.case import SPHERE

PEAK, MID = "largest pressure outside the end zones d", "pressure at mid-length"
FIT = "contact pressure, mean, rings, plane stress"


def swapped(right):
    other = {"plane stress": "plane strain", "plane strain": "plane stress"}
    return lambda E, nu, assumption: right(E, nu, other[assumption])


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


def without_power(_):
    return lambda *, length, slices: slices * palmgren.CONSTANT / length**0.8


def kernel(weights):
    """Other weights in Eq. 3."""
    return lambda defaults: defaults | {"kernel": weights}


def alone(d, D, b):
    return np.where(d == 0, slice_compliance.love(d, D, b), 0.0)


READINGS = [
    pytest.param(FLAT, flat, "disc_under_load", given(E_plane=lambda k: 0.91 * k["E_plane"]),
                 "half-width, disc", id="thin rollers"),
    pytest.param(FLAT, flat.hertz_line_approach, "approach_to_centre", times(2),
                 "approach of flat and centre, Hertz", id="approach of both flats"),
    pytest.param(PAIR, hertz_line, "relative_radius",
                 given(R_1=lambda k: k["R_1"] / 2, R_2=lambda k: k["R_2"] / 2),
                 f"half-width, {pair.WHERE}, Hertz", id="diameters for radii"),
    pytest.param(RING, hertz_line, "relative_radius", given(R_2=lambda k: -k["R_2"]),
                 "peak pressure, Hertz", id="the bore's curvature is added"),
    pytest.param(PRESS_FIT, fits, "contact_pressures",
                 lambda f: lambda pair, delta, **k: f(pair, delta / 2, **k), FIT,
                 id="interference of the diameters"),
    pytest.param(PRESS_FIT, press_fit, "in_plane", swapped, FIT, id="the other plane state"),
    pytest.param(PRESS_FIT, fits, "pressure_of_overlap", one_radius,
                 "contact pressure, mean, rings drawn with overlap, plane strain",
                 id="one radius for walls that overlap"),
    pytest.param(SLIP, hertz_line, "relative_radius", lambda _: lambda *, R_1, R_2: np.asarray(R_1),
                 "stick half-width at Q_max", id="one roller on a flat"),
    pytest.param(SLIP, hertz_line, "contact_modulus", given(assumption=lambda _: "plane stress"),
                 "cycle: energy lost, work of friction", id="thin rollers that slip"),
    pytest.param(SLIP, partial_slip, "stick_half_width",
                 lambda _: lambda *, Q, P, mu, a: np.asarray(a * (1 - Q / (mu * P))),
                 "traction within 3 % in L2, Q/(μP) = 0.4", id="c/a = 1 - Q/(μP)"),
    pytest.param(SLIP, tangential_cycle, "dissipation", times(0.5),
                 "cycle: energy lost, area of the loop", id="half a cycle"),
    pytest.param(SPHERE, hertz_line, "relative_radius",
                 given(R_1=lambda k: 2 * k["R_1"], R_2=lambda k: 2 * k["R_2"]),
                 "peak pressure on a sphere", id="diameters of spheres"),
    pytest.param(SPHERE, hertz_point, "peak_pressure", times(2 / 3),
                 "peak pressure on a rigid flat", id="mean for peak pressure"),
    pytest.param(ROLLER, crown, "_scale", times(0.5), f"{PEAK}, strips", id="E' of Eq. 1 is 4 E*"),
    pytest.param(ROLLER, crown, "_scale", times(2.0), f"{PEAK}, strips", id="E' of Eq. 1 is E*"),
    pytest.param(ROLLER, inputs, "logarithmic", from_the_end, f"{PEAK}, strips",
                 id="y counts from the end"),
    pytest.param(TILTED, inputs, "logarithmic", one_end, "tilting moment, strips within 1%",
                 id="a crown at one end"),
    pytest.param(CROWNS, inputs, "logarithmic", straight_by_z_m,
                 "the straight middle follows K_2, not z_m", id="straight part depends on z_m"),
    pytest.param(ROLLER, palmgren, "compliance", without_power, f"{MID}, slices",
                 id="s without the power 1/0.9"),
    pytest.param(ROLLER, palmgren, "compliance", given(length=lambda k: k["length"] / 2),
                 f"{PEAK}, slices", id="s of half the length"),
    pytest.param(UNCROWNED, slices.press, "__kwdefaults__", kernel(alone), f"{MID}, slices",
                 id="w deflects none but its own slice"),
    pytest.param(TILTED, slices.press, "__kwdefaults__",
                 kernel(lambda d, D, b: slice_compliance.love(d, D, 4 * b)), f"{PEAK}, slices",
                 id="w on four times Hertz's width"),
    pytest.param(TILTED, Tilt, "gap", lambda f: lambda self, y: f(self, -y),
                 "tilting moment, strips within 1%", id="tilt the other way"),
    pytest.param(TILTED, Tilt, "gap",
                 lambda f: lambda self, y: f(self, y) + self.theta * self.L / 2,
                 "approach, strips", id="tilt about the end"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, broken):
    broken(owner, name, reading)
    assert row in failed(case, row)
