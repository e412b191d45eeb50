"""`freewheel design` as a user meets it: statuses, what it prints and writes, finite elements."""

import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from tests.verify.template_text import whole
from verify.app.cli import run
from verify.app.commands import load as load_check
from verify.cases.spring.stages.inputs import StagesInputs
from verify.studies.design.console import rounded, verdict
from verify.studies.design.fem import Verified, verified_by_fem
from verify.studies.design.inputs import default
from verify.studies.design.limits import Limit
from verify.studies.design.nearest import relaxation
from verify.studies.design.outcome import Outcome
from verify.studies.design.search import search
from verify.studies.design.template import template

# eight springs, two of them on the front
SMALL = {
    "n": "10",
    "b": '"0.12 mm"',
    "L1": '"12.9 mm : 13.6 mm : 2"',
    "r": '"0.35 mm : 0.6 mm : 2"',
    "alpha": '"81 deg : 83 deg : 2"',
    "width_factor": "1",
}


def task(tmp_path, **changes):
    """The template with other lines."""
    text = whole(template())
    for key, value in (SMALL | changes).items():
        text, found = re.subn(rf"(?m)^(# )?{key} = .*$", f"{key} = {value}", text)
        assert found == 1, key
    path = tmp_path / "task.toml"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def done(tmp_path_factory):
    """The small task with its folder."""
    folder = tmp_path_factory.mktemp("design")
    out = folder / "out"
    status = run(["design", str(task(folder)), "--out", str(out)])
    return status, out


def test_a_feasible_task_ends_with_0_and_leaves_three_whole_files(done):
    status, out = done
    assert status == 0
    assert sorted(p.name for p in out.iterdir()) == [
        "candidates.csv", "chosen.toml", "design.html",
    ]  # fmt: skip


def test_the_chosen_spring_goes_through_check(done, capsys):
    _, out = done
    _, case, inputs, _ = load_check(out / "chosen.toml")
    assert case.id == "spring-stages"
    assert isinstance(inputs, StagesInputs)
    assert run(["check", "--json", str(out / "chosen.toml")]) == 0
    found = {v["key"]: v["value"] for v in json.loads(capsys.readouterr().out)["values"]}
    (line,) = (c for c in candidates(out) if matches(c, inputs))
    assert float(line["k1 [N/mm]"]) == pytest.approx(found["k1"], rel=1e-4)  # axial strain
    assert float(line["U_A [mm]"]) == pytest.approx(found["U_A"], rel=1e-4)


def candidates(out):
    with (out / "candidates.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def matches(line, inputs):
    names = ("b [mm]", "L1 [mm]", "r [mm]", "alpha [deg]")
    own = (1e3 * inputs.b, 1e3 * inputs.L1, 1e3 * inputs.r, np.degrees(inputs.alpha))
    close = (abs(float(line[n]) - v) < 1e-6 for n, v in zip(names, own, strict=True))
    return int(line["n"]) == inputs.n and all(close)


def test_json_holds_the_front_and_its_finite_elements(tmp_path, capsys):
    assert run(["design", "--json", str(task(tmp_path))]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["candidates"] == 8
    assert found["passed"] is True
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


def test_an_impossible_task_ends_with_1_says_what_to_relax_and_clears_the_old_spring(
    tmp_path, capsys
):
    out = tmp_path / "out"
    out.mkdir()
    (out / "chosen.toml").write_text("an earlier one")
    assert run(["design", str(task(tmp_path, sigma='"100 MPa"')), "--out", str(out)]) == 1
    printed = capsys.readouterr().out
    assert "nothing is feasible; the nearest is n = 10" in printed
    assert re.search(r"relax sigma from 100 MPa to 29\d\.?\d* MPa", printed)
    assert sorted(p.name for p in out.iterdir()) == ["candidates.csv", "design.html"]
    page = (out / "design.html").read_text(encoding="utf-8")
    assert "No candidate keeps every limit" in page
    assert "One of these alone would admit a spring" in page
    # what is to be relaxed suffices as it is printed, rounded up
    needed = re.search(r"relax sigma from 100 MPa to (\S+ MPa)", printed)[1]
    assert run(["design", "--no-fem", str(task(tmp_path, sigma=f'"{needed}"'))]) == 0


@pytest.mark.parametrize("off", [-1e-14, 1e-14])
def test_a_bound_that_is_whole_but_for_round_off_is_printed_as_it_is(off):
    limit = Limit(
        key="room", what="", symbol="", unit="m", value=np.array([0.012 * (1 + off)]), bound=0.01,
        source="",
    )  # fmt: skip
    assert rounded(relaxation(limit, 0)) == "0.012 m"


def test_a_member_that_is_not_there_cannot_be_chosen(tmp_path, capsys):
    assert run(["design", str(task(tmp_path)), "--choose=99"]) == 2
    assert re.search(r"--choose: the front has members 1 to \d+, got ", capsys.readouterr().err)


# What finite elements decide


def test_a_spring_whose_formula_takes_the_inner_radius_disagrees():
    """3 % too stiff, three times what is allowed."""
    base = default()
    q = base.demands.model_copy(update={"arcs": "inner"})
    ranges = {"n": (10.0,), "b": (1.2e-4,), "L1": (12.9e-3,), "r": (0.6e-3,),
              "alpha": (float(np.radians(83)),)}  # fmt: skip
    found = search(type(base)("x", q, ranges))
    v = verified_by_fem(found.springs, found.formulas, 0, q)
    assert 0.02 < v.deviation < 0.05
    assert not v.agrees
    outcome = Outcome(found, [v], 0)
    assert not outcome.passed


def made(**changes):
    """A verified member, by hand."""
    from verify.studies.design.compressed import Curve

    curve = Curve(np.array([0.0, 8e-3, 9e-3]), np.array([0.0, 5.0, 5.6]), float("inf"))
    base = {"k1": 625.0, "mesh": 1e-6, "deviation": 1e-3, "curve": curve, "delta": 8e-3,
            "U_w": 8e-3, "e_max": 0.03}  # fmt: skip
    return Verified(**(base | changes))


def test_limits_of_finite_elements_hold_on_their_boundary():
    assert made(deviation=0.0099).agrees
    assert not made(deviation=-0.0101).agrees
    assert not made(mesh=0.02).agrees  # the mesh leaves it open
    assert made(delta=8e-3 / 1.0299).fits
    assert not made(delta=8e-3 / 0.9699).fits
    assert not made(delta=float("nan")).fits


def test_leaves_that_touch_before_the_working_displacement_reject_a_spring():
    early = replace(made().curve, touches=8e-3)
    assert not made(curve=early).fits
    assert made(curve=replace(early, touches=8.1e-3)).fits


def test_a_pressed_spring_needs_its_room_and_its_strength():
    """Leaves straighten and the spring grows across: what counts is its height when pressed."""
    high = replace(made().curve, height=15.1e-3)
    assert not made(curve=high, room=15e-3).fits
    assert made(curve=high, room=15.2e-3).fits
    assert not made(stress=501e6, sigma=500e6).fits
    assert made(stress=499e6, sigma=500e6).fits


def test_a_curve_that_ends_without_an_equilibrium_is_no_verdict_on_the_spring():
    """Neither fitting nor rejected for its displacement: what comes after is not known."""
    broken = replace(made().curve, U=np.array([0.0, 7e-3, 7.9e-3]), whole=False)
    v = made(curve=broken)
    assert v.unsolved
    assert not v.fits
    assert verdict(v) == "no equilibrium found beyond 7.9 mm"
    assert made(curve=broken, U_w=7.9e-3 * (1 + 1e-12)).fits
    assert verdict(made(curve=broken, delta=float("nan"), U_w=7.5e-3)).startswith("no equilibrium")
    # a spring that never bears F_w on a whole curve is rejected
    assert verdict(made(delta=float("nan"))) == "beyond ±3 %"


def test_finite_elements_see_the_height_and_stress_of_a_pressed_spring():
    """An elastica of its own gave 15.56 mm and 394.5 MPa for this spring of the template."""
    base = default()
    q = base.demands.model_copy(update={"width_factor": 1.0})
    ranges = {"n": (8.0,), "b": (1.1e-4,), "L1": (13.8e-3,), "r": (0.45e-3,),
              "alpha": (float(np.radians(78)),)}  # fmt: skip
    found = search(type(base)("x", q, ranges))
    v = verified_by_fem(found.springs, found.formulas, 0, q)
    assert v.curve.height == pytest.approx(15.56e-3, rel=5e-3)
    assert v.stress == pytest.approx(394.5e6, rel=0.01)
    assert v.too_high
