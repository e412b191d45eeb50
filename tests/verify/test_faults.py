"""Deliberate faults: each turns at least one row red, or the suite proves nothing."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.ring import lame
from analytic.spring import energy, frame
from fem.beam import curved, straight
from fem.plane import loads, solution, solve, traces
from fem.plane.material import Elastic
from meshes.ring import quarter
from verify.cases.ring.lame.case import LAME
from verify.cases.spring.accordion.case import ACCORDION
from verify.cases.spring.continuum.case import CONTINUUM
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level
from verify.judging import claims, convergence

# Coarser levels where the finite elements themselves are broken and must be solved anew.
STRIP = replace(CONTINUUM, levels=(2, 4, 8))


def solve_anew(case):
    """A case on its paper's inputs without any cache."""
    q = case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


@pytest.fixture
def broken(monkeypatch):
    """Replace an attribute by what `fault` makes of it."""

    def break_(owner, name, fault):
        right = getattr(owner, name)
        monkeypatch.setattr(owner, name, fault(right))

    return break_


# Faults of the formulas: finite elements come from the cache.
FORMULA_FAULTS = [
    pytest.param(LAME, lame, "_constants", lambda f: lambda *a: (f(*a)[0], 1.01 * f(*a)[1]),
                 id="Lamé: B a per cent too large"),
    pytest.param(LAME, lame, "_constants", lambda f: lambda *a: (f(*a)[0], -f(*a)[1]),
                 id="Lamé: sign of B"),
    pytest.param(LAME, lame, "_constants",
                 lambda f: lambda r_i, r_o, p_i, p_o: f(r_i, r_o, p_i, -np.asarray(p_o)),
                 id="Lamé: sign of the outer pressure"),
    pytest.param(LAME, lame, "stresses", lambda f: lambda *a, **k: f(*a, **k)[::-1],
                 id="Lamé: radial and hoop stress swapped"),
    pytest.param(LAME, lame, "_axial_factor", lambda _: lambda _nu, _ends: 0.0,
                 id="Lamé: plane stress for plane strain"),
    pytest.param(LAME, lame, "_axial_factor",
                 lambda f: lambda nu, ends: f(nu, ends) / 2, id="Lamé: 2 nu read as nu"),
    pytest.param(ACCORDION, energy, "_sign", lambda f: lambda i: -f(i),
                 id="spring: all signs the other way"),
    pytest.param(ACCORDION, energy, "head_flexibility", lambda f: lambda **k: f(**k) * 1.02,
                 id="spring: head 2 % too soft"),
    pytest.param(ACCORDION, energy, "_EI", lambda f: lambda E, h, b: f(E, h, b) / (1 - 0.3**2),
                 id="spring: wide strip for a narrow one"),
    pytest.param(ACCORDION, frame, "SHEAR", lambda _: 1.0, id="frame: shear factor 1"),
    pytest.param(ACCORDION, frame, "stiffness",
                 lambda f: lambda **k: f(**k | {"radius": k["radius"] - 0.05e-3}),
                 id="frame: inner radius for the centre line"),
    pytest.param(CONTINUUM, frame, "stiffness",
                 lambda f: lambda **k: f(**k | {"plane_strain": False}),
                 id="frame: 1 - nu^2 dropped"),
    pytest.param(CONTINUUM, frame, "_curved_bar",
                 lambda f: lambda *a: (f(*a)[0], -f(*a)[1], f(*a)[2]),
                 id="frame: sign of the curved bar's coupling"),
]  # fmt: skip


@pytest.mark.parametrize(("case", "owner", "name", "fault"), FORMULA_FAULTS)
def test_a_wrong_formula_turns_a_row_red(case, owner, name, fault, broken, judged, red):
    assert not red(judged(case))
    broken(owner, name, fault)
    assert red(judged(case))


# Faults of the finite elements: solved anew.
FEM_FAULTS = [
    pytest.param(LAME, Elastic, "lame_constants",
                 lambda f: lambda self, _: f(self, "plane stress"),
                 id="plane: plane stress for plane strain"),
    pytest.param(LAME, solve, "vector_basis",
                 lambda f: lambda mesh, _degree, **_: f(mesh, 1), id="plane: linear elements"),
    pytest.param(LAME, quarter, "plane_mesh",
                 lambda f: lambda **_: f(straight=True), id="mesh: straight edges"),
    pytest.param(LAME, solution.Samples, "polar",
                 lambda f: lambda self: tuple(np.roll(np.array(f(self)), 1, axis=0)),
                 id="plane: stresses swapped"),
    pytest.param(LAME, loads, "push", lambda f: lambda *a: -f(*a), id="plane: pressure pulls"),
    pytest.param(LAME, traces, "_places", lambda f: lambda *a: 1 - f(*a),
                 id="plane: boundary points at the wrong end"),
    pytest.param(ACCORDION, straight, "_deformation",
                 lambda f: lambda *a: (f(*a)[0], 1.0025 * f(*a)[1]),
                 id="beam: bending stiffness half a per cent too large"),
    pytest.param(ACCORDION, curved, "_strains",
                 lambda f: lambda d, phi, t: f(d, 1.01 * phi, t), id="beam: shear strain"),
    pytest.param(STRIP, Elastic, "lame_constants",
                 lambda f: lambda self, _: f(self, "plane stress"),
                 id="strip: plane stress for plane strain"),
]  # fmt: skip


@cache
def red_without_fault(case):
    return {row.id for row in solve_anew(case).rows if row.status is Status.FAIL}


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("case", "owner", "name", "fault"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(case, owner, name, fault, broken, red):
    before = red_without_fault(case)
    broken(owner, name, fault)
    assert {row.id for row in red(solve_anew(case))} - before


@pytest.mark.soak  # solves three cases anew, for the faults above
def test_no_row_is_red_without_a_fault():
    assert not red_without_fault(LAME) | red_without_fault(ACCORDION) | red_without_fault(STRIP)


# Faults of the judging itself.
@pytest.mark.parametrize(
    "factor",
    [
        pytest.param(0.7, id="r^p in place of r^p - 1 at order 2"),
        pytest.param(0.1, id="a tenth of the safety factor"),
        pytest.param(1e3, id="a thousand times the safety factor"),
    ],
)
def test_a_wrong_gci_factor_turns_a_row_red(factor, broken, judged, red):
    def fault(right):
        def wrong(*args, **more):
            grid = right(*args, **more)
            return replace(grid, gci=grid.gci * factor)

        return wrong

    broken(claims, "grid_convergence", fault)
    assert red(judged(LAME)) + red(judged(ACCORDION))


def test_a_series_that_moves_away_turns_its_row_red(broken, judged, red):
    def fault(right):
        def wrong(h, values, **more):
            return right(h, values[::-1], **more)

        return wrong

    broken(claims, "grid_convergence", fault)
    assert "does not converge" in {row.reason for row in red(judged(LAME))}


def test_the_order_of_convergence_is_not_taken_for_granted(broken, judged, red):
    broken(convergence, "observed_order", lambda _: lambda *_a: 0.4)
    assert red(judged(LAME))
