"""Cases that are judged on the engine while others are solved, as this process judges them."""

from dataclasses import replace

import pytest

from tests.verify.test_run import CASE, OTHER, Beam
from verify.cases.registry import find
from verify.core.store import Store
from verify.jobs.executor import local
from verify.jobs.level import Job
from verify.jobs.scheduler import run
from verify.jobs.tasks import Prepared


def drawn(result, folder):
    (folder / f"{result.id}.drawn").write_text("equations", "utf-8")


def not_drawn(_result, _folder):
    raise ValueError("no such command: \\unknown")


def cleared(_result, folder):
    """A store that loses its levels once a case is judged."""
    Store(folder).clear("level")


def compared(result):
    return replace(result, seconds=0.0, cached=False).rows, result.equations, result.command


def test_processes_judge_and_prepare_as_this_process_does(tmp_path):
    case = find("polyhedral-pressure")
    done = []
    prepared = Prepared(drawn, done.append)
    (there,) = run(
        [Job(case, case.inputs())], engine=local(1), cache_folder=tmp_path, prepared=prepared
    )
    (here,) = run([Job(case, case.inputs())], cache_folder=tmp_path)
    assert compared(there) == compared(here)
    assert done == [there]
    assert (tmp_path / "polyhedral-pressure.drawn").is_file()


@pytest.mark.parametrize(("prepare", "judged"), [(not_drawn, 0), (cleared, 3)])
def test_a_case_that_cannot_be_judged_there_is_judged_here(prepare, judged, tmp_path):
    done = []
    jobs = [Job(CASE, Beam()), Job(OTHER, Beam())]
    run(jobs, cache_folder=tmp_path)
    jobs.extend(Job(replace(CASE, id=f"ring-{n}"), Beam()) for n in range(2))
    results = run(jobs, cache_folder=tmp_path, prepared=Prepared(prepare, done.append))
    assert [compared(one) for one in results] == [compared(one) for one in run(jobs)]
    assert len(done) == judged


def test_stored_cases_are_judged_on_the_engine_where_there_are_many(tmp_path):
    jobs = [Job(replace(CASE, id=f"ring-{n}"), Beam()) for n in range(4)]
    run(jobs, cache_folder=tmp_path)
    for count, judged in ((3, 0), (4, 4)):
        done = []
        run(jobs[:count], cache_folder=tmp_path, prepared=Prepared(drawn, done.append))
        assert len(done) == judged


def test_without_a_store_this_process_judges():
    done = []
    run([Job(CASE, Beam())], prepared=Prepared(drawn, done.append))
    assert done == []
