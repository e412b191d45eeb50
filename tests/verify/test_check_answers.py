"""`check` on files: the first lines, the exit status, JSON by its schema."""

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest

import verify.answers
from tests.verify.template_text import whole
from verify.answers.answer import Verdict
from verify.answers.evidence import with_rows
from verify.answers.registry import answer
from verify.answers.template import run_init
from verify.app.check_command import exit_status
from verify.app.check_console import Checked
from verify.app.cli import run
from verify.cases.registry import CASES, find
from verify.core.results import Status

SCHEMA = json.loads((Path(verify.answers.__file__).parent / "check.schema.json").read_text("utf-8"))


ROLLER = (Path(__file__).parent / "parts" / "roller-clutch-31.toml").read_text("utf-8")


def written(tmp_path, case, replaced=None, removed=()):
    """A template of the case with values replaced, lines of some inputs removed."""
    path = tmp_path / f"{case}.toml"
    run_init(case, path)
    text = whole(path.read_text("utf-8"))
    for old, new in (replaced or {}).items():
        assert old in text, old
        text = text.replace(old, new)
    lines = [x for x in text.splitlines() if not x.startswith(tuple(f"{k} " for k in removed))]
    path.write_text("\n".join(lines), "utf-8")
    return path


def checked(path, *options, capsys):
    capsys.readouterr()
    status = run(["check", *options, str(path)])
    return status, capsys.readouterr().out


@pytest.mark.parametrize("case", [case.id for case in CASES])
def test_json_meets_its_schema_and_the_status_its_verdict(case, tmp_path, capsys):
    status, out = checked(written(tmp_path, case), "--json", capsys=capsys)
    record = json.loads(out)
    jsonschema.validate(record, SCHEMA)
    assert status == {"holds": 0, "fails": 1, "cannot say": 3}[record["answer"]["verdict"]]


def test_the_answer_comes_first(tmp_path, capsys):
    path = written(tmp_path, "polyhedral-clutch", {'M_t = "100 N m"': 'M_t = "80 N m"'})
    status, out = checked(path, capsys=capsys)
    first, design, margin, *rest = out.splitlines()
    assert status == 0
    assert first == "my polyhedral-clutch: holds"
    assert design.startswith("  design value: M_el = 90.5 N m")
    assert margin.startswith("  margin: 1.06, limited by hoop stress in the fillets")
    heads = [x.split(":")[0].split(" by ")[0] for x in rest if not x.startswith(("  ", "("))]
    shared = "assumptions that formula and reference share"
    assert [h for h in heads if h != "warning"] == ["limits", "values", "inputs", shared]


def test_a_target_between_plane_stress_and_plane_strain_is_not_decided(tmp_path, capsys):
    status, out = checked(written(tmp_path, "polyhedral-clutch"), capsys=capsys)
    assert status == 3
    assert (
        "between the torques in plane strain (90.5 N m) and plane stress (115.2 N m)"
        in out.splitlines()[0]
    )


def test_a_sprag_without_a_crown_is_not_decided(tmp_path, capsys):
    status, out = checked(written(tmp_path, "sprag-clutch", removed=("z_m",)), capsys=capsys)
    assert status == 0  # a crown is assumed
    path = tmp_path / "flat.toml"
    text = (tmp_path / "sprag-clutch.toml").read_text("utf-8")
    path.write_text(text + '\nz_m = "0 mm"\n', "utf-8")
    status, out = checked(path, capsys=capsys)
    assert status == 3
    assert "grows with the number of slices" in out.splitlines()[0]


def test_where_the_part_fails_in_the_range_of_an_assumed_input_it_is_stated(tmp_path, capsys):
    path = tmp_path / "roller.toml"
    path.write_text(ROLLER, "utf-8")
    status, out = checked(path, capsys=capsys)
    assert status == 0
    assert "μ = 0.06 to 0.12: -25% (fails) to +50%" in out
    assert "(assumed)" in out.splitlines()[2]


def test_a_ring_without_enough_pressure_fails_with_the_pressure_it_needs(tmp_path, capsys):
    path = written(tmp_path, "polyhedral-clutch", {'p_t = "30 MPa"': 'p_t = "10 MPa"'})
    status, out = checked(path, capsys=capsys)
    assert status == 1
    assert out.splitlines()[0] == (
        "my polyhedral-clutch: fails: p_t = 10 MPa does not reach the rollers: needs p_1r = "
        "20.26 MPa, and 28.78 MPa for the target torque"
    )


@pytest.mark.parametrize("case", ["freewheel-clutch", "sprag-clutch"])
def test_a_limit_that_is_left_out_is_that_of_the_standard(case, tmp_path, capsys):
    torque = {"freewheel-clutch": 'T = "26 N m"', "sprag-clutch": 'T = "25 N m"'}[case]
    path = written(tmp_path, case, {torque: 'T = "95 N m"'}, removed=("p_lim",))
    _, out = checked(path, "--json", capsys=capsys)
    limits = {c["limit"]: c for c in json.loads(out)["answer"]["criteria"] if c["assumed"]}
    assert "ISO 76" in limits[4000.0]["source"]


def test_a_roller_clutch_beyond_the_standard_fails_without_p_lim(tmp_path, capsys):
    path = written(tmp_path, "freewheel-clutch",
                   {'T = "26 N m"': 'T = "105 N m"', 'L = "10 mm"': 'L = "4 mm"',
                    "mu = 0.08": "mu = 0.15"}, removed=("p_lim",))  # fmt: skip
    status, out = checked(path, "--json", capsys=capsys)
    answer = json.loads(out)["answer"]
    pressure = next(c for c in answer["criteria"] if c["key"] == "contact_pressure")
    assert pressure["value"] > 4000.0
    assert (status, answer["verdict"], pressure["is_met"]) == (1, "fails", False)


def test_the_accordion_spring_recommends_one_stiffness(tmp_path, capsys):
    path = written(tmp_path, "spring-accordion")
    status, out = checked(path, capsys=capsys)
    assert status == 3
    assert "  design value: k = 0.6377 N/mm" in out.splitlines()[1]
    with path.open("a", encoding="utf-8") as file:
        file.write('\nF = "5 N"\n')
    status, out = checked(path, capsys=capsys)
    assert status == 0
    assert "limited by" in out


def test_the_curve_has_a_force_at_its_stroke(tmp_path, capsys):
    path = written(tmp_path, "spring-curve", {'stroke = "17 mm"': 'stroke = "14 mm"'})
    _, out = checked(path, "--json", capsys=capsys)
    design = json.loads(out)["answer"]["design"]
    k_1, U_A, k_2 = 0.640717, 13.4413, 0.760666
    assert design["key"] == "force_at_stroke"
    assert design["value"] == pytest.approx(k_1 * U_A + k_2 * (14 - U_A), rel=1e-4)


def test_unusual_inputs_are_named_in_the_first_lines(tmp_path, capsys):
    path = written(tmp_path, "ring-lame", {"nu = 0.3": "nu = 0.05"})
    _, out = checked(path, capsys=capsys)
    assert "  outside the usual range: nu" in out.splitlines()[:5]
    assert "warning: nu = 0.05 is outside the usual range 0.2 to 0.36" in out


@pytest.mark.parametrize("named", ["file", "case"])
def test_keys_lists_inputs_and_values(named, tmp_path, capsys):
    path = written(tmp_path, "polyhedral-map")
    status, out = checked(path if named == "file" else "polyhedral-map", "--keys", capsys=capsys)
    assert status == 0
    assert "  K_mid_3 " in out
    assert "  delta_1 " in out


def test_a_failed_row_ends_with_one_and_leaves_the_part_undecided(tmp_path, capsys, judged):
    case = find("ring-lame")
    result = judged(case)
    failed = replace(result.rows[0], status=Status.FAIL, reason="far")
    inputs = case.inputs()
    found = with_rows(answer(case, inputs, case.analytic(inputs)), [failed])
    assert found.verdict is Verdict.CANNOT_SAY
    checked = Checked(
        case=case, result=replace(result, rows=(failed,)), answer=found, used_fem=True
    )
    assert exit_status(checked) == 1


def test_finite_elements_stand_beside_the_design_value(tmp_path, capsys):
    status, out = checked(written(tmp_path, "ring-lame"), "--fem", capsys=capsys)
    assert status == 0
    assert out.splitlines()[3].startswith("  finite elements: 22.71 µm; the formula differs by ")


def test_keys_of_an_unknown_case_or_file_get_one_line(tmp_path, capsys):
    for named, words in (("nosuch", "unknown case"), (tmp_path / "no.toml", "No such file")):
        assert run(["check", "--keys", str(named)]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        assert words in line


def test_a_thin_outer_ring_of_a_roller_clutch_fails(tmp_path, capsys):
    """Ten forces of some 7.6 kN on a wall of 2 mm: bending near 1200 MPa by a curved beam."""
    path = tmp_path / "thin.toml"
    path.write_text(ROLLER + '\nR_a = "33 mm"\nmu = 0.12\n', "utf-8")
    status, out = checked(path, "--json", capsys=capsys)
    found = {c["key"]: c for c in json.loads(out)["answer"]["criteria"]}
    assert status == 1
    assert found["hoop_stress_ring"]["value"] > 1000
    assert not found["hoop_stress_ring"]["is_met"]
