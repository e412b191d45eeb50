"""Readings of rotors and of the clutch between them: another one fails against the reference."""

import numpy as np
import pytest

from analytic.rotor import clutch, clutch_uniform, shafts
from tests.verify.cases.readings import times
from verify.cases.rotor.clutch.case import CLUTCH
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.cases.rotor.shaft.case import SHAFT
from verify.cases.rotor.step.case import STEP, SteppedBeam


def tilted(right):
    """The tilt about x with the other sign, in the gradient of the deformation."""

    def post_init(self):
        right(self)
        object.__setattr__(self, "gradient", self.gradient * (1, 1, -1, 1, 1))

    return post_init


COUPLED = "coupling of y and the tilt about x, clutch with offset and tilt"
READINGS = [
    pytest.param(CLUTCH, clutch_uniform, "approach", times(2), "stiffness along y, even load",
                 id="each contact yields as both"),
    pytest.param(CLUTCH, clutch.SpragCoupling, "deformation",
                 lambda f: lambda self, q: f(self, np.asarray(q) * [-1, 1, 1, 1, 1]),
                 "coupling of bending and torsion, with an offset", id="sign in Eq. 3"),
    pytest.param(CLUTCH, SpragLink, "crown", times(2), "stiffness along x, with a crown",
                 id="four drops for two in Eq. 6"),
    pytest.param(CLUTCH, clutch.SpragCoupling, "__post_init__", tilted, COUPLED,
                 id="tilt about x in Eq. 7"),
    pytest.param(SHAFT, shafts.UniformShaft, "whirl", lambda f: (
                 lambda s, j, *, Omega=0.0, theory: f(s, j, Omega=Omega / 2, theory=theory)),
                 "weak form of Rayleigh's beam: whirl frequency of mode 1 backward",
                 id="polar for diametral inertia"),
    pytest.param(STEP, SteppedBeam, "rotor", lambda f: lambda s, **_: f(s),
                 "the 45° rule removes more than half of the frequency error of mode 1",
                 id="no 45° rule"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)
