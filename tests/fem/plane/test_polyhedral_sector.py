"""Half a sector of a polyhedral ring: statics, convergence, limits, and a roller outside."""

from math import cos, hypot, pi, sin

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.polyhedral.half_sector import half_sector

D_E, D_I, FILLET, THICKNESS = 0.08, 0.072, 0.002, 0.03  # [m]
E, NU, PRESSURE = 210e9, 0.3, 30e6  # [Pa]
D_M = (D_E + D_I) / 2
CLEARANCE = 0.06e-3  # [m] of the diameter
ROLLER = 0.005  # [m] radius
HUB, PUSH = (8.5e-3, 9.5e-3), (400.0, -20.0)  # [m], [N]
BALANCE = 1e-11  # of the loads, far below the 1e-8 that is asked for


def mesh(z, refine=1, **more):
    return half_sector(z=z, d_e=D_E, d_i=D_I, fillet=FILLET, refine=refine, **more)


def pressed(z, refine=1, *, assumption="plane stress", nu=NU, forces=None, **more):
    return solve_plane(
        mesh(z, refine, **more), materials=Elastic(E=E, nu=nu), assumption=assumption,
        supports={"mid": "n", "corner": "n"}, pressures={"bore": PRESSURE}, forces=forces,
        thickness=THICKNESS,
    )  # fmt: skip


def outward(solution, angle):
    """Radial displacement outside at `angle`."""
    c, s = cos(angle), sin(angle)
    x, y = solution.displacement_at((D_E / 2 * c, D_E / 2 * s))
    return x * c + y * s


def stiffness_factor(solution, angle=0.0):
    """Pressure that takes up the clearance over that of a thin round ring."""
    thin = (D_E - D_I) * E * CLEARANCE / (D_I * D_M)
    return PRESSURE * CLEARANCE / 2 / outward(solution, angle) / thin


def apothem(z):
    return D_I / 2 * cos(pi / z) + FILLET * (1 - cos(pi / z))


@pytest.mark.parametrize("z", [3, 48])
def test_cuts_carry_the_pressure_on_the_bore_beside_them(z):
    solution = pressed(z)
    x, y, _ = solution.reaction("mid")
    assert (x, -y) == pytest.approx(
        (0, PRESSURE * THICKNESS * apothem(z)), rel=BALANCE, abs=BALANCE * -y
    )
    x, y, _ = solution.reaction("corner")
    assert hypot(x, y) == pytest.approx(PRESSURE * THICKNESS * D_I / 2, rel=BALANCE)


def test_many_sides_are_a_round_ring():
    z = np.array([12, 24, 48, 96])
    factors = np.array([stiffness_factor(pressed(int(n))) for n in z])
    lame = D_M**2 / (D_I * D_E)
    assert np.all(np.diff(factors) < 0)
    assert factors[-1] > lame
    assert factors[2] == pytest.approx(lame, rel=0.02)
    # what the polygon's wall has more than the round one's falls with 1/z^2
    assert (4 * factors[3] - factors[2]) / 3 == pytest.approx(lame, rel=5e-4)


def roller(z, refine=1, **more):
    """The ring with a rigid roller outside, whose gap is wider by half the clearance."""
    return ContactProblem(
        mesh(z, refine, zone=4e-4, cells=8, **more), materials=Elastic(E=E, nu=NU),
        assumption="plane stress", supports={"mid": "n", "corner": "n"}, thickness=THICKNESS,
        obstacles={"roller": Obstacle(Circle((D_E / 2 + ROLLER, 0.0), ROLLER))},
        contacts=[Pair(slave="zone", master="roller", slave_shape=Circle((0.0, 0.0), D_E / 2),
                       interference=-CLEARANCE / 2)],
    )  # fmt: skip


def test_roller_hub_pressure_and_cuts_are_in_balance():
    solution = roller(6, hub=HUB).solve(pressures={"bore": PRESSURE}, forces={"hub": PUSH})
    c, s = D_I / 2 * cos(pi / 6), D_I / 2 * sin(pi / 6)
    load = PRESSURE * THICKNESS * np.array([s, apothem(6) - c])
    cuts = np.sum([solution.plane.reaction(name)[:2] for name in ("mid", "corner")], axis=0)
    rest = cuts + load + np.array(PUSH) - solution.touches[0].force
    assert np.abs(rest).max() < BALANCE * load[0]
