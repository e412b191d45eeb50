"""The command `sweep`: what it refuses before it solves, what it says meanwhile."""

import json
import sqlite3
import subprocess
import sys

import numpy as np
import pytest

from tests.verify.sweep_files import RING
from verify.app.cli import run
from verify.app.sweep import command
from verify.core.case import Portion
from verify.core.inputs import InputError
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.executor import Where
from verify.studies.sweep.point import Solution
from verify.studies.sweep.run import Solved, Timing
from verify.studies.sweep.store import Points

REFUSED = "refused: more than the mesh can have"
PART = Portion(name="", fem=lambda *_: None, levels=(1, 2, 4), keys=())


@pytest.fixture
def ring(tmp_path):
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    return path


def swept(path, *, solutions, monkeypatch, vary=("z=3:4:2",), as_json=False):
    """The status of a sweep whose points have these solutions, and its folder."""

    def solve(plan, where, *, again, show):
        assert solutions, "nothing was to be solved"
        return Solved(
            plan, PART, (None,) * len(solutions), solutions,
            Timing(len(solutions), 1.0, 1.0, 1, 0),
        )  # fmt: skip

    monkeypatch.setattr(command, "solve", solve)
    return command.run_sweep(
        path, vary=vary, star=False, sample="", tolerances=(), only=("K of",), where=Where(1),
        out=path.parent / "out", as_json=as_json, again=False,
    )  # fmt: skip


def test_points_that_the_rules_all_refuse_are_never_solved(ring, monkeypatch):
    said = r"^every point is refused, such as: z = 1: must be at least 3$"
    with pytest.raises(InputError, match=said):
        swept(ring, solutions=(), monkeypatch=monkeypatch, vary=("z=1:2:2",))
    assert not (ring.parent / "out").exists()


def test_points_that_solving_all_refuses_leave_no_files(ring, monkeypatch):
    solutions = (Solution({}, (), {}, {}, problem_fe=REFUSED),) * 2
    with pytest.raises(InputError, match=r"^every point is refused, such as: more than the mesh"):
        swept(ring, solutions=solutions, monkeypatch=monkeypatch)
    assert not list((ring.parent / "out").iterdir())


def test_a_point_that_failed_is_told_with_files(ring, monkeypatch, capsys):
    solutions = (
        Solution({}, (), {}, {}, problem_fe=REFUSED),
        Solution({}, (), {}, {}, problem_fe="level 2: no"),
    )
    monkeypatch.setattr(command, "files", lambda *_: {"sweep.json": b"{}\n"})
    assert swept(ring, solutions=solutions, monkeypatch=monkeypatch, as_json=True) == 1
    out, err = capsys.readouterr()
    assert json.loads(out) == {}
    # what is being done is on the other stream
    assert err.startswith("ring: 2 points of polyhedral-ring, 1 row\n")


def test_json_goes_with_lines_of_progress_as_without_a_terminal(ring, monkeypatch):
    shown = []

    def solve(plan, where, *, again, show):
        shown.append(show)
        raise InputError("enough")

    monkeypatch.setattr(command, "solve", solve)
    with pytest.raises(InputError, match="enough"):
        command.run_sweep(
            ring, vary=("z=3:4:2",), star=False, sample="", tolerances=(), only=(), where=Where(1),
            out=ring.parent / "out", as_json=True, again=False,
        )  # fmt: skip
    assert isinstance(shown[0], command.Lines)


def test_a_star_varies_one_input_at_a_time_and_its_command_says_so(ring):
    vary = ("z=3:5:3", "rho=1mm:2mm:2")
    plan = command.planned(ring, vary=vary, star=True, sample="", tolerances=(), only=())
    assert (plan.star, len(plan.points)) == (True, 5)  # the file's z = 6, rho = 2 mm and 3 + 1
    assert (np.sum(plan.points != plan.points[0], axis=1) <= 1).all()
    repeat = command.command(ring, vary, True, "", (), ())
    assert repeat == "freewheel sweep ring.toml --vary z=3:5:3 --vary rho=1mm:2mm:2 --star"


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ((), "sweep needs --vary NAME=a:b:n, or --sample"),
        (("--vary", "z=3:4:2", "--sample", "sobol:8"), "--vary, which makes a grid, and --sample "
                                                       "exclude each other"),
        (("--vary", "z=3:4:2", "--tolerance", "E=±5%"), "--tolerance belongs to --sample"),
        (("--star", "--sample", "sobol:8"), "--star belongs to --vary"),
        (("--vary", "=3:4:2"), "the input's name is missing"),
    ],
)  # fmt: skip
def test_options_that_make_no_sweep_are_told_in_a_line(ring, capsys, options, said):
    assert run(["sweep", str(ring), *options]) == 2
    err = capsys.readouterr().err
    assert said in err
    assert err.count("\n") == 1


def test_a_task_for_design_is_told_with_the_command_that_takes_it(tmp_path, capsys):
    task = tmp_path / "task.toml"
    task.write_text('case = "design-spring"\n[inputs]\n')
    assert run(["sweep", str(task), "--vary", "n=3:4:2"]) == 2
    assert f"a task for freewheel design: freewheel design {task}" in capsys.readouterr().err


def test_a_grid_is_planned_without_scipys_statistics():
    code = "import sys, verify.app.sweep.command; print('scipy.stats' in sys.modules)"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout == "False\n"


# Where points are kept


def kept(folder):
    return Points(Store(folder), "ring", PART, ("a", "b"), "numpy 1")


def test_a_database_that_is_none_is_told_with_what_to_do(tmp_path):
    file = tmp_path / "store.sqlite"
    file.write_bytes(b"no database" * 100)
    with pytest.raises(OSError, match=r"store\.sqlite: .*; remove it to begin again$"):
        kept(tmp_path)


def test_a_locked_database_is_not_to_be_moved(tmp_path, monkeypatch):
    file = tmp_path / "store.sqlite"
    kept(tmp_path).keep({"b": Solution({"x": 1.0}, (), {}, {})})
    monkeypatch.setattr("verify.core.database.PATIENCE", 0.01)
    other = sqlite3.connect(file, isolation_level=None)
    other.execute("BEGIN EXCLUSIVE")
    with pytest.raises(OSError, match=r"locked: results cannot be stored there$"):
        kept(tmp_path).keep({"a": Solution({"x": 1.0}, (), {}, {})})
    other.close()


def test_a_cache_that_is_a_file_is_named(tmp_path, monkeypatch):
    file = tmp_path / "cache"
    file.write_text("")
    monkeypatch.setattr(cache, "default_folder", lambda: file)
    said = r"cache: is a file, expected a folder: results cannot be stored there$"
    for place in (file, file / "deep"):
        with pytest.raises(OSError, match=said):
            kept(place / "sweeps")
