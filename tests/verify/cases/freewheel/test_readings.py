"""Freewheels (Nagler 2021): the other reading of an equation fails a row of its case."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.freewheel import compliance, criterion, printed
from analytic.freewheel.cam import Cam
from analytic.freewheel.state import RollerClutchState
from verify.cases.freewheel import star
from verify.cases.freewheel.cup.case import CUP
from verify.cases.freewheel.friction.case import FRICTION
from verify.cases.freewheel.torque.case import TORQUE

ANGLE = "clamping angle under torque"
FORCE = "normal force under torque"
REQUIRED = "required friction (Eqs. 8, 9)"
SLIP = "time of slip, load case"


def given(**factors):
    """The same formula with some of its arguments multiplied."""
    return lambda right: lambda **k: right(**{n: factors.get(n, 1) * v for n, v in k.items()})


READINGS = [
    (TORQUE, FORCE, star, "loaded", lambda f: lambda c, T: f(c, 8 * T), "T of one roller"),
    (TORQUE, "torque z R F_t (Eq. 3", Cam, "torque_on_race", lambda _: (
        lambda self, *, F_t: self.count * self.flat * F_t), "X for R in Eq. 3"),
    (TORQUE, ANGLE, Cam, "distance", lambda f: (
        lambda self, *, d_i, d_o: f(self, d_i=d_i, d_o=-np.asarray(d_o))), "sign of d_o in Eq. 5"),
    (TORQUE, "approach of roller and star", compliance, "_star",
     lambda f: lambda clutch: f(replace(clutch, star="half space")),
     "a half space for the star"),
    (TORQUE, "torque z X F_t of the star, Eq. 3 as printed", printed, "torque_on_cam",
     lambda _: lambda cam, *, F_t: cam.torque_on_race(F_t=F_t), "Eq. 3 corrected as printed"),
    (CUP, "wind-up by exact rolling", RollerClutchState, "phi",
     lambda _: property(lambda self: self.s / 10e-3), "the shaft's part alone"),
    (FRICTION, REQUIRED, criterion, "required_friction", lambda _: lambda *, alpha, T, F_ax, R: (
        np.tan(alpha) * (1 + F_ax * R / T)), "forces added without their right angle"),
    (FRICTION, "required friction, Eq. 8 as printed, with F_ax in place of F_a", criterion,
     "required_friction_of_contact", given(F_a=1 / 8), "F_ax/z where F_ax is printed"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("case", "row", "owner", "name", "fault"),
    [pytest.param(*one, id=f"{one[0].id}: {what}") for *one, what in READINGS],
)
def test_another_reading_fails_a_row(case, owner, name, fault, row, fails):
    assert fails(case, owner, name, fault, row)
