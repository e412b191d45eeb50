"""Rigid links between points of a frame against closed forms of beams that touch."""

import math

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.links import Link
from fem.beam.section import Section
from fem.beam.straight import solve_frame

L, EI = 2.0, 3.0
THIN = Section(EA=1e6, EI=EI)
ABOVE = [[0.0, 0.0], [L, 0.0], [0.0, 0.1], [L, 0.1]]  # two cantilevers, one over the other
PAIR = [[0, 1], [2, 3]]
CLAMPS = {0: "xyr", 2: "xyr"}
PUSH = {3: (0.0, -1.0, 0.0)}


def pressed(link, *, points=ABOVE, elements=PAIR, sections=THIN, loads=PUSH, **more):
    return solve_frame(
        points, elements, sections=sections, supports=CLAMPS, loads=loads, links=[link], **more
    )


def test_a_gap_is_closed_before_the_second_cantilever_bears():
    """The gap g leaves F - 3 EI g/L³ to share."""
    gap = 0.3 * L**3 / (3 * EI)
    solved = pressed(Link(first=3, second=1, direction=(0, -1), value=-gap))
    assert solved.link_forces == pytest.approx([(1 - 0.3) / 2], rel=1e-12)
    assert solved.u[1, 1] - solved.u[3, 1] == pytest.approx(gap, rel=1e-12)


@pytest.mark.parametrize("shares", [(0.25, 0.75), (0.75, 0.25)])
def test_an_element_may_be_linked_at_several_places(shares):
    """Whatever the order: the same as nodes there from the start."""
    links = [Link(first=(1, s), second=(0, s), direction=(0, 1)) for s in shares]
    cut = solve_frame(ABOVE, PAIR, sections=THIN, supports=CLAMPS, loads=PUSH, links=links)
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
        ({"second": (0, 1.5)}, r"a link's place on element 0 must lie in \[0, 1\], got 1.5"),
        ({"second": 3}, "a link needs two different points, got 3 twice"),
        ({"second": 1, "direction": (0, 0)}, r"direction \(x, y\) with a length, got \(0, 0\)"),
        ({"second": 1, "value": math.nan}, "relative displacement must be finite, got nan m"),
    ],
)
def test_impossible_links_are_named_in_one_line(more, message):
    with pytest.raises(ValueError, match=message):
        pressed(Link(**({"first": 3, "direction": (0, -1)} | more)))


LINK, TWICE = Link(first=3, second=1, direction=(0, -1)), "links repeat each other or join points"


@pytest.mark.parametrize(
    ("points", "elements", "supports", "loads", "links", "message"),
    [
        (ABOVE, PAIR, CLAMPS, PUSH, [LINK, LINK], TWICE),
        (ABOVE, PAIR, CLAMPS, PUSH, [Link(first=0, second=2, direction=(0, 1))], TWICE),
        # a hinge and a link through the hinge: the beam turns about it
        ([[0, 0], [L, 0], [L, 0.0], [L + 1, 0.0]], [[0, 1], [2, 3]], {0: "xyr", 3: "xy"},
         {2: (0, -1, 0)}, [Link(first=2, second=1, direction=(1, 0))],
         "can move rigidly in spite of its links"),
    ],
)  # fmt: skip
def test_links_that_hold_nothing_are_refused(points, elements, supports, loads, links, message):
    with pytest.raises(ValueError, match=message):
        solve_frame(points, elements, sections=THIN, supports=supports, loads=loads, links=links)


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

    # tip on tip of two cantilevers alike
    tips = bent(Link(first=17, second=8, direction=(0, -1)))
    assert tips.link_forces == pytest.approx([0.5], rel=1e-9)
    with pytest.raises(ValueError, match=r"linked at their nodes, got place \(0, 0.5\)"):
        bent(Link(first=17, second=(0, 0.5), direction=(0, 1)))
