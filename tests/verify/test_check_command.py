"""`check` on files: first lines, exit status, JSON by its schema, a report."""

import json
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest

import verify.answers
from tests.verify.ring_file import RING
from tests.verify.template_text import whole
from verify.answers.answer import EXIT_STATUS, Verdict
from verify.answers.evidence import with_rows
from verify.answers.registry import answer
from verify.answers.template import run_init
from verify.app.check_command import exit_status
from verify.app.check_console import Checked, print_check
from verify.app.cli import run
from verify.cases.registry import CASES
from verify.core.results import Status

SCHEMA = json.loads((Path(verify.answers.__file__).parent / "check.schema.json").read_text("utf-8"))
ROLLER = Path(__file__).parent / "parts" / "roller-clutch-31.toml"


@pytest.fixture
def ring(tmp_path):
    path = tmp_path / "ring.toml"
    path.write_text(RING, "utf-8")
    return path


def written(tmp_path, case, old="", new=""):
    """A template of the case with a value replaced."""
    path = tmp_path / f"{case}.toml"
    path.unlink(missing_ok=True)
    run_init(case, path)
    text = whole(path.read_text("utf-8"))
    assert old in text
    path.write_text(text.replace(old, new) if old else text, "utf-8")
    return path


def checked(path, *options, capsys):
    capsys.readouterr()
    status = run(["check", *options, str(path)])
    return status, capsys.readouterr().out


def as_json(path, *options, capsys):
    status, out = checked(path, "--json", *options, capsys=capsys)
    return status, json.loads(out)


SLOW = ("sprag-clutch", "polyhedral-clutch", "sprag-optimum")  # seconds of formulas alone


@pytest.mark.parametrize(
    "case",
    [pytest.param(c.id, id=c.id, marks=pytest.mark.soak if c.id in SLOW else ()) for c in CASES],
)
def test_a_template_is_answered_in_json_by_its_schema(case, tmp_path, capsys):
    path = tmp_path / "my.toml"
    assert run(["init", case, "--out", str(path)]) == 0
    status, record = as_json(path, capsys=capsys)
    jsonschema.validate(record, SCHEMA)
    assert status == EXIT_STATUS[record["answer"]["verdict"]]
    assert record["values"]


def test_the_answer_comes_first(tmp_path, capsys):
    path = written(tmp_path, "polyhedral-clutch", 'M_t = "100 N m"', 'M_t = "80 N m"')
    assert run(["check", "--keys", "polyhedral-map"]) == 0
    assert {"K_mid_3", "delta_1"} <= set(capsys.readouterr().out.split())
    status, out = checked(path, capsys=capsys)
    first, design, margin, *rest = out.splitlines()
    assert (status, first) == (0, "my polyhedral-clutch: holds")
    assert design.startswith("  design value: M_el = 90.5 N m")
    assert margin.startswith("  margin: 1.06, limited by hoop stress in the fillets")
    heads = [x.split(":")[0].split(" by ")[0] for x in rest if not x.startswith(("  ", "("))]
    shared = "assumptions that formula and reference share"
    verdicts = "verdicts of the formulas (freewheel explain EQUATION prints the evidence)"
    assert [h for h in heads if h != "warning"] == ["limits", "values", verdicts, "inputs", shared]
    # the printed target lies between the torques in plane strain and plane stress
    status, out = checked(written(tmp_path, "polyhedral-clutch"), capsys=capsys)
    assert status == 3
    words = "between the torques in plane strain (90.5 N m) and plane stress (115.2 N m)"
    assert words in out.splitlines()[0]
    # that the part fails within the range of an assumed input is stated
    status, out = checked(ROLLER, capsys=capsys)
    assert status == 0
    assert "μ = 0.06 to 0.12: -25 % (fails) to +50 %" in out
    assert "(assumed)" in out.splitlines()[2]


def test_a_ring_of_60_and_90_mm_by_hand(ring, capsys):
    """Boundary stresses (r_o² + r_i²)/(r_o² - r_i²) p = 2.6 p and 1.6 p: 260 and 160 MPa."""
    ring.write_text(RING + 'R_p = "200 MPa"\n', "utf-8")
    status, found = as_json(ring, capsys=capsys)
    values = {v["key"]: v["value"] for v in found["values"]}
    assert status == 1
    assert values["hoop_bore"] == pytest.approx(260.0, rel=1e-12)
    assert values["hoop_rim"] == pytest.approx(160.0, rel=1e-12)
    # u(r_i) = r_i/E (2.6 p + nu p), plane stress, in µm
    assert values["u_bore"] == pytest.approx(60e3 / 210e3 * (260 + 0.3 * 100), rel=1e-12)
    assert found["inputs"]["p_o"] == {"value": 0.0, "unit": "MPa"}  # left out: no pressure
    # Tresca at the bore, hoop less radial: 260 + 100 MPa
    assert "Tresca stress 360 MPa at the bore exceeds R_p = 200 MPa" in found["warnings"][0]
    ring.write_text(RING.replace("nu = 0.3", "nu = 0.05"))
    _, out = checked(ring, capsys=capsys)
    assert "  outside the usual range: nu" in out.splitlines()[:5]
    assert "warning: nu = 0.05 is outside the usual range 0.2 to 0.36" in out


def test_user_parameters_are_judged_with_finite_elements(ring, tmp_path, capsys):
    status, found = as_json(ring, "--fem", capsys=capsys)
    assert status == 0
    assert {row["status"] for row in found["rows"]} == {"PASS"}
    assert all(row["fem"] is not None for row in found["rows"] if row["kind"] == "identity")
    assert not any(
        row["published"] for row in found["rows"]
    )  # these are about the inputs of the paper
    # more cells than memory holds are refused in a line
    path = written(tmp_path, "spring-continuum", "n = 10 ", "n = 90 ")
    assert checked(path, capsys=capsys)[0] == 0  # formulas for any length
    assert run(["check", "--fem", str(path)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "unknowns, more than 1,000,000" in line


def test_a_failed_row_is_named_once_and_leaves_the_part_undecided(of_paper, capsys):
    case = CASES[0]
    result = replace(of_paper(case), name="mine", warnings=("it yields",), findings=("so",))
    of = answer(case, case.inputs(), case.analytic(case.inputs()))

    def printed(rows):
        shown = replace(result, rows=rows)
        print_check(Checked(case=case, result=shown, answer=of, used_fem=True))
        return capsys.readouterr().out.splitlines()

    lines = printed(result.rows)
    at = lines.index("warning: it yields")
    assert (lines[0], *lines[at + 1 : at + 3]) == ("mine: holds", "notes", "  so")
    orders = sum(row.quantity.endswith(": convergence") for row in result.rows)
    n = len(result.rows) - orders
    assert lines[-3] == f"{n} of {n} comparisons pass; {orders} of {orders} convergence rows pass"
    good, convergence, *_ = result.rows
    bad = replace(convergence, status=Status.FAIL, reason="grows")
    failed = [line for line in printed((good, bad)) if "grows" in line]
    assert failed == [f"FAIL {bad.quantity}: grows"]  # once
    undecided = with_rows(of, [bad])
    assert undecided.verdict is Verdict.CANNOT_SAY
    failed = replace(result, rows=(bad,))
    assert exit_status(Checked(case=case, result=failed, answer=undecided, used_fem=True)) == 1
