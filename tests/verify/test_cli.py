"""The command line as a user meets it."""

import json
import os
import re
import resource
import subprocess
import sys

import pytest

from analytic.ring import lame
from verify.app import commands
from verify.app.cli import run
from verify.cases.registry import CASES, QUICK
from verify.core.results import Status
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.scheduler import run as solve

HEAVY = ("gmsh", "skfem", "meshio", "pyvista", "matplotlib", "sklearn", "numba", "llvmlite",
         "scipy.stats")  # fmt: skip
SPRING = """\
case = "spring-accordion"
name = "twelve segments"
[inputs]
n = 12
b = "0.1 mm"
h = "56 mm"
r = "0.45 mm"
L1 = "11.6 mm"
alpha = "80 deg"
E = "206 GPa"
nu = 0.3
F = "5 N"
R_p = "300 MPa"
"""
RING = """\
case = "ring-lame"
[inputs]
r_i = "60 mm"
r_o = "90 mm"
p_i = "100 MPa"
E = "210 GPa"
nu = 0.3
"""


@pytest.fixture
def spring(tmp_path):
    path = tmp_path / "spring.toml"
    path.write_text(SPRING)
    return path


@pytest.fixture
def ring(tmp_path):
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    return path


def shell(*arguments, **more):
    return subprocess.run(
        [sys.executable, "-m", "verify", *map(str, arguments)],
        capture_output=True, text=True, check=False, timeout=300, **more,
    )  # fmt: skip


def checked(path, *options, capsys):
    status = run(["check", str(path), "--json", *options])
    return status, json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(
    "arguments",
    [["--help"], ["list"], ["check", "FILE"], ["init", "ring-lame"], ["completion", "bash"]],
    ids=lambda a: a[0],
)
def test_nothing_heavy_is_imported_before_it_is_needed(arguments, spring):
    script = (
        "import sys\nfrom verify.app.cli import run\n"
        f"status = run({[str(spring) if a == 'FILE' else a for a in arguments]!r})\n"
        f"print('loaded', [m for m in {HEAVY!r} if m in sys.modules], status, file=sys.stderr)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False, timeout=60
    )
    status = 1 if arguments[0] == "check" else 0  # the spring of this file yields
    assert done.stderr.splitlines()[-1] == f"loaded [] {status}"


def test_help_names_the_commands_and_the_exit_status():
    done = shell("--help")
    assert done.returncode == 0
    for word in ("verify", "check", "list", "init", "explain", "doctor", "completion"):
        assert word in done.stdout


LIBRARIES = "import numpy, scipy.optimize, scipy.integrate, scipy.interpolate, pydantic, pint"


def seconds(command, **more):
    """Processor seconds of `command`."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([sys.executable, *command], capture_output=True, check=False, **more)
    assert done.returncode in (0, 1)  # the spring of the file yields
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@pytest.mark.parametrize(
    ("arguments", "share"),
    [(["--help"], 0.6), pytest.param(["check", "FILE"], 3.5, marks=pytest.mark.soak)],
)
def test_short_commands_answer_at_once(arguments, share, spring, tmp_path):
    """Beside what the libraries alone take to import, in turns, on a machine that others load.

    The first turn compiles the modules. What `check` takes is a benchmark's as well; that it
    imports nothing heavy is checked in every run.
    """
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    environment["PYTHONPYCACHEPREFIX"] = str(tmp_path / "compiled")
    command = ["-m", "verify", *(str(spring) if a == "FILE" else a for a in arguments)]
    turns = [
        seconds(command, env=environment) / seconds(["-c", LIBRARIES], env=environment)
        for _ in range(3)
    ]
    assert min(turns[1:]) < share


def test_list_names_every_case_with_subject_units_and_what_may_be_left_out(capsys):
    assert run(["list"]) == 0
    out = capsys.readouterr().out
    for case in CASES:
        assert f"{case.id} " in out
        assert case.title in out
    assert "inputs: r_i [mm], r_o [mm], p_i [MPa], E [GPa], nu\n" in out
    assert "optional: p_o [MPa], R_p [MPa]\n" in out


@pytest.mark.parametrize("shell_name", ["bash", "zsh", "fish"])
def test_completion_knows_the_commands(shell_name, capsys):
    assert run(["completion", shell_name]) == 0
    out = capsys.readouterr().out
    for word in ("verify", "check", "list", "init", "explain", "doctor", "fem", "quick"):
        assert word in out


@pytest.mark.parametrize("command", ["verify", "init", "explain"])
def test_completion_offers_the_cases(command):
    done = shell("__complete", command, "")
    others = ["design-spring", "design-sprag"] if command == "init" else []
    offered = done.stdout.split()[1:]  # after the opening directive
    assert [*(case.id for case in CASES), *others] == offered


def test_converted_units_are_shown_short_and_kept_whole(tmp_path, capsys):
    path = tmp_path / "ring.toml"
    path.write_text(RING.replace('"100 MPa"', '"14.5 ksi"'))
    _, found = checked(path, capsys=capsys)
    assert found["inputs"]["p_i"]["value"] == pytest.approx(99.9739808, rel=1e-9)
    assert len(str(found["inputs"]["p_i"]["value"])) > 12
    assert run(["check", str(path)]) == 0
    assert re.search(r" 99\.974 +MPa ", capsys.readouterr().out)


def test_a_ring_of_60_and_90_mm_by_hand(ring, capsys):
    """Boundary stresses (r_o² + r_i²)/(r_o² - r_i²) p = 2.6 p and 1.6 p: 260 and 160 MPa."""
    status, found = checked(ring, capsys=capsys)
    values = {v["key"]: v["value"] for v in found["values"]}
    assert status == 0
    assert values["hoop_bore"] == pytest.approx(260.0, rel=1e-12)
    assert values["hoop_rim"] == pytest.approx(160.0, rel=1e-12)
    # u(r_i) = r_i/E (2.6 p + nu p), plane stress, in µm
    assert values["u_bore"] == pytest.approx(60e3 / 210e3 * (260 + 0.3 * 100), rel=1e-12)
    assert found["inputs"]["p_o"] == {"value": 0.0, "unit": "MPa"}  # left out: no pressure
    assert found["rows"] == []


def test_a_spring_of_twelve_segments_is_softer_than_the_paper_s(spring, capsys):
    """Two more leaves: compliance grows by two units' share, 0.60096 (8 + 1.3)/(10 + 1.3)."""
    status, found = checked(spring, capsys=capsys)
    values = {v["key"]: v["value"] for v in found["values"]}
    assert (status, found["answer"]["limited_by"]) == (1, "bending_stress")
    k = values["k1"]
    assert 0.60096 * 8 / 10 < k < 0.60096 * 9 / 11
    assert values["deflection"] == pytest.approx(5.0 / k, rel=1e-12)
    # 6 F (L1/2 + r)/(h b²) by hand; inside a bar of b/r = 0.1/0.45 some 7 % more
    assert values["stress"] == pytest.approx(1.07 * 6 * 5.0 * 6.25 / (56 * 0.01), rel=5e-3)
    text = " ".join(found["warnings"])
    assert "exceeds R_p = 300 MPa" in text
    assert "above 240 (Eq. 13)" in text


@pytest.mark.parametrize(("name", "expected"), [("ring", 0), ("spring", 1)])
def test_user_parameters_are_judged_with_finite_elements(name, expected, request, capsys):
    status, found = checked(request.getfixturevalue(name), "--fem", capsys=capsys)
    assert status == expected  # the spring yields, its rows pass
    assert {row["status"] for row in found["rows"]} == {"PASS"}
    assert all(row["fem"] is not None for row in found["rows"] if row["kind"] == "identity")
    assert not any(row["published"] for row in found["rows"])  # these speak of the paper's own


def test_a_ring_that_yields_is_warned_of(ring, capsys):
    ring.write_text(RING + 'R_p = "200 MPa"\n')
    _, found = checked(ring, capsys=capsys)
    # Tresca at the bore, hoop less radial: 260 + 100 MPa
    assert "Tresca stress 360 MPa at the bore exceeds R_p = 200 MPa" in found["warnings"][0]


def test_check_prints_inputs_values_and_warnings(spring, capsys):
    assert run(["check", str(spring)]) == 1
    out = capsys.readouterr().out
    assert "twelve segments" in out
    assert re.search(r"b +0\.1 +mm +thickness", out)
    assert "warning: " in out


def test_verify_writes_the_report_and_says_where(tmp_path, capsys):
    assert run(["verify", "spring-accordion", "--out", str(tmp_path / "out")]) == 0
    out = capsys.readouterr().out
    written = {p.name for p in (tmp_path / "out").iterdir()}
    assert {
        "report.html",
        "report.pdf",
        "tables.xlsx",
        "results.json",
        "results.schema.json",
        "rows.csv",
        "junit.xml",
    } <= written
    assert str(tmp_path / "out" / "report.html") in out.replace("\n", "")
    assert {name for name in written if name.startswith(".")} <= {".lock", ".up-to-date.json"}


def test_the_quick_round_has_cases_of_every_subject():
    subjects = {case.partition("-")[0] for case in CASES.ids}
    assert {case.partition("-")[0] for case in QUICK} == subjects
    assert set(QUICK) <= set(CASES.ids)


def test_the_quick_round_runs_its_cases_alone(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(commands, "QUICK", ("ring-lame",))
    assert run(["verify", "--quick", "--out", str(tmp_path)]) == 0
    rows = json.loads((tmp_path / "results.json").read_text())["rows"]
    assert {row["case"] for row in rows} == {"ring-lame"}
    assert run(["verify", "ring-rotation", "--quick", "--out", str(tmp_path)]) == 2
    assert "name no case beside it" in capsys.readouterr().err


def test_a_red_row_makes_the_exit_status_one(monkeypatch, tmp_path, capsys):
    right = lame.strain_energy
    monkeypatch.setattr(lame, "strain_energy", lambda **k: 1.001 * right(**k))
    assert run(["verify", "ring-lame", "--out", str(tmp_path)]) == 1
    assert "FAIL" in capsys.readouterr().out


def test_a_solver_that_fails_is_a_red_row_and_no_traceback(
    monkeypatch, tmp_path, with_equations, capsys
):
    from fem.plane import solve
    from verify.jobs import session as solving

    def stuck(*_args, **_more):
        raise ArithmeticError("the linear solve did not converge: relative residual 1e+00")

    monkeypatch.setattr(solve, "_solve", stuck)
    right = solving.run
    here = lambda work, **more: right(work, **more | {"engine": None})  # noqa: E731
    monkeypatch.setattr(solving, "run", here)
    monkeypatch.setenv("FREEWHEEL_CACHE", str(with_equations(tmp_path / "cache")))
    assert run(["verify", "ring-lame", "--out", str(tmp_path)]) == 1
    rows = json.loads((tmp_path / "results.json").read_text())["rows"]
    assert {row["status"] for row in rows} == {"FAIL"}
    assert "did not converge" in rows[0]["reason"]
    assert rows[0]["fem"] is None


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["check", "nowhere.toml"], "nowhere.toml: cannot be read: No such file or directory"),
        (["verify", "ring-lam"], "unknown case 'ring-lam'"),
        (["verify", "--jobs", "many"], "--jobs: needs a whole number, got 'many'"),
        (["verify", "--jobs", "1.5"], "--jobs: needs a whole number, got '1.5'"),
        (["check", "a.toml", "-j", "1.5"], "-j: needs a whole number, got '1.5'"),
        (["verify", "--jobs", "-1"], "--jobs is 0 (one a core) to 256, got -1"),
        (["completion", "tcsh"], "tcsh"),
        (["chekc", "a.toml"], "chekc"),
        (["check"], "FILE"),
    ],
    ids=lambda x: " ".join(x) if isinstance(x, list) else "",
)
def test_bad_command_lines_end_with_one_line_and_status_two(arguments, message, capsys):
    assert run(arguments) == 2
    err = capsys.readouterr().err
    assert err.startswith("freewheel: ")
    assert err.count("\n") == 1
    assert message in err


def test_an_output_folder_that_cannot_be_made_is_bad_input(tmp_path, capsys):
    blocked = tmp_path / "file"
    blocked.write_text("")
    assert run(["verify", "spring-accordion", "--out", str(blocked / "out")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_results_do_not_depend_on_the_number_of_processes(tmp_path):
    from verify.cases.spring.accordion.case import ACCORDION

    found = []
    for jobs in (1, 2):
        engine, folder = Where(jobs).entered(), tmp_path / str(jobs)
        work = [Job(ACCORDION, ACCORDION.inputs())]
        (result,) = solve(work, engine=engine, cache_folder=folder)
        found.append(result.rows)
    assert found[0] == found[1]
    assert not any(row.status is Status.FAIL for row in found[0])


def test_the_stiffness_of_the_paper_is_within_a_ten_thousandth():
    """0.60096 ± 0.0001 N/mm, the acceptance figure of Eqs. 1-9."""
    from verify.cases.spring.accordion.case import ACCORDION

    assert ACCORDION.analytic(ACCORDION.inputs())["k1"] / 1e3 == pytest.approx(0.60096, abs=1e-4)


def test_a_fault_of_the_program_is_one_line_and_a_file(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr("verify.app.commands.run_list", lambda: {}["nothing"])
    assert run(["list"]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "KeyError: 'nothing'" in said
    (file,) = tmp_path.iterdir()
    assert str(file) in said
    assert "Traceback" in file.read_text("utf-8")


def test_more_cells_than_memory_holds_are_refused_in_one_line(tmp_path, capsys):
    path = tmp_path / "long.toml"
    assert run(["init", "spring-continuum", "--out", str(path)]) == 0
    path.write_text(path.read_text("utf-8").replace("n = 10 ", "n = 90 "), "utf-8")
    assert run(["check", str(path)]) == 3  # formulas for any length; no force is given
    capsys.readouterr()
    assert run(["check", "--fem", str(path)]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "unknowns, more than 1,000,000" in said


def test_an_empty_argument_is_refused(capsys):
    assert run(["verify", "--out", ""]) == 2
    assert "an argument is empty" in capsys.readouterr().err
