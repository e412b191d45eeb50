"""Cases in files outside the suite: commands that accept them, and one clear line for an error."""

import html
import json
import os
import re
import shutil
from pathlib import Path

import pytest

from reports import write
from reports.typesetting import NotSet
from verify.app.cli import run
from verify.cases import files, registry
from verify.core import source_code
from verify.jobs.executor import Where, local

EXAMPLE = Path(__file__).parents[3] / "examples" / "winkler_bach.py"
OWN = """case = "{file}"
[inputs]
r_i = "50 mm"
r_o = "90 mm"
b = "20 mm"
M = "300 N m"
"""
INNER = "return self.M * (self.r_n - self.r_i)"
NEUTRAL = "return (self.r_o - self.r_i) / log(self.r_o / self.r_i)"
ELASTIC = "from fem.plane.material"
TITLE = "    title = "
names = iter(range(1000))  # a module is read once: each test has a separate file


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    """Equations and levels of the files of all tests: changed files have separate keys."""
    return tmp_path_factory.mktemp("cache")


@pytest.fixture
def printed_bar(tmp_path, monkeypatch, cache):
    """A copy of the example with replacements, and its path as the command line takes it."""
    monkeypatch.setenv("FREEWHEEL_CACHE", str(cache))
    monkeypatch.setenv(files.FILES, "")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(source_code, "_outside", set())

    def copied(*changes):
        name = f"curved_bar_{os.getpid()}_{next(names)}.py"
        text = EXAMPLE.read_text("utf-8")
        for old, new in changes:
            assert old in text
            text = text.replace(old, new)
        (tmp_path / name).write_text(text, "utf-8")
        return name

    yield copied
    files._loaded.cache_clear()


@pytest.fixture
def bar(printed_bar, monkeypatch):
    """The same, solved in this process and without a PDF, which few tests are about."""

    def not_set(*_):
        raise NotSet("it is not asked for")

    monkeypatch.setattr(Where, "entered", lambda _: local(0))
    monkeypatch.setattr(write, "printed", not_set)
    return printed_bar


def verify(file, *more):
    return run(["verify", file, "--out", "out", *more])


def test_a_file_is_verified_with_a_separate_report(printed_bar, capsys):
    """In worker processes; the report has the title of the case, and nothing of the papers."""
    file = printed_bar(("Timoshenko, Strength of Materials", "Timoshenko | Strength"))
    assert verify(file, "--jobs", "2") == 0
    assert "since 0." not in capsys.readouterr().out  # no release has these rows
    data = json.loads(Path("out/results.json").read_text("utf-8"))
    assert {row["status"] for row in data["rows"]} == {"PASS"}
    assert [p["key"] for p in data["papers"]] == ["Timoshenko | Strength"]
    assert not data["errata"] + data["equations"] + data["published"] + data["paper_tables"]
    page = html.unescape(Path("out/report.html").read_text("utf-8"))
    heads = re.findall(r"<h([1-4])[^>]*>([^<]*)", page)
    assert heads[0] == ("1", "Bending stresses of a curved bar")
    assert not {"Tables of the papers", "Errata", "Readings", "Assumptions"} & {h for _, h in heads}
    assert f"freewheel verify {file}\nfreewheel init {file} > my.toml" in page
    assert r"(Timoshenko \| Strength, curved bars) |" in Path("out/cases.md").read_text("utf-8")
    assert Path("out/report.pdf").is_file()


def test_a_summary_in_markdown_is_appended_for_each_file(bar, capsys):
    right, wrong = bar(), bar((INNER, f"return 1.05 * {INNER.removeprefix('return ')}"))
    assert verify(right, "--summary", "job.md") == 0
    assert verify(wrong, "--summary", "job.md") == 1
    first, second = re.split(r"(?=^## )", Path("job.md").read_text("utf-8"), flags=re.MULTILINE)[1:]
    assert first.startswith("## freewheel verify: passed\n\n5 rows of 1 case\n")
    assert "| 0 | 0 | 0 | 0 | 0 | 5 |" in first
    assert "Rows that fail" not in first
    assert "Verdicts of the formulas" not in first  # which rest on all cases of the suite
    assert second.startswith("## freewheel verify: failed\n")
    stem = Path(wrong).stem.replace("_", "-")
    (row,) = re.findall(r"^\| `.*", second, re.MULTILINE)
    assert re.fullmatch(rf"\| `{stem}` \| stress at the inner edge \| FAIL \| \S.* \|", row)
    assert re.search(r"^freewheel \d+\.\d+\.\d+, commit \S+, Python 3\.", second, re.MULTILINE)
    capsys.readouterr()
    assert verify(right, "--summary", "nosuch/job.md") == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "nosuch/job.md: cannot be written" in line


def test_a_parameter_file_and_a_template_name_a_case_file_beside_them(bar, capsys):
    off = "sigma_i=inner * (1 + 0.05 * level * (self.r_i > 0.07)),"
    file = bar(("sigma_i=inner,", off))
    Path("my.toml").write_text(OWN.format(file=file), "utf-8")
    assert run(["check", "my.toml"]) == 3  # no limits, so that nothing holds or fails
    assert "σ_i  69.4981   MPa" in capsys.readouterr().out
    assert run(["explain", "inner edge", "my.toml"]) == 0
    # a sweep fails where a row does not converge
    assert run(["sweep", "my.toml", "--vary", "r_i=60mm:80mm:3", "--out", "sweep"]) == 1
    assert "1 point: does not converge in 1 of 2 rows" in capsys.readouterr().out
    Path("parts").mkdir()
    assert run(["init", file, "--out", "parts/my.toml"]) == 0
    assert run(["check", "parts/my.toml"]) == 3
    assert run(["init", file]) == 0
    text = capsys.readouterr().out
    assert f'case = "{file}"' in text
    assert f"The numbers are the defaults of {file}" in text
    assert 'r_i = "100 mm"  # inner radius; greater than 0 mm\n' in text


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (('"MPa", "stress at the inner', '"MPx", "stress at the inner'),
         r".py:\d+: CurvedBar.sigma_i: .*MPx"),
        (("def e(self) -> float:", "def e(self) -> float"), r".py:\d+: expected ':'"),
        (("def e(self) -> float:", "def r_n(self) -> float:"),
         r".py:\d+: CurvedBar.r_n: this name is already declared in line \d+"),
        ((TITLE, "    ends = 3\n    title = "),
         ".py: ends: annotate it, an input as float = given"),
        (('    title = "Bending stresses of a curved bar"\n', ""),
         ": declares no subclass of Case with a title"),
        ((TITLE, '    id = "ring-lame"\n    title = '),
         ": the suite has a case ring-lame already; give the new case another id"),
        (("        most = ", "        pass\n\n    def others(self):\n        most = "),
         r".py:\d+: CurvedBar.comparisons: must yield comparisons, got None"),
    ],
)  # fmt: skip
def test_a_wrong_declaration_is_one_line(change, message, bar, capsys):
    assert verify(bar(change)) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert re.search(message, line), line
    assert line.startswith("freewheel: ")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ((INNER, "return self.M * self.r_i**2 / (self.r_i - self.r_i)"),
         "sigma_i: ZeroDivisionError: float division by zero"),
        ((NEUTRAL, "while True:\n            pass\n        return 0.0"),
         "r_n: TimeLimitError: the code took longer than 0.3 s"),
        ((ELASTIC, f"while self.M:\n            pass\n        {ELASTIC}"),
         "reference: TimeLimitError: the code took longer than 0.3 s"),
    ],
)  # fmt: skip
def test_a_fault_of_a_formula_or_reference_fails_its_rows_with_its_place(
    change, message, bar, capsys
):
    limited = "TimeLimit" in message
    file = bar(change, (TITLE, "    time_limit = 0.3\n    title = " if limited else TITLE))
    assert verify(file) == 1
    assert re.search(rf"{file}:\d+: {message}", capsys.readouterr().out)
    assert file in Path("out/errors.txt").read_text("utf-8")
    if message.startswith("sigma_i: Zero"):
        Path("my.toml").write_text(OWN.format(file=file), "utf-8")
        assert run(["check", "my.toml"]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        assert re.search(rf"{file}:\d+: {message}", line)


def test_ctrl_c_in_a_formula_ends_the_run_with_one_line(bar, capsys):
    assert verify(bar((INNER, "raise KeyboardInterrupt\n        " + INNER))) == 130
    assert capsys.readouterr().err.splitlines()[-1].startswith("freewheel: interrupted")


def test_a_case_of_an_installed_package_has_a_name(bar, capsys, monkeypatch):
    package = Path("curved_bars")
    package.mkdir()
    (package / "__init__.py").touch()
    shutil.copy(bar((TITLE, '    id = "curved-bar"\n    title = ')), package / "bar.py")
    info = Path("curved_bars-1.0.dist-info")
    info.mkdir()
    (info / "METADATA").write_text("Name: curved-bars\nVersion: 1.0\n", "utf-8")
    (package / "exits.py").write_text("raise SystemExit(3)\n", "utf-8")
    points = "curved-bar = curved_bars.bar:CurvedBar\nother = curved_bars.bar:ART_29\n" \
        "exits = curved_bars.exits:Bar\n"  # fmt: skip
    (info / "entry_points.txt").write_text(f"[freewheel.cases]\n{points}", "utf-8")
    monkeypatch.syspath_prepend(str(Path.cwd()))
    files.of_package.cache_clear()
    assert "other" in files.installed()
    Path("my.toml").write_text(OWN.format(file="curved-bar"), "utf-8")
    assert run(["check", "my.toml", "--fem"]) == 3
    assert "σ_i" in capsys.readouterr().out
    assert source_code.source_of(registry.find("curved-bar").reference)
    assert verify("other") == 2
    assert "curved_bars.bar:ART_29: must be a subclass of Case" in capsys.readouterr().err
    assert verify("exits") == 2
    assert capsys.readouterr().err == "freewheel: curved_bars.exits:Bar: SystemExit: 3\n"


@pytest.mark.parametrize(
    ("name", "message"),
    [("nosuch.py", "nosuch.py: there is no such file"),
     ("json.py", "another module is called json; rename the file"),
     ("my-bar.py", "only letters, digits and _ are allowed")],
)  # fmt: skip
def test_a_file_that_cannot_be_a_module_is_one_line(name, message, bar, capsys):
    if name != "nosuch.py":
        shutil.copy(bar(), name)
    assert verify(name) == 2
    assert message in capsys.readouterr().err
