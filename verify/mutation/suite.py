"""The project's own tests, run in this process: which functions each calls, and whether one fails.

Run it in a forked child only: pytest leaves its traces in the process.
"""

import sys
import time
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import CodeType, FrameType
from typing import Any

import pytest

from verify.mutation.tracing import ROOT, named

OPTIONS = (
    "-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "--capture=fd", "--tb=no",
    "--rootdir", str(ROOT), "-c", str(ROOT / "pyproject.toml"),
)  # fmt: skip
AT_MOST = 30.0  # s of tests for one mutant, by what they took unchanged
SHARED = 1.0  # s: shorter tests of a file that reaches a function are run, too
JUDGING = tuple(
    f"tests/verify/{name}.py"
    for name in (
        "test_judge", "test_convergence", "test_convergence_verdict", "test_checks",
        "test_judged_edges", "test_agreement",
    )
)  # fmt: skip

TESTED = {"formulas": ("analytic",), "judging": ("verify",), "elements": ("fem", "meshes")}

Traces = Mapping[str, tuple[float, frozenset[str]]]  # of tests: seconds and functions


@dataclass(eq=False)  # pytest hashes its plugins
class _Tracer:
    """Notes for each test how long it takes and which functions it calls."""

    found: dict[str, tuple[float, list[str]]] = field(default_factory=dict)

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        codes: set[CodeType] = set()

        def note(frame: FrameType, event: str, _argument: Any) -> None:
            if event == "call":
                codes.add(frame.f_code)

        start = time.process_time()  # whoever else is at work
        sys.setprofile(note)
        try:
            return (yield)
        finally:
            sys.setprofile(None)
            self.found[item.nodeid] = time.process_time() - start, named(codes)


@dataclass(eq=False)  # pytest hashes its plugins
class _Chosen:
    """Runs the tests that are named, in their order, and remembers the first that fails."""

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
    """Seconds and called functions of every test of a file or folder."""
    tracer = _Tracer()
    pytest.main([*OPTIONS[:1], *OPTIONS[2:], path], plugins=[tracer])
    return tracer.found


def first_failure(tests: Sequence[str]) -> str:
    """The first of these tests, in their order, that fails; empty where all pass.

    RuntimeError where they do not run: that is no merit of the tests.
    """
    chosen = _Chosen({name: n for n, name in enumerate(tests)})
    files = dict.fromkeys(name.partition("::")[0] for name in tests)
    status = pytest.main([*OPTIONS, *files], plugins=[chosen])
    if chosen.failed or status == pytest.ExitCode.OK:
        return chosen.failed
    raise RuntimeError(f"pytest ends with {status!r}")


def covering(functions: Collection[str], traces: Traces, at_most: float = AT_MOST) -> list[str]:
    """Tests that reach one of these functions: that call it themselves first, the quickest first.

    Of a file that reaches it by what its tests share all short tests count.
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
    """Files and folders of tests, for formulas with the doctests."""
    if kind == "formulas":
        return [*_files("tests/analytic"), *_folders("analytic")]
    return list(JUDGING) if kind == "judging" else [*_files("tests/fem"), *_files("tests/meshes")]


def _files(folder: str) -> list[str]:
    return [str(path.relative_to(ROOT)) for path in sorted((ROOT / folder).rglob("test_*.py"))]


def _folders(package: str) -> list[str]:
    inside = sorted((ROOT / package).iterdir())
    return [str(path.relative_to(ROOT)) for path in inside if (path / "__init__.py").exists()]
