"""The polyhedral ring under pressure: readings and faults turn rows red; rings of one's own."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.polyhedral import bore_pressure, expansion, wall_stress
from analytic.polyhedral.sector import Sector
from fem.plane import loads, solve
from fem.plane.material import Elastic
from meshes.polyhedral import half_sector
from verify.case import about
from verify.cases.polyhedral import thin_ring
from verify.cases.polyhedral.ring import case as polyhedral_ring
from verify.cases.polyhedral.ring import reference
from verify.cases.polyhedral.ring.case import RING, PolyhedralRing
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.jobs.level import Job, judge_case, solve_level

pytestmark = pytest.mark.xdist_group("polyhedral-ring")

PAPER = {"d_e": "80 mm", "delta_1": "4 mm", "j_D": "0.06 mm", "E": "210 GPa", "nu": 0.3, "z": 6,
         "rho": "2 mm", "e": "9 mm", "R_b": "200 N/mm", "tan_phi": 0.05}  # fmt: skip
MIDDLE, MEAN = "K in the middle of the flats", "K in the mean"
CORNER, STRAIN = "flexibility at the corners", "K in the middle of the flats, plane strain"
WALL, FILLET = "mean hoop stress in the corners, Eq. 12", "largest hoop stress in the fillets"
HUB, AT_CORNER = "hub at e: middle of the flats", "hub at the corner: corners"


def own(**changes):
    return build(PolyhedralRing, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


def undrawn(case=RING):
    return replace(case, figures=lambda _: ())


@pytest.fixture
def broken(monkeypatch):
    def break_(owner, name, fault):
        monkeypatch.setattr(owner, name, fault(getattr(owner, name)))

    return break_


def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(RING))


def to_unfilleted(_):
    """d_i of the inputs taken to the corners that the bore would have without fillets."""
    return lambda *, z, **_: unfilleted(z)


def unfilleted(z):
    rho = 2e-3
    return Sector(z=z, d_e=0.08, d_i=0.072 - 2 * rho * (1 / np.cos(np.pi / z) - 1), rho=rho)


def mean_for_middle(right):
    def wrong(**k):
        K = right(**k)
        return replace(K, mid=K.mean)

    return wrong


OTHER = {"plane stress": "plane strain", "plane strain": "plane stress"}
FAULTS = [
    pytest.param(thin_ring, "Sector", to_unfilleted, MIDDLE,
                 id="d_i through corners without fillets"),
    pytest.param(bore_pressure, "stiffness_factors", mean_for_middle, MIDDLE,
                 id="the mean for the middle"),
    pytest.param(bore_pressure, "stiffness_factors",
                 lambda f: lambda **k: f(**k | {"assumption": OTHER[k["assumption"]]}), STRAIN,
                 id="plane strain for plane stress"),
    pytest.param(bore_pressure, "stiffness_factors",
                 lambda f: lambda **k: replace(f(**k), mean=1.0005 * f(**k).mean), MEAN,
                 id="K_mean 0.05 % off"),
    pytest.param(bore_pressure, "stiffness_factors",
                 lambda f: lambda **k: replace(f(**k), corner=-f(**k).corner), CORNER,
                 id="corners that draw in"),
    pytest.param(expansion, "mean_hoop_stress",
                 lambda f: lambda *, p, **k: f(p=p * 1.0999, **k), WALL, id="Eq. 12 as printed"),
    pytest.param(expansion, "touching_pressure",
                 lambda f: lambda **k: f(**k | {"j_D": 2 * k["j_D"]}), FILLET,
                 id="clearance on the radius"),
    pytest.param(wall_stress, "largest_fillet_stress",
                 lambda f: lambda **k: (1.005 * f(**k)[0], 0.0), FILLET, id="fillet 0.5 % off"),
    pytest.param(polyhedral_ring, "hub_force",
                 lambda f: lambda **k: f(**k | {"along": -k["along"]}), HUB,
                 id="the hub's friction the other way"),
    pytest.param(polyhedral_ring, "hub_force", lambda f: lambda **k: f(**k | {"along": 0.0}), HUB,
                 id="a hub without friction"),
    pytest.param(polyhedral_ring, "hub_force",
                 lambda f: lambda **k: f(**k | {"normal": k["normal"] / 2}), AT_CORNER,
                 id="half of the hub's force"),
    pytest.param(polyhedral_ring, "hub_force",
                 lambda f: lambda **k: f(**k | {"e": 0.99 * k["e"]}), HUB, id="e 1 % off"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, broken, judged, without_fault, red
):
    without_fault(RING)
    broken(owner, name, fault)
    assert row in names(red(judged(RING, drawn=False)))


def test_k_of_the_paper_is_judged_against_what_the_series_says(broken, judged, red):
    broken(polyhedral_ring, "of_one", lambda _: lambda _: about(0.0, 1e-3, "K = 1"))
    assert "K of the paper" in names(red(judged(undrawn())))


@pytest.mark.parametrize(("z", "more"), [(3, 0.47), (4, 0.25), (5, 0.15), (6, 0.10)])
def test_corners_without_fillets_make_k_that_much_larger(z, more):
    """With d_i of the inputs read as that of sharp corners, the ring is thicker than δ_1."""
    given = {"nu": 0.3, "assumption": "plane stress"}
    K = bore_pressure.stiffness_factors(sector=Sector(z=z, d_e=0.08, d_i=0.072, rho=2e-3), **given)
    other = unfilleted(z)
    p = bore_pressure.stiffness_factors(sector=other, **given).mid
    # over the same p_1, that of d_i = 72 mm
    thin = [(80 - d) / (d * (80 + d)) for d in (1e3 * other.d_i, 72.0)]
    assert p * thin[0] / thin[1] / K.mid - 1 == pytest.approx(more, abs=0.02)


COARSE = replace(RING, levels=(1, 2, 3), figures=lambda _: ())


def solve_anew():
    q = COARSE.inputs()
    return judge_case(Job(COARSE, q), [solve_level(COARSE, q, n, None) for n in COARSE.levels])


def with_hub(**change):
    """The hub's finite elements with other inputs."""

    def fault(right):
        return lambda q, level: right(
            q.model_copy(update={k: f * getattr(q, k) for k, f in change.items()}), level
        )

    return fault


FEM_FAULTS = [
    pytest.param(Elastic, "lame_constants", lambda f: lambda self, _: f(self, "plane stress"),
                 STRAIN, id="plane stress for plane strain"),
    pytest.param(solve, "vector_basis", lambda f: lambda mesh, _degree, **k: f(mesh, 1, **k),
                 FILLET, id="linear elements"),
    pytest.param(loads, "push", lambda f: lambda *a: -f(*a), MIDDLE, id="pressure pulls"),
    pytest.param(half_sector, "Outline", lambda f: lambda z, d_e, d_i, rho: f(
        z, d_e, d_i, 1.05 * rho), FILLET, id="fillets 5 % larger"),
    pytest.param(reference, "pushed_fem", with_hub(R_b=2), HUB, id="forces not halved"),
    pytest.param(reference, "pushed_fem", with_hub(tan_phi=-1), HUB,
                 id="friction the other way"),
]  # fmt: skip


@pytest.mark.soak  # finite elements solved anew for every fault
@pytest.mark.parametrize(("owner", "name", "fault", "row"), FEM_FAULTS)
def test_wrong_finite_elements_turn_a_row_red(owner, name, fault, row, broken, red):
    broken(owner, name, fault)
    assert row in names(red(solve_anew()))


@pytest.mark.soak  # finite elements solved anew, for the faults above
def test_the_coarser_levels_alone_turn_no_row_red(red):
    assert not red(solve_anew())


ODD = [
    pytest.param({"z": 3}, "draw in", id="triangle"),
    pytest.param({"z": 4}, "give R_p", id="square"),
    pytest.param({"z": 5}, "give R_p", id="pentagon"),
    pytest.param({"z": 48, "rho": "0.5 mm", "e": "1 mm"}, "", id="48 flats"),
    pytest.param({"z": 48, "rho": "30 mm", "e": "0.2 mm"}, "", id="48 flats, nearly round"),
    pytest.param({"z": 24, "delta_1": "0.5 mm", "rho": "0.3 mm", "e": "2 mm"}, "", id="24, thin"),
    pytest.param({"z": 3, "delta_1": "0.5 mm", "rho": "0.3 mm"}, "draw in", id="thin triangle"),
    pytest.param({"delta_1": "20 mm", "e": "5 mm"}, "give R_p", id="thick"),
    pytest.param({"rho": "0.1 mm", "R_p": "900 MPa"}, "exceeds R_p", id="sharp corners"),
    pytest.param({"rho": "34 mm", "e": "0.5 mm"}, "", id="hardly any flat"),
    pytest.param({"e": "0.1 mm"}, "give R_p", id="hub in the middle"),
    pytest.param({"e": "16.1 mm"}, "give R_p", id="hub at the flat's end"),
    pytest.param({"R_b": "1e6 N/mm", "tan_phi": 1.0}, "give R_p", id="huge hub force"),
    pytest.param({"R_b": "1e-6 N/mm", "tan_phi": 0.0}, "give R_p", id="hardly a hub"),
    pytest.param({"E": "0.01 GPa"}, "give R_p", id="soft"),
    pytest.param({"z": 4, "delta_1": "4.6 mm"}, "give R_p", id="corners that hardly move"),
]


@pytest.mark.parametrize(("change", "said"), ODD)
def test_formulas_of_odd_rings_are_finite_and_their_state_is_told(change, said):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = RING.analytic(q)
    assert all(np.isfinite(x) for x in v.values())
    warned = RING.warnings(q, v)
    assert any(said in line for line in warned) if said else not warned
    assert RING.equations(q, v)
    assert RING.sketch(q).shapes
    assert not RING.figures(Context(RING.id, q, v, [], False))  # of finite elements alone


# Solved anew for seconds each; one set is judged in every run.
SOAK = pytest.mark.soak


@pytest.mark.parametrize(
    "change",
    [
        pytest.param({"z": 5}, id="an error that changes sign", marks=SOAK),
        pytest.param(
            {"z": 3, "delta_1": "0.5 mm", "rho": "0.3 mm"}, id="thin triangle", marks=SOAK
        ),
        pytest.param({"z": 48, "rho": "0.5 mm", "e": "1 mm"}, id="48 flats", marks=SOAK),
        pytest.param({"rho": "34 mm", "e": "0.5 mm"}, id="hardly any flat"),
        pytest.param({"delta_1": "20 mm", "e": "5 mm"}, id="thick", marks=SOAK),
        pytest.param({"e": "16.1 mm", "R_b": "1e6 N/mm"}, id="hub at the flat's end", marks=SOAK),
    ],
)
def test_no_row_of_an_odd_ring_fails(change, judged, red):
    result = judged(undrawn(), own(**change))
    assert not red(result)
    assert not result.errors


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"z": 2}, r"inputs.z = 2: must be at least 3"),
        ({"z": 49}, r"inputs.z = 49: must be at most 48"),
        ({"z": 6.5}, r"inputs.z: needs a whole number"),
        ({"rho": "35 mm"}, r"fillets leave no flat: ρ must be at most 34.2 mm .* got 35 mm"),
        ({"rho": "0 mm"}, r"inputs.rho = 0 mm: must be greater than 0 mm"),
        (
            {"e": "16.2 mm"},
            r"hub must touch the flat: e must be at most 0.95 .*, 16.15 mm, got 16.2",
        ),
        ({"tan_phi": 1.1}, r"inputs.tan_phi = 1.1: must be at most 1"),
        ({"R_b": "0 N/mm"}, r"inputs.R_b = 0 N/mm: must be greater than 0 N/mm"),
    ],
)
def test_a_ring_that_cannot_be_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        own(**change)
    assert "\n" not in str(caught.value)
