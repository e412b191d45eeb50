"""Results of forked child processes, as a campaign receives them."""

from verify.audit.mutation.sandbox import Answer, Task, forks, perform
from verify.jobs.executor import Drive


def answers(tasks, jobs=1):
    """The answer of each task as they come."""
    with forks(jobs) as engine:
        for event in Drive(engine, perform).answers(tasks):
            if event is not None:
                yield event[1]


def answer(work, limit) -> Answer:
    """The answer of one task."""
    (found,) = answers([Task(0, work, limit)])
    return found
