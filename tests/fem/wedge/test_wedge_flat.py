"""A roller between flat and race: its position, and the evaluation of load paths and contacts."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.errors import NotFoundError
from fem.wedge.flat import Sector
from fem.wedge.flat_balance import balance, over_hertz
from fem.wedge.flat_course import FlatCourse
from fem.wedge.flat_place import Names, Pitch, Place
from fem.wedge.flat_start import (
    Start,
    after,
    guessed_inside,
    loaded,
    overlap,
    rigid_force,
)

NAMES = Names(*("cam", "race", "flat", "bore", "cam held", "race held"))


def pitch(sense):
    size = {"race": 16.5e-3, "flat": 11.39565e-3, "r": 2.5e-3}
    if sense < 0:
        size = {"race": 10e-3, "flat": 13.910554e-3, "r": 2e-3}
    return Pitch(sense=sense, r_b=4e-3, R_a=30e-3, z=8, E=206e9, nu=0.3, names=NAMES, mesh=None,
                 **size)  # fmt: skip


@pytest.mark.parametrize("sense", [1, -1])
def test_without_overlap_a_roller_lies_at_the_rigid_angle_and_load_moves_it(sense):
    q = pitch(sense)
    rest = Place.overlapping(q, 0.0, 0.0)
    assert rest.psi == pytest.approx(q.rigid_angle, rel=1e-12)
    loaded = Place.overlapping(q, 6e-6, 14e-6)
    assert loaded.to_race == pytest.approx(14e-6 if sense > 0 else 6e-6, abs=1e-15)
    assert sense * (loaded.psi - rest.psi) > 0
    assert float(q.arc(np.array(loaded.psi), np.array(loaded.to_race))) > 0


class Rolled(FlatCourse):
    """States of rigid statics: forces in balance at every angle, energy that of rolling."""

    def __init__(self, sense):
        self.q = q = pitch(sense)
        d = np.geomspace(1e-6, 12e-6, 9)
        places = [Place.overlapping(q, one, 2 * one) for one in d]
        self.psi = np.array([place.psi for place in places])
        N = 1e9 * d**1.1
        F_t = N * np.tan(self.psi / 2)
        T = q.z * q.race * F_t
        self.at_states = {"T": T, "N": N, "N race": N, "F_t": F_t, "F_t race": F_t, "d_i": d,
                          "d_o": 2 * d, "U": 3 * q.z * 1e9 * d**2.1 / 2.1}  # fmt: skip
        touches = [SimpleNamespace(force=(3.0, 4.0)), SimpleNamespace(force=(-3.0, -4.0))]
        self.last = SimpleNamespace(solution=SimpleNamespace(touches=touches))


@pytest.mark.parametrize("sense", [1, -1])
def test_prescribed_drags_rotate_the_held_boundaries(sense):
    """The angle is the drag over the radius; its sense is into the wedge."""
    sector, q = Sector.__new__(Sector), pitch(sense)
    sector.place = SimpleNamespace(q=q)
    sector.problem = SimpleNamespace(solve=lambda displacements: displacements)
    moved = sector.at((1e-6, 3e-6)).solution
    cam, race = (1e-6, 3e-6) if sense > 0 else (3e-6, 1e-6)
    assert moved["race held"] == {"r": pytest.approx(-sense * race / q.race)}
    angle = cam / q.flat
    if sense > 0:
        x = np.array([0.3, 0.4])
        found = [moved["cam held"][name](x) for name in ("x", "y")]
        assert found == pytest.approx([0.4 * angle, -0.3 * angle])
    else:
        assert moved["cam held"] == {"r": pytest.approx(angle)}


def test_states_in_balance_leave_nothing():
    course = Rolled(1)
    found = balance(course, float(np.sqrt(course.at_states["T"][3] * course.at_states["T"][4])))
    for name, left in found.items():
        assert left == pytest.approx(0.0, abs=2e-3 if name == "torque_cam" else 2e-4), name
    course.at_states["F_t"] = 1.1 * course.at_states["F_t"]
    assert balance(course, course.at_states["T"][4])["share_flat"] == pytest.approx(0.1, abs=1e-3)


@pytest.mark.parametrize("sense", [1, -1])
def test_the_force_at_an_angle_is_that_of_the_state_there(sense):
    course = Rolled(sense)
    for psi, N in zip(course.psi[1:-1], course.at_states["N"][1:-1], strict=True):
        assert course.force_at_angle(psi) == pytest.approx(N, rel=1e-9)
    with pytest.raises(ArithmeticError, match="outside the range of the states"):
        course.force_at_angle(course.psi[-1] + 0.1 * sense)


def test_the_pressure_of_hertz_is_a_semi_ellipse_of_height_one():
    """With points in any order, and the half-width by the moments."""
    x = np.random.default_rng(1).permutation(np.linspace(-1, 1, 4001)) * 2e-4
    p = 3e9 * np.sqrt(1 - (x / 2e-4) ** 2)
    touch = SimpleNamespace(along=lambda: x, p=p, weight=np.full(x.size, 1e-7),
                            half_width=lambda: 2 * math.sqrt(p @ x**2 / p.sum()))  # fmt: skip
    at = np.linspace(-0.95, 0.95, 11)
    assert over_hertz(touch, at) == pytest.approx(np.sqrt(1 - at**2), rel=1e-3)


def test_a_start_overlaps_as_much_in_materials_of_one_plane_strain_modulus():
    nu = 0.2
    stretchy = replace(pitch(1), E=206e9 * (1 - nu**2), nu=nu)
    stiff = replace(pitch(1), nu=0.0)
    assert overlap(stretchy, 2e5) == pytest.approx(overlap(stiff, 2e5), rel=1e-12)


@pytest.mark.parametrize("sense", [1, -1])
def test_a_rigid_clutch_presses_by_its_torque_over_the_tangent_of_half_its_angle(sense):
    q = pitch(sense)
    exact = 25.0 / (q.z * q.race * math.tan(q.rigid_angle / 2))
    assert rigid_force(q, 25.0) == pytest.approx(exact, rel=1e-12)


def test_a_start_is_guessed_from_its_overlap_and_grows_with_it():
    q = pitch(1)
    start = Start.guessed(q, 9e-6, inner=1 / 3, flatter=2)
    assert start.d == pytest.approx((3e-6, 6e-6), rel=1e-12)
    flatter = [q.r * d / a**2 for d, a in zip(start.d, start.widths, strict=True)]
    assert flatter == pytest.approx([2, 3], rel=1e-12)
    inside = guessed_inside(q, 2e5)
    assert sum(inside.d) == pytest.approx(overlap(q, 2e5), rel=1e-12)
    assert inside.d[0] == pytest.approx(0.33 * sum(inside.d), rel=1e-12)
    assert overlap(q, 2e5) * q.E / (2e5 * (1 - q.nu**2)) == pytest.approx(16, rel=1e-12)
    larger = Start((1.0, 2.0), (3.0, 4.0), (5.0, 6.0)).scaled(4.0)
    assert larger == Start((4.0, 8.0), (6.0, 8.0), (20.0, 24.0))


def test_a_load_is_searched_by_states_that_share_their_overlap_as_they_rest(monkeypatch):
    state = SimpleNamespace(
        start=SimpleNamespace(d_i=1e-6, d_o=3e-6), place=SimpleNamespace(d_i=3e-6, d_o=5e-6),
        widths=(2e-5, 4e-5), drags=(1e-7, -1e-7),
    )  # fmt: skip
    rest = after(state)
    assert rest.d == pytest.approx((1.5e-6, 2.5e-6), rel=1e-12)
    assert (rest.widths, rest.drags) == (state.widths, state.drags)
    monkeypatch.setattr(Start, "state", lambda *_: state)
    given = {"power": 0.5, "near": 0.02, "what": "the torque"}
    found = loaded(pitch(1), rest, lambda _: 1.01, **given)
    assert found.d == pytest.approx(rest.scaled(1.01**0.5).d, rel=1e-12)
    message = r"the torque was not reached: the last step .* by -50\.0%"
    with pytest.raises(NotFoundError, match=message):
        loaded(pitch(1), rest, lambda _: 0.5, **given)
