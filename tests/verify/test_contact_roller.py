"""Finite line contacts: every reading and every deliberate fault turns a row red."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import (
    crown,
    hertz_line,
    lamina,
    love,
    palmgren,
    slice_compliance,
    sliced,
    slices,
    strip_newton,
)
from analytic.contact.half_space_convolution import Convolution
from analytic.contact.half_space_roller import RollerContact
from fem.plane.material import Elastic
from verify.cases.contact.roller import crowns, formulas, inputs
from verify.cases.contact.roller.case import ROLLER
from verify.cases.contact.roller.crowns import CROWNS
from verify.cases.contact.roller.flat import UNCROWNED
from verify.cases.contact.roller.half_space import pressed
from verify.cases.contact.roller.inputs import Crown, Roller, Tilt
from verify.cases.contact.roller.profiles import even_crowns
from verify.cases.contact.roller.tilted import TILTED
from verify.cases.registry import find
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("contact-roller")
CASES = (ROLLER, TILTED, UNCROWNED, CROWNS)
COARSE = (12, 16, 20)  # levels on which every row but the slope, which needs four, passes too

PEAK, MID = "largest pressure beyond d of the ends", "pressure at mid-length"
ELSEWHERE = "load that slices put elsewhere than the half-space, below 4%"
ENDS = "load within d of the ends, strips within 6%"
PLANE = f"{MID}, plane finite elements under the strips' load"
BEST = "largest pressure of the best crown, ends included, strips"
EVEN = f"{MID} of Lundberg's crown, strips within 0.3%"
LOADED = "load within d of the ends of Johns and Gohar's crown, strips within 2.0%"
STRAIGHT = "the straight middle follows K_2, not z_m"


def names(rows):
    return {row.quantity for row in rows}


def undrawn(case):
    """The case without its figures, which judge nothing."""
    return replace(case, figures=lambda _: ())


PLAIN = {case.id: undrawn(case) for case in CASES}


@pytest.fixture(autouse=True, scope="module")
def from_the_cache(judged):
    """Solve all cases before anything is broken."""
    for case in PLAIN.values():
        judged(case)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_every_row_passes_and_the_case_is_registered(case, judged, red):
    result = judged(PLAIN[case.id])
    assert not red(result)
    assert find(case.id) is case
    assert all(
        r.status in (Status.PASS, Status.SHOWN)
        or (r.status is Status.CALIBRATED and r.quantity.startswith("Fig. 12"))  # fitted inputs
        for r in result.rows
    )


def given(**changes):
    """Fault: all models but the half-space are given something else."""

    def fault(right):
        def wrong(*args):
            found = right(*args)
            return found | {key: change(found[key]) for key, change in changes.items()}

        return wrong

    return fault


def times(factor):
    return lambda right: lambda *a, **k: factor * right(*a, **k)


def from_the_end(right):
    """Eq. 5's count of y: |y| from one end, up to half the length."""

    def wrong(y, *, length, **more):
        return right(np.minimum(np.asarray(y) + length / 2, length / 2), length=length, **more)

    return wrong


def one_end(right):
    """Eq. 1 as printed, without the bars."""
    return lambda y, **more: np.where(np.asarray(y) > 0, right(y, **more), 0.0)


def respond_twice(right):
    def wrong(s):
        r = right(s)
        return replace(
            r, u=2 * r.u, ratios=2 * r.ratios, slopes=2 * r.slopes, far=tuple(2 * m for m in r.far)
        )

    return wrong


def without_power(_):
    return lambda *, length, slices: slices * palmgren.CONSTANT / length**0.8


def half_length(right):
    return lambda *, length, slices: right(length=length / 2, slices=slices)


def one_for_all(right):
    return lambda *, length, slices: right(length=length, slices=1)


def kernel(weights):
    """Fault: other weights in Eq. 3."""
    return lambda defaults: defaults | {"kernel": weights}


def alone(d, D, b):
    return np.where(d == 0, slice_compliance.love(d, D, b), 0.0)


def deeper(right):
    return lambda y, *, z_m, **more: right(y, z_m=2 * z_m, **more)


def straight_by_z_m(right):
    """A crowned part that grows with z_m, about the paper's."""

    def wrong(y, *, K_2, z_m, **more):
        return right(y, K_2=np.minimum(K_2 * (1 + z_m / 50e-6), 1.0), z_m=z_m, **more)

    return wrong


def turned_the_other_way(right):
    return lambda self, y: right(self, -y)


def about_its_end(right):
    return lambda self, y: right(self, y) + self.theta * self.L / 2


# The reference takes no gap of the formulas, so that its cached results are those of a true run.
def test_the_half_space_takes_neither_the_formulas_crowns_nor_their_tilt(monkeypatch):
    def found():
        return [
            *(pressed(case.inputs(), 4).values for case in (ROLLER, TILTED, UNCROWNED)),
            *(
                pressed(CROWNS.inputs(), 4, crown=crown).values
                for crown in even_crowns(CROWNS.inputs()).values()
            ),
            {k: v for k, v in CROWNS.reference(CROWNS.inputs(), 4).values.items() if v},
        ]

    def refused(*_, **__):
        raise AssertionError("the formulas' gap")

    right = found()
    for name in ("logarithmic", "lundberg", "johns_gohar", "_scale", "_position"):
        monkeypatch.setattr(crown, name, refused)
    monkeypatch.setattr(inputs, "logarithmic", refused)
    for owner in (Roller, Crown, Tilt):
        monkeypatch.setattr(owner, "gap", refused)
    assert found() == right


# Faults of the formulas, and other readings of them: the half-space comes from the cache. What a
# best crown and the plane finite elements are given comes from the formulas: no row of theirs here.
@pytest.mark.parametrize(
    ("case", "owner", "name", "fault", "row"),
    [
        # readings
        pytest.param(ROLLER, crown, "_scale", times(0.5), f"{PEAK}, strips",
                     id="reading: E' of Eq. 1 is 4 E*"),
        pytest.param(ROLLER, crown, "_scale", times(2.0), f"{PEAK}, strips",
                     id="reading: E' of Eq. 1 is E*"),
        pytest.param(CROWNS, crown, "_scale", times(2.0), EVEN,
                     id="reading: E' of Eq. 1 is E*, Lundberg's crown"),
        pytest.param(ROLLER, inputs, "logarithmic", from_the_end, f"{PEAK}, strips",
                     id="reading: y counts from the end"),
        pytest.param(CROWNS, inputs, "logarithmic", from_the_end, STRAIGHT,
                     id="reading: y counts from the end, designs"),
        pytest.param(ROLLER, inputs, "logarithmic", one_end, f"{PEAK}, strips",
                     id="reading: a crown at one end"),
        pytest.param(TILTED, inputs, "logarithmic", one_end, "tilting moment, strips within 1%",
                     id="reading: a crown at one end, tilted"),
        pytest.param(ROLLER, inputs, "logarithmic", straight_by_z_m, f"{PEAK}, strips",
                     id="reading: the straight part depends on z_m"),
        pytest.param(CROWNS, inputs, "logarithmic", straight_by_z_m, STRAIGHT,
                     id="reading: the straight part depends on z_m, designs"),
        pytest.param(ROLLER, palmgren, "compliance", without_power, f"{MID}, slices",
                     id="reading: s without the power 1/0.9"),
        pytest.param(TILTED, palmgren, "compliance", without_power, f"{PEAK}, slices",
                     id="reading: s without the power 1/0.9, tilted"),
        pytest.param(ROLLER, palmgren, "compliance", half_length, f"{PEAK}, slices",
                     id="reading: s of half the length"),
        pytest.param(UNCROWNED, slices.press, "__kwdefaults__", kernel(alone), f"{MID}, slices",
                     id="reading: w deflects none but its own slice"),
        pytest.param(TILTED, slices.press, "__kwdefaults__",
                     kernel(lambda d, D, b: slice_compliance.love(d, D, 4 * b)), f"{PEAK}, slices",
                     id="reading: w on four times Hertz's width"),
        pytest.param(TILTED, Tilt, "gap", turned_the_other_way,
                     "tilting moment, strips within 1%", id="reading: tilt the other way"),
        pytest.param(TILTED, Tilt, "gap", about_its_end, "approach, strips",
                     id="reading: tilt about the end"),
        # faults
        pytest.param(ROLLER, inputs, "logarithmic", deeper, f"{PEAK}, strips", id="z_m doubled"),
        pytest.param(CROWNS, crowns, "lundberg", times(1.15), EVEN, id="Lundberg's crown x 1.15"),
        pytest.param(ROLLER, formulas, "roller", given(E_star=lambda E: 0.91 * E),
                     f"{MID}, strips", id="E* without 1 - nu²"),
        pytest.param(UNCROWNED, formulas, "roller", given(E_star=lambda E: 0.91 * E),
                     f"{MID}, strips as wide as the contact within 0.5%",
                     id="E* without 1 - nu², no crown"),
        pytest.param(ROLLER, formulas, "roller", given(R=lambda R: 2 * R), PLANE,
                     id="diameter for radius"),
        pytest.param(UNCROWNED, formulas, "roller", given(R=lambda R: 2 * R), ENDS,
                     id="diameter for radius, no crown"),
        pytest.param(ROLLER, formulas, "roller", given(load=lambda F: F / 2), f"{MID}, slices",
                     id="half the load"),
        pytest.param(ROLLER, strip_newton, "respond", respond_twice, "approach, strips",
                     id="twice the influence"),
        pytest.param(UNCROWNED, slices.press, "__kwdefaults__",
                     kernel(lambda d, D, b: slice_compliance.love(d, 2 * D, b)), ELSEWHERE,
                     id="slices of twice their width"),
        pytest.param(TILTED, slices.press, "__kwdefaults__",
                     kernel(lambda d, D, b: slice_compliance.love(d, D, 0 * b + 0.5e-3)),
                     f"{PEAK}, slices", id="one width for every load"),
        pytest.param(ROLLER, palmgren, "compliance", one_for_all, ELSEWHERE, id="s without n"),
        pytest.param(ROLLER, sliced.SlicedContact, "peak_pressure",
                     lambda right: property(lambda self: 1.05 * right.fget(self)),
                     f"{MID}, slices", id="slices' pressure 5 % too large"),
        pytest.param(CROWNS, hertz_line, "peak_pressure", times(1.006),
                     f"{MID}, Lundberg's crown", id="Hertz's pressure 0.6 % too large"),
        pytest.param(CROWNS, crown, "END", lambda right: 2 * right,
                     LOADED, id="0.6065 b/l for half of it"),
        pytest.param(ROLLER, slices, "press", lambda _: lamina.press,
                     "slices put less load elsewhere than uncoupled slices",
                     id="slices that are uncoupled"),
    ],
)  # fmt: skip
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    case, owner, name, fault, row, judged, red, monkeypatch
):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(PLAIN[case.id])))


def test_weights_that_are_not_reciprocal_are_refused(judged, red, monkeypatch):
    lower = np.tril(np.ones((50, 50))) + np.eye(50)
    monkeypatch.setitem(slices.press.__kwdefaults__, "kernel", lower)
    assert any("works are reciprocal" in row.reason for row in red(judged(PLAIN[ROLLER.id])))


# Faults of the half-space and of the finite elements: solved anew.
def periodic(_):
    """The influence repeats, as it does without padding by zeros."""
    return lambda self, pressure: self._filter(pressure, 1, 1 / self._inverse)


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(
    ("case", "owner", "name", "fault", "row"),
    [
        pytest.param(TILTED, Convolution, "displacement", periodic, "approach, strips",
                     id="no padding"),
        pytest.param(TILTED, love, "table", times(1.001), "approach, strips",
                     id="cells larger by a thousandth"),
        pytest.param(TILTED, RollerContact, "end_load",
                     lambda f: lambda self, d: f(self, d)[::-1],
                     "load within d of the pressed end, strips within 6%", id="ends swapped"),
        pytest.param(UNCROWNED, RollerContact, "end_load",
                     lambda f: lambda self, d: (f(self, d)[0], 0.0), ENDS, id="one end for two"),
        pytest.param(ROLLER, Elastic, "lame_constants",
                     lambda f: lambda self, _: f(self, "plane stress"), PLANE,
                     id="plane stress for plane strain"),
    ],
)  # fmt: skip
def test_a_wrong_half_space_or_wrong_finite_elements_turn_a_row_red(
    case, owner, name, fault, row, red, monkeypatch
):
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(solve_anew(case)))


# The best crown is searched for by the formulas: solved anew.
@pytest.mark.soak  # finite elements solved anew for every fault
def test_a_best_crown_of_a_wrong_law_turns_its_row_red(red, monkeypatch):
    monkeypatch.setattr(crown, "_scale", times(2.0)(crown._scale))
    assert BEST in names(red(solve_anew(ROLLER)))


def solve_anew(case):
    """The case on coarse levels, without any cache."""
    q = case.inputs()
    solved = [solve_level(case, q, level, None) for level in COARSE]
    return judge_case(Job(PLAIN[case.id], q), solved)


@pytest.mark.soak  # finite elements solved anew, for the faults above
@pytest.mark.parametrize("case", [ROLLER, TILTED], ids=lambda case: case.id)
def test_solved_anew_no_row_is_red_without_a_fault(case, red):
    assert not red(solve_anew(case))
