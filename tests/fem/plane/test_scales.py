"""Neither size nor place of a body changes what happens to it; a rigid motion strains nothing."""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_case, mapped, ring

E, NU = 210e9, 0.3
STEEL = Elastic(E=E, nu=NU)


@pytest.mark.parametrize(
    ("kind", "slenderness", "away"), [("tri6", 1024, 1e6), ("quad9", 128, 0.0)]
)
def test_a_slender_beam_far_away_stores_half_its_loads_work(kind, slenderness, away):
    mesh = mapped(kind, np.linspace(0, 1, 65), np.array([0, 1 / slenderness]))
    s = solve_plane(
        mesh.translated((away, away)), materials=STEEL, assumption="plane stress",
        supports={"left": "xy"}, tractions={"right": (0.0, 1.0)},
    )  # fmt: skip
    assert 2 * s.strain_energy == pytest.approx(s.f @ s.u, rel=1e-11, abs=0)  # Clapeyron
    body = s.in_body()
    # and so say its stresses: sigma : C^-1 : sigma / 2
    xx, yy, xy, _ = body.stress
    stored = (xx**2 + yy**2 - 2 * NU * xx * yy + 2 * (1 + NU) * xy**2) / (2 * E)
    assert body.weight @ stored == pytest.approx(s.strain_energy, rel=1e-11, abs=0)


@every_case
def test_a_bore_moved_rigidly_takes_the_ring_along(kind, assumption):
    moved = {"x": lambda x: 0.3 - 0.1 * x[1], "y": lambda x: -0.2 + 0.1 * x[0]}
    s = solve_plane(
        ring(kind, np.linspace(1, 2, 4), np.linspace(0, np.pi / 2, 7)), materials=STEEL,
        assumption=assumption, supports={"bore": moved},
    )  # fmt: skip
    inside = s.in_body()
    np.testing.assert_allclose(inside.u, [moved[c](inside.x) for c in "xy"], atol=1e-12)
    np.testing.assert_allclose(inside.stress, 0.0, atol=1e-12 * E)
    assert 0 <= s.strain_energy < E * 1e-24
