"""The command `sweep`: what it refuses before it solves, what it says meanwhile."""

import json

import numpy as np
import pytest

from tests.verify.sweep_made import RING
from verify.app.cli import run
from verify.app.sweep import command
from verify.core.case import Portion
from verify.core.inputs import InputError
from verify.core.store import Store
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


def test_a_point_that_failed_has_its_files(ring, monkeypatch, capsys):
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
        (("--star", "--sample", "sobol:8"), "--star belongs to --vary"),
    ],
)  # fmt: skip
def test_options_that_make_no_sweep_are_refused_in_a_line(ring, capsys, options, said):
    assert run(["sweep", str(ring), *options]) == 2
    err = capsys.readouterr().err
    assert said in err
    assert err.count("\n") == 1


# Where points are kept


def kept(folder):
    return Points(Store(folder), "ring", PART, ("a", "b"), "numpy 1")
