"""Readings of rotors and of the clutch between them: another one fails beside the reference."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.rotor import clutch, clutch_inclined, clutch_uniform, shafts, stepped
from tests.verify.cases.readings import given, times
from tests.verify.cases.rows import failed
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


def stiff(of):
    """Another diameter that counts for stiffness, in the cones."""
    return lambda f: (
        lambda q, **k: tuple(
            replace(p, d_stiff=of(q, p)) if q.d_1 < p.d_stiff < p.d else p for p in f(q, **k)
        )
    )


COUPLED = "coupling of y and the tilt about x, aside and tilted"
RULE = "weak form, 45° rule,"
READINGS = [
    pytest.param(CLUTCH, clutch_uniform, "radial_stiffness", times(2),
                 "stiffness along x, uniform", id="Z for Z/2"),
    pytest.param(CLUTCH, clutch_uniform, "contact_stiffness", times(0.9),
                 "stiffness along x, uniform", id="secant for tangent"),
    pytest.param(CLUTCH, clutch_uniform, "approach", times(2), "stiffness along y, uniform",
                 id="each contact yields as both"),
    pytest.param(CLUTCH, clutch.Clutch, "deformation",
                 lambda f: lambda self, q: f(self, np.asarray(q) * [-1, 1, 1, 1, 1]),
                 "coupling of bending and torsion, with an offset", id="sign in Eq. 3"),
    pytest.param(CLUTCH, clutch.Clutch, "d_t", lambda f: property(lambda s: 1.001 * f.fget(s)),
                 "torsional stiffness, with sprags missing", id="another lever in Eq. 4"),
    pytest.param(CLUTCH, clutch, "slice_middles", given(L=lambda k: 1.01 * k["L"]),
                 "tilting stiffness, with a crown", id="slices beyond the ends in Eq. 5"),
    pytest.param(CLUTCH, SpragLink, "crown", times(2), "stiffness along x, with a crown",
                 id="four drops for two in Eq. 6"),
    pytest.param(CLUTCH, clutch.Clutch, "__post_init__", tilted(1, 1, -1, 1, 1), COUPLED,
                 id="tilt about x in Eq. 7"),
    pytest.param(CLUTCH, clutch.Clutch, "__post_init__", tilted(1, 1, 1, -1, 1), COUPLED,
                 id="tilt about y in Eq. 7"),
    pytest.param(CLUTCH, clutch.Clutch, "slopes", times(1.001),
                 "tangent against differences of the loads, 1e-8", id="Eq. 11 of other loads"),
    pytest.param(CLUTCH, clutch_inclined, "replace",
                 lambda f: lambda c, psi: f(c, psi=2 * c.psi - psi),
                 "coupling of x and y by the wedge angle, with offset, crown and gap",
                 id="forces inclined the other way"),
    pytest.param(SHAFT, inputs, "hutchinson", lambda _: shafts.cowper,
                 "Timoshenko's beam as d/L goes to 0", id="Cowper's coefficient"),
    pytest.param(SHAFT, shafts.UniformShaft, "whirl", turning(0.0),
                 "gyroscopic splitting of mode 1, elements", id="no gyroscopic term"),
    pytest.param(SHAFT, shafts.UniformShaft, "whirl", turning(-1.0),
                 "elements of Rayleigh, mode 1 forward", id="forward for backward"),
    pytest.param(SHAFT, shafts.UniformShaft, "whirl", turning(0.5),
                 "weak form of Rayleigh, mode 1 backward", id="polar for diametral inertia"),
    pytest.param(STEP, SteppedBeam, "rotor", lambda f: lambda s, **_: f(s),
                 "the 45° rule removes more than half of the error of mode 1", id="no 45° rule"),
    pytest.param(STEP, SteppedBeam, "rotor",
                 lambda f: lambda s, **k: f(s.model_copy(update={"k": s.k / 2}), **k),
                 "weak form, mode 1 forward", id="k of both bearings"),
    pytest.param(STEP, stepped.SteppedShape, "pieces", stiff(lambda q, p: (p.d_stiff + q.d_1) / 2),
                 f"{RULE} mode 1 forward", id="half the cones' slope"),
    pytest.param(STEP, stepped, "Disc", given(polar=lambda k: k["polar"] / 2),
                 f"{RULE} gyroscopic splitting of mode 2", id="half the lumps' polar moment"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "reading", "row"), READINGS)
def test_another_reading_fails(case, owner, name, reading, row, broken):
    broken(owner, name, reading)
    assert row in failed(case, row)
