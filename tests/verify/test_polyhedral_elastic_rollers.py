"""Elastic rollers of the locked ring: faults on either side turn their rows red."""

from dataclasses import replace

import pytest

from analytic.polyhedral import locking
from analytic.polyhedral.locking import RollerContact
from fem.contact import locked
from verify.cases.polyhedral.locking.case import LOCKING
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("polyhedral-locking")

FORCE = "force of an elastic roller under pressure, series"
SHARE = "share of further pressure that reaches elastic rollers, series"
ON_RING = "half-width of an elastic roller's contact on the ring, Hertz"
ON_RACE = "half-width of an elastic roller's contact on the race, Hertz"
BALANCE = "forces on an elastic roller"
ROWS = {FORCE, SHARE, ON_RING, ON_RACE, BALANCE}
COARSE = replace(
    LOCKING, levels=LOCKING.levels[:3], figures=lambda _: (),
    checks=tuple(check for check in LOCKING.checks if check.name in ROWS),
)  # fmt: skip


def names(rows):
    return {row.quantity for row in rows}


def solve_anew():
    q = COARSE.inputs()
    return judge_case(Job(COARSE, q), [solve_level(COARSE, q, n, None) for n in COARSE.levels])


FAULTS = [
    pytest.param(locking, "approach_to_centre", lambda f: lambda **k: f(**k)[:1], {FORCE, SHARE},
                 id="a roller that is rigid towards the race"),
    pytest.param(RollerContact, "_roller_modulus",
                 lambda f: property(lambda self: f.fget(self) / (1 - self.roller.nu**2)),
                 {FORCE, SHARE, ON_RACE}, id="plane strain of the roller"),
    pytest.param(RollerContact, "half_width_on_race",
                 lambda f: lambda self, N: self.half_width(N), {ON_RACE},
                 id="the ring's half-width on the race"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "rows"), FAULTS)
def test_a_wrong_series_turns_the_rows_of_elastic_rollers_red(
    owner, name, fault, rows, monkeypatch, judged, red
):
    judged(LOCKING)
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    found = names(red(judged(replace(LOCKING, figures=lambda _: ()))))
    assert rows <= found <= ROWS


def convex(right):
    """Circles of which hollow ones bulge towards what they held."""

    def circle(centre, radius, hollow=False):
        x, y = centre
        return right((x + 2 * radius, y), radius) if hollow else right(centre, radius)

    return circle


def plane_strain(right):
    return lambda mesh, **k: right(mesh, **k | {"assumption": "plane strain"})


FEM_FAULTS = [
    pytest.param(locked, "Circle", convex, {ON_RACE}, id="a convex race"),
    pytest.param(locked, "ContactProblem", plane_strain, {FORCE}, id="plane strain of both"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "rows"), FEM_FAULTS)
def test_wrong_finite_elements_turn_the_rows_of_elastic_rollers_red(
    owner, name, fault, rows, monkeypatch, red
):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert rows <= names(red(solve_anew()))


@pytest.mark.soak  # finite elements solved anew, for the faults above
def test_three_levels_turn_no_row_of_elastic_rollers_red(red):
    assert not red(solve_anew())
