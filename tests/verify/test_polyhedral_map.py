"""Maps of K: faults turn rows and statements red; maps of one's own; what is refused."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.polyhedral import bore_pressure, expansion
from verify.cases.polyhedral.map import case as polyhedral_map
from verify.cases.polyhedral.map.case import MAP, PolyhedralMap
from verify.core.case import Context
from verify.core.inputs import InputError, build

pytestmark = pytest.mark.xdist_group("polyhedral-map")

PAPER = {"d_e": "80 mm", "delta_1": "4 mm", "j_D": "0.06 mm", "E": "210 GPa", "nu": 0.3,
         "rho": "2 mm", "d": "10 mm"}  # fmt: skip
SIX, WALLS = "K of 6 flats, middle", "series and FE agree to 0.1 % over flats and walls"
FILLETS = "series and FE agree to 0.1 % over flats and fillets"
SHARE = "series and FE agree to 1 % in the share that reaches the rollers"


def own(**changes):
    return build(PolyhedralMap, PAPER | changes, "my.toml")


def names(rows):
    return {row.quantity for row in rows}


def test_no_row_is_red_on_the_case_s_inputs(judged, red):
    assert not red(judged(MAP))


def changed(**parts):
    """K with some of its definitions replaced by what is made of it."""

    def fault(right):
        def wrong(**k):
            K = right(**k)
            return replace(K, **{name: make(K) for name, make in parts.items()})

        return wrong

    return fault


FAULTS = [
    pytest.param(bore_pressure, "stiffness_factors", changed(mid=lambda K: K.mean), SIX,
                 id="the mean for the middle"),
    pytest.param(bore_pressure, "stiffness_factors", changed(mid=lambda K: 1.002 * K.mid), WALLS,
                 id="K 0.2 % off, walls"),
    pytest.param(bore_pressure, "stiffness_factors", changed(mid=lambda K: 1.002 * K.mid), FILLETS,
                 id="K 0.2 % off, fillets"),
    pytest.param(bore_pressure, "stiffness_factors",
                 lambda f: lambda **k: f(**k | {"assumption": "plane strain"}), WALLS,
                 id="plane strain"),
    pytest.param(polyhedral_map, "Roller", lambda f: lambda **k: f(**k | {"j_D": 2 * k["j_D"]}),
                 SHARE, id="clearance on the radius"),
    pytest.param(polyhedral_map, "Sector",
                 lambda f: lambda *, z, d_i, rho, **k: f(
                     z=z, d_i=d_i - 2 * rho * (1 / np.cos(np.pi / z) - 1), rho=rho, **k), WALLS,
                 id="d_i through unfilleted corners"),
    pytest.param(expansion, "many_corners_factor", lambda f: lambda **k: 0.95 * f(**k),
                 "K of 48 flats is within 2 % of Lamé's limit", id="Lamé's limit 5 % off"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_another_reading_or_a_wrong_formula_turns_its_row_red(
    owner, name, fault, row, judged, without_fault, red, monkeypatch
):
    without_fault(MAP)
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    found = names(red(judged(MAP, drawn=False)))
    assert row in found


# Maps that take seconds each; two others are drawn in every run.
SOAK = pytest.mark.soak
ODD = [
    pytest.param({"delta_1": "0.4 mm", "rho": "0.3 mm"}, id="thin", marks=SOAK),
    pytest.param({"delta_1": "11.9 mm"}, id="thick", marks=SOAK),
    pytest.param({"rho": "0.3 mm"}, id="sharp corners", marks=SOAK),
    pytest.param({"rho": "20 mm"}, id="round corners", marks=SOAK),
    pytest.param({"d": "0.1 mm"}, id="needles", marks=SOAK),
    pytest.param({"d": "1000 mm"}, id="rollers that never fit"),
    pytest.param({"j_D": "1.5 mm"}, id="large clearance", marks=SOAK),
    pytest.param({"E": "0.01 GPa", "nu": 0.0}, id="soft", marks=SOAK),
    pytest.param({"d_e": "0.08 mm", "delta_1": "0.004 mm", "j_D": "6e-5 mm", "rho": "0.002 mm",
                  "d": "0.01 mm"}, id="tiny"),
]  # fmt: skip


@pytest.mark.parametrize("change", ODD)
def test_maps_of_odd_rings_are_finite_and_drawn(change):
    q = own(**change)
    with np.errstate(over="raise", divide="raise", invalid="raise"):  # as the command does
        v = MAP.analytic(q)
    assert all(np.isfinite(x) for x in v.values())
    assert len(MAP.figures(Context(MAP.id, q, v, [], False))) == 4


def test_maps_do_not_notice_the_size_of_the_ring():
    small = own(d_e="0.8 mm", delta_1="0.04 mm", j_D="6e-4 mm", rho="0.02 mm", d="0.1 mm")
    assert small.K_many == pytest.approx(own().K_many, rel=1e-7)
    assert small.flexible_middle == pytest.approx(own().flexible_middle, rel=1e-7)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"delta_1": "13 mm"},
            r"map's fillets leave no flat: δ_1 must be at most 0.15 d_e = 12 mm",
        ),
        ({"rho": "22 mm"}, r"no flat in the thickest walls of the map: ρ must be at most 21.6 mm"),
        ({"delta_1": "0.3 mm"}, r"the wall vanishes"),
        ({"d": "0 mm"}, r"inputs.d = 0 mm: must be greater than 0 mm"),
    ],
)
def test_a_map_that_cannot_be_gets_one_line(change, message):
    with pytest.raises(InputError, match=message) as caught:
        own(**change)
    assert "\n" not in str(caught.value)
