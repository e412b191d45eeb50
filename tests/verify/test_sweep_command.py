"""The command `sweep`: inputs refused before solving, and files written."""

import json

import pytest

from tests.verify.sweep_made import RING
from verify.app.cli import run
from verify.app.sweep import command
from verify.core.case import Portion
from verify.core.inputs import InputError
from verify.jobs.executor import Where
from verify.studies.sweep.point import Solution
from verify.studies.sweep.run import Solved, Timing

REFUSED = Solution({}, (), {}, {}, problem_fe="refused: more than the mesh can have")
FAILED = Solution({}, (), {}, {}, problem_fe="level 2: no")
PART = Portion(name="", fem=lambda *_: None, levels=(1, 2, 4), keys=())


@pytest.fixture
def ring(tmp_path):
    path = tmp_path / "ring.toml"
    path.write_text(RING)
    return path


@pytest.fixture
def swept(ring, monkeypatch):
    """The status of a sweep whose points have these solutions."""

    def sweep(*solutions, vary="z=3:4:2"):
        def solve(plan, where, *, again, show):
            assert solutions, "nothing was to be solved"
            timing = Timing(len(solutions), 1.0, 1.0, 1, 0)
            return Solved(plan, PART, (None,) * len(solutions), solutions, timing)

        monkeypatch.setattr(command, "solve", solve)
        return command.run_sweep(
            ring, vary=(vary,), star=False, sample="", tolerances=(), only=("K of",),
            where=Where(1), out=ring.parent / "out", as_json=True, again=False,
        )  # fmt: skip

    return sweep


def test_a_sweep_of_which_every_point_is_refused_leaves_no_files(swept, tmp_path):
    out = tmp_path / "out"
    with pytest.raises(InputError, match=r"^every point is rejected, the first because: z = 1"):
        swept(vary="z=1:2:2")  # by the rules of the inputs, before anything is solved
    assert not out.exists()
    with pytest.raises(InputError, match=r"^every point is rejected, the first because: more than"):
        swept(REFUSED, REFUSED)
    assert not list(out.iterdir())


def test_a_sweep_with_a_point_that_failed_ends_with_one_and_has_its_files(
    swept, monkeypatch, capsys
):
    monkeypatch.setattr(command, "files", lambda *_: {"sweep.json": b"{}\n"})
    assert swept(REFUSED, FAILED) == 1
    out, err = capsys.readouterr()  # what is being done is on the other stream
    assert json.loads(out) == {}
    assert err.startswith("ring: 2 points of polyhedral-ring, 1 row\n")


def test_options_that_make_no_sweep_are_refused_in_a_line(ring, capsys):
    for options, message in (
        ("", "give --vary NAME=a:b:n, or --sample"),
        ("--vary z=3:4:2 --sample sobol:8", "--vary (a grid) and --sample cannot"),
        ("--star --sample sobol:8", "--star requires --vary"),
    ):
        assert run(["sweep", str(ring), *options.split()]) == 2
        (line,) = capsys.readouterr().err.splitlines()
        assert message in line
