"""Freewheels (Nagler 2021): the other reading of an equation fails a row of its case."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.freewheel import compliance, course, criterion, load_path, printed
from analytic.freewheel.cam import Cam
from analytic.freewheel.clutch import hertz_line
from analytic.freewheel.state import State
from tests.verify.cases.rows import failed
from verify.cases.freewheel import star
from verify.cases.freewheel.cup.case import CUP
from verify.cases.freewheel.friction.case import FRICTION
from verify.cases.freewheel.paths.case import PATHS
from verify.cases.freewheel.torque.case import TORQUE

ANGLE = "clamping angle under torque"
FORCE, WAY = "normal force under torque", "travel of the rollers (Eq. 6)"
TORSION = "wind-up by exact rolling, against ∫dU/T (Eq. 7, corrected)"
REQUIRED, LIMIT = "required friction (Eqs. 8, 9)", "limit of the axial load (Eq. 9)"
ALONE = "required friction, torque alone (Eqs. 1, 2)"
WEDGES = "rollers hold below tan α = μ and are released above"
SLIP = "time of slip, load case"


def scaled(factor):
    return lambda right: lambda *a, **k: factor * np.asarray(right(*a, **k))


def given(**factors):
    """The same formula with some of its arguments multiplied."""
    return lambda right: lambda **k: right(**{n: factors.get(n, 1) * v for n, v in k.items()})


def by_flat(_):
    return lambda self, *, F_t: self.count * self.flat * F_t


def opening(sign_i, sign_o):
    """Approaches of other signs."""
    return lambda right: (
        lambda self, *, d_i, d_o: right(
            self, d_i=sign_i * np.asarray(d_i), d_o=sign_o * np.asarray(d_o)
        )
    )


def plane_stress(right):
    return lambda **k: right(**k | {"assumption": "plane stress"})


def half_space(right):
    return lambda clutch: right(replace(clutch, star="half space"))


def only_race(radius):
    return lambda _: property(lambda self: self.s / radius)


READINGS = [
    (TORQUE, ANGLE, Cam, "alpha", scaled(2), "the wedge's angle for alpha"),
    (TORQUE, FORCE, Cam, "distance", scaled(21 / 16.5), "R_a for R"),
    (TORQUE, ANGLE, Cam, "distance", scaled(2), "diameters for radii"),
    (TORQUE, FORCE, star, "loaded", lambda f: lambda c, T: f(c, 8 * T), "T of one roller"),
    (TORQUE, "torque z R F_t (Eq. 3", Cam, "torque_on_race", by_flat, "X for R in Eq. 3"),
    (TORQUE, WAY, Cam, "arc", scaled(0.5), "way of alpha for 2 alpha"),
    (TORQUE, ANGLE, Cam, "distance", opening(1, -1), "sign of d_o in Eq. 5"),
    (TORQUE, "half-width on the star", hertz_line, "contact_modulus", plane_stress,
     "plane stress"),
    (TORQUE, "approach of roller and star", compliance, "_star", half_space,
     "a half space for the star"),
    (TORQUE, TORSION, State, "phi", only_race(16.5e-3), "the race's part alone in Eq. 7"),
    (TORQUE, "torque z X F_t of the star, Eq. 3 as printed", printed, "torque_on_cam",
     lambda _: lambda cam, *, F_t: cam.torque_on_race(F_t=F_t), "Eq. 3 corrected as printed"),
    (CUP, WAY, Cam, "arc", scaled(0.5), "way of alpha for 2 alpha"),
    (CUP, "wind-up, Eq. 7 as printed", printed, "torsion",
     lambda _: lambda cam, **d: 2 * cam.arc(**d) / cam.race, "Eq. 7 corrected as printed"),
    (CUP, "wind-up by exact rolling", State, "phi", only_race(10e-3), "the shaft's part alone"),
    (FRICTION, REQUIRED, criterion, "required_friction", given(alpha=2), "the wedge's angle"),
    (FRICTION, REQUIRED, criterion, "required_friction", given(F_ax=8), "F_ax of one roller"),
    (FRICTION, REQUIRED, criterion, "required_friction", given(R=11.39565 / 16.5), "X for R"),
    (FRICTION, REQUIRED, criterion, "required_friction", lambda _: lambda *, alpha, T, F_ax, R: (
        np.tan(alpha) * (1 + F_ax * R / T)), "forces added without their right angle"),
    (FRICTION, ALONE, criterion, "required_friction", lambda _: lambda *, alpha, T, F_ax, R: (
        np.sin(alpha) * np.hypot(1, F_ax * R / T)), "sin for tan"),
    (FRICTION, "required friction, Eq. 8 with the F_ax of Eq. 9 (as printed)", criterion,
     "required_friction_of_contact", given(F_a=1 / 8), "F_ax/z where F_ax is printed"),
    (FRICTION, LIMIT, criterion, "largest_axial_load", scaled(1 / 8), "limit of one roller"),
    (FRICTION, WEDGES, criterion, "self_releasing",
     lambda _: lambda *, alpha, mu: np.tan(2 * alpha) > mu, "half of the wedge's limit"),
    (PATHS, "axial load at slip, torque first", criterion, "largest_axial_load", scaled(8),
     "F_ax of one roller"),
    (PATHS, "required friction at the extremes of load case 2", criterion,
     "required_friction_of_ratio", lambda _: lambda *, alpha, ratio, R: (
        np.tan(alpha) * (1 + np.abs(ratio) * R)), "forces added without their right angle"),
    (PATHS, SLIP, load_path.BothAlternating, "_turn", scaled(2), "twice the frequency"),
    (PATHS, SLIP, load_path.AxialRamp, "axial_load", scaled(0.5), "a ramp to half of the load"),
    (PATHS, SLIP, course.Course, "slips_at", lambda f: property(
        lambda self: f.fget(self) + 3e-3), "slip three milliseconds late"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("case", "row", "owner", "name", "fault"),
    [pytest.param(*one, id=f"{one[0].id}: {what}") for *one, what in READINGS],
)
def test_another_reading_fails_a_row(case, row, owner, name, fault, broken):
    broken(owner, name, fault)
    assert failed(case, row)
