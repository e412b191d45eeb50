"""The round ring under pressure: readings and faults turn rows red; rings of one's own."""

from dataclasses import replace

import pytest

from analytic.bounds.polyhedral import thin_ring
from analytic.polyhedral import expansion
from analytic.ring import lame
from fem.plane import solve
from fem.plane.material import Elastic
from meshes.ring import quarter
from verify.cases.polyhedral.pressure.case import PRESSURE
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("polyhedral-pressure")

PAPER = {"d_e": "80 mm", "delta_1": "4 mm", "j_D": "0.06 mm", "E": "210 GPa", "nu": 0.3}
PLANE = [f"pressure that takes up the clearance, plane {a}" for a in ("stress", "strain")]
THIN, MEAN = (
    "pressure of the thin ring, Eq. 10",
    "hoop stress, Eq. 9, against the mean over the wall",
)
OUTSIDE, GROWTH = (
    "hoop stress, Eq. 9, against that of the outside",
    "growth of the mean diameter, Eq. 8",
)
LIMIT = "pressure of ever thinner rings, Eq. 10"


def own(**changes):
    return build(PRESSURE.inputs, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


@pytest.fixture
def broken(monkeypatch):
    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))

    return break_


def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(PRESSURE))


def doubled(f):
    return lambda **k: f(**k | {"j_D": 2 * k["j_D"]})


OTHER = {"plane stress": "plane strain", "plane strain": "plane stress"}
FAULTS = [
    pytest.param(expansion, "round_ring_pressure", doubled, PLANE[0], id="clearance on the radius"),
    pytest.param(expansion, "touching_pressure", doubled, THIN, id="the same, thin ring"),
    pytest.param(expansion, "hoop_stress", doubled, MEAN, id="the same, stress"),
    pytest.param(expansion, "round_ring_pressure",
                 lambda f: lambda **k: f(**k | {"ends": OTHER[k["ends"]]}), PLANE[1],
                 id="plane stress for plane strain"),
    pytest.param(expansion, "round_ring_pressure",
                 lambda f: lambda **k: f(**k) * (k["d_e"] + k["d_i"]) / 2 / k["d_e"], PLANE[0],
                 id="the clearance closes at the mean diameter"),
    pytest.param(expansion, "growth", lambda f: lambda **k: f(**k | {"d_m": 0.08}), GROWTH,
                 id="outer for mean diameter"),
    pytest.param(expansion, "mean_diameter", lambda _: lambda *, d_i, d_e: d_i, OUTSIDE,
                 id="inner for mean diameter"),
    pytest.param(thin_ring, "_thick_over_thin", lambda f: lambda *a: 1.0005 * f(*a), THIN,
                 id="Lamé's factor 0.05 % off"),
    pytest.param(expansion, "touching_pressure", lambda f: lambda **k: 1.002 * f(**k), LIMIT,
                 id="0.2 % too much pressure in the limit"),
    pytest.param(lame, "radial_displacement", lambda f: lambda *a, **k: 1.001 * f(*a, **k), GROWTH,
                 id="Lamé's growth 0.1 % off"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(PRESSURE)
    broken(owner, name, fault)
    assert row in names(red(judged(PRESSURE, drawn=False)))


def solve_anew():
    q = PRESSURE.inputs()
    levels = [solve_level(PRESSURE, q, level, None) for level in PRESSURE.levels]
    return judge_case(Job(replace(PRESSURE, figures=lambda _: ()), q), levels)


@pytest.mark.parametrize(
    ("owner", "name", "fault", "row"),
    [
        pytest.param(Elastic, "lame_constants", lambda f: lambda self, _: f(self, "plane stress"),
                     PLANE[1], id="plane stress for plane strain"),
        pytest.param(solve, "vector_basis", lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k),
                     OUTSIDE, id="linear elements"),
        pytest.param(quarter, "plane_mesh", lambda f: lambda **_: f(straight=True), OUTSIDE,
                     id="straight edges"),
    ],
)  # fmt: skip
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, broken, red):
    broken(owner, name, fault)
    assert row in names(red(solve_anew()))


# Solved anew for seconds each; the others go the same way.
SOAK = pytest.mark.soak
ODD = [
    pytest.param({"delta_1": "0.4 mm"}, "", id="thin"),
    pytest.param({"delta_1": "20 mm"}, "", id="thick", marks=SOAK),
    pytest.param({"delta_1": "39 mm"}, "", id="hardly a bore", marks=SOAK),
    pytest.param({"j_D": "1e-6 mm"}, "", id="hardly any clearance"),
    pytest.param({"j_D": "1.6 mm"}, "give R_p", id="all of the clearance"),
    pytest.param({"E": "0.001 GPa"}, "", id="soft"),
    pytest.param({"E": "1e5 GPa"}, "", id="stiff"),
    pytest.param({"nu": 0.0}, "", id="no Poisson's ratio"),
    pytest.param({"nu": 0.45}, "", id="large Poisson's ratio"),
    pytest.param({"R_p": "1 MPa"}, "exceeds R_p = 1 MPa", id="yields"),
    pytest.param({"d_e": "0.08 mm", "delta_1": "0.004 mm", "j_D": "6e-5 mm"}, "", id="tiny"),
    pytest.param({"d_e": "8e4 mm", "delta_1": "4e3 mm", "j_D": "60 mm"}, "", id="huge"),
]


@pytest.mark.parametrize(("change", "said"), ODD)
def test_no_row_of_an_odd_ring_fails_and_its_state_is_told(change, said, judged, red):
    q = own(**change)
    warned = PRESSURE.warnings(q, PRESSURE.analytic(q))
    assert any(said in line for line in warned) if said else not warned
    result = judged(PRESSURE, q)
    assert not red(result)
    assert not result.errors
    assert PRESSURE.figures(Context(PRESSURE.id, q, PRESSURE.analytic(q), [], False))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"delta_1": "39.5 mm"}, r"wall leaves no bore: δ_1 must be below 0.49 d_e = 39.2 mm, got"),
        ({"delta_1": "0.3 mm"}, r"wall vanishes: δ_1 must be at least 0.005 d_e = 0.4 mm, got"),
        ({"j_D": "2 mm"}, r"j_D = 2 mm strains the ring by 2.6%: .*, at most 0.02 d_e = 1.6 mm"),
        ({"E": "-1 GPa"}, r"inputs.E = -1 GPa: must be greater than 0 GPa"),
        ({"nu": 0.5}, r"inputs.nu = 0.5: must be at most 0.45"),
        ({"d_e": "80 N"}, r"inputs.d_e: "),
    ],
)
def test_a_ring_that_cannot_be_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        own(**change)
    assert "\n" not in str(caught.value)
