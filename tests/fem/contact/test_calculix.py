"""Two discs in contact: the project's solver beside calculix, on the same mesh."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks import hertz
from benchmarks.calculix_contact import Settings, run_deck, write_deck
from verify.studies.crosscheck.calculix.numbering import Numbering
from verify.studies.crosscheck.calculix.running import executable

CELLS = (18, 15)
STIFF = Settings(slope=500, start=0.25)
COARSE = hertz.ZONE / CELLS[1] / hertz.A  # the longest cell in the contact [a]
# Hertz's pressure has the share 8 sqrt(2)/(3 pi) (h/a)^1.5 of its load within h of an edge; both
# sides know the edge to half a cell, and misplace that share by as much: load times distance over a
MISPLACED = 8 * np.sqrt(2) / (3 * np.pi) * COARSE**1.5 * COARSE / 2
pytestmark = pytest.mark.skipif(executable() is None, reason="calculix (ccx) is not installed")


def overlap(ask):
    """Penalty: the discs overlap by the pressure over the slope, at most so [m]."""
    return hertz.EXACT.p_0 / (ask.slope * hertz.STEEL.E / hertz.A)


@pytest.fixture(scope="module")
def ours():
    problem = hertz.pressed(hertz.discs(CELLS))
    return problem, hertz.solve_pressed(problem)


@pytest.fixture(scope="module")
def ask_calculix(ours, tmp_path_factory):
    problem, solution = ours

    def ask(how):
        deck = tmp_path_factory.mktemp("discs") / "discs.inp"
        write_deck(deck, solution, how)
        return run_deck(deck, problem, solution.plane, how)

    return ask


@pytest.fixture(scope="module")
def theirs(ask_calculix):
    return ask_calculix(STIFF)


def test_both_carry_the_load_on_equal_widths(ours, theirs):
    assert abs(hertz.own_errors(ours[1])["load"]) < 1e-9
    assert abs(theirs.errors["load"]) < 1e-6  # calculix prints seven digits
    # the penalty's overlap flattens the discs, whose gap is a^2/R where the contact ends
    widened = overlap(STIFF) / (hertz.A**2 / hertz.R)
    apart = theirs.errors["a"] - hertz.own_errors(ours[1])["a"]
    assert abs(apart) < widened + 2 * 3 * np.pi / 4 * MISPLACED


def test_both_discs_move_alike(ours, theirs):
    plane = ours[1].plane
    moved = plane.u[Numbering(plane.basis).dofs].T
    # a force P moved by d within the contact changes displacements by about 2 P d/(pi E' a)
    misplaced = 2 * hertz.LOAD / (np.pi * hertz.E_PLANE) * 2 * MISPLACED
    cells = 1e-4 * np.abs(moved).max()  # eight nodes there, nine here
    assert np.abs(theirs.u - moved).max() < overlap(STIFF) + misplaced + cells


def test_a_softer_penalty_yields_as_an_elastic_layer_does(theirs, ask_calculix):
    # a layer's energy int p^2/(2 slope) is 2/3 p_0^2 a/slope, as P^1.5; its slope over P is the
    # layer's share of the approach, 2/pi p_0/slope, up to the overlap over the gap a^2/R
    soft = replace(STIFF, slope=20)
    more = ask_calculix(soft).errors["approach"] - theirs.errors["approach"]
    layer = 2 / np.pi * (overlap(soft) - overlap(STIFF))
    second_order = overlap(soft) / (hertz.A**2 / hertz.R)
    assert more * 2 * hertz.EXACT.approach == pytest.approx(layer, rel=second_order)
