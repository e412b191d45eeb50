"""Size, place and a rigid motion change nothing in a frame."""

import numpy as np
import pytest

from fem.beam.section import Section
from tests.fem.beam.models import both_solvers

BRACKET = np.array([(0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (3, 2)], float)
PAIRS = [(k, k + 1) for k in range(5)]


def bracket_sink(P, size, EA, EI, GA):
    """Up by 2 sizes, out by 3, loaded by P at its end: bending of both parts, shear, shortening."""
    up, out = 2 * size, 3 * size
    return P * (out**3 / (3 * EI) + out**2 * up / EI + out / GA + up / EA)


@pytest.mark.parametrize(("size", "away"), [(1e4, (0, 0)), (1e-6, (1e6, 0))])
@both_solvers
def test_a_bracket_sinks_alike_at_every_size_and_place(solve, size, away):
    # a square section a twentieth of the size thick, of steel
    E, d = 210e9, size / 20
    EA, EI, GA, P = E * d**2, E * d**4 / 12, 5 / 6 * E / 2.6 * d**2, 1e-6 * E * d**2
    s = solve(
        size * (BRACKET + away), PAIRS, sections=Section(EA=EA, EI=EI, GA=GA),
        supports={0: "xyr"}, loads={5: (0.0, -P, 0.0)},
    )  # fmt: skip
    sink = bracket_sink(P, size, EA, EI, GA)
    # 6 of 16 digits lost to the distance, 3 to EA size^2 / EI = 5e3
    assert s.u[5, 1] == pytest.approx(-sink, rel=1e-7 if any(away) else 1e-10)
    assert s.strain_energy == pytest.approx(P * sink / 2, rel=1e-7 if any(away) else 1e-10)


@both_solvers
def test_a_support_that_moves_rigidly_takes_the_frame_along(solve):
    move, turn = (0.3, -0.2), 0.1
    EA = 1e6
    s = solve(
        BRACKET, PAIRS, sections=Section(EA=EA, EI=10.0, GA=1e6), loads={},
        supports={0: {"x": move[0], "y": move[1], "r": turn}},
    )  # fmt: skip
    x, y = BRACKET.T
    expected = np.column_stack([move[0] - turn * y, move[1] + turn * x, np.full(6, turn)])
    np.testing.assert_allclose(s.u[:6], expected, atol=1e-12)
    assert 0 <= s.strain_energy < EA * 1e-24
    assert s.reaction(0) == pytest.approx((0, 0, 0), abs=EA * 1e-14)


@both_solvers
def test_the_supports_balance_loads_in_force_and_moment(solve):
    rng = np.random.default_rng(1)
    loads = {k: tuple(rng.normal(size=3)) for k in range(6)}
    supports = {0: "xy", 3: "y", 5: "xyr"}
    s = solve(
        BRACKET, PAIRS, sections=Section(EA=500.0, EI=10.0, GA=100.0), supports=supports,
        loads=loads,
    )  # fmt: skip
    total = np.zeros(3)
    for node in range(6):
        x, y = BRACKET[node]
        f = np.array(loads[node])
        if node in supports:
            f += s.reaction(node)
        else:  # nothing holds it
            assert s.reaction(node) == pytest.approx((0, 0, 0), abs=1e-10)
        total += f[0], f[1], f[2] + x * f[1] - y * f[0]
    np.testing.assert_allclose(total, 0, atol=1e-9)
    assert s.reaction(3)[0] == pytest.approx(0, abs=1e-10)  # only held along y
    assert s.reaction(0)[2] == pytest.approx(0, abs=1e-10)  # free to turn


@both_solvers
def test_two_nodes_move_each_other_alike(solve):
    # Maxwell and Betti: a couple at 2 moves 5 down as a force down at 5 turns 2
    def under(loads):
        return solve(
            BRACKET, PAIRS, sections=Section(EA=500.0, EI=10.0, GA=100.0), supports={0: "xyr"},
            loads=loads,
        ).u  # fmt: skip

    sink = under({2: (0.0, 0.0, 1.0)})[5, 1]
    turn = under({5: (0.0, 1.0, 0.0)})[2, 2]
    assert sink == pytest.approx(turn, rel=1e-10)
    # by hand: the couple turns the corner by 2 / EI, over the arm of 3
    assert sink == pytest.approx(3 * 2 / 10, rel=1e-10)
