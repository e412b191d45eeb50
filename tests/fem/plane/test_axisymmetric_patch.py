"""A body of revolution meets constant stress exactly on any mesh."""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import KINDS, degree, mapped

E, NU = 210e9, 0.3
ROUND_OFF = 1e-12  # relative
BORES = dict(zip(KINDS, (0.0, 0.5, 0.0, 0.5, 0.0, 0.5), strict=True))  # solid and hollow in turn
every_body = pytest.mark.parametrize(("kind", "bore"), BORES.items())


def tube(kind, bore):
    """A tube or a bar of outer radius 2 and length 1: wavy cells within, two bodies."""

    def place(s, t):
        wave = np.sin(np.pi * s) * np.sin(np.pi * t)
        s = s + 0.06 * wave * np.cos(5 * t)
        return bore + (2 - bore) * s, t + 0.08 * np.sin(np.pi * t) * np.cos(4 * s)

    names = ("bore", "rim", "bottom", "top")
    return mapped(kind, np.linspace(0, 1, 7), np.linspace(0, 1, 4), place, names, split=0.5)


@every_body
def test_constant_stress_is_exact_on_wavy_cells(kind, bore):
    pressure, pull = 70e6, 40e6
    s = solve_plane(
        tube(kind, bore), materials=Elastic(E=E, nu=NU), assumption="axisymmetric",
        degree=degree(kind), supports={"bottom": "y"}, tractions={"top": (0.0, pull)},
        pressures={"rim": pressure} | ({"bore": pressure} if bore else {}),
    )  # fmt: skip
    expected = np.array([[-pressure], [pull], [0.0], [-pressure]])
    strains = (-(1 - NU) * pressure - NU * pull) / E, (pull + 2 * NU * pressure) / E
    for some in (s.in_body(), *(s.on_boundary(name) for name in ("bore", "rim", "top"))):
        np.testing.assert_allclose(
            some.stress, np.broadcast_to(expected, some.stress.shape), atol=ROUND_OFF * E * 1e-3
        )
        np.testing.assert_allclose(some.u, some.x * np.reshape(strains, (2, 1)), atol=1e-15)
    # energy is half the stress times strain on the volume 2 pi, less that of the bore
    density = (-2 * pressure * strains[0] + pull * strains[1]) / 2
    volume = np.pi * (2**2 - bore**2)
    assert s.strain_energy == pytest.approx(density * volume, rel=ROUND_OFF)
    assert s.in_body().weight.sum() == pytest.approx(volume, rel=ROUND_OFF)
