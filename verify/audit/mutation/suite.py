"""Runs tests of the project in this process; finds called functions or the first failure.

The module must be used in a forked child process only, because pytest changes the state of the
process.
"""

import time
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import pytest
from hypothesis import Phase, settings

from verify.audit.mutation.tracing import ROOT, Calls
from verify.form.memoised import forget_memoised

OPTIONS = (
    "-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "-p", "no:hypothesispytest",
    "--assert=plain", "--capture=fd", "--tb=no",
    "--rootdir", str(ROOT), "-c", str(ROOT / "pyproject.toml"),
)  # fmt: skip
RUN = (
    pytest.ExitCode.OK,
    pytest.ExitCode.TESTS_FAILED,
    pytest.ExitCode.NO_TESTS_COLLECTED,  # a package without doctests
)
AT_MOST = 20.0  # s of tests for one mutant, by their duration with unchanged code
PER_FILE = 12.0  # s, after which a file's further tests are asked of no mutant
OTHERS = ("_calculix", "_ross", "_tamaas")  # tests with solvers that not every machine has
SHARED = 1.0  # s: shorter tests of a file that reaches a function are run, too
JUDGING = tuple(
    f"tests/verify/{name}.py"
    for name in (
        "test_judge", "test_convergence", "test_convergence_verdict", "test_checks",
        "test_agreement", "test_convergence_values", "test_checks_printed",
    )
)  # fmt: skip

# a failure is enough: it is neither made smaller nor looked for again, and is found in every run
settings.register_profile(
    "mutants", derandomize=True, database=None, phases=[Phase.explicit, Phase.generate]
)

TESTED = {"formulas": ("analytic",), "judging": ("verify",), "elements": ("fem", "meshes")}

Traces = Mapping[str, tuple[float, frozenset[str]]]  # of tests: seconds and functions


@dataclass(eq=False)  # pytest hashes its plugins
class _Tracer:
    """pytest plugin that records the duration and the called functions of each test."""

    found: dict[str, tuple[float, list[str]]] = field(default_factory=dict)
    is_stopped: bool = False

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        start, calls = time.process_time(), Calls()  # independent of other processes
        try:
            with calls:
                return (yield)
        finally:
            self.found[item.nodeid] = time.process_time() - start, calls.names()
            if sum(seconds for seconds, _ in self.found.values()) > PER_FILE:
                self.is_stopped = True
                item.session.shouldstop = "enough of this file is known"


@dataclass(eq=False)  # pytest hashes its plugins
class _Chosen:
    """pytest plugin that runs the given tests in their order and records the first failing test."""

    order: dict[str, int]
    failed: str = ""

    def pytest_collection_modifyitems(
        self, config: pytest.Config, items: list[pytest.Item]
    ) -> None:
        left = [item for item in items if item.nodeid not in self.order]
        items[:] = sorted(
            (item for item in items if item.nodeid in self.order),
            key=lambda item: self.order[item.nodeid],
        )
        config.hook.pytest_deselected(items=left)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self._note(report)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        self._note(report)

    def _note(self, report: pytest.TestReport | pytest.CollectReport) -> None:
        if report.failed and not self.failed:
            self.failed = report.nodeid


def traced(path: str) -> dict[str, tuple[float, list[str]]]:
    """Time [s] and called functions of each test of a file or folder.

    No test is started after PER_FILE [s]. Raises RuntimeError if the tests cannot be run. Without
    this error, such a file would count as a file that detects nothing.
    """
    forget_memoised()
    tracer = _Tracer()
    status = pytest.main([*OPTIONS[:1], *OPTIONS[2:], path], plugins=[tracer])
    if status not in RUN and not tracer.is_stopped:
        raise RuntimeError(f"pytest could not run the tests: {status!r}")
    return tracer.found


def first_failure(tests: Sequence[str]) -> str:
    """First failing test of `tests`, in their order; empty if all pass.

    Raises RuntimeError if the tests cannot be run, which does not count as a detection.
    """
    settings.load_profile("mutants")
    chosen = _Chosen({name: n for n, name in enumerate(tests)})
    files = dict.fromkeys(name.partition("::")[0] for name in tests)
    status = pytest.main([*OPTIONS, *files], plugins=[chosen])
    if chosen.failed or status == pytest.ExitCode.OK:
        return chosen.failed
    raise RuntimeError(f"pytest could not run the tests: {status!r}")


def covering(functions: Collection[str], traces: Traces, at_most: float = AT_MOST) -> list[str]:
    """Tests to run for changes of `functions`; their total time is at most `at_most` [s].

    Tests that call one of the functions are first; other short tests of the same files follow,
    because tests of one file may share the result of a call. Both groups are sorted by increasing
    time.
    """
    direct = {test for test, (_, called) in traces.items() if not called.isdisjoint(functions)}
    files = {test.partition("::")[0] for test in direct}
    shared = {
        test for test, (seconds, _) in traces.items()
        if test not in direct and seconds < SHARED and test.partition("::")[0] in files
    }  # fmt: skip
    chosen: list[str] = []
    total = 0.0
    for group in (direct, shared):
        for test in sorted(group, key=lambda test: (traces[test][0], test)):
            total += traces[test][0]
            if total > at_most and chosen:
                return chosen
            chosen.append(test)
    return chosen


def files(kind: str) -> list[str]:
    """Files and folders of the tests of one kind; tests of formulas include doctests."""
    if kind == "formulas":
        return [*_files("tests/analytic"), *_folders("analytic")]
    return list(JUDGING) if kind == "judging" else [*_files("tests/fem"), *_files("tests/meshes")]


def _files(folder: str) -> list[str]:
    return [
        str(path.relative_to(ROOT)) for path in sorted((ROOT / folder).rglob("test_*.py"))
        if not path.stem.endswith(OTHERS)
    ]  # fmt: skip


def _folders(package: str) -> list[str]:
    inside = sorted((ROOT / package).iterdir())
    return [str(path.relative_to(ROOT)) for path in inside if (path / "__init__.py").exists()]
