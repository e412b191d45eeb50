"""The clutch of Huang 2018, Table 1, with what the paper leaves open set to round values."""

import numpy as np
import pytest

from analytic.sprag.clutch import Clutch
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import Parts


@pytest.fixture
def sprag():
    return LogSprag.from_wedge_angle(nu_0=np.radians(3.15), R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)


@pytest.fixture
def parts(sprag):
    return Parts(
        sprag=sprag, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
    )  # fmt: skip


@pytest.fixture
def clutch(parts):
    return Clutch(sprag=parts.sprag, n_s=parts.n_s, compliance=parts.palmgren())


@pytest.fixture
def plane_clutch(parts):
    return Clutch(sprag=parts.sprag, n_s=parts.n_s, compliance=parts.plane())
