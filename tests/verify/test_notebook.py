"""Calls from Python: the answers of the command line, displayed as tables and drawings."""

import base64
import math
import re
import shutil
import sys
import types
from dataclasses import replace
from html import unescape
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

import verify
from reports.notebook import table
from verify.answers.answer import Verdict
from verify.app.cli import run
from verify.app.notebook import Run
from verify.core.results import Status

TEMPLATES = Path(__file__).parents[2] / "verify" / "app" / "templates"


def cells(html):
    """Texts of the cells, line by line."""
    lines = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", line) for line in html.split("<tr>")[1:]]
    return [[unescape(text) for text in line] for line in lines]


@pytest.fixture(scope="module")
def judged():
    return verify.run("ring-rotation")


def test_a_run_is_a_table_of_its_rows(judged):
    header, *lines = cells(judged._repr_html_())
    assert header[2:4] == ["formula", "FE"]
    assert lines[0][:5] == ["PASS", "bore growth, plane stress", "0.0463354", "0.0463354", "µm"]
    compared = [row for row in judged.rows if not row.quantity.endswith(": convergence")]
    assert [line[1] for line in lines] == [row.quantity for row in compared]
    assert judged.passed
    assert "16 of 17 comparisons pass" in judged._repr_html_()
    assert "bore growth, plane stress" in str(judged)


def test_a_run_and_a_part_are_one_line_with_the_main_number(judged):
    start = "<Run ring-rotation: PASS, 28 of 29 rows pass; bore growth, plane stress: PASS, "
    assert repr(judged).startswith(start)
    assert repr(judged).endswith(" µm>")
    part = verify.check("freewheel-clutch", {"T": "500 N m"})
    name = "my freewheel-clutch (freewheel-clutch)"
    assert repr(part) == f"<Part {name}: fails, margin {part.margin:.3g}>"


def test_the_line_of_a_run_has_its_first_failure_or_its_first_compared_row(judged):
    row = next(row for row in judged.rows if row.difference is not None)
    cited = replace(row, quantity="cited", analytic=None, fem=None)
    compared = replace(row, quantity="b", unit="µm", difference=2e-3)
    failed = replace(row, quantity="c", status=Status.FAIL, unit="1", difference=-1e-3)
    skipped = replace(failed, quantity="d", status=Status.SKIP, difference=None)
    for rows, line in (
        ((cited, compared), "PASS, 2 of 2 rows pass; b: PASS, difference 0.002 µm"),
        ((compared, failed, skipped), "FAIL, 1 of 3 rows pass; c: FAIL, difference -0.001"),
        ((compared, skipped), "FAIL, 1 of 2 rows pass; d: SKIP"),
        ((cited,), "PASS, 1 of 1 rows pass"),
    ):
        found = repr(Run(replace(judged.result, rows=rows)))
        assert found == f"<Run ring-rotation: {line}>"


def test_the_line_of_a_part_without_limits_has_no_margin():
    part = verify.check("rotor-clutch")
    assert part.margin is None
    assert repr(part) == "<Part my rotor-clutch (rotor-clutch): cannot say>"


def test_its_table_has_the_values_of_the_rows_as_plain_ones(judged):
    assert len(judged.table) == len(judged.rows)
    for line, row in zip(judged.table, judged.rows, strict=True):
        assert (line["quantity"], line["analytic"], line["fem"]) == (
            row.quantity, row.analytic, row.fem,
        )  # fmt: skip
        assert {type(value) for value in line.values()} <= {str, float, int, bool, type(None)}
    first = judged.table[0]
    assert (first["status"], first["unit"]) == ("PASS", "µm")
    assert first["analytic"] == pytest.approx(0.0463354, rel=1e-5)
    assert first["difference"] == pytest.approx(first["analytic"] / first["fem"] - 1, rel=1e-5)


def test_a_table_is_a_dataframe_where_pandas_is_installed(judged, monkeypatch):
    made = types.SimpleNamespace(DataFrame=lambda table: ("frame", table))
    monkeypatch.setitem(sys.modules, "pandas", made)
    assert judged.to_dataframe() == ("frame", judged.table)
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match=r"requires pandas: install pandas, or use \.table"):
        judged.to_dataframe()


def test_the_table_of_a_part_has_its_criteria_in_si():
    part = verify.check("freewheel-clutch", {"T": "500 N m"})
    worst = min(part.table, key=lambda line: line["margin"])
    assert worst["margin"] == pytest.approx(part.margin)
    assert not worst["met"]
    for line in part.table:
        above, below = line["limit"], line["value"]
        if line["minimum"]:
            above, below = below, above
        assert line["margin"] == (pytest.approx(above / below) if below > 0 else math.inf)


def test_its_drawings_are_images_that_stand_alone(judged):
    titles = [one.title for one in judged.drawings]
    assert titles[-1] == "Convergence"
    assert "Growth of the bore over speed" in titles
    html = judged.drawings._repr_html_()
    images = re.findall(r'src="data:image/svg\+xml;base64,([^"]+)"', html)
    assert len(images) == len(titles)
    for image in images:
        svg = base64.b64decode(image).decode()
        assert ET.fromstring(svg).tag.endswith("svg")
        assert "<style>" in svg  # an image does not know the style of a page
        assert "var(--" not in svg


def test_a_part_is_checked_as_on_the_command_line(capsys):
    part = verify.check("freewheel-clutch", {"T": "30 N m"})
    assert part.verdict == "holds"
    assert part.verdict is Verdict.HOLDS
    run(["init", "freewheel-clutch"])
    text = re.sub(r'^T = "[^"]*"', 'T = "30 N m"', capsys.readouterr().out, flags=re.MULTILINE)
    Path("clutch.toml").write_text(text, "utf-8")
    run(["check", "clutch.toml"])
    printed = capsys.readouterr().out.splitlines()
    assert str(part).splitlines() == printed[: len(str(part).splitlines())]
    by_file = verify.check("clutch.toml")
    assert (by_file.margin, by_file.values) == (part.margin, part.values)
    assert part.values["alpha"] == pytest.approx(0.0676, abs=5e-4)  # rad


def test_a_part_is_displayed_as_its_answer_and_limits():
    part = verify.check("freewheel-clutch", {"T": "500 N m"})
    html = part._repr_html_()
    assert html.startswith("<p><b>my freewheel-clutch: fails")
    assert cells(html)[0][1:5] == ["criterion", "value", "limit", "margin"]
    assert any(line[0] == "NOT MET" for line in cells(html))
    assert "by finite elements" not in html


def test_warnings_are_displayed():
    part = verify.check("spring-accordion", {"F": "5 N", "R_p": "1200 MPa"})
    assert "3 warnings" in str(part)
    assert part._repr_html_().count("warning: ") == 3


def test_a_case_file_is_run_with_other_inputs_and_a_wrong_formula_fails(monkeypatch):
    monkeypatch.syspath_prepend(str(Path.cwd()))
    shutil.copy(TEMPLATES / "shaft.py", "run_shaft.py")
    right = verify.run("run_shaft.py", {"d_o": "80 mm"})
    assert right.passed
    assert right.rows[0].analytic == pytest.approx(1015.56, rel=1e-5)  # 4/3 of that of 60 mm
    text = Path("run_shaft.py").read_text("utf-8").replace("return pi *", "return 1.02 * pi *")
    Path("wrong_shaft.py").write_text(text, "utf-8")
    wrong = verify.run("wrong_shaft.py")
    assert not wrong.passed
    assert cells(wrong._repr_html_())[1][:2] == ["FAIL", "first bending frequency, Eq. 1"]
    assert "FAIL first bending frequency" in wrong._repr_html_()


def test_with_fem_the_rows_stand_below_the_limits():
    part = verify.check("ring-rotation", fem=True)
    assert part.verdict is Verdict.HOLDS
    assert "formulas against finite elements" in part._repr_html_()
    assert len(part.rows) > 10


@pytest.mark.parametrize(
    ("call", "message"),
    [(lambda: verify.run("nosuch"), "unknown case 'nosuch'"),
     (lambda: verify.check("nosuch.toml"), "nosuch.toml: cannot be read"),
     (lambda: verify.check("freewheel-clutch", {"T": "30 kg"}), "inputs.T: .* is not a torque"),
     (lambda: verify.check("any.toml", {"T": "1 N m"}), "inputs must not be given for a "
                                                        "parameter file")],
)  # fmt: skip
def test_what_is_wrong_is_one_line(call, message):
    with pytest.raises(ValueError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)


def test_text_of_cells_is_escaped():
    assert '<td style="text-align: left">a &lt; b</td>' in table(("x",), [("a < b",)])


def test_nothing_of_a_notebook_is_imported():
    assert "IPython" not in sys.modules
    with pytest.raises(AttributeError, match="no attribute 'sweep'"):
        verify.sweep  # noqa: B018


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
