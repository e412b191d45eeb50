"""Press fit: every reading and every deliberate fault turns a row red."""

from dataclasses import replace
from functools import cache

import pytest

from analytic.contact import checks, press_fit
from fem.contact import bodies, interface
from fem.plane.material import Elastic
from meshes.ring import quarter
from verify.cases.contact.press_fit import formulas
from verify.cases.contact.press_fit.case import PRESS_FIT, PressFit
from verify.core.inputs import InputError, build
from verify.core.results import Status
from verify.jobs.level import Job, judge_case, solve_level

COARSE = replace(PRESS_FIT, levels=(1, 2, 3))
RAW = {"r_i": "20 mm", "r_f": "26 mm", "r_o": "40 mm", "delta": "15 µm", "E_i": "206 GPa",
       "nu_i": 0.3, "E_o": "70 GPa", "nu_o": 0.33}  # fmt: skip
PRESSURE = "contact pressure, mean, rings, plane stress"

pytestmark = pytest.mark.xdist_group("contact-press-fit")


def names(rows):
    return {row.quantity for row in rows}


def solve_anew(case):
    q = case.inputs()
    return judge_case(Job(case, q), [solve_level(case, q, level, None) for level in case.levels])


@cache
def red_without_fault():
    """Coarse meshes leave some rows without the sharpness they need: these prove nothing."""
    return frozenset(names(r for r in solve_anew(COARSE).rows if r.status is Status.FAIL))


def other_assumption(right):
    other = {"plane stress": "plane strain", "plane strain": "plane stress"}
    return lambda E, nu, assumption: right(E, nu, other[assumption])


# Readings, and faults of the formulas: finite elements come from the cache.
@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(formulas, "contact_pressures",
                     lambda f: lambda pair, delta, **k: f(pair, delta / 2, **k),
                     PRESSURE, id="interference of the diameters"),
        pytest.param(press_fit, "in_plane", other_assumption,
                     PRESSURE, id="plane stress and plane strain swapped"),
        pytest.param(formulas, "contact_pressures",
                     lambda f: lambda *a, **k: f(*a, **k | {"p_o": 0.0}),
                     PRESSURE, id="outer pressure forgotten"),
        pytest.param(formulas, "pressure_of_overlap",
                     lambda _: lambda inner, outer, **k: press_fit.contact_pressures(
                         [replace(inner, r_o=26.23e-3), replace(outer, r_i=26.23e-3)],
                         inner.r_o - outer.r_i, **k)[0],
                     "contact pressure, mean, rings drawn with overlap, plane strain",
                     id="one radius for walls that overlap"),
        pytest.param(press_fit.Wall, "strain_energy",
                     lambda f: lambda self, **k: 1.002 * f(self, **k),
                     "strain energy, rings, plane strain", id="energy 0.2 % too large"),
        pytest.param(press_fit.Wall, "stresses",
                     lambda f: lambda self, r, **k: f(self, r, **k)[::-1],
                     "hoop stress at the inner ring's bore, rings, plane stress",
                     id="stresses swapped"),
    ],
)  # fmt: skip
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, without_fault, red, monkeypatch
):
    assert not red(without_fault(PRESS_FIT))
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert row in names(red(judged(PRESS_FIT, drawn=False)))


def test_the_readings_share_one_hooke_s_law():
    assert press_fit.in_plane is checks.in_plane


# Faults of the finite elements: solved anew on coarser meshes.
@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(
    ("owner", "name", "fault"),
    [
        pytest.param(Elastic, "lame_constants",
                     lambda f: lambda self, _: f(self, "plane stress"), id="plane stress always"),
        pytest.param(bodies, "vector_basis",
                     lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k), id="linear elements"),
        pytest.param(quarter, "plane_mesh", lambda f: lambda **_: f(straight=True),
                     id="straight edges"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, red, monkeypatch):
    before = red_without_fault()
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    assert names(red(solve_anew(COARSE))) - before


@pytest.mark.soak  # finite elements solved anew for every fault
def test_a_pressure_that_is_not_even_turns_its_row_red(red, monkeypatch):
    """One row's weighted gap a thousandth of the interference too small."""
    right = interface.Interface.__init__

    def dented(self, *args, **more):
        right(self, *args, **more)
        self.gaps[self.gaps.size // 2] *= 1.001

    before = red_without_fault()
    monkeypatch.setattr(interface.Interface, "__init__", dented)
    found = names(red(solve_anew(COARSE))) - before
    assert any("scatter" in name for name in found)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"r_f": "19 mm"}, "r_i < r_f < r_o"),
        ({"r_i": "25.99 mm"}, "below a thousandth"),
        ({"delta": "1 mm"}, "strains are not small"),
        ({"delta": "0 µm"}, "must be greater than 0"),
        ({"p_i": "-1 MPa"}, "must be at least 0"),
        ({"E_o": "70"}, "has no unit|needs"),
    ],
)
def test_input_that_makes_no_sense_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        build(PressFit, RAW | change, "my.toml")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("change", "words"),
    [({"R_p": "20 MPa"}, "loses pressure"), ({"delta": "120 µm"}, "most metals yield before")],
)
def test_walls_that_yield_are_warned_of(change, words):
    q = build(PressFit, RAW | change, "my.toml")
    assert any(words in line for line in PRESS_FIT.warnings(q, PRESS_FIT.analytic(q)))


def test_thin_walls_are_checked_without_finite_elements():
    q = build(PressFit, RAW | {"r_i": "25.8 mm", "delta": "1 µm"}, "my.toml")
    assert "without --fem" in PRESS_FIT.too_large(q)
    assert not PRESS_FIT.too_large(build(PressFit, RAW, "my.toml"))


NANOMETRE = {"delta": "1 nm", "E_o": "2 GPa", "p_i": "0 MPa", "p_o": "0 MPa"}


def test_a_nanometre_of_interference_is_judged_within_round_off(judged, red):
    assert not red(judged(PRESS_FIT, build(PressFit, RAW | NANOMETRE, "my.toml")))


def test_interference_below_round_off_is_checked_without_finite_elements():
    q = build(PressFit, RAW | NANOMETRE | {"delta": "0.001 nm"}, "my.toml")
    assert "rounded positions" in PRESS_FIT.too_large(q)
    assert "\n" not in PRESS_FIT.too_large(q)
