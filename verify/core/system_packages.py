"""Checks before the set-up: Python, and system libraries, which apt-get installs if permitted.

Only the standard library is used, and Python 3.7 can read the file, because the module runs as a
script before the virtual environment exists. The exit status is 0; 2 after one line with the
required action; 130 after Ctrl-C.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path

from verify.core.environment import LIBRARIES, MESHES, missing_libraries, python_problem

FORBIDDEN = "FREEWHEEL_NO_APT"  # if set, nothing is installed and the command to run is printed
LOCK_SECONDS = 120  # s: another apt-get or dpkg may need this long
APT = ("apt-get", "-q", "-o", f"DPkg::Lock::Timeout={LOCK_SECONDS}", "-o", "Acquire::Retries=1")
INSTALL = (*APT, "install", "-y", "--no-install-recommends")
REPAIR = "dpkg --configure -a"  # required by apt-get after an interrupted installation


@dataclass(frozen=True)
class Machine:
    """Properties of a machine that decide whether, and by which command, packages are installed."""

    root: bool = False
    apt: bool = False  # Debian, Ubuntu or a descendant, with apt-get
    dnf: bool = False
    forbidden: bool = False  # by FREEWHEEL_NO_APT

    @property
    def may_install(self) -> bool:
        return self.root and self.apt and not self.forbidden


def this_machine() -> Machine:
    """Properties of this machine and of the user of this process."""
    return Machine(
        root=hasattr(os, "geteuid") and os.geteuid() == 0,
        apt=debian_family(_os_release()) and shutil.which("apt-get") is not None,
        dnf=shutil.which("dnf") is not None,
        forbidden=os.environ.get(FORBIDDEN, "0") not in ("", "0"),
    )


def debian_family(os_release: str) -> bool:
    """Whether the text of /etc/os-release belongs to Debian, Ubuntu or a derivative."""
    pairs = (line.partition("=")[::2] for line in os_release.splitlines())
    names = {key: value.strip("\"'").split() for key, value in pairs}
    return "debian" in names.get("ID", []) + names.get("ID_LIKE", []) or "ubuntu" in names.get(
        "ID", []
    )


def venv_package(prefix: str, version: Sequence[int]) -> str:
    """Debian package with venv for the Python installed at `prefix`; "" if there is none."""
    return f"python{version[0]}.{version[1]}-venv" if prefix == "/usr" else ""


def packages_for(libraries: Collection[str], venv: str = "") -> list[str]:
    """Debian packages to install: `venv`, if not empty, then packages that contain `libraries`."""
    found = [package for library, package, _ in LIBRARIES if library in libraries]
    return [venv, *found] if venv else found


def line_to_run(libraries: Collection[str], venv: str, machine: Machine) -> str:
    """Command that installs the missing packages on `machine`."""
    packages = " ".join(packages_for(libraries, venv))
    sudo = "" if machine.root else "sudo "
    if machine.apt:
        return f"{sudo}apt-get update && {sudo}apt-get install -y {packages}"
    if machine.dnf:
        return " ".join([f"{sudo}dnf install", *(f"'{library}()(64bit)'" for library in libraries)])
    return f"install the packages that contain them (in Debian: {packages})"


def apt_install(packages: Sequence[str]) -> str:
    """Install Debian packages without questions; returns "", or the reason of a failure."""
    outdated = _update()
    status, output = _run([*INSTALL, *packages])
    if status and REPAIR in output:
        _run(REPAIR.split())
        status, output = _run([*INSTALL, *packages])
    return (outdated or reason(output) or f"exit status {status}") if status else ""


def reason(output: str) -> str:
    """First line of apt-get's output that states an error; "" if there is none."""
    starts = ("E: ", "W: Failed to fetch")
    lines = [line for line in output.splitlines() if line.startswith(starts)]
    return " ".join(lines[0][3:].split()) if lines else ""


def _update() -> str:
    """Update the package lists, after waiting for another apt-get; returns "" or the error."""
    end = time.monotonic() + LOCK_SECONDS
    while True:
        _, output = _run([*APT, "update"])
        if "lists/lock" not in output or time.monotonic() > end:
            return reason(output)
        time.sleep(2)


def _run(words: Sequence[str]) -> tuple[int, str]:
    """Run a command without questions to the user; returns its exit status and its output.

    After Ctrl-C, wait for the end of the command.
    """
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C"}
    with subprocess.Popen(  # noqa: S603 - the project's command
        words, env=quiet, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, errors="replace",
    ) as process:  # fmt: skip
        try:
            output = process.communicate()[0]
        except KeyboardInterrupt:  # apt-get also gets the signal, and ends without breaking dpkg
            process.communicate()
            raise
    return process.returncode, output


def _os_release() -> str:
    path = Path("/etc/os-release")
    return path.read_text("utf-8", "replace") if path.is_file() else ""


def _without_venv() -> bool:
    """Whether this Python cannot make a virtual environment that contains pip."""
    importlib.invalidate_caches()
    return importlib.util.find_spec("venv") is None or importlib.util.find_spec("ensurepip") is None


def _install(libraries: Sequence[str], venv: str, machine: Machine) -> str:
    """Install missing packages; returns "", or a message with the command to run."""
    packages = packages_for(libraries, venv)
    _print_message(f"installing with apt-get ({FORBIDDEN}=1 forbids it): {' '.join(packages)}")
    problem = apt_install(packages)
    if not problem:
        return ""
    return f"apt-get failed ({problem}); run: {line_to_run(libraries, venv, machine)}"


def check(machine: Machine) -> str:
    """Install or report missing packages.

    Returns "" if the set-up can continue, otherwise the reason in one line.
    """
    problem = python_problem(sys.version_info[:2])
    if problem:
        return problem
    lacking = _without_venv()
    venv = venv_package(sys.base_prefix, sys.version_info[:2]) if lacking else ""
    if lacking and not venv:
        return (
            f"{sys.executable} has no module venv or ensurepip: set PYTHON to a Python that "
            "has both"
        )
    missing = missing_libraries()
    if (missing or venv) and machine.may_install:
        return _install(missing, venv, machine)
    what = ", ".join([*(["the module ensurepip"] if venv else []), *missing])
    line = line_to_run(missing, venv, machine)
    if venv or missing_libraries(MESHES):
        return f"missing {what}; run: {line}"
    if missing:
        _print_message(f"without {what}, reports have fewer pictures; run: {line}")
    return ""


def main() -> int:
    try:
        problem = check(this_machine())
    except KeyboardInterrupt:
        _print_message(
            "the installation of system libraries was interrupted; the next make continues it"
        )
        return 130
    if problem:
        _print_message(problem)
    return 2 if problem else 0


def _print_message(message: str) -> None:
    print(f"freewheel: {message}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
