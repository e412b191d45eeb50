"""Sprag clutches (Huang 2018): the other reading of an equation fails a row of its case."""

import numpy as np
import pytest

from analytic.sprag import closure, printed, race_spring
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.geometry import LogSprag
from tests.verify.cases.rows import failed
from verify.cases.sprag.clutch import model
from verify.cases.sprag.clutch.case import CLUTCH
from verify.cases.sprag.engagement.case import ENGAGEMENT
from verify.cases.sprag.wedge.case import WEDGE

TURN, FORCE = "rotation of the sprags under torque", "normal force under torque"
LARGEST = "largest pressure, inner race, under N/2, by slices"
LONG = "rotation of the sprags with elastic deflections"
OMEGA = "force ratio T_e/N_e against tan ω (Eq. 10), at N_0"


def as_printed(_):
    return printed.wedged


def of_a_closure(change):
    """Other lever arms of a closure: `OA_s` of the spiral and `OA` of the forces."""

    def fault(right):
        def closed(clutch, N, yields, *, OA_s, OA):
            return right(clutch, N, yields, **change(OA_s, OA, yields.contact_i))

        return closed

    return fault


def polar(_):
    return property(lambda self: np.asarray(self.r_i))


def in_micrometres(right):
    return lambda q: right(q.model_copy(update={"z_m": q.z_m / 1e3}))


READINGS = [
    (WEDGE, LONG, closure, "closed", of_a_closure(lambda OA_s, OA, d: {"OA_s": OA, "OA": OA}),
     "Eqs. 9 and 10 as printed"),
    (WEDGE, OMEGA, closure, "closed", of_a_closure(
        lambda OA_s, OA, d: {"OA_s": OA_s, "OA": OA - d / 2}), "all of δ_HI in the lever arm"),
    (WEDGE, "rotation of the sprags with Eqs. 9, 10 as printed", printed, "wedged",
     lambda _: closure.wedged, "the corrected closure as printed"),
    (ENGAGEMENT, "normal force at rest, after a slow rise", race_spring, "wedged", as_printed,
     "Eqs. 9 and 10 as printed"),
    (CLUTCH, TURN, LogSprag, "rho_0", polar, "r_i a polar radius"),
    (CLUTCH, "normal force with rigid races (Liu)", SpragClutch, "rigid_races",
     lambda _: lambda self: self, "rigid races that yield"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("case", "row", "owner", "name", "fault"),
    [pytest.param(*one, id=f"{one[0].id}: {what}") for *one, what in READINGS],
)
def test_another_reading_fails_a_row(case, owner, name, fault, row, fails):
    assert fails(case, owner, name, fault, row)


def test_z_m_is_in_millimetres(fails):
    assert not failed(CLUTCH, LARGEST)
    assert fails(CLUTCH, model, "gap", in_micrometres, LARGEST)
