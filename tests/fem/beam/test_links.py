"""Rigid links between points of a frame against closed forms; contacts that close one by one."""

import math

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.linked_stages import LinkedFrame, opposite
from fem.beam.links import Link
from fem.beam.section import Section
from fem.beam.straight import solve_frame
from fem.beam.two_lines import fitted, on_common, retraced, touching

L, EI = 2.0, 3.0
THIN = Section(EA=1e6, EI=EI)
ABOVE = [[0.0, 0.0], [L, 0.0], [0.0, 0.1], [L, 0.1]]  # two cantilevers, one over the other
PAIR = [[0, 1], [2, 3]]
CLAMPS = {0: "xyr", 2: "xyr"}
PUSH = {3: (0.0, -1.0, 0.0)}


def pressed(*links, loads=PUSH, **more):
    return solve_frame(
        ABOVE, PAIR, sections=THIN, supports=CLAMPS, loads=loads, links=links, **more
    )


def test_a_gap_is_closed_before_the_second_cantilever_carries_load():
    """The gap g leaves F - 3 EI g/L³ to share."""
    gap = 0.3 * L**3 / (3 * EI)
    solved = pressed(Link(first=3, second=1, direction=(0, -1), value=-gap))
    assert solved.link_forces == pytest.approx([(1 - 0.3) / 2], rel=1e-12)
    assert solved.u[1, 1] - solved.u[3, 1] == pytest.approx(gap, rel=1e-12)


@pytest.mark.parametrize("shares", [(0.25, 0.75), (0.75, 0.25)])
def test_an_element_may_be_linked_at_several_places(shares):
    """In any order: the same as nodes there from the start."""
    links = [Link(first=(1, s), second=(0, s), direction=(0, 1)) for s in shares]
    cut = pressed(*links)
    x = np.array([0, *sorted(shares), 1]) * L
    points = np.concatenate([np.column_stack([x, 0 * x]), np.column_stack([x, 0 * x + 0.1])])
    chain = [[0, 1], [1, 2], [2, 3], [4, 5], [5, 6], [6, 7]]
    whole = solve_frame(
        points, chain, sections=THIN, supports={0: "xyr", 4: "xyr"}, loads={7: (0.0, -1.0, 0.0)},
        links=[Link(first=4 + i, second=i, direction=(0, 1)) for i in (1, 2)],
    )  # fmt: skip
    inner = dict(zip(shares, cut.link_forces, strict=True))
    assert [inner[0.25], inner[0.75]] == pytest.approx(whole.link_forces, rel=1e-10)
    np.testing.assert_allclose(cut.u[3], whole.u[7], rtol=1e-10)


def test_loads_along_an_element_stay_when_a_link_cuts_it():
    """A uniform load on a cantilever whose tip a second one props: 3 q L/8 is shared by two."""
    q = {0: (0.0, 1.0)}
    tip = pressed(Link(first=1, second=3, direction=(0, 1)), loads={}, distributed=q)
    assert tip.link_forces == pytest.approx([3 * L / 16], rel=1e-12)
    middles = Link(first=(0, 0.5), second=(1, 0.5), direction=(0, 1))
    middle = pressed(middles, loads={}, distributed=q)  # 17 q L⁴/384EI against 2 P L³/24EI
    assert middle.link_forces == pytest.approx([17 * L / 32], rel=1e-12)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"second": 9}, "no node 9: the frame has nodes 0 to 3"),
        ({"second": (7, 0.5)}, "no element 7: the frame has elements 0 to 1"),
        ({"second": (0, 1.5)}, r"the position of a link on element 0 must lie in \[0, 1\], got"),
        ({"second": 3}, "a link must have two different points, got 3 twice"),
        (
            {"second": 1, "direction": (0, 0)},
            r"the direction \(x, y\) of a link must be finite and not zero",
        ),
        (
            {"second": 1, "value": math.nan},
            "the relative displacement of a link must be finite, got nan m",
        ),
    ],
)
def test_impossible_links_are_named_in_one_line(more, message):
    with pytest.raises(ValueError, match=message):
        pressed(Link(**({"first": 3, "direction": (0, -1)} | more)))


def test_links_that_hold_nothing_are_refused():
    one = Link(first=3, second=1, direction=(0, -1))
    for links in ([one, one], [Link(first=0, second=2, direction=(0, 1))]):
        with pytest.raises(
            ValueError, match="links must not be redundant and must not join points that"
        ):
            pressed(*links)
    # a hinge and a link through the hinge: the beam turns about it
    with pytest.raises(ValueError, match="can move rigidly in spite of its links"):
        solve_frame(
            [[0, 0], [L, 0], [L, 0.0], [L + 1, 0.0]], PAIR, sections=THIN, loads={2: (0, -1, 0)},
            supports={0: "xyr", 3: "xy"}, links=[Link(first=2, second=1, direction=(1, 0))],
        )  # fmt: skip


def test_curved_elements_are_linked_at_nodes():
    def bent(link):
        section = Section(EA=1e6, EI=EI, GA=1e5)
        x = np.linspace(0, L, 9)
        points = np.concatenate([np.column_stack([x, 0 * x]), np.column_stack([x, 0 * x + 0.1])])
        thirds = [[i, i + 2, i + 1] for i in (*range(0, 8, 2), *range(9, 17, 2))]
        return solve_curved_frame(
            points, thirds, sections=section, supports={0: "xyr", 9: "xyr"},
            loads={17: (0, -1, 0)}, links=[link],
        )  # fmt: skip

    # tip on tip of two equal cantilevers
    tips = bent(Link(first=17, second=8, direction=(0, -1)))
    assert tips.link_forces == pytest.approx([0.5], rel=1e-9)
    with pytest.raises(
        ValueError, match=r"links of curved elements must be at nodes, got \(0, 0.5\)"
    ):
        bent(Link(first=17, second=(0, 0.5), direction=(0, 1)))


EA = 100.0  # of pieces of the length 1


def bar(gaps):
    """Three pieces in a row, and two beside them that nodes 0 and 1 come to touch."""
    points = np.array([[0.0, 0], [1, 0], [2, 0], [3, 0], [0.5, 1], [1.5, 1], [3, 1]])
    chords = np.array([[0, 1], [1, 2], [2, 3], [4, 5], [5, 6]])
    ends = np.array([[0, 4], [1, 5]])
    links = [Link(first=i, second=j, direction=(1.0, 0.0), value=-g)
             for (i, j), g in zip(ends.tolist(), gaps, strict=True)]  # fmt: skip
    return LinkedFrame(
        points, chords, ends, Section(EA=EA, EI=1.0), head=0,
        supports={0: "yr", 1: "yr", 3: "xyr", 4: "yr", 5: "yr", 6: "xyr"}, links=links,
    )  # fmt: skip


def test_a_bar_touches_its_stops_in_turn():
    """Three pieces in a row under F move node 0 by 3 F/(E A) and node 1 by 2 F/(E A)."""
    found = bar((10.0, 0.2)).stages()
    assert found["k1"] == pytest.approx(EA / 3, rel=1e-9)
    assert found["F_A"] == pytest.approx(0.2 * EA / 2, rel=1e-9)
    assert found["U_A"] == pytest.approx(0.3, rel=1e-9)
    rest = EA / 2 + EA / 1.5  # of both rows behind the first stop
    assert found["k2"] == pytest.approx(1 / (1 / EA + 1 / rest), rel=1e-9)
    assert found["k3"] == pytest.approx(1 / (1 / (2 * EA) + 1 / rest), rel=1e-9)
    assert found["F_B"] == pytest.approx(found["F_A"] + (10.0 - 0.3) * EA, rel=1e-9)
    assert abs(found["push"]) < 1e-9 * found["F_A"]


@pytest.mark.parametrize("normal", ["force", "leaf"])
def test_the_place_opposite_of_a_tip_lies_on_the_normal_of_force_or_leaf(normal):
    slope = np.radians(80)
    along = np.array([np.cos(slope), np.sin(slope)])
    points = np.vstack([[0.0, 5.0], *(np.array([3.0, 0.0]) + s * along for s in range(11))])
    leaf = np.column_stack([np.arange(1, 11), np.arange(2, 12)])
    found = opposite(points, leaf, 0, normal, 0.0)
    ends = points[leaf[found.element]]
    place = ends[0] + found.share * (ends[1] - ends[0])
    n = np.array(found.direction)
    assert place - points[0] == pytest.approx(found.gap * n, abs=1e-12)
    wanted = (1.0, 0.0) if normal == "force" else (np.sin(slope), -np.cos(slope))
    assert n == pytest.approx(wanted, abs=1e-12)


mm = 1e-3


def kinked(U):
    """Lines of 600 and 750 N/m, a kink at 12 mm, and the normal force that grows from it on."""
    beyond = np.maximum(0, U - 12 * mm)
    return np.array([U, 600 * U + 150 * beyond, 300 * beyond])


def test_two_lines_are_found_again():
    found = fitted(kinked(np.arange(1, 18) * mm), 17 * mm)
    assert (found.k1, found.k2) == pytest.approx((600, 750), rel=1e-12)
    assert pytest.approx((12 * mm, 12 * mm), rel=1e-12) == (found.U_A, found.U)
    assert (found.F_A, found.c1, found.c2) == pytest.approx((7.2, 0, -1.8), abs=1e-12)
    # a stroke that ends before A has one line, one that ends at it no second slope
    found = fitted(kinked(np.arange(1, 11) * mm), 17 * mm)
    assert found.k1 == pytest.approx(600, rel=1e-12)
    assert np.isnan([found.k2, found.c2, found.U_A, found.F_A, found.U]).all()
    found = fitted(kinked(np.arange(1, 15) * mm), 17 * mm)
    assert pytest.approx(12 * mm) == found.U_A
    assert np.isnan(found.k2)
    assert np.isnan(fitted(kinked(np.arange(1, 3) * mm), 17 * mm).k1)
    # touching is read from two states past it
    U = np.array([11, 11.5, 12.2, 12.4, 13]) * mm
    assert touching(*kinked(U)) == pytest.approx((12 * mm, 7.2, 750), rel=1e-12)
    assert np.isnan(touching(*kinked(U[:2]))).all()
    assert np.isnan(touching(*kinked(U[:3]))).all(), "one state gives no slope"


def test_curves_are_compared_in_the_states_that_both_have():
    fine, coarse = kinked(np.arange(1, 18) * mm), kinked(np.arange(2, 24, 2) * mm * (1 + 1e-12))
    one, other = on_common(fine, coarse, 17 * mm)
    assert one[0] == pytest.approx(np.arange(2, 17, 2) * mm)
    assert other == pytest.approx(one, rel=1e-9, abs=1e-9)
    assert fitted(one, 17 * mm).apart(fitted(other, 17 * mm)) < 1e-9


def test_forces_that_are_not_retraced_are_found():
    U = np.array([1, 2, 3, 2, 1]) * mm
    assert retraced(U, 600 * U) < 1e-14
    assert retraced(U, np.where(np.arange(5) > 2, 1.01, 1.0) * U) == pytest.approx(0.01)
