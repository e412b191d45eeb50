"""One diagonalisation for many speeds gives what a solution at each gives."""

import numpy as np
import pytest

from fem.rotor import response
from fem.rotor.critical import critical_speeds
from fem.rotor.damping import Rayleigh
from fem.rotor.many_speeds import Diagonal
from fem.rotor.model import Disc, Element, Material, Rotor, Shaft, Support
from tests.fem.rotor.rotor_ross import ours

UNBALANCES = {3: 1.4e-5, 18: 1e-5j}
SPEEDS = np.linspace(-3000, 4000, 2 * response.MANY)


def whole(rotor, speeds):
    return response.unbalance_response(rotor, speeds, UNBALANCES).q


def one_by_one(rotor, speeds):
    parts = np.array_split(speeds, 1 + speeds.size // (response.MANY // 2))
    return np.concatenate([whole(rotor, part) for part in parts])


AGREE = 1e-9  # of the motion at its speed
STEEL = Material(E=210e9, nu=0.3, rho=7850.0)


@pytest.mark.parametrize(("unlike", "damped"), [(True, True), (False, False)])
def test_many_speeds_agree_with_few(unlike, damped):
    rotor = ours([0.88] * 20, unlike=unlike, damped=damped)
    assert any(Diagonal.of(block, SPEEDS, SPEEDS) for block in rotor.blocks)
    each, together = one_by_one(rotor, SPEEDS), whole(rotor, SPEEDS)
    missed = np.linalg.norm(together - each, axis=1)
    assert np.all(missed <= AGREE * np.linalg.norm(each, axis=1))
    assert np.any(missed > 0)  # not the same computation


def test_at_an_undamped_resonance_the_direct_solution_decides():
    rotor = ours([0.88] * 20, damped=False)
    near = critical_speeds(rotor, 1).speeds * (1 + np.linspace(-1e-9, 1e-9, response.MANY))
    (modes,) = (Diagonal.of(b, near, near) for b in rotor.blocks if b.sense == 1)
    force = np.ones((near.size, modes.mu.size), complex)
    assert not np.any(modes.solve(near, force)[1])
    # of two speeds, one of them far from the modes, only that one is solved
    two = np.array([near[0], 0.5 * near[0]])
    assert modes.solve(two, force[:2])[1].tolist() == [False, True]
    assert np.array_equal(whole(rotor, near), one_by_one(rotor, near))


def shaft(*, damping=None, **more):
    """A shaft on two supports, the first with more."""
    supports = [Support(0, 1e7, cxx=3e3, **more), Support(8, 2e7)]
    return Rotor(
        [Shaft([Element(0.1, 0.03, material=STEEL)] * 8)], [Disc(3, 8.0, 0.4, 0.2)], supports,
        damping=damping,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("rotor", "omega"),
    [
        (shaft(damping=Rayleigh(3.0, 1e-6)), SPEEDS),  # damped everywhere
        (shaft(kxy=1e5, kyx=-2e5), SPEEDS),  # a stiffness that is not symmetric
        (shaft(), 900.0 + 0 * SPEEDS),  # forces that do not turn with the shaft
    ],
)
def test_other_problems_are_left_to_direct_solutions(rotor, omega):
    bending = [block for block in rotor.blocks if "bending" in block.planes]
    assert all(Diagonal.of(block, SPEEDS, omega) is None for block in bending)
