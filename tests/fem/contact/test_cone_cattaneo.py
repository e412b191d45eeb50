"""Rollers pressed together, pushed and pulled along z at once: Cattaneo in every direction.

Under a line of force in the surface of a half-space it moves by (1 - nu)/(pi G) ln(1/|x|) across
the line and by 1/(pi G) ln(1/|x|) along it, each with the pressure's own compliance but for a
factor. So the traction mu p(x; a) less a pressure over |x| < c shifts |x| < c as one along z too,
and c = a sqrt(1 - Q/(mu P)). With nu = 0 both compliances are one, and the same holds for a force
in any direction within the surface.
"""

import numpy as np
import pytest

from fem.contact.along import Along
from fem.plane.material import Elastic
from tests.fem.contact.models import rollers

MU, E = 0.3, 210e9


def stick_half_width(touch, q):
    """C of the traction `q` (points,): int (mu p - q) x^2 is that of an ellipse over |x| < c."""
    x, P = touch.along(), touch.normal_force
    left = (MU * touch.p - q) @ touch.weight
    # the ellipse left has the moment left c^2/4, and left = mu P c^2/a^2
    moment = ((MU * touch.p - q) * x**2) @ touch.weight
    assert left > 0
    assert P > 0
    return 2 * np.sqrt(moment / left)


@pytest.mark.parametrize("angle", [30.0, 120.0])
def test_without_poissons_ratio_every_direction_is_cattaneos(angle):
    # moved: what is pushed above would tilt
    problem = rollers(
        MU, materials=Elastic(E=E, nu=0.0),
        along=Along(supports={"lower.middle": 0.0, "upper.middle": 0.0}),
    )  # fmt: skip
    pressed = problem.solve(displacements={"upper.middle": {"x": 0.0, "y": -5e-6}})
    x, z = 7e-7 * np.cos(np.radians(angle)), 7e-7 * np.sin(np.radians(angle))
    moved = {"upper.middle": {"x": x, "y": -5e-6}}
    s = problem.solve(displacements=moved, axial_displacements={"upper.middle": z}, after=pressed)
    touch = s.touches[0]
    F = np.array([touch.friction_force, touch.force_z])
    Q, P = np.hypot(*F), touch.normal_force
    d = F / Q
    assert 0.3 < Q / (MU * P) < 0.9
    own, across = d[0] * touch.q + d[1] * touch.q_z, d[0] * touch.q_z - d[1] * touch.q
    scale = MU * touch.p.max()
    assert np.abs(across).max() < 0.02 * scale  # pressing alone leaves 0.01, for discs are round
    c = touch.half_width() * np.sqrt(1 - Q / (MU * P))
    assert stick_half_width(touch, own) == pytest.approx(c, rel=2e-3)
    nodal = np.hypot(touch.traction, touch.traction_z)
    slips = touch.closed & ~touch.sticks
    assert np.count_nonzero(slips) > 4
    np.testing.assert_allclose(nodal[slips], MU * touch.pressure[slips], rtol=1e-9)
    assert np.all(nodal <= MU * touch.pressure + 1e-9 * scale)
    # friction opposes the slip, in both of its components
    along = (touch.traction * touch.slip + touch.traction_z * touch.slip_z)[slips]
    size = nodal[slips] * np.hypot(touch.slip, touch.slip_z)[slips]
    np.testing.assert_allclose(along, -size, atol=1e-8 * size.max())
