"""Cases that are judged on the engine while others are solved, as this process judges them."""

from dataclasses import replace

from tests.verify.test_run import CASE, Beam
from verify.cases.registry import find
from verify.core.store import Store
from verify.jobs.executor import local
from verify.jobs.level import Job
from verify.jobs.scheduler import run


def compared(result):
    return replace(result, seconds=0.0, cached=False).rows, result.equations, result.command


def test_processes_judge_as_this_process_does(tmp_path):
    case = find("polyhedral-pressure")
    done = []
    (there,) = run(
        [Job(case, case.inputs())], engine=local(1), cache_folder=tmp_path, judged=done.append
    )
    (here,) = run([Job(case, case.inputs())], cache_folder=tmp_path)
    assert compared(there) == compared(here)
    assert done == [there]


def test_a_case_whose_levels_the_store_has_lost_is_judged_here(tmp_path):
    done = []
    jobs = [Job(replace(CASE, id=f"ring-{n}"), Beam()) for n in range(4)]
    run(jobs, cache_folder=tmp_path)

    def cleared(result):
        done.append(result)
        Store(tmp_path).clear("level")

    results = run(jobs, cache_folder=tmp_path, judged=cleared)
    assert [compared(one) for one in results] == [compared(one) for one in run(jobs)]
    assert len(done) == 1


def test_stored_cases_are_judged_on_the_engine_where_there_are_many(tmp_path):
    jobs = [Job(replace(CASE, id=f"ring-{n}"), Beam()) for n in range(4)]
    run(jobs, cache_folder=tmp_path)
    for count, judged in ((3, 0), (4, 4)):
        done = []
        run(jobs[:count], cache_folder=tmp_path, judged=done.append)
        assert len(done) == judged


def test_without_a_store_this_process_judges():
    done = []
    run([Job(CASE, Beam())], judged=done.append)
    assert done == []
