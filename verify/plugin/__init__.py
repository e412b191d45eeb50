"""pytest plugin: one test per row of a case file, one test for the check of a parameter file.

`pytest --freewheel my_case.py part.toml` runs the named files. If `freewheel_collect = true` is set
in the configuration, pytest also collects files without the option: those whose names match
`freewheel_cases` (default `case_*.py`) or `freewheel_parts` (no default).
"""

from pathlib import Path

import pytest

CASES, PARTS, ON = "freewheel_cases", "freewheel_parts", "freewheel_collect"
STRICT = "freewheel_strict"
# of rows: the words of `verify.core.results.Kind`, whose import takes 70 ms of every run of pytest
KINDS = ("identity", "asymptotic", "approximation", "trend", "fact", "exact")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the option and the settings to pytest."""
    parser.getgroup("freewheel").addoption(
        "--freewheel", action="store_true", help="collect case files and parameter files as tests"
    )
    parser.addini(ON, "collect these files without --freewheel", type="bool", default=False)
    parser.addini(CASES, "patterns of case files", type="args", default=["case_*.py"])
    parser.addini(PARTS, "patterns of parameter files", type="args", default=[])
    parser.addini(STRICT, "tests of results without a verdict fail", type="bool", default=False)


def pytest_configure(config: pytest.Config) -> None:
    """Register the markers of tests: freewheel, and the kinds of rows."""
    config.addinivalue_line("markers", "freewheel: a row of a case, or a part")
    for kind in KINDS:
        config.addinivalue_line("markers", f"{kind}: a row of this kind")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Collector of a case or parameter file that is given to pytest or matches a pattern."""
    if not _is_ours(file_path, parent.config):
        return None
    from verify.plugin.cases import CaseFile  # half a second, of every run of pytest
    from verify.plugin.parts import PartFile

    collector = CaseFile if file_path.suffix == ".py" else PartFile
    return collector.from_parent(parent, path=file_path)


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makemodule(
    module_path: Path, parent: pytest.Collector
) -> pytest.Collector | None:
    """Empty collector for case and parameter files, instead of the module that pytest makes."""
    if not _is_ours(module_path, parent.config):
        return None
    return NoModule.from_parent(parent, path=module_path)


class NoModule(pytest.File):
    """A case file whose functions are not tests."""

    def collect(self) -> list[pytest.Item]:
        """No tests."""
        return []


def _is_ours(file_path: Path, config: pytest.Config) -> bool:
    """Whether a file is a case file or a parameter file that is to be collected."""
    if not (config.getoption("--freewheel") or config.getini(ON)):
        return False
    setting = {".py": CASES, ".toml": PARTS}.get(file_path.suffix)
    if setting is None:
        return False
    fits = any(file_path.match(pattern) for pattern in config.getini(setting))
    return fits or (config.getoption("--freewheel") and _is_named(file_path, config))


def _is_named(file_path: Path, config: pytest.Config) -> bool:
    """Whether the command line names the file, and the name is not that of a test module."""
    named = (Path(config.invocation_params.dir, arg.partition("::")[0]) for arg in config.args)
    is_of_tests = file_path.match("test_*.py") or file_path.match("*_test.py")
    return file_path in {path.resolve() for path in named} and not is_of_tests
