"""The synthetic clutch of the freewheel cases of the project, and a clutch with an outer cam."""

import numpy as np
import pytest

from analytic.freewheel.clutch import ContactMaterial, RollerClutch
from analytic.freewheel.geometry import InnerCam, OuterCam

STEEL = ContactMaterial(E=206e9, nu=0.3)
PARTS = {"roller": STEEL, "inner": STEEL, "outer": STEEL}


@pytest.fixture
def star():
    """Clutch with R = 16.5 mm, r = 2.5 mm, alpha_0 = 3.5 deg and eight rollers, 10 mm long."""
    cam = InnerCam(R=16.5e-3, r=2.5e-3, X=11.39565e-3, z=8)
    return RollerClutch(cam=cam, L=10e-3, r_b=7.5e-3, R_a=21e-3, **PARTS)


@pytest.fixture
def cup():
    """Cup clutch [mm]: shaft of 10, rollers of 2, cup of 20; alpha_0 = 4 deg."""
    cam = OuterCam(R_s=10e-3, r=2e-3, X_o=12e-3 * np.cos(np.radians(8)) + 2e-3, z=8)
    return RollerClutch(cam=cam, L=10e-3, r_b=0.0, R_a=20e-3, **PARTS)


@pytest.fixture(params=["star", "cup"])
def clutch(request):
    return request.getfixturevalue(request.param)
