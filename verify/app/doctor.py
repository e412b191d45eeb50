"""The command `doctor`: components of this machine, available or missing, one line each.

Components that may crash are tried in separate processes, which run in parallel.
"""

import importlib.util
import json
import os
import platform
import shutil
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path

from verify.app.extras import PACKAGE, shared_names
from verify.app.installed import installed, mismatches
from verify.core import environment
from verify.core.environment import LIBRARIES
from verify.core.terminal import print_wrapped
from verify.studies.crosscheck import solvers
from verify.studies.crosscheck.calculix import running
from verify.studies.crosscheck.statement import CALCULIX, SOLVERS

ROOT = Path(__file__).parents[2]
OK, MISSING, OPTIONAL = "ok", "missing", "optional"
SHOWN = (
    "numpy", "scipy", "scikit-fem", "gmsh", "numba", "scikit-learn", "cvxopt", "pydantic", "pint",
    "cyclopts", "pyvista", "typst",
)  # fmt: skip
SOLVING = (
    "numpy", "scipy", "skfem", "gmsh", "numba", "sklearn", "cvxopt", "pydantic", "pint", "jinja2",
    "meshio",
)  # fmt: skip
TYPST = 'import typst\nassert typst.compile(b"Hello")'
SECONDS = 60.0
SEPARATE = "install this package in a separate environment"


@dataclass(frozen=True)
class Finding:
    """One line of output about a component; `fatal`: without the component, no run is possible."""

    what: str
    state: str
    detail: str
    fatal: bool = False


def run_doctor(*, as_json: bool) -> int:
    """Print all findings and return the exit status.

    It is 0 if `verify` can run, possibly with fewer pictures, and 2 if it cannot.
    """
    found = list(findings())
    fatal = any(f.fatal for f in found)
    last = conclusion(found)
    if as_json:
        lines = [asdict(f) for f in found]
        print(json.dumps({"ok": not fatal, "conclusion": last, "findings": lines}))
    else:
        width = max(len(f.what) for f in found)
        for f in found:
            print_wrapped(f"{f.state:8}  {f.what:{width}}  {f.detail}")
        print(last)
    return 2 if fatal else 0


def conclusion(found: list[Finding]) -> str:
    """Statement that no component is missing, or the action to take."""
    lost = [f for f in found if f.state == MISSING]
    if not lost:
        return "no component is missing"
    consequence = (
        "verify cannot run"
        if any(f.fatal for f in lost)
        else ("verify runs, but some parts of the report are missing")
    )
    libraries = [f.what for f in lost if f.what in {library for library, _, _ in LIBRARIES}]
    remedy = environment.install_line(libraries) if libraries else "; ".join(f.detail for f in lost)
    return f"{consequence}: {remedy}"


def findings() -> Iterator[Finding]:
    """All findings, in the order machine, packages, libraries, solvers, folders."""
    with ThreadPoolExecutor() as pool:
        gmsh = pool.submit(environment.probe, "import gmsh", SECONDS)
        pictures = pool.submit(environment.missing_for_pictures)
        typst = pool.submit(environment.probe, TYPST, SECONDS)
        others = [pool.submit(_solver, name) for name in SOLVERS]
        yield from _machine()
        yield from _packages()
        yield from _libraries()
        problem = gmsh.result() and environment.missing_for_meshes(gmsh.result())
        yield _tried("gmsh makes meshes", problem, fatal=True)
        yield _tried("pictures by pyvista", pictures.result())
        yield _tried("PDF by typst", typst.result())
        second = [found.result() for found in others]
    yield _cache()
    yield _output()
    yield from second
    browser = shutil.which("chromium") or ""  # used by tests of the page
    yield Finding("chromium", OK if browser else OPTIONAL, browser or "not installed")


def _machine() -> Iterator[Finding]:
    problem = environment.python_problem(sys.version_info[:2])
    detail = f"{platform.python_version()}, {sys.executable}" + (f": {problem}" if problem else "")
    yield Finding("Python", MISSING if problem else OK, detail, fatal=bool(problem))
    yield Finding("machine", OK, f"{platform.platform()}, {_cores()} cores, {_memory()}")


def _cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _memory() -> str:
    try:
        size = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (ValueError, OSError, AttributeError):  # not on this system
        return "memory unknown"
    return f"{size / 1e9:.1f} GB"


def _packages() -> Iterator[Finding]:
    absent = [name for name in SOLVING if importlib.util.find_spec(name) is None]
    known = ", ".join(f"{name} {installed(name) or 'absent'}" for name in SHOWN)
    set_up = "make setup" if (ROOT / "Makefile").is_file() else f"pip install '{PACKAGE}[report]'"
    text = f"missing {', '.join(absent)}: {set_up}" if absent else known
    yield Finding("packages", MISSING if absent else OK, text, fatal=bool(absent))
    if shared := shared_names():
        yield Finding(
            "names", MISSING, f"other packages also contain {', '.join(shared)}: {SEPARATE}"
        )
    lock = ROOT / "requirements.txt"
    if lock.is_file():
        differ = "; ".join(mismatches(lock.read_text("utf-8")))
        same = "the installed packages agree with requirements.txt"
        yield Finding("lock", MISSING if differ else OK, differ or same)


def _libraries() -> Iterator[Finding]:
    missing = environment.missing_libraries()
    for library, package, need in LIBRARIES if sys.platform == "linux" else ():
        if library in missing:
            detail = f"{environment.install_line([library])} ({need})"
            yield Finding(library, MISSING, detail, fatal=need == environment.MESHES)
        else:
            yield Finding(library, OK, package)


def _tried(what: str, problem: str, *, fatal: bool = False) -> Finding:
    return Finding(what, MISSING if problem else OK, problem or "works", fatal and bool(problem))


def _cache() -> Finding:
    try:
        from verify.jobs.cache import default_folder
    except (ImportError, OSError) as error:
        return Finding("cache", MISSING, str(error))
    folder = default_folder()
    problem = _unwritable(folder)
    if problem:
        return Finding(
            "cache", MISSING, f"{folder}: {problem}: results cannot be stored and reused"
        )
    size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
    free = shutil.disk_usage(folder).free
    return Finding("cache", OK, f"{folder}: {size / 1e6:.1f} MB, {free / 1e9:.1f} GB free")


def _output() -> Finding:
    folder = ROOT / "reports" / "out"
    problem = _unwritable(folder)
    detail = f"{folder}: {problem}: run verify with --out FOLDER" if problem else str(folder)
    return Finding("report folder", MISSING if problem else OK, detail)


def _unwritable(folder: Path) -> str:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return ""
    except OSError as error:
        return error.strerror or str(error)


def _solver(name: str) -> Finding:
    """Finding about a second solver, which no run requires."""
    found = solvers.solver(name)
    if found.missing:
        return Finding(name, OPTIONAL, found.missing)
    place = running.executable() if name == CALCULIX else solvers.interpreter()
    return Finding(name, OK, f"{found.version}, {place}")
