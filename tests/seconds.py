"""Processor seconds of each test file against those of a ledger, and reasons of slow tests.

A whole run names the files that take far more than the ledger says, on the scale of this machine,
and the tests of over SLOW seconds that have no mark `slow` with their reason. The ledger is of a
run that found the levels of all cases in the store: `pytest --keep-seconds` writes it after such a
run, and with `--check-seconds` such a run fails where it names something.
"""

import json
import resource
import time
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from statistics import median
from typing import Any

import pytest

LEDGER = Path(__file__).with_name("seconds.json")
SLOW = 5.0  # s of a test, beyond which it states its reason
LEAST = 10.0  # s that a file may take longer in any case
GROWTH = 2.0  # times its seconds of the ledger
WHOLE = 0.9  # of the ledger's files, from which on a run counts as a whole one
LISTED = 12
spent: defaultdict[str, float] = defaultdict(float)  # by test
slow: dict[str, str] = {}  # reasons by test


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--keep-seconds", action="store_true", help="write tests/seconds.json")
    parser.addoption("--check-seconds", action="store_true", help="fail beyond tests/seconds.json")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    start = processor()
    if mark := item.get_closest_marker("slow"):
        slow[item.nodeid] = str(mark.args[0])
    result = yield
    spent[item.nodeid] += processor() - start
    return result


def processor() -> float:
    """Seconds of this process and of those that it has started and that have ended."""
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + ended.ru_utime + ended.ru_stime


@pytest.hookimpl(optionalhook=True)  # the mutants run without xdist
def pytest_testnodedown(node: Any) -> None:
    """What a worker has measured."""
    output = getattr(node, "workeroutput", {})
    for test, seconds in output.get("spent", {}).items():
        spent[test] += seconds
    slow.update(output.get("slow", {}))


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    output = getattr(session.config, "workeroutput", None)
    if output is not None:
        output |= {"spent": dict(spent), "slow": slow}
        return
    if session.config.getoption("--keep-seconds"):
        kept = {name: round(seconds, 1) for name, seconds in sorted(by_file(spent).items())}
        LEDGER.write_text(f"{json.dumps(kept, indent=0)}\n", "utf-8")
    elif session.config.getoption("--check-seconds") and faults():
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    files = by_file(spent)
    if is_whole(files):
        terminalreporter.section("processor seconds")
        largest = sorted(files.items(), key=lambda one: -one[1])[:LISTED]
        terminalreporter.line(f"{sum(files.values()):.0f} s in {len(files)} files")
        for line in [f"{seconds:7.1f} {name}" for name, seconds in largest] + faults():
            terminalreporter.line(line)


def by_file(tests: Mapping[str, float]) -> dict[str, float]:
    """Seconds of each file."""
    found: defaultdict[str, float] = defaultdict(float)
    for test, seconds in tests.items():
        found[test.partition("::")[0]] += seconds
    return dict(found)


def is_whole(files: Mapping[str, float]) -> bool:
    """Whether nearly all files of the ledger were run."""
    known = _ledger()
    return bool(known) and len(known.keys() & files.keys()) >= WHOLE * len(known)


def faults() -> list[str]:
    """Files that have grown, and slow tests without a reason, in a whole run."""
    files, known = by_file(spent), _ledger()
    if not is_whole(files):
        return []
    ratios = [files[name] / known[name] for name in known.keys() & files.keys() if known[name] > 1]
    scale = median(ratios) if ratios else 1.0  # of this machine's speed
    grown = [
        f"{name}: {seconds:.0f} s, {GROWTH * known.get(name, 0) * scale + LEAST:.0f} s expected "
        "at most by tests/seconds.json (pytest --keep-seconds)"
        for name, seconds in files.items()
        if seconds > GROWTH * known.get(name, 0) * scale + LEAST
    ]
    return grown + [
        f"{test}: {seconds:.0f} s without a mark `slow` that states the reason"
        for test, seconds in spent.items()
        if seconds > SLOW * max(scale, 1.0) and test not in slow
    ]


def _ledger() -> dict[str, float]:
    known: dict[str, float] = json.loads(LEDGER.read_text("utf-8")) if LEDGER.is_file() else {}
    return known
