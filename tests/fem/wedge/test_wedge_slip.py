"""Sectors of a sprag clutch and of a freewheel: statics, rings, friction, and slip."""

import math
from functools import cache
from math import cos, hypot, pi, radians, sin, tan

import numpy as np
import pytest

from fem.contact.errors import NotFoundError
from fem.wedge import drive as slip
from fem.wedge import slip_limit
from fem.wedge.drive import Drive, Driven
from fem.wedge.flat_start import COARSE
from fem.wedge.pulled import at_torque
from fem.wedge.slip_limit import Limit
from meshes.sprag.wedged import first_contact
from verify.cases.freewheel.paths.case import LoadPaths
from verify.cases.freewheel.pulled_sector import one_pulled
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.stroke import at_force, guessed, races

Q = WedgeInputs()
P = 3407 / Q.l  # [N/m] of a sprag under 25 N m


@pytest.fixture(scope="module")
def start():
    return at_force(Q, P)


@pytest.fixture(scope="module")
def state(start):
    return start.state(6)


@pytest.fixture(scope="module")
def around(state):
    """Below, at and above the load of 25 N m."""
    return at_force(Q, 0.9 * P).state(6), state, at_force(Q, 1.1 * P).state(6)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: first_contact(Q.R_i, Q.R_e, Q.r_i, 1.4),
         r"no spiral between the races has the wedge angle nu_0 = 1.4 rad"),
        (lambda: guessed(Q, 0.0), "does not touch both races"),  # not turned
        (lambda: at_force(Q, 10 * P), "flank"),  # turned off its profile
    ],
)  # fmt: skip
def test_what_no_sprag_can_carry_is_refused_in_one_line(make, words):
    with pytest.raises(ValueError, match=words) as refused:
        make()
    assert "\n" not in str(refused.value)


def test_forces_and_moments_of_both_contacts_balance(state):
    inner, outer = (np.array(touch.force) for touch in state.solution.touches)
    np.testing.assert_allclose(inner, -outer, rtol=0, atol=1e-10 * hypot(*inner))
    nu, omega = state.angles
    assert state.N[1] / state.N[0] == pytest.approx(cos(omega) / cos(nu), rel=1e-12)
    assert state.N[0] == pytest.approx(P, rel=3e-3)
    q, place = Q, state.start
    assert state.torque == pytest.approx(q.z * place.OA * state.T[0], rel=1e-9)
    assert state.held == pytest.approx(q.z * place.OB * state.T[1], rel=1e-9)
    assert state.held == pytest.approx(state.torque, rel=2e-4)
    # the force runs along the line between the centres of pressure
    (OA, a), (OB, b) = state.acts_at
    assert tan(nu) == pytest.approx(OB * sin(a - b) / (OB * cos(a - b) - OA), rel=3e-4)


def test_races_breathe_as_rings_under_the_smeared_load(state):
    for u, r, other, N in zip(state.race_mean, (Q.R_i, Q.R_e), (Q.R_id, Q.R_ed), state.N,
                              strict=True):  # fmt: skip
        p = N * Q.z / (2 * pi * r)
        # Lame in plane strain, pressed from outside at R_i, from inside at R_e
        core = p * r / (Q.E * (r**2 - other**2)) * (1 + Q.nu)
        expected = -core * ((1 - 2 * Q.nu) * r**2 + other**2)
        assert u == pytest.approx(expected, rel=3e-4)


def test_the_energy_is_the_work_on_the_overlaps_and_on_the_wind_up(around):
    overlaps = np.array([s.start.overlaps for s in around])
    N, T, drags = (np.array([getattr(s, name) for s in around]) for name in ("N", "T", "drags"))
    work = np.trapezoid(N, overlaps, axis=0).sum()
    work += np.trapezoid(T, drags * [1, -1], axis=0).sum()
    assert around[-1].energy - around[0].energy == pytest.approx(work, rel=1e-3)


@pytest.mark.parametrize(("share", "holds"), [(1.01, True), (0.99, False)])
def test_friction_above_the_tangent_holds_the_sprag_and_below_it_slides_out(
    start, state, share, holds
):
    mu = share * tan(state.angles[0])
    if holds:
        assert start.state(6, mu=mu).torque == pytest.approx(state.torque, rel=1e-3)
    else:
        with pytest.raises(NotFoundError, match="every node of a contact slips"):
            start.state(6, mu=mu)


@pytest.mark.parametrize(
    ("changed", "T"),
    [
        ({"nu_0": radians(6)}, 48),
        ({"R_id": 1.5e-3, "R_i": 2.2e-3, "R_e": 3.9e-3, "R_ed": 5e-3, "r_i": 0.8e-3, "b": 0.8e-3,
          "l": 2e-3, "z": 10}, 0.25),
    ],
)  # fmt: skip
def test_odd_clutches_come_to_rest(changed, T):
    q = Q.model_copy(update=changed)
    state = at_force(q, T / (q.z * q.R_i * tan(q.nu_0) * q.l)).state(4)
    assert state.torque * q.l == pytest.approx(T, rel=0.02)
    assert tan(state.angles[0]) == pytest.approx(tan(state.start.strut[0]), rel=0.01)


def test_the_inner_contact_is_narrower_and_pressed_harder(state):
    assert state.widths[0] < state.widths[1]
    assert state.peaks[0] > state.peaks[1]
    for i, bends in enumerate((1 / Q.r_i + 1 / Q.R_i, 1 / races(Q).sprag.r_e - 1 / Q.R_e)):
        a = (8 * state.N[i] * (1 - Q.nu**2) / (pi * Q.E * bends)) ** 0.5  # Hertz
        assert state.widths[i] == pytest.approx(a, rel=0.01)
        assert state.peaks[i] == pytest.approx(2 * state.N[i] / (pi * a), rel=0.01)


@cache
def wedged():
    return at_torque(one_pulled(LoadPaths()), COARSE)


@cache
def drive():
    return Drive.at(one_pulled(LoadPaths()), wedged(), COARSE)


def bound(mu=0.08):
    return Limit(one_pulled(LoadPaths(mu=mu, F_ax=600.0)), wedged(), wedged().drags)


def test_the_limit_is_what_the_cone_leaves_for_the_axis(monkeypatch):
    """All of mu N, at the angle of the mesh, which micro-slip changes by next to nothing."""
    lever, doubt = drive().lever(drive().along((0.95,)))
    law = math.sqrt((0.08 / math.tan(drive().rest.start.psi / 2)) ** 2 - 1)
    assert lever == pytest.approx(law, rel=2e-3)
    assert 0 < doubt < 3e-3 * law
    monkeypatch.setattr(slip, "MOST", 2)
    with pytest.raises(NotFoundError, match="no slip was found: after 2 steps"):
        drive().lever(Driven(drive().rest, 0.0))


def test_a_path_ends_at_its_last_load_and_short_of_slip():
    at = drive().along((0.5, -0.4))
    assert at.force / drive().unit == pytest.approx(-0.4, abs=slip.MET)
    assert drive().left(at) == math.inf  # of a force along the motion of the rim
    back = drive().along((0.4,))
    assert drive().left(back) > 1


def not_found(*_a, **_k):
    raise NotFoundError("no state of rest was found")


def test_a_solve_that_finds_nothing_is_no_slip(monkeypatch):
    drive()
    monkeypatch.setattr(slip, "creeping", not_found)
    for ask in (lambda: bound().bears(0.08), bound().of_load, lambda: drive().along((0.3,)),
                lambda: drive().together(0.9)):  # fmt: skip
        with pytest.raises(NotFoundError, match="no state of rest"):
            ask()


def test_a_load_is_borne_below_its_limit_and_nothing_is_decided_within_its_uncertainty(monkeypatch):
    for off, held in ((-0.01, False), (0.01, True)):
        lever = lambda self, _mu, off=off: ((1 + off) * self.asked, 1e-3)  # noqa: E731
        monkeypatch.setattr(Limit, "_lever", lever)
        assert bound().bears(0.08) is held
    monkeypatch.setattr(Limit, "_lever", lambda self, _mu: (self.asked + 1e-3, 2e-3))
    with pytest.raises(NotFoundError, match="cannot be decided"):
        bound().bears(0.08)
    # where every node slips under torque alone, none is transmitted, and no lever is needed
    monkeypatch.setattr(Limit, "sticks", lambda *_: False)
    monkeypatch.setattr(Limit, "_lever", not_found)
    assert not bound().bears(0.05)


def test_the_friction_of_a_load_is_that_of_eq_8_where_slip_is_the_cone_s(monkeypatch):
    def coulomb(self, mu):
        return math.sqrt((mu / self.tan) ** 2 - 1), 1e-6

    monkeypatch.setattr(slip_limit.Limit, "_lever", coulomb)
    value, half = bound().of_load()
    assert value == pytest.approx(1.0, abs=1e-12)
    assert 0 < half < 2e-6
