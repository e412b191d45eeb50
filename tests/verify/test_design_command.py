"""`freewheel design` from the command line: statuses, output, files, finite elements."""

import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from tests.verify.template_text import whole
from verify.app.cli import run
from verify.app.commands import load as load_check
from verify.studies.design.compressed import Curve
from verify.studies.design.console import verdict
from verify.studies.design.fem import Verified, verified_by_fem
from verify.studies.design.inputs import default
from verify.studies.design.outcome import Outcome
from verify.studies.design.search import search
from verify.studies.design.template import template

# eight springs, two of them on the front
SMALL = {
    "n": "10", "b": '"0.12 mm"', "L1": '"12.9 mm : 13.6 mm : 2"', "r": '"0.35 mm : 0.6 mm : 2"',
    "alpha": '"81 deg : 83 deg : 2"', "width_factor": "1",
}  # fmt: skip


def task(tmp_path, **changes):
    """The template with other lines."""
    text = whole(template())
    for key, value in (SMALL | changes).items():
        text, found = re.subn(rf"(?m)^(# )?{key} = .*$", f"{key} = {value}", text)
        assert found == 1, key
    path = tmp_path / "task.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_chosen_spring_passes_check_and_is_one_of_the_front(tmp_path, capsys):
    out = tmp_path / "out"
    assert run(["design", str(task(tmp_path)), "--json", "--out", str(out)]) == 0
    found = json.loads(capsys.readouterr().out)
    assert sorted(p.name for p in out.iterdir()) == ["candidates.csv", "chosen.toml", "design.html"]
    assert (found["candidates"], found["passed"]) == (8, True)
    assert found["feasible"] >= found["front"] == len(found["members"]) == 2
    distances = [m["distance_to_ideal"] for m in found["members"]]
    assert distances == sorted(distances)
    for member in found["members"]:
        fem = member["fem"]
        assert fem["agrees"]
        assert fem["deviation"] == pytest.approx(member["k1"]["value"] / fem["k1"]["value"] - 1)
        # frames shear and stretch a little, which the formula leaves out
        assert 0 < fem["deviation"] < 5e-4
        assert fem["mesh"] < 1e-4
    _, case, q, _ = load_check(out / "chosen.toml")
    assert case.id == "spring-stages"
    values = case.analytic(q)
    shape = {"b [mm]": 1e3 * q.b, "L1 [mm]": 1e3 * q.L1, "r [mm]": 1e3 * q.r,
             "alpha [deg]": np.degrees(q.alpha)}  # fmt: skip
    with (out / "candidates.csv").open(encoding="utf-8") as file:
        (line,) = [
            one for one in csv.DictReader(file)
            if all(abs(float(one[name]) - value) < 1e-6 for name, value in shape.items())
        ]  # fmt: skip
    assert float(line["k1 [N/mm]"]) == pytest.approx(values["k1"] / 1e3, rel=1e-4)  # axial strain
    assert float(line["U_A [mm]"]) == pytest.approx(values["U_A"] * 1e3, rel=1e-4)
    assert run(["design", str(task(tmp_path)), "--choose=99"]) == 2
    assert re.search(
        r"--choose must be the number of a design of the Pareto front, 1 to \d+, got ",
        capsys.readouterr().err,
    )


def test_an_impossible_task_ends_with_1_states_what_to_relax_and_clears_the_old_spring(
    tmp_path, capsys
):
    out = tmp_path / "out"
    out.mkdir()
    (out / "chosen.toml").write_text("an earlier one")
    assert run(["design", str(task(tmp_path, sigma='"100 MPa"')), "--out", str(out)]) == 1
    printed = capsys.readouterr().out
    assert "no candidate is feasible; the closest is n = 10" in printed
    assert sorted(p.name for p in out.iterdir()) == ["candidates.csv", "design.html"]
    page = (out / "design.html").read_text(encoding="utf-8")
    assert "No candidate meets all limits" in page
    assert "Relaxing one of these limits makes a spring feasible" in page
    # what is to be relaxed suffices as it is printed, rounded up
    needed = re.search(r"relax sigma from 100 MPa to (29\d\S* MPa)", printed)[1]
    assert run(["design", "--no-fem", str(task(tmp_path, sigma=f'"{needed}"'))]) == 0


# What finite elements decide


def verified(demands, **ranges):
    base = default()
    q = base.demands.model_copy(update=demands)
    found = search(type(base)("x", q, {name: (value,) for name, value in ranges.items()}))
    return found, verified_by_fem(found.springs, found.formulas, 0, q)


def test_a_spring_whose_formula_takes_the_inner_radius_disagrees():
    """3 % too stiff, three times what is allowed."""
    found, v = verified(
        {"arcs": "inner"}, n=10.0, b=1.2e-4, L1=12.9e-3, r=0.6e-3, alpha=np.radians(83)
    )
    assert 0.02 < v.deviation < 0.05
    assert not v.agrees
    assert not Outcome(found, [v], 0).passed


def test_finite_elements_give_the_height_and_stress_of_a_pressed_spring():
    """A separate elastica gave 15.56 mm and 394.5 MPa for this spring of the template."""
    _, v = verified(
        {"width_factor": 1.0}, n=8.0, b=1.1e-4, L1=13.8e-3, r=0.45e-3, alpha=np.radians(78)
    )
    assert v.curve.height == pytest.approx(15.56e-3, rel=5e-3)
    assert v.stress == pytest.approx(394.5e6, rel=0.01)
    assert v.too_high


CURVE = Curve(np.array([0.0, 8e-3, 9e-3]), np.array([0.0, 5.0, 5.6]), float("inf"))
ENDS = replace(CURVE, U=np.array([0.0, 7e-3, 7.9e-3]), whole=False)
NAN = float("nan")


def made(**changes):
    """A verified member, by hand."""
    base = {"k1": 625.0, "mesh": 1e-6, "deviation": 1e-3, "curve": CURVE, "delta": 8e-3,
            "U_w": 8e-3, "e_max": 0.03}  # fmt: skip
    return Verified(**(base | changes))


@pytest.mark.parametrize(
    ("changes", "fits"),
    [
        ({"delta": 8e-3 / 1.0299}, True), ({"delta": 8e-3 / 0.9699}, False),
        ({"delta": NAN}, False),
        # leaves touch before the working displacement
        ({"curve": replace(CURVE, touches=8e-3)}, False),
        ({"curve": replace(CURVE, touches=8.1e-3)}, True),
        # leaves straighten and the spring grows across: its height when pressed counts
        ({"curve": replace(CURVE, height=15.1e-3), "room": 15e-3}, False),
        ({"curve": replace(CURVE, height=15.1e-3), "room": 15.2e-3}, True),
        ({"stress": 501e6, "sigma": 500e6}, False), ({"stress": 499e6, "sigma": 500e6}, True),
        ({"curve": ENDS}, False), ({"curve": ENDS, "U_w": 7.9e-3 * (1 + 1e-12)}, True),
    ],
)  # fmt: skip
def test_a_spring_fits_up_to_its_limits(changes, fits):
    assert made(**changes).fits is fits


def test_agreement_holds_up_to_one_per_cent_where_the_mesh_does_not_leave_it_open():
    assert made(deviation=0.0099).agrees
    assert not made(deviation=-0.0101).agrees
    assert not made(mesh=0.02).agrees


def test_a_curve_that_ends_without_an_equilibrium_is_no_verdict_on_the_spring():
    v = made(curve=ENDS)
    assert v.unsolved
    assert verdict(v) == "no equilibrium found beyond 7.9 mm"
    assert verdict(made(curve=ENDS, delta=NAN, U_w=7.5e-3)).startswith("no equilibrium")
    # a spring that never reaches F_w on a whole curve is rejected
    assert verdict(made(delta=NAN)) == "|e_r| beyond 3 %"
