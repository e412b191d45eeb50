"""Case spring-width: statements about widths and ends fail where shells say otherwise."""

from dataclasses import replace
from functools import cache

import pytest

from verify.cases.spring.width import claims
from verify.cases.spring.width.case import WIDTH, WideSpring
from verify.cases.spring.width.reference import ENDS, fem_spring
from verify.core.case import Context
from verify.core.results import Status
from verify.judging.judge import fit_limit

WIDE = "a wide spring is in plane strain but for edges as wide as leaves are long"
TAKEN = "the factor that case spring-curve takes"
MEETS = "k_1 of the shell, head free, tail held at mid-leaf, beside the paper's"
ONE_LEAF = "one leaf's factor within"


@pytest.fixture
def levels():
    """Of the paper's inputs, from the store."""
    from tests.conftest import solved

    return [level.result for level in solved(WIDTH, WideSpring())]


@cache
def formulas():
    return WIDTH.analytic(WideSpring())


def context(levels):
    return Context(WIDTH.id, WideSpring(), formulas(), levels, True)


def status(name, levels):
    (check,) = (c for c in WIDTH.checks if c.name == name)
    return check.rows(context(levels))[0].status


def with_values(levels, **changed):
    return [
        replace(r, values={k: changed[k](v) if k in changed else v for k, v in r.values.items()})
        for r in levels
    ]


def with_arrays(levels, **changed):
    return [
        replace(r, arrays={k: changed[k](v) if k in changed else v for k, v in r.arrays.items()})
        for r in levels
    ]


VALUES = [
    # edges held by mistake: the factor is that of plane strain, 0.3 % more
    pytest.param("f", lambda _: 1.0989, TAKEN, id="edges held"),
    pytest.param("f", lambda _: 1.0989, f"{ONE_LEAF} 0.1 % of the spring's", id="of one leaf"),
    pytest.param("solid_100", lambda v: 1.0025 * v,
                 "loop as a shell and as solids, 100 times as wide as thick", id="solids"),
]  # fmt: skip
ARRAYS = [
    pytest.param("ends", lambda f: f * [1, 1, 1.02, 1], MEETS, id="other ends"),
    pytest.param("ends", lambda f: f * [1, 1, 1.001, 1],
                 "the factor is the same however the ends are held", id="a thousandth by ends"),
    pytest.param("uniform", lambda f: f * [1, 1.0001],
                 "the factor is the same for a head under a uniform force", id="uniform force"),
    pytest.param("sweep_wide", lambda s: s * [1, 1.001], WIDE, id="a thousandth at wide springs"),
    pytest.param("sweep_wide", lambda s: s * [2, 1.01],
                 "a spring 90 times as wide as its leaves within 0.5 % of plane strain", id="wide"),
    pytest.param("sweep_narrow", lambda s: s * [1, 1.001], "a narrow spring is in plane stress",
                 id="a thousandth at narrow springs"),
    pytest.param("sweep_narrow", lambda s: s * [1, 1.01],
                 "the narrowest spring within 0.5 % of plane stress", id="narrow"),
    pytest.param("sweep_medium", lambda s: s * [2, 1], f"{ONE_LEAF} 0.5 % of the spring's over all "
                 "widths", id="half the width"),
]  # fmt: skip


@pytest.mark.parametrize(("key", "fault", "row"), VALUES + ARRAYS)
def test_a_wrong_result_of_shells_fails(key, fault, row, levels):
    change = with_values if key in levels[0].values else with_arrays
    assert status(row, levels) is not Status.FAIL
    assert status(row, change(levels, **{key: fault})) is Status.FAIL


def test_a_uniform_force_on_a_free_head_is_a_little_softer_than_a_straight_edge():
    """The force bends the edge; of a short spring the most."""
    q = WideSpring(n=4)
    straight = fem_spring(q, q.h, 2, "arc", "free")
    force = fem_spring(q, q.h, 2, "arc", "free", uniform=True)
    assert force < straight
    assert force == pytest.approx(straight, rel=2e-4)


def test_what_a_wide_spring_lacks_of_plane_strain_is_as_wide_as_its_leaves(levels):
    fit = fit_limit(*claims.wide(context(levels)))
    assert abs(fit.q - 1) < fit.U_q < 0.1
    assert abs(fit.d0) < 1e-4


def test_tables_hold_the_printed_stiffness_for_the_paper_s_spring_alone(levels):
    readings, widths = WIDTH.tables(context(levels))
    assert [row[:2] for row in readings.rows] == list(ENDS)
    assert readings.rows[2][-2:] == ("+0.1 %", "+0.6 %")
    assert len(widths.rows) == 15
    plain, _ = WIDTH.tables(replace(context(levels), is_paper=False))
    assert len(plain.header) == len(plain.rows[0]) == len(readings.header) - 2
    assert not WIDTH.tables(context([]))
