"""Case spring-width: what shells say of widths and of loads on the head's edge."""

from dataclasses import replace

import pytest

from tests.verify.cases.rows import context, failed
from verify.cases.spring.width import claims
from verify.cases.spring.width.case import WIDTH, WideSpring
from verify.cases.spring.width.reference import ENDS, fem_spring
from verify.judging.judge import fit_limit


def test_a_uniform_force_on_a_free_head_is_a_little_softer_than_a_straight_edge():
    """The force bends the edge; of a short spring the most."""
    q = WideSpring(n=4)
    straight = fem_spring(q, q.h, 2, "arc", "free")
    force = fem_spring(q, q.h, 2, "arc", "free", uniform=True)
    assert force < straight
    assert force == pytest.approx(straight, rel=2e-4)


def test_what_a_wide_spring_lacks_of_plane_strain_is_as_wide_as_its_leaves():
    fit = fit_limit(*claims.wide(context(WIDTH)))
    assert abs(fit.q - 1) < fit.U_q < 0.1
    assert abs(fit.d0) < 1e-4


def test_no_row_fails_and_tables_hold_the_printed_stiffness_for_the_paper_s_spring_alone():
    of = context(WIDTH)
    assert not failed(WIDTH, of=of)
    readings, widths = WIDTH.tables(of)
    assert [row[:2] for row in readings.rows] == list(ENDS)
    assert readings.rows[2][-2:] == ("+0.1 %", "+0.6 %")
    assert len(widths.rows) == 15
    plain, _ = WIDTH.tables(replace(of, is_paper=False))
    assert len(plain.header) == len(plain.rows[0]) == len(readings.header) - 2
    assert not WIDTH.tables(replace(of, fem=[]))
