"""Rollers pressed together and pulled along z, alone and with a push: Cattaneo in every direction.

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

R, MU, E = 10e-3, 0.3, 210e9
A = 0.01 * R


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
    s = problem.solve(
        displacements={"upper.middle": {"x": x, "y": -5e-6}}, axial_displacements={"upper.middle": z},
        after=pressed,
    )  # fmt: skip
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


def test_the_edges_turn_back_at_twice_the_change_of_load():
    # Mindlin and Deresiewicz, along z: unloading is a loading of twice the friction
    problem = rollers(
        MU, supports={"lower.middle": "xy", "upper.middle": "x"},
        along=Along(supports={"lower.middle": 0.0}),
    )  # fmt: skip
    P = np.pi * E / (1 - 0.3**2) * A**2 / (4 * R)  # half the modulus, half the radius
    pressed = problem.solve(forces={"upper.middle": (0.0, -P)})

    def at(share, after):
        return problem.solve(
            forces={"upper.middle": (0.0, -P)}, axial_forces={"upper.middle": share * MU * P},
            after=after,
        )  # fmt: skip

    there = at(0.8, pressed)
    back = at(0.3, there)
    touch, before = back.touches[0], there.touches[0]
    a = touch.half_width()
    c = a * np.sqrt(1 - 0.5 / 2)
    assert np.ptp(touch.x[0, touch.sticks]) / 2 == pytest.approx(c, abs=0.1 * A)
    change = before.q_z - touch.q_z
    x = touch.along()
    twice = 2 * MU * touch.p - change
    found = 2 * np.sqrt((twice * x**2) @ touch.weight / (twice @ touch.weight))
    assert found == pytest.approx(c, rel=2e-3)
    again = at(0.8, back)
    np.testing.assert_allclose(
        again.touches[0].traction_z, before.traction_z, atol=1e-3 * MU * touch.peak
    )
