"""Provenance of the numbers of a report: versions, commit, lock file, times."""

import hashlib
import platform
import subprocess
import time
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from verify.core.results import CaseResult

PACKAGES = (
    "cyclopts", "gmsh", "jinja2", "matplotlib", "meshio", "numpy", "pint", "pydantic", "pyvista",
    "scikit-fem", "scipy", "typst", "xlsxwriter",
)  # fmt: skip


def provenance(root: Path, results: Sequence[CaseResult], seconds: float) -> dict[str, Any]:
    """Provenance of a run for the report; an unknown commit or lock file is "unknown"."""
    return {
        "made": time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime()),
        **conditions(root),
        "processor": processor(),
        "blas": _blas(),
        "seconds": {r.id: round(r.seconds, 3) for r in results} | {"total": round(seconds, 3)},
        "cached": {r.id: r.cached for r in results},
        "cells": {f"{r.id}, {f}": n for r in results for f, n in r.cells.items()},
    }


def conditions(root: Path) -> dict[str, Any]:
    """Environment of a run: commit, hash of the lock file, Python, machine, package versions."""
    lock = root / "requirements.txt"
    return {
        "commit": _commit(root),
        "lock": hashlib.sha256(lock.read_bytes()).hexdigest()[:12] if lock.is_file() else "unknown",
        "python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
        "versions": {name: version_of(name) for name in PACKAGES},
    }


def processor(path: Path = Path("/proc/cpuinfo")) -> str:
    """Name of the first processor on Linux; "unknown" on other systems."""
    try:
        text = path.read_text("utf-8")
    except OSError:
        return "unknown"
    line = next((line for line in text.splitlines() if line.startswith("model name")), "")
    return line.partition(":")[2].strip() or "unknown"


def _blas() -> str:
    """Text with kernels and number of threads of each loaded BLAS library."""
    from verify.audit.portable.effective import effective  # loads scipy

    found = effective()
    return ", ".join(
        f"{owner} {kernels or 'unknown'} on {found['threads'][owner]} thread(s)"
        for owner, kernels in sorted(found["blas"].items())
    )


def version_of(name: str) -> str:
    """Version of an installed package; "not installed" if it is missing."""
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def _commit(root: Path) -> str:
    try:
        run = ["git", "-C", str(root), "describe", "--always", "--dirty", "--abbrev=10"]
        done = subprocess.run(run, capture_output=True, text=True, timeout=10, check=True)  # noqa: S603
    except (OSError, subprocess.SubprocessError):
        return "unknown"
    return done.stdout.strip() or "unknown"
