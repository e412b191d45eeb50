"""Wrong and odd input files: one clear line with the place and the value, exit status 2."""

import pytest

from verify.app.cli import run

RING = """case = "ring-lame"
[inputs]
r_i = "60 mm"
r_o = "90 mm"
p_i = "100 MPa"
E = "210 GPa"
nu = 0.3
"""
CLUTCH = """case = "freewheel-clutch"
[inputs]
R = "16.5 mm"
r = "2.5 mm"
X = "11.39565 mm"
R_a = "21 mm"
r_b = "7.5 mm"
z = 8
L = "10 mm"
T = "26 N m"
F_ax = "600 N"
mu = 0.08
E = "206 GPa"
nu = 0.3
"""
ROTOR = """case = "rotor-system"
[inputs]
speed_from = "1000 r/min"
speed_to = "2000 r/min"
margin = 0.15
speed = "1500 r/min"
probe = 1
shafts = [{name = "a"}]
segments = [{shaft = "a", length = "100 mm", d_o = "50 mm"}]
supports = [{node = 1, k = "60 N/µm"}, {node = 2, k = "60 N/µm"}]
"""
BASE = {"ring": RING, "clutch": CLUTCH, "rotor": ROTOR}

# base, old text, new text, words of the line that the user reads
FILES = [
    ("ring", 'r_i = "60 mm"', "r_i = 60", ("inputs.r_i", "no unit")),
    ("ring", 'r_i = "60 mm"', 'r_i = "60"', ("inputs.r_i", "60")),
    ("ring", 'r_i = "60 mm"', 'r_i = "60 MPa"', ("inputs.r_i", "length")),
    ("ring", 'r_i = "60 mm"', 'r_i = "-60 mm"', ("inputs.r_i", "greater than")),
    ("ring", 'r_i = "60 mm"', 'r_i = "0 mm"', ("inputs.r_i", "greater than")),
    ("ring", 'r_i = "60 mm"', 'r_i = "120 mm"', ("r_i", "120")),
    ("ring", 'r_i = "60 mm"', 'r_i = "sixty mm"', ("inputs.r_i", "sixty")),
    ("ring", 'r_i = "60 mm"', 'r_i = "60 furlong"', ("inputs.r_i", "furlong")),
    ("ring", 'r_i = "60 mm"', 'r_i = ""', ("inputs.r_i",)),
    ("ring", 'r_i = "60 mm"', "r_i = true", ("inputs.r_i", "True")),
    ("ring", 'r_i = "60 mm"', "r_i = [60]", ("inputs.r_i",)),
    ("ring", 'r_i = "60 mm"', "r_i = {mm = 60}", ("inputs.r_i",)),
    ("ring", 'r_i = "60 mm"', "r_i = nan", ("inputs.r_i", "nan")),
    ("ring", 'r_i = "60 mm"', 'r_i = "inf mm"', ("inputs.r_i", "inf")),
    ("ring", 'r_i = "60 mm"', 'r_i = "1e400 mm"', ("inputs.r_i",)),
    ("ring", 'r_i = "60 mm"', 'r_i = "60 mm"\nr_i = "61 mm"', ("cannot be read",)),
    ("ring", 'r_i = "60 mm"', 'r_i = "60,5 mm"', ("inputs.r_i", "60,5")),
    ("ring", 'r_i = "60 mm"\n', "", ("missing r_i",)),
    ("ring", 'r_i = "60 mm"', 'ri = "60 mm"', ("inputs.ri", "unknown key")),
    ("ring", 'r_i = "60 mm"', 'R_i = "60 mm"', ("inputs.R_i", "unknown key")),
    ("ring", "nu = 0.3", "nu = 0.5", ("inputs.nu", "0.5")),
    ("ring", "nu = 0.3", "nu = -0.3", ("inputs.nu", "at least")),
    ("ring", "nu = 0.3", 'nu = "0.3 mm"', ("inputs.nu",)),
    ("ring", 'E = "210 GPa"', 'E = "0 GPa"', ("inputs.E", "greater than")),
    ("ring", 'E = "210 GPa"', 'E = "210 kg"', ("inputs.E", "pressure")),
    ("ring", 'E = "210 GPa"', 'E = "1e300 GPa"', ("inputs.E",)),
    ("ring", 'p_i = "100 MPa"', 'p_i = "100 N"', ("inputs.p_i", "pressure")),
    ("ring", "[inputs]", "[input]", ("input", "unknown key")),
    ("ring", "[inputs]", "", ("unknown key",)),
    ("ring", "[inputs]", "[inputs", ("cannot be read",)),
    ("ring", 'case = "ring-lame"', 'case = "ring-lamé"', ("case", "ring-lamé")),
    ("ring", 'case = "ring-lame"', "case = 3", ("case", "3")),
    ("ring", 'case = "ring-lame"\n', "", ("case", "missing")),
    ("ring", 'case = "ring-lame"', 'case = "design-spring"', ("freewheel design",)),
    ("ring", 'case = "ring-lame"', 'case = "ring-lame"\nname = ""', ("name",)),
    ("ring", 'case = "ring-lame"', 'case = "ring-lame"\nname = 7', ("name", "7")),
    ("ring", 'case = "ring-lame"', 'case = "ring-lame"\nunits = "inch"', ("units", "unknown key")),
    ("clutch", "z = 8", "z = 8.5", ("inputs.z", "whole number")),
    ("clutch", "z = 8", "z = 0", ("inputs.z", "at least")),
    ("clutch", "z = 8", "z = -8", ("inputs.z", "at least")),
    ("clutch", "z = 8", 'z = "8"', ("inputs.z", "whole number")),
    ("clutch", "z = 8", "z = 999999999999999999999", ("inputs.z", "out of range")),
    ("clutch", 'X = "11.39565 mm"', 'X = "14 mm"', ("X", "14")),
    ("clutch", 'R = "16.5 mm"', 'R = "2.5 mm"\nkind = "outer cam"', ("inputs",)),
    ("clutch", 'R_a = "21 mm"', 'R_a = "16 mm"', ("R_a", "16")),
    ("clutch", 'r_b = "7.5 mm"', 'r_b = "12 mm"', ("r_b", "12")),
    ("clutch", "mu = 0.08", "mu = 0", ("inputs.mu", "at least")),
    ("clutch", "mu = 0.08", 'mu = 0.08\nkind = "inner"', ("inputs.kind", "inner cam")),
    ("clutch", 'F_ax = "600 N"', 'F_ax = "600 N m"', ("inputs.F_ax", "force")),
    ("clutch", 'T = "26 N m"', 'T = "26 N"', ("inputs.T", "torque")),
    ("rotor", 'shaft = "a"', 'shaft = "b"', ("segments", "b")),
    ("rotor", "node = 2", "node = 9", ("supports", "9")),
    ("rotor", "probe = 1", "probe = 0", ("probe", "0")),
    ("rotor", 'speed_to = "2000 r/min"', 'speed_to = "500 r/min"', ("speed", "500")),
]  # fmt: skip


def refused(path, capsys):
    """The single line on stderr; nothing is printed on stdout."""
    status = run(["check", str(path)])
    out, err = capsys.readouterr()
    assert status == 2, out
    assert out == ""
    (line,) = err.splitlines()
    assert line.startswith("freewheel: ")
    assert "Traceback" not in line
    return line


@pytest.mark.parametrize(("base", "old", "new", "words"), FILES, ids=lambda x: str(x)[:40])
def test_a_wrong_file_gets_one_line(base, old, new, words, tmp_path, capsys):
    path = tmp_path / "part.toml"
    assert old in BASE[base]
    path.write_text(BASE[base].replace(old, new, 1), "utf-8")
    line = refused(path, capsys)
    assert str(path) in line
    for word in words:
        assert word in line, line


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (RING.encode("utf-16"), "UTF-8"),
        (RING.replace("case", "# Größe\ncase").encode("latin-1"), "UTF-8"),
        (b"\x00\x01\x02", "cannot be read"),
        (b"", "case"),
        (b"[" * 5000, "cannot be read"),
        (b"#" * 1_000_001, "larger"),
    ],
    ids=["utf-16", "latin-1", "binary", "empty", "nested", "large"],
)
def test_another_encoding_gets_one_line(content, words, tmp_path, capsys):
    path = tmp_path / "part.toml"
    path.write_bytes(content)
    assert words in refused(path, capsys)


def test_a_byte_order_mark_and_windows_lines_are_read(tmp_path, capsys):
    path = tmp_path / "part.toml"
    path.write_bytes(b"\xef\xbb\xbf" + RING.replace("\n", "\r\n").encode())
    assert run(["check", str(path)]) == 0
    assert capsys.readouterr().out.startswith("part: holds")


def test_a_folder_and_a_missing_file_get_one_line(tmp_path, capsys):
    assert "directory" in refused(tmp_path, capsys)
    assert "No such file" in refused(tmp_path / "none.toml", capsys)
