"""Stress in the fillets of a driven ring, with the hub's force from the balance of torques."""

import numpy as np
import pytest

from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.fillet_stress import driven_fillet_stress, loaded_fillet_stress
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import Roller, RollerContact
from analytic.polyhedral.sector import Sector

RING = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
CONTACT = RollerContact(RING, Roller(d=10.0, j_D=0.06), 210e3, 0.3, "plane stress")


@pytest.mark.parametrize("tan_phi", [0.0, 0.05, 0.6])
def test_the_hub_pushes_as_hard_as_the_rollers_torque_asks_of_it(tan_phi):
    N, p = 150.0, 30.0
    hub = Driven(CONTACT, grip=0.08, D_i=100.06, e=9.0, tan_phi=tan_phi)
    phi, at = np.arctan(tan_phi), np.array([RING.apothem, 9.0])
    leaning = np.array([np.cos(phi), -np.sin(phi)])  # off the flat's normal, to its middle
    R = 0.08 * N * 100.06 / 2 / (at[1] * leaning[0] - at[0] * leaning[1])
    normal, along = R * leaning
    push = hub_force(sector=RING, e=9.0, normal=normal, along=along)
    expected = loaded_fillet_stress(RING, p=p, hub=push, N=N, a=CONTACT.half_width(N))
    assert driven_fillet_stress(hub, N, p) == pytest.approx(expected, rel=1e-12)
    assert driven_fillet_stress(hub, 0.0, p) == loaded_fillet_stress(RING, p=p)
