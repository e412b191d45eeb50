"""The wedged roller against the equilibrium of its free body."""

import numpy as np
import pytest

from analytic.polyhedral import wedging

HALF_ANGLES = pytest.mark.parametrize("half", np.radians([0.5, 2.0, 4.5]))


# The roller as a free body: the wedge opens along +x, its bisector.


def roller(half):
    """Unit normal and tangential forces on the roller and its moments: columns N', T', N'', T''."""
    c, s = np.cos(half), np.sin(half)
    upper, lower = np.array([s, -c]), np.array([s, c])  # normals, from the races into the roller
    into = np.array([-c, -s]), np.array([-c, s])  # friction, into the wedge
    columns = [
        [*force, np.linalg.det([-at, force])]
        for at, pair in ((upper, (upper, into[0])), (lower, (lower, into[1])))
        for force in pair
    ]
    return np.array(columns).T


@HALF_ANGLES
def test_a_free_roller_s_tangential_force_is_n_tan_half_the_wedge_angle(half):
    body = roller(half)
    tangential, N, other = np.linalg.solve(body[:, 1:], -10.0 * body[:, 0])  # N' = 10 N
    assert (N, other) == (pytest.approx(10.0), pytest.approx(tangential))
    M_t = 6 * tangential * 0.05  # of six rollers in a race of 0.1 m
    free = {"alpha": 2 * half, "z": 6, "D_i": 0.1}
    assert float(wedging.torque(N=10.0, **free)) == pytest.approx(M_t, rel=1e-12)
    assert float(wedging.tangential_force(N=10.0, alpha=2 * half)) == pytest.approx(tangential)
    printed = float(wedging.largest_torque(N=10.0, mu=0.08, z=6, D_i=0.1))
    assert printed > 1.01 * M_t  # wherever Eq. 2 holds


@HALF_ANGLES
def test_the_friction_limit_needs_a_cage_that_pulls(half):
    body, mu = roller(half), 0.08
    cage = np.array([[1.0], [0.0], [0.0]])
    at_limit = 10.0 * (body[:, 0] + mu * body[:, 1])
    normal, tangential, pull = np.linalg.solve(np.hstack([body[:, 2:], cage]), -at_limit)
    assert (normal, tangential) == pytest.approx((10.0, 0.8))
    ours = float(wedging.cage_force(N=10.0, alpha=2 * half, mu=mu))
    assert ours == pytest.approx(pull, rel=1e-12)
    assert ours > 0


@HALF_ANGLES
def test_eq_5_is_an_equality(half):
    body = roller(half)
    tangential = np.linalg.solve(body[:, 1:], -10.0 * body[:, 0])[0]
    M_t = 6 * tangential * 0.05
    bound = float(wedging.normal_force(M_t=M_t, alpha=2 * half, z=6, D_i=0.1))
    assert bound == pytest.approx(10.0, rel=1e-12)  # as printed 10 N would be less


@HALF_ANGLES
def test_friction_carries_the_roller_up_to_the_largest_angle(half):
    """The tangential force of the free body over its normal force."""
    body = roller(half)
    needed = np.linalg.solve(body[:, 1:], -body[:, 0])[0]
    assert bool(wedging.holds(alpha=2 * half, mu=needed * 1.001))
    assert not wedging.holds(alpha=2 * half, mu=needed * 0.999)
    assert float(wedging.largest_angle(mu=needed)) == pytest.approx(2 * half, rel=1e-12)
    assert float(wedging.cage_force(N=1.0, alpha=2 * half, mu=needed)) == pytest.approx(
        0, abs=1e-15
    )


def test_torque_and_normal_force_are_inverse_free_and_caged():
    angles, race = np.radians([1.0, 5.0, 9.0]), {"z": 6, "D_i": 0.1}
    free = wedging.torque(N=1e4, alpha=angles, **race)
    np.testing.assert_allclose(wedging.normal_force(M_t=free, alpha=angles, **race), 1e4)
    caged = wedging.largest_torque(N=1e4, mu=0.08, **race)
    assert float(caged) == pytest.approx(240.0)  # 0.08 of 1e4 N, six times, at 50 mm
    assert float(wedging.least_normal_force(M_t=caged, mu=0.08, **race)) == pytest.approx(1e4)
