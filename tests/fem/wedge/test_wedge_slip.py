"""The axial load at which a freewheel slips, read from solved states; nothing from failed ones."""

import math
from functools import cache

import pytest

from fem.contact.errors import NotFoundError
from fem.wedge import drive as slip
from fem.wedge import slip_limit
from fem.wedge.drive import Drive, Driven
from fem.wedge.flat_start import COARSE
from fem.wedge.pulled import at_torque
from fem.wedge.slip_limit import Limit
from verify.cases.freewheel.paths.case import LoadPaths
from verify.cases.freewheel.pulled_sector import one_pulled


@cache
def start():
    return at_torque(one_pulled(LoadPaths()), COARSE)


@cache
def drive():
    return Drive.at(one_pulled(LoadPaths()), start(), COARSE)


def bound(mu=0.08):
    return Limit(one_pulled(LoadPaths(mu=mu, F_ax=600.0)), start(), start().drags)


def test_the_limit_is_what_the_cone_leaves_for_the_axis(monkeypatch):
    """All of mu N, at the angle of the mesh, which micro-slip changes by next to nothing."""
    lever, doubt = drive().lever(drive().along((0.95,)))
    law = math.sqrt((0.08 / math.tan(drive().rest.start.psi / 2)) ** 2 - 1)
    assert lever == pytest.approx(law, rel=2e-3)
    assert 0 < doubt < 3e-3 * law
    monkeypatch.setattr(slip, "MOST", 2)
    with pytest.raises(NotFoundError, match="no slip was found: 2 steps"):
        drive().lever(Driven(drive().rest, 0.0))


def test_a_path_ends_at_its_last_load_and_short_of_slip():
    at = drive().along((0.5, -0.4))
    assert at.force / drive().unit == pytest.approx(-0.4, abs=slip.MET)
    assert drive().left(at) == math.inf  # of a force along the rim's way
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
    with pytest.raises(NotFoundError, match="not decided"):
        bound().bears(0.08)
    # where every node slips under torque alone, none is borne, and its lever is not asked for
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
