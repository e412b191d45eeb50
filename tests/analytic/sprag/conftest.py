"""Clutch of Huang 2018, Table 1; values that the paper does not print are set to round numbers."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.events import engage_by_events
from analytic.sprag.geometry import LogSprag
from analytic.sprag.motion import Motion, Torque
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.table import tabulated
from analytic.sprag.transient import engage


@pytest.fixture
def sprag():
    return LogSprag.from_wedge_angle(nu_0=np.radians(3.15), R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)


@pytest.fixture
def parts(sprag):
    return SpragClutchParts(
        sprag=sprag, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
    )  # fmt: skip


@pytest.fixture
def clutch(parts):
    return SpragClutch(sprag=parts.sprag, n_s=parts.n_s, compliance=parts.palmgren())


@pytest.fixture
def plane_clutch(parts):
    return SpragClutch(sprag=parts.sprag, n_s=parts.n_s, compliance=parts.plane())


@pytest.fixture
def motion():
    """Motion: inertias, springs, damping of Table 1; k_out, friction, alpha_max are assumed."""
    return Motion(
        m_g=1.8e-3, I_g=1.18e-8, I_bi=1.41e-3, I_be=1.41e-3, K_r=0.01, alpha_max=0.5, C_rl=0.1,
        k_out=1e5, mu_s=0.12, mu_c=0.08, gamma_b=1.0,
    )  # fmt: skip


@pytest.fixture
def table(clutch):
    return tabulated(clutch, N_end=20e3)


@pytest.fixture
def engaged(table, motion):
    """Function: engagement under a torque [N m]; keywords change the motion."""

    def run(torque, *, duration=0.01, dt=1e-5, D_V=None, speeds=None, guard=True, **other):
        return engage(
            table, replace(motion, **other),
            torque if isinstance(torque, Torque) else Torque.step(torque),
            duration=duration, dt=dt, D_V=D_V, speeds=speeds, guard=guard,
        )  # fmt: skip

    return run


@pytest.fixture
def by_events(clutch, motion):
    """Engagement integrated with event location, for forces up to 40 kN."""

    def run(torque, *, duration=0.009, speeds=None, unlimited=False, **other):
        states = wedged(clutch, 40e3 * np.linspace(0, 1, 4001) ** 2)
        return engage_by_events(
            states, clutch.n_s, replace(motion, **other), Torque.step(torque),
            duration=duration, speeds=speeds, unlimited=unlimited,
        )  # fmt: skip

    return run
