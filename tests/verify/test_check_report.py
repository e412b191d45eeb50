"""A report on one's own parameters, from a file whose name and texts are not harmless."""

import json
from pathlib import Path

import pytest

from verify.app.cli import run

RING = """
case = "ring-lame"
name = "<script>alert(1)</script> & \\"my\\" ring"
[inputs]
r_i = "30 mm"
r_o = "45 mm"
p_i = "90 MPa"
E = "210 GPa"
nu = 0.3
"""


@pytest.fixture
def ring(tmp_path) -> Path:
    path = tmp_path / "<script>alert(1)<script>.toml"
    path.write_text(RING, "utf-8")
    return path


def test_a_file_named_script_stays_text(ring, tmp_path, capsys):
    assert run(["check", str(ring), "--out", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().out
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert f"report: {tmp_path / 'out' / 'report.html'}" in said
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt; &amp; &#34;my&#34; ring</h1>" in page
    assert "freewheel check &#39;&lt;script&gt;alert(1)&lt;script&gt;.toml&#39;" in page
    results = json.loads((tmp_path / "out" / "results.json").read_text("utf-8"))
    assert results["rows"] == []  # formulas alone judge nothing
    assert (tmp_path / "out" / "report.pdf").read_bytes().startswith(b"%PDF")


def test_with_finite_elements_it_is_judged(ring, tmp_path):
    assert run(["check", "--fem", str(ring), "--out", str(tmp_path / "out"), "--jobs", "1"]) == 0
    results = json.loads((tmp_path / "out" / "results.json").read_text("utf-8"))
    assert {row["status"] for row in results["rows"]} == {"PASS"}
    assert "<svg" in (tmp_path / "out" / "report.html").read_text("utf-8")


def test_json_stays_alone_on_standard_output(ring, tmp_path, capsys):
    assert run(["check", "--json", str(ring), "--out", str(tmp_path / "out")]) == 0
    assert json.loads(capsys.readouterr().out)["case"] == "ring-lame"


@pytest.mark.parametrize("place", ["file", "file/below"])
def test_a_file_in_the_place_of_the_folder_is_found_before_the_work(ring, tmp_path, capsys, place):
    (tmp_path / "file").write_text("")
    assert run(["check", str(ring), "--out", str(tmp_path / place)]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert f"{tmp_path / 'file'}: is a file, expected a folder" in said
