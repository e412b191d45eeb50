"""Rotors of one's own: what a file may say, what is found, and that faults turn rows red."""

import json
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.rotor import rotor_study, transfer_bending, transfer_model, transfer_torsion
from tests.conftest import solved
from tests.verify.template_text import inputs_of, whole
from verify.answers.template import template
from verify.app.cli import run
from verify.cases.registry import find
from verify.cases.rotor.system.case import SYSTEM, RotorSystem
from verify.cases.rotor.system.inputs import RPM
from verify.cases.rotor.system.reference import solve
from verify.cases.rotor.system.transfer import inertia_of
from verify.cases.rotor.system.warnings import warnings
from verify.core import units
from verify.core.case import Context
from verify.core.inputs import InputError, build
from verify.jobs.level import Job, Solved, judge_case

pytestmark = pytest.mark.xdist_group("rotor-system")
RAW = inputs_of(template(SYSTEM))


def changed(table=None, entry=1, drop=(), **values):
    """The template's inputs with an entry's values changed, or those of the top."""
    raw = json.loads(json.dumps(RAW))
    at = raw if table is None else raw[table][entry - 1]
    at.update(values)
    for key in drop:
        del at[key]
    return raw


def built(raw):
    return build(RotorSystem, raw, "r.toml")


def test_every_row_passes_and_the_case_is_registered(judged, red):
    assert not red(judged(SYSTEM))
    assert find("rotor-system") is SYSTEM


# Rotors beside the default one: the formulas against beams.


def counter_rotating():
    return built(changed("shafts", 2, ratio=-1.3))


def unlike_bearings():
    raw = changed("supports", 1, kyy="25 N/µm", kxy="8 N/µm", cyy="300 N s/m")
    raw["links"][0] |= {"k_tilt": "2e4 N m/rad", "c_tilt": "3 N m s/rad", "kyy": "20 N/µm"}
    return built(raw)


def clutched():
    raw = changed("shafts", 2, drop=["ratio"])
    raw["links"][0] |= {"k_turn": "5e3 N m/rad", "k_tilt": "2e4 N m/rad"}
    return built(raw)


@pytest.mark.parametrize("make", [counter_rotating, unlike_bearings, clutched])
def test_beams_agree_on_other_rotors(make):
    q = make()
    v, (coarse, fine) = dict(SYSTEM.analytic(q)), (solve(q, level).values for level in (1, 4))
    assert v.pop("lowest") == 2 * np.pi * v["frequency_1"]
    assert set(v) == set(fine)
    for key, value in v.items():
        loads = key in ("amplitude", "support_load", "link_load")
        assert coarse[key] == pytest.approx(value, rel=1e-2 if loads else 2e-4), key
        assert fine[key] == pytest.approx(value, rel=1e-4 if loads else 2e-5), key


def test_a_shaft_that_turns_against_the_rotor_meets_backward_whirl():
    met = counter_rotating().study.excited
    assert [set(e.modes.whirl) for e in met] == [{1}, {-1}]


def test_a_clutch_couples_the_torsion_of_both_shafts():
    """Soft, it lets both turn against each other as rigid bodies do."""
    q = clutched()
    J = [0.0, 0.0]
    for disc in q.rotor.discs:
        J[q.rotor.shaft_of[disc.node]] += disc.polar
    for k, shaft in enumerate(q.rotor.shafts):
        J[k] += sum(2 * s.rho * s.I * s.length for s in shaft.segments)
    rigid = np.sqrt(5e3 * (1 / J[0] + 1 / J[1])) / (2 * np.pi)
    found = SYSTEM.analytic(q)["torsion"]
    assert 0.9 * rigid < found < rigid  # Rayleigh: shafts that twist are slower
    assert found < 0.7 * SYSTEM.analytic(RotorSystem())["torsion"]


def test_a_campbell_diagram_takes_a_second_at_most_and_meets_the_critical_speeds():
    q = RotorSystem()
    speeds, w, whirl = q.campbell
    assert w.shape == (len(speeds), len(whirl)) == (20, 6)
    first = q.study.excited[0].speeds[0]
    gap = w[:, 0] - speeds
    k = int(np.flatnonzero(gap < 0)[0])
    assert speeds[k - 1] <= first <= speeds[k]


def test_on_unlike_bearings_a_branch_has_the_sense_that_is_told():
    _, w, whirl = unlike_bearings().campbell
    assert w.shape[1] == len(whirl) == 6
    assert set(whirl) == {1, -1}


# Faults of either side turn a row red.

FAULTS = [
    pytest.param(transfer_model, "hutchinson", lambda f: lambda **k: 0.97 * f(**k),
                 "natural frequency 4 at the speed", id="another shear coefficient"),
    pytest.param(transfer_bending, "numbers",
                 lambda f: lambda r, w, Omega: f(r, w, -np.asarray(Omega)),
                 "natural frequency 1 at the speed", id="shafts turn backwards"),
    pytest.param(transfer_bending.Bending, "length", lambda f: property(lambda self: 0.1),
                 None, id="another length for phi: no fault"),
    pytest.param(transfer_torsion, "free_turns", lambda f: lambda rotor: f(rotor) - 1,
                 "torsional frequency", id="a free turn counted"),
    pytest.param(rotor_study, "unbalance_response",
                 lambda f: lambda r, n, u, excitation: f(r, n, u, excitation=1.0),
                 "amplitude at the probe", id="unbalance turns with the first shaft"),
    pytest.param(rotor_study, "critical_speeds",
                 lambda f: lambda r, **k: f(r, **k | {"excitation": 1.0}),
                 "critical speed 1, unbalance of another speed", id="one excitation for all"),
    pytest.param(rotor_study, "critical_speeds",
                 lambda f: lambda r, **k: f(r, **k | {"whirl": "backward"}),
                 "critical speed 2, the first shaft's unbalance", id="backward critical speeds"),
]  # fmt: skip


@pytest.mark.parametrize(("owner", "name", "fault", "row"), FAULTS)
def test_a_fault_of_the_formulas_turns_its_row_red(
    owner, name, fault, row, judged, without_fault, red, monkeypatch
):
    without_fault(SYSTEM)
    monkeypatch.setattr(owner, name, fault(getattr(owner, name)))
    found = {r.quantity for r in red(judged(SYSTEM, drawn=False))}
    assert row in found if row else not found


@pytest.mark.parametrize(
    ("key", "rows"),
    [
        ("frequency_3", {"natural frequency 3 at the speed"}),
        ("critical_other_1", {"critical speed 1, unbalance of another speed"}),
        ("torsion", {"torsional frequency"}),
        ("amplitude", {"amplitude at the probe"}),
        ("support_load", {"load of the first support"}),
        ("link_load", {"load of the first link"}),
        ("sense_2", {"sense of each whirl"}),
    ],
)
def test_an_error_of_beams_turns_its_row_red(key, rows, judged, red):
    q = RotorSystem()
    size = 1.0003 if key in ("amplitude", "support_load", "link_load") else 1.00003
    size = -1.0 if key.startswith("sense") else size
    levels = [
        as_solved(replace(found, values={**found.values, key: size * found.values[key]}))
        for found in beams()
    ]
    result = judge_case(Job(SYSTEM, q, drawn=False), levels)
    found = {r.quantity for r in red(result)}
    assert rows <= found


@cache
def beams():
    return [found.result for found in solved(SYSTEM, RotorSystem())]


def as_solved(result):
    return Solved(result, "", 0.0, cached=False)


# What is refused, in one line.


@pytest.mark.parametrize(
    ("raw", "message"),
    [
        (changed("supports", 2, node=31), "inputs.supports[2].node = 31: there are nodes 1 to 14"),
        (changed("links", 1, to=15), "inputs.links[1].to = 15: there are nodes 1 to 14"),
        (changed("discs", 3, node=20), "inputs.discs[3].node = 20: there are nodes 1 to 14"),
        (changed("unbalances", 1, node=99), "inputs.unbalances[1].node = 99: there are nodes"),
        (changed("segments", 2, length="0 mm"),
         "inputs.segments[2].length = 0 mm: must be greater than 0 mm"),
        (changed("segments", 1, d_i="70 mm"),
         "inputs.segments[1].d_i = 70 mm: must be below d_o = 70 mm"),
        (changed("supports", 1, k="-1 N/µm"), "inputs.supports[1].k = -1 N/µm: must be at least 0"),
        (changed("supports", 1, kxy="70 N/µm"), "inputs.supports[1]: kxy must not exceed the root"),
        (changed("links", 1, to=5), "inputs.links[1].to = 5: joins a node with itself"),
        (changed("links", 1, k_turn="1 N m/rad"),
         "inputs.links[1].k_turn = 1 N m/rad: shafts outer and inner turn at different speeds"),
        (changed("segments", 7, shaft="middle"),
         "inputs.segments[7].shaft = middle: there is no such shaft, only outer, inner"),
        (changed("shafts", 2, name="outer"),
         "inputs.shafts[2].name = outer: two shafts have this name"),
        (changed(shafts=[*RAW["shafts"], {"name": "third"}]),
         "inputs.shafts[3]: shaft third has no segments"),
        (changed("discs", 4, drop=["width"]),
         "inputs.discs[4]: needs mass, polar and diametral, or d_o and width of a cylinder"),
        (changed("discs", 4, d_i="220 mm"), "inputs.discs[4]: needs d_i < d_o, got 220, 220 mm"),
        (changed("discs", 2, node=2), "inputs.discs[2]: overlaps discs[1] by 20 mm"),
        (changed("discs", 2, node=3, width="230 mm"), "inputs.discs[2]: overlaps discs[1] by 5 mm"),
        (changed(supports=RAW["supports"][1:], links=[]),
         "inputs: an unsupported rotor: shaft outer shifts and tilts freely in x and y"),
        (changed(segments=[]), "inputs: a rotor has at least one shaft with one segment"),
        (changed(shafts=[]), "inputs: a rotor has at least one shaft with one segment"),
        (changed(supports=RAW["supports"][:2], links=[]), "inputs: an unsupported rotor: shaft "),
        (changed(supports=[]), "inputs: an unsupported rotor: shaft "),
        (changed(supports=[], links=[]), "inputs: an unsupported rotor: no bearing holds it"),
        (changed(speed_from="9000 r/min"), "inputs: the operating speeds need speed_from < speed"),
        (changed(speed_from="9500 r/min"), "inputs: the operating speeds need speed_from < speed"),
        (changed(probe=15), "inputs: probe = 15: there are nodes 1 to 14"),
        (changed(segments=RAW["segments"] * 13), "inputs: segments have 158 nodes, at most 150"),
        (changed("shafts", 1, ratio=0.5),
         "inputs.shafts[1].ratio = 0.5: the first shaft has the ratio 1, as all speeds are its"),
        (changed("discs", 1, polar="0.0102 kg m^2"),
         "inputs.discs[1].polar = 0.0102 kg m^2: no body has more than twice its diametral "
         "moment, 0.01 kg m^2"),
        (changed("links", 1, to=3),
         "inputs.links[1].to = 3: node 5 is on shaft outer too: a link joins two shafts"),
        (changed(speed="150 mm"), 'inputs.speed: "150 mm" is not a speed of rotation'),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused_in_one_line(raw, message):
    with pytest.raises(InputError) as found:
        built(raw)
    assert str(found.value).startswith(f"r.toml: {message}")
    assert "\n" not in str(found.value)


def test_check_refuses_with_status_two(tmp_path, capsys):
    path = tmp_path / "r.toml"
    path.write_text(
        whole(template(SYSTEM)).replace(
            "[[inputs.links]]\nnode = 5 ", "[[inputs.links]]\nnode = 55"
        )
    )
    assert run(["check", str(path)]) == 2
    err = capsys.readouterr().err
    assert err == f"freewheel: {path}: inputs.links[1].node = 55: there are nodes 1 to 14\n"


# What is understood.


def test_speeds_are_taken_in_other_units():
    q = built(changed(speed="942.4777960769379 rad/s", speed_to="54000 deg/s"))
    assert q.speed == pytest.approx(9000 * RPM)
    assert q.speed_to == pytest.approx(9000 * RPM)


def test_a_cylinder_has_its_mass_and_moments_and_what_is_given_counts_instead():
    _, _, disc, _ = RotorSystem().discs
    mass, polar, diametral = inertia_of(disc)
    ring = 0.2**2 + 0.03**2
    assert mass == pytest.approx(7850 * np.pi / 4 * (0.2**2 - 0.03**2) * 0.02)
    assert polar == pytest.approx(mass * ring / 8)
    assert diametral == pytest.approx(mass * (ring / 16 + 0.02**2 / 12))
    raw = changed("discs", 3, mass="10 kg", polar="0.05 kg m^2")
    mass, polar, diametral = inertia_of(built(raw).discs[2])
    assert (mass, polar) == (10.0, 0.05)
    assert diametral == pytest.approx(10 * (ring / 16 + 0.02**2 / 12))
    assert solve(built(raw), 1).values["frequency_3"] == pytest.approx(
        SYSTEM.analytic(built(raw))["frequency_3"], rel=2e-4
    )


def test_places_follow_from_each_shaft_s_start():
    q = RotorSystem()
    assert q.places[:5] == pytest.approx([0.16, 0.22, 0.34, 0.46, 0.52])
    assert q.places[5:8] == pytest.approx([0.0, 0.06, 0.16])
    assert q.places[4] == pytest.approx(q.places[10])  # the bearing between the shafts


# What is told.


def told(raw):
    q = built(raw)
    v = SYSTEM.analytic(q)
    return q, SYSTEM.findings(q, v), SYSTEM.summary(q, v), SYSTEM.warnings(q, v)


def test_the_verdict_comes_first_and_the_nearest_critical_speeds_follow():
    q, found, summary, warned = told(RAW)
    below, above = (q.study.excited[k].speeds[j] / RPM for k, j in ((0, 0), (1, 1)))
    assert found[0] == "clear: no critical speed within 15% of 5600 to 9000 r/min"
    assert f"critical at {below:.5g} r/min (unbalance of outer, forward): " in found[1]
    assert f"{1 - below / 5600:.1%} below them" in found[1]
    assert f"critical at {above:.5g} r/min (unbalance of inner, forward): " in found[2]
    assert f"{above / 9000 - 1:.1%} above them" in found[2]
    assert summary["verdict"] == "clear"
    assert not warned


def test_a_critical_speed_too_near_is_not_clear():
    q, found, summary, _ = told(changed(margin=0.25))
    assert found[0] == "not clear: 2 critical speeds within 25% of 5600 to 9000 r/min"
    assert summary["verdict"] == "not clear"
    _, found, _, _ = told(changed(speed_from="4000 r/min"))
    assert found[0].startswith("not clear: 1 critical speed within")
    assert found[1].endswith("among the operating speeds")
    distances = {round(c["speed"]): c["distance"] for c in summary["critical_speeds"]}
    first = q.study.excited[0].speeds[0] / RPM
    assert distances[round(first)] == pytest.approx(first / 5600 - 1)


def test_warnings_say_what_is_odd():
    *_, warned = told(changed("shafts", 1, start="150 mm"))
    assert warned == ("links[1] joins nodes 10 mm apart along the axis: set the shafts' start",)
    raw = changed(links=[RAW["links"][0] | {"c": "0 N s/m"}])
    raw["supports"] = [s | {"c": "0 N s/m"} for s in raw["supports"]]
    assert any("no bearing is damped" in w for w in told(raw)[3])
    assert any("steps by half" in w for w in told(changed("segments", 3, d_o="120 mm"))[3])
    narrow = changed("segments", 4, length="5 mm", d_o="65 mm")
    assert any("no beam there" in w for w in told(narrow)[3])
    assert any("is not among the operating" in w for w in told(changed(speed="100 r/min"))[3])


def test_shafts_that_pass_through_each_other_are_told():
    """The tube's bore is 50 mm; segment 7 of the core lies in its first two segments."""
    (warned,) = told(changed("segments", 7, d_o="52 mm"))[3]
    assert warned == (
        "shafts pass through each other: segments[7], d_o = 52 mm, in the bore of segments[1], "
        "d_i = 50 mm, over 60 mm; segments[7], d_o = 52 mm, in the bore of segments[2], "
        "d_i = 50 mm, over 60 mm"
    )
    assert not told(changed("segments", 7, d_o="50 mm"))[3]  # fits


def test_damping_that_holds_a_shaft_is_told():
    """Half of 60 N/µm over 9000 r/min is 31.8 kN s/m."""
    assert not told(changed("supports", 1, c="31.7 kN s/m"))[3]
    for name in ("c", "cyy"):
        (warned,) = told(changed("supports", 1, **{name: "32 kN s/m"}))[3]
        assert warned.startswith("supports[1]: damping times the highest operating speed is above")


def test_short_segments_of_one_diameter_are_judged_together():
    short = changed("segments", 1, length="3 mm")["segments"][0]
    cut = [short] * 20 + RAW["segments"][1:4]  # 60 mm again
    alone = {"shafts": RAW["shafts"][:1], "discs": [], "links": [], "unbalances": [], "probe": 1,
             "supports": [{"node": 1, "k": "60 N/µm"}, {"node": 24, "k": "60 N/µm"}]}  # fmt: skip
    assert not list(warnings(built(changed(**alone, segments=cut))))
    cut[:9] = [short | {"d_o": f"{70 + k} mm"} for k in range(9)]
    (warned,) = warnings(built(changed(**alone, segments=cut)))
    assert warned == (
        "segments[1], segments[2], segments[3], segments[4] and 5 more are shorter than a tenth "
        "of the diameter: no beam there"
    )


def test_check_prints_findings_and_json_has_every_entry(tmp_path, capsys):
    path = tmp_path / "r.toml"
    path.write_text(whole(template(SYSTEM)))
    assert run(["check", str(path)]) == 0
    assert "clear: no critical speed within" in capsys.readouterr().out
    assert run(["check", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["inputs"]["segments"][3]["d_o"] == {"value": 60.0, "unit": "mm"}
    assert found["inputs"]["supports"][0]["node"] == {"value": 1, "unit": "1"}
    assert found["details"]["verdict"] == "clear"
    speeds = [c["speed"] for c in found["details"]["critical_speeds"]]
    assert speeds == sorted(speeds)
    by_key = {v["key"]: v["value"] for v in found["values"]}
    assert by_key["critical_first_1"] in speeds


def test_figures_are_made_without_beams(judged):
    q = unlike_bearings()
    figures = SYSTEM.figures(Context(SYSTEM.id, q, SYSTEM.analytic(q), (), is_paper=False))
    assert [type(f).__name__ for f in figures] == ["Campbell", "Whirl", "Curves"]
    assert list(figures[0].whirl) == [int(sense) for sense in q.study.modes.whirl]
    for mode in figures[1].modes:
        assert len(mode.lines) == 2


def test_a_rotor_without_links_or_unbalances_has_fewer_rows(red):
    raw = changed(shafts=[{"name": "outer"}], links=[], unbalances=[], discs=RAW["discs"][:2],
                  segments=RAW["segments"][:4], probe=1)  # fmt: skip
    raw["supports"] = [{"node": 1, "k": "60 N/µm"}, {"node": 5, "k": "60 N/µm"}]
    q = built(raw)
    result = judge_case(Job(SYSTEM, q), [as_solved(solve(q, n)) for n in SYSTEM.levels])
    assert not red(result)
    quantities = {row.quantity for row in result.rows}
    assert "critical speed 1, the first shaft's unbalance" in quantities
    assert not {"amplitude at the probe", "load of the first link"} & quantities


def test_a_shaft_that_stands_still_meets_no_critical_speed():
    q = built(changed("shafts", 2, ratio=0.0))
    v = SYSTEM.analytic(q)
    assert [e.shafts for e in q.study.excited] == [("outer",)]
    assert not [key for key in v if key.startswith("critical_other")]
    assert "amplitude" in v


def test_axes_of_the_speed_reach_the_nearest_critical_speed_above():
    """And a fifth beyond the highest speed asked for, where that is further."""
    q = RotorSystem()
    above = min(w for e in q.study.excited for w in e.speeds if w > q.speed_to)
    assert q.speed_axis == pytest.approx(max(1.1 * above, 1.2 * q.speed_to))
    far = built(changed(speed_to="6000 r/min", speed="6000 r/min"))
    assert far.speed_axis == pytest.approx(1.1 * above)
    assert far.campbell[0][-1] == far.speed_axis


def test_bearings_stand_at_their_shaft_s_radius_and_links_are_drawn():
    drawn = SYSTEM.sketch(RotorSystem()).shapes
    numbers = {s.label: s.points[0] for s in drawn if s.style == "text"}
    closed = [s.points for s in drawn if s.style == "body"]
    triangles = [p for p in closed if len(p) == 3]
    assert set(numbers) == {"1", "6", "14"}
    length = 0.8  # of the inner shaft, the longer one
    tops = [p[0] for p in triangles]
    scale = length / 6 / 0.035  # the largest radius is drawn as a sixth of it
    expected = [(0.16, 0.035), (0.0, 0.015), (0.8, 0.015)]
    assert tops == [pytest.approx((z, -scale * r)) for z, r in expected]
    for number, triangle in zip(numbers.values(), triangles, strict=True):
        assert number[1] < triangle[:, 1].min() - 0.02 * length
    (diamond,) = (p for p in closed if len(p) == 4 and p[0, 1] < 0)
    assert diamond[:, 0].mean() == pytest.approx(0.52)


def test_units_of_a_rotor_are_known():
    assert units.parse("1 MN/m", "N/µm") == pytest.approx(1e6)
    assert units.parse("1 oz in", "g mm") == pytest.approx(0.45359237 / 16 * 0.0254)
