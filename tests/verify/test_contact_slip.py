"""Partial slip: what the case computes with, its inputs, and that every fault turns a row red."""

from dataclasses import replace
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

from analytic.contact import checks, hertz_line, partial_slip, tangential_cycle
from fem.contact import active_sets, bodies, interface, slip_course, solution
from fem.contact.friction_lcp import FrictionLcp
from fem.plane.material import Elastic
from verify.cases.contact.slip.case import SLIP, SlippingRollers
from verify.cases.contact.slip.claims import HALF_PLANES, neglected
from verify.core.case import Context
from verify.core.results import Kind, Status
from verify.jobs.level import Job, judge_case, solve_level

COARSE = replace(SLIP, levels=(16, 24, 32))
MPa, mm = 1e6, 1e-3

pytestmark = pytest.mark.xdist_group("contact-slip")


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case, q=None):
    q = q or case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


@cache
def red_without_fault():
    """Coarse meshes leave some rows without the sharpness they need: these prove nothing."""
    return frozenset(names(r for r in solve_anew(COARSE).rows if r.status is Status.FAIL))


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it."""

    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))

    return break_


# Inputs.
def test_the_default_is_a_contact_of_a_hundredth_of_the_radius():
    q = SlippingRollers()
    # a = sqrt(4 P (R/2) / (pi E*)), E* = 206 GPa / (2 * 0.91)
    assert q.a / mm == pytest.approx(np.sqrt(2 * 70 * 4.02 / (np.pi * 206e3 / 1.82)), rel=1e-12)
    assert q.a / q.R == pytest.approx(0.01, rel=0.02)
    assert neglected(q) < HALF_PLANES


def test_a_contact_wider_than_the_rollers_bear_is_refused_in_one_line():
    with pytest.raises(
        ValueError, match=r"a/R of at most 0.3, got a/R = 0\.3\d+ with P = 80000 N/mm"
    ):
        SlippingRollers(P=8e7)


def test_amplitudes_that_the_meshes_do_not_resolve_are_left_to_the_formulas():
    assert not SLIP.too_large(SlippingRollers(share=0.5)) + SLIP.too_large(
        SlippingRollers(share=0.9)
    )
    for share in (0.49, 0.91):
        assert "check it without --fem" in SLIP.too_large(SlippingRollers(share=share))
        assert SlippingRollers(share=share).W > 0


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"P": 1.5e6}, "no half planes"),
        ({"hardness": 1000 * MPa}, "exceeds p_lim = 1000 MPa"),
        ({"P": 1.5e6, "hardness": None}, "give p_lim"),
        ({"mu": 0.6}, "friction this high"),
    ],
)
def test_inputs_beyond_the_range_of_the_formulas_are_warned_of(change, word):
    q = SlippingRollers(**change)
    assert word in " ".join(SLIP.warnings(q, SLIP.analytic(q)))
    assert not SLIP.warnings(SlippingRollers(), SLIP.analytic(SlippingRollers()))


# Judging.
def test_no_row_is_red_on_the_paper_s_inputs(judged, red):
    assert not red(judged(SLIP))


@pytest.mark.parametrize(("a_over_R", "status"), [(0.03, "interval"), (0.15, "measured")])
def test_wide_contacts_are_judged_as_approximations(a_over_R, status):
    q = SlippingRollers(P=SlippingRollers().P * (a_over_R / 0.0099) ** 2)
    (check,) = [c for c in SLIP.checks if c.name == "cycle: energy lost, work of friction"]
    exact = q.W * (1 + 1.3 * a_over_R**2)  # what discs were found to lose
    fem = [SimpleNamespace(h=h, values={"work": exact}, u_it={}) for h in (1.0, 0.5, 0.25)]
    row, _ = check.rows(Context("contact-slip", q, SLIP.analytic(q), fem, is_paper=False))
    assert row.kind is Kind.APPROXIMATION
    assert (row.interval is not None) == (status == "interval")
    assert row.status is (Status.PASS if status == "interval" else Status.SHOWN)


# Readings, and faults of the formulas: finite elements come from the cache.
READINGS = [
    pytest.param(hertz_line, "relative_radius",
                 lambda f: lambda *, R_1, R_2: f(R_1=R_1 / 2, R_2=R_2 / 2),
                 "stick half-width at Q_max", id="R is a diameter"),
    pytest.param(hertz_line, "relative_radius", lambda _: lambda *, R_1, R_2: np.asarray(R_1),
                 "stick half-width at Q_max", id="one roller on a flat"),
    pytest.param(hertz_line, "contact_modulus", lambda f: lambda **k: 2 * f(**k),
                 "cycle: energy lost, work of friction", id="one body rigid"),
    pytest.param(hertz_line, "contact_modulus",
                 lambda f: lambda **k: f(**k | {"assumption": "plane stress"}),
                 "cycle: energy lost, work of friction", id="plane stress"),
    pytest.param(checks, "in_plane", lambda _: lambda E, nu, _a: (np.asarray(E), np.asarray(nu)),
                 "stick half-width at Q_max", id="1 - nu² dropped"),
    pytest.param(partial_slip, "_share", lambda f: lambda Q, P, mu: f(Q, P, mu) * 0.99,
                 "stick half-width, Q/(μP) = 0.8", id="Q a per cent smaller"),
    pytest.param(partial_slip, "stick_half_width",
                 lambda _: lambda *, Q, P, mu, a: np.asarray(a * (1 - Q / (mu * P))),
                 "traction within 3 % in L2, Q/(μP) = 0.4", id="c/a = 1 - Q/(μP)"),
    pytest.param(partial_slip, "traction",
                 lambda f: lambda x, *, Q, P, mu, a: Q * hertz_line.pressure(x, a=a, p_0=2 / (
                     np.pi * a)), "traction within 3 % in L2, Q/(μP) = 0.6",
                 id="q shaped like the pressure"),
    pytest.param(partial_slip, "rigid_displacement_beyond_stick", lambda f: lambda **k: 1.01 * f(
        **k), "cycle: displacement left at Q = 0", id="slip a per cent larger"),
    pytest.param(tangential_cycle, "traction",
                 lambda f: lambda x, *, branch, **k: f(x, branch="reloading", **k),
                 "cycle: traction within 3 % in L2, Q/Q_max = 0", id="branches exchanged"),
    pytest.param(tangential_cycle, "dissipation", lambda f: lambda **k: f(**k) / 2,
                 "cycle: energy lost, area of the loop", id="half a cycle"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), READINGS)
def test_another_reading_or_a_wrong_formula_turns_a_row_red(
    owner, name, fault, row, broken, judged, red
):
    right = judged(SLIP)
    broken(owner, name, fault)
    assert row in names(red(judged(SLIP))) - names(red(right))


# Faults of the finite elements: solved anew.
def rough(factor):
    def fault(right):
        return lambda **k: right(**k | {"friction": factor * k["friction"]})

    return fault


FEM_FAULTS = [
    pytest.param(Elastic, "lame_constants", lambda f: lambda self, _: f(self, "plane stress"),
                 "stick half-width, Q/(μP) = 0.6", id="plane stress for plane strain"),
    pytest.param(bodies, "vector_basis", lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k),
                 "stick half-width at Q_max", id="linear elements"),
    pytest.param(interface, "Complementarity", rough(1.02),
                 "stick half-width, Q/(μP) = 0.8", id="friction 2 % too large"),
    pytest.param(solution.ContactSolution, "slips", lambda _: property(lambda self: 0 * self.w[
        self.interface.gaps.size:]), "cycle: both energies agree within 0.1 %",
                 id="slip of earlier steps forgotten"),
    pytest.param(slip_course, "stick_share", lambda f: lambda touch: f(touch) + 0.004,
                 "stick half-width, Q/(μP) = 0.8", id="moments read wrongly"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, broken, red):
    before = red_without_fault()
    broken(owner, name, fault)
    assert row in names(red(solve_anew(COARSE))) - before


def test_friction_that_drives_finds_no_equilibrium(broken):
    broken(active_sets, "SIGN", lambda right: -right)
    broken(FrictionLcp, "candidates", lambda _: lambda _self: iter(()))
    assert "no state of rest was found" in solve_level(SLIP, SLIP.inputs(), 4, None).failure


@pytest.mark.soak  # finite elements solved anew, for the faults above
def test_few_rows_are_red_on_the_coarser_levels():
    # strips of slip are too narrow for them
    assert all("L2" in name or "energy lost" in name for name in red_without_fault())
