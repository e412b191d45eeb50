"""Readings of rotors and of the clutch between them: another one fails beside the reference."""

import numpy as np
import pytest

from analytic.rotor import clutch, clutch_uniform, shafts, stepped
from tests.verify.cases.readings import given, times
from verify.cases.rotor.clutch.case import CLUTCH
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.cases.rotor.shaft import inputs
from verify.cases.rotor.shaft.case import SHAFT
from verify.cases.rotor.step.case import STEP, SteppedBeam


def tilted(*factors):
    """Columns of the deformation's gradient times factors."""

    def reading(f):
        def post_init(self):
            f(self)
            object.__setattr__(self, "gradient", self.gradient * factors)

        return post_init

    return reading


def turning(change):
    """Whirl at another speed of rotation."""
    return lambda f: lambda s, j, *, Omega=0.0, theory: f(s, j, Omega=change * Omega, theory=theory)


COUPLED = "coupling of y and the tilt about x, aside and tilted"
RULE = "weak form, 45° rule,"
READINGS = [
    pytest.param(CLUTCH, clutch_uniform, "approach", times(2), "stiffness along y, uniform",
                 id="each contact yields as both"),
    pytest.param(CLUTCH, clutch.Clutch, "deformation",
                 lambda f: lambda self, q: f(self, np.asarray(q) * [-1, 1, 1, 1, 1]),
                 "coupling of bending and torsion, with an offset", id="sign in Eq. 3"),
    pytest.param(CLUTCH, SpragLink, "crown", times(2), "stiffness along x, with a crown",
                 id="four drops for two in Eq. 6"),
    pytest.param(CLUTCH, clutch.Clutch, "__post_init__", tilted(1, 1, -1, 1, 1), COUPLED,
                 id="tilt about x in Eq. 7"),
    pytest.param(SHAFT, inputs, "hutchinson", lambda _: shafts.cowper,
                 "Timoshenko's beam as d/L goes to 0", id="Cowper's coefficient"),
    pytest.param(SHAFT, shafts.UniformShaft, "whirl", turning(0.0),
                 "gyroscopic splitting of mode 1, elements", id="no gyroscopic term"),
    pytest.param(SHAFT, shafts.UniformShaft, "whirl", turning(0.5),
                 "weak form of Rayleigh, mode 1 backward", id="polar for diametral inertia"),
    pytest.param(STEP, SteppedBeam, "rotor", lambda f: lambda s, **_: f(s),
                 "the 45° rule removes more than half of the error of mode 1", id="no 45° rule"),
    pytest.param(STEP, stepped, "Disc", given(polar=lambda k: k["polar"] / 2),
                 f"{RULE} gyroscopic splitting of mode 2", id="half the lumps' polar moment"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, fails):
    assert row in fails(case, owner, name, reading, row)
