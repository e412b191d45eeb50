"""Friction by active sets and by Lemke's method: laws, proofs, tolerances on both sides."""

from types import SimpleNamespace

import numpy as np
import pytest

from benchmarks.friction import PULLED, problem, steps
from fem.contact.active_sets import fitting_states
from fem.contact.complementarity import METHODS, Complementarity, Rest
from fem.contact.errors import NoEquilibriumError
from fem.contact.friction_lcp import FrictionLcp
from fem.contact.lemke import lemke
from fem.contact.residual import residual
from fem.contact.solution import ContactSolution
from fem.contact.system import BACKWARD, FORWARD, OPEN, STICK

OF_A_NODE = np.array([[1.0, -0.9], [-0.9, 1.0]])  # pressure and slip of one node


def node(B=OF_A_NODE, mu=1.5):
    return Complementarity(
        B=B, D=np.zeros((2, 0)), friction=np.array([mu]), partner=np.array([1]), part=np.array([0])
    )


@pytest.mark.parametrize(
    ("push", "state", "friction"),
    [(0.1, STICK, -0.1), (-0.1, STICK, 0.1), (3.0, BACKWARD, -0.6), (-3.0, FORWARD, 0.6)],
)
def test_a_node_without_coupling_sticks_below_mu_p_and_slips_at_it(push, state, friction):
    # an overlap of 2 on unit compliance: p = 2, mu p = 0.6
    kernel = node(np.eye(2), mu=0.3)
    for found in (
        kernel.solve(np.array([-2.0, push]), np.zeros(0)),
        Rest(*next(FrictionLcp(kernel, np.array([-2.0, push]), np.zeros(0),
                               np.zeros((0, 0))).candidates())),
    ):  # fmt: skip
        assert found.states.tolist() == [state]
        assert found.multipliers == pytest.approx([2.0, friction])
    assert kernel.solve(np.array([-2.0, push]), np.zeros(0)).method == METHODS[0]


@pytest.mark.parametrize(
    ("row", "factor", "law"),
    [
        pytest.param(0, -1.0, "gap", id="tension"),
        pytest.param(1, 1.001, "friction", id="traction beyond the cone"),
        pytest.param(1, -1.0, "friction", id="friction along the slip"),
        pytest.param(0, 1.001, "complementarity", id="pressure across a gap"),
        pytest.param(0, -1.0, "complementarity", id="tension counts by its size"),
    ],
)
def test_a_wrong_force_violates_its_law(row, factor, law):
    kernel, w_0, none = node(np.eye(2), mu=0.3), np.array([-2.0, 3.0]), np.zeros(0)
    right = kernel.solve(w_0, none)
    assert residual(kernel, w_0, none, right.multipliers, none).largest < 1e-12
    wrong = right.multipliers * np.where(np.arange(2) == row, factor, 1.0)
    assert getattr(residual(kernel, w_0, none, wrong, none), law) > 2e-4


def test_of_three_solutions_the_one_of_index_minus_one_proves_the_others():
    # open, slipping forward at n = 0.1/0.35, and sticking: by hand
    kernel, w_0, none = node(), np.array([0.1, -0.3]), np.zeros(0)
    slipping = Rest(np.array([1.0, 1.5]) * 0.1 / 0.35, none, np.array([FORWARD], np.int8))
    sticking = Rest(np.linalg.solve(OF_A_NODE, -w_0), none, np.array([STICK], np.int8))
    lost = Rest(np.zeros(2), none, np.array([OPEN], np.int8))
    for rest in (slipping, sticking, lost):
        assert residual(kernel, w_0, none, rest.multipliers, none).largest < 1e-12
    assert kernel.is_proven_non_unique(slipping, w_0, none)
    assert not kernel.is_proven_non_unique(lost, w_0, none)
    # without force a row at the limit of its state proves no other solution
    rest = kernel.solve(np.zeros(2), none, np.array([FORWARD], np.int8))
    assert not np.any(rest.multipliers)
    assert not kernel.is_proven_non_unique(rest, np.zeros(2), none)


def test_a_wedge_held_by_friction_has_zero_force_as_another_solution():
    # a body between two plates at +-5 deg, drawn out of the wedge by neither: tan 5 deg = 0.087
    c, s = np.cos(np.radians(5)), np.sin(np.radians(5))
    D = np.array([[s, c], [s, -c], [-c, s], [c, s]])
    kernel = Complementarity(
        B=np.eye(4), D=D, friction=np.full(2, 0.2), partner=np.array([2, 3]),
        part=np.array([0, 1]),
    )  # fmt: skip
    w_0, e = np.array([-1.0, -1.0, 0.0, 0.0]), np.zeros(2)
    held = kernel.solve(w_0, e)
    assert held.multipliers[:2] == pytest.approx(held.multipliers[0])
    assert held.multipliers[0] > 0.5
    assert kernel.is_proven_non_unique(held, w_0, e)


@pytest.mark.parametrize(
    "seed",
    [
        *range(3),
        7482,  # forces far below those that close the gaps, which rows miss by 1e-12 of them
        7004,  # separated bodies without load: pivots leave forces of 1e-13 that nothing balances
    ],
)
def test_random_problems_meet_the_laws_of_contact_on_their_whole_path(seed):
    found = list(steps(problem(seed)))
    allowed = (*METHODS, "proven") + (("not found",) if seed < 3 else ())
    assert {outcome for outcome, _, _ in found} <= set(allowed)
    assert max(missed for _, _, missed in found) < 1e-9


def test_loads_outside_the_cone_of_forces_are_proven_to_have_no_equilibrium():
    one = next(one for one in map(problem, range(1000)) if one.kind == PULLED)
    w_0, e = one.ground[4] + np.concatenate([one.gaps, 0 * one.gaps]), one.loads[4]
    with pytest.raises(NoEquilibriumError, match="no admissible contact forces"):
        one.kernel.solve(w_0, e)
    assert issubclass(NoEquilibriumError, ValueError)


def test_lemke_solves_ties_at_every_pivot_and_gives_up_on_a_ray_and_after_four_pivots_a_row():
    # Murty's problem: 2^N - 1 pivots for N rows and covering vectors 2^-k; 15 of 16, 31 of 20
    for rows, solution in ((4, [1, 0, 0, 0]), (5, None)):
        M = np.eye(rows) + np.tril(2 * np.ones((rows, rows)), -1)
        z = lemke(M, -np.ones(rows), 0.5 ** np.arange(rows))
        assert z is None if solution is None else z.tolist() == pytest.approx(solution)
    n = 40
    z = lemke(np.eye(n) + 0.5 * np.ones((n, n)), -np.ones(n), np.ones(n))
    assert z == pytest.approx(np.full(n, 1 / (1 + 0.5 * n)))
    assert lemke(np.array([[-1.0]]), np.array([-1.0]), np.array([1.0])) is None


def smooth(B=((1.0, 0.0), (0.0, 1.0)), D=None):
    """Nodes without friction, on the compliance B."""
    n = len(B)
    return Complementarity(
        B=np.array(B), D=np.zeros((n, 0)) if D is None else np.array(D), friction=np.zeros(n),
        partner=np.full(n, -1), part=np.zeros(n, int),
    )  # fmt: skip


COUPLED = smooth(((1.0, -1.0), (-1.0, 2.0)))
MOVED = smooth([[1.0]], [[-1.0]])  # a body that meets one obstacle, which it moves to


@pytest.mark.parametrize(
    ("system", "w_0", "multipliers", "motion", "before", "state"),
    [
        pytest.param(smooth(), [-1.0, 0.0], [1.0, -1e-13], [], STICK, STICK, id="round-off"),
        pytest.param(smooth(), [-1.0, 0.0], [1.0, -1e-9], [], STICK, OPEN, id="tension"),
        # the gap of 1 and the approach of 1 and a little
        pytest.param(COUPLED, [-1.0, 1.0 - 1e-13], [1.0, 0.0], [], OPEN, OPEN, id="round-off"),
        pytest.param(COUPLED, [-1.0, 1.0 - 1e-9], [1.0, 0.0], [], OPEN, STICK, id="an overlap"),
        # it went by 1e3 to where the gap is a share of that
        pytest.param(MOVED, [1e3 * (1 + 1e-14)], [0.0], [1e3], OPEN, OPEN, id="of a path"),
        pytest.param(MOVED, [1e3 * (1 - 1e-13)], [0.0], [1e3], OPEN, OPEN, id="the other sign"),
        pytest.param(MOVED, [1e3 * (1 - 1e-9)], [0.0], [1e3], OPEN, STICK, id="after a path"),
    ],
)
def test_a_node_opens_and_closes_by_more_than_round_off(
    system, w_0, multipliers, motion, before, state
):
    states = np.array([STICK, before] if len(w_0) == 2 else [before], np.int8)
    found = fitting_states(system, np.array(w_0), np.array(multipliers), np.array(motion), states)
    assert found[-1] == state


def test_loads_gaps_and_slips_count_beyond_round_off():
    for load, unloaded in ((1e-14, True), (1e-12, False)):
        system = smooth(D=np.ones((2, 1)))
        assert system.is_unloaded(np.ones(2), np.array([load])) is unloaded
    for gap, left in ((1e-15, 0.0), (1e-12, 1e-12)):
        assert smooth().without_round_off(np.array([1.0, gap])).tolist() == [1.0, left]
    for share, slides in ((1e-12, True), (1e-6, False)):
        one = SimpleNamespace(touches=[SimpleNamespace(sticking_share=share)])
        assert ContactSolution.slides.fget(one) is slides


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_what_a_gap_misses_counts_against_the_path_whichever_direction_a_body_goes(sign):
    # bodies overlap by 0.1 at the end of a path of 1e6
    system = smooth([[1.0]], [[-sign]])
    none = np.zeros(1)
    found = residual(system, np.array([1e6 - 0.1]), none, none, np.array([sign * 1e6]))
    assert found.gap == pytest.approx(0.1 / (1e-5 * 2e6), rel=1e-6)


def test_a_slip_is_measured_by_its_row_not_by_a_distant_gap():
    # Row 0 touches under pressure 1, row 1 is open by 1e6. Sliding forward (traction 1e-6, the
    # limit) would need a slip of +5e-7, with the traction: it sticks at 5e-7 instead.
    kernel = Complementarity(
        B=np.eye(4), D=np.zeros((4, 0)), friction=np.array([1e-6, 1e-6]),
        partner=np.array([2, 3]), part=np.array([0, 0]),
    )  # fmt: skip
    w_0 = np.array([-1.0, 1e6, -5e-7, 0.0])
    rest = kernel.solve(w_0, np.zeros(0), np.array([FORWARD, 0], np.int8))
    assert rest.states[0] == STICK
    assert np.isclose(rest.multipliers[2], 5e-7, rtol=1e-12)
