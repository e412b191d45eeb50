"""Contact of nearly incompressible bodies: their own stresses agree with the contact pressure."""

import numpy as np
import pytest

from fem.contact.nitsche import solve_nitsche
from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.join import join
from tests.fem.contact.models import tower

RUBBER = Elastic(E=1.0, nu=0.4999)


@pytest.mark.parametrize("cells", ["quad", "tri"])
def test_a_uniform_pressure_passes_a_contact_of_rubber_and_steel(cells):
    p, nu = 0.01, {"up": RUBBER.nu, "low": 0.2}
    mesh = join({"up": block(x=(0, 1), y=(1, 2), nx=6, ny=3, cells=cells),
                 "low": block(x=(0, 1), y=(0, 1), nx=5, ny=3, cells=cells)})  # fmt: skip
    s = ContactProblem(
        mesh, materials={"up": RUBBER, "low": Elastic(E=4.0, nu=0.2)}, assumption="plane strain",
        supports={"low.bottom": "y", "low.left": "x", "up.left": "x"},
        contacts=[Pair(slave="up.bottom", master="low.top")],
    ).solve(pressures={"up.top": p})  # fmt: skip
    np.testing.assert_allclose(s.touches[0].pressure, p, rtol=1e-8)
    for body in nu:
        stress = s.plane.in_body(body).stress.T
        np.testing.assert_allclose(stress - [0, -p, 0, -nu[body] * p], 0.0, atol=1e-8 * p)


def test_nitsches_method_refuses_them():
    problem = tower(0.0, materials={"up": RUBBER, "low": RUBBER},
                    supports={"low.bottom": "xy", "up.left": "x"})  # fmt: skip
    with pytest.raises(ValueError, match=r"Nitsche.*: nu <= 0.45 is required, got nu=0.4999 in "):
        solve_nitsche(problem, pressures={"up.top": 0.01})
