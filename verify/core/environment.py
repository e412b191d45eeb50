"""Requirements of the project: versions of Python, shared libraries, Debian packages.

Only the standard library is used, and Python 3.7 can read the file, because the set-up (module
system_packages) runs before the virtual environment exists. Libraries and packages are listed only
here.
"""

from __future__ import annotations

import ctypes
import importlib
import shutil
import signal
import subprocess
import sys
from collections.abc import Collection, Sequence

OLDEST, NEWEST = (3, 11), (3, 14)  # versions with all wheels of requirements.txt
MESHES, PICTURES = "meshes", "pictures"  # gmsh needs the first, pyvista the second

# shared library, its Debian package, its users
LIBRARIES = (
    ("libGLU.so.1", "libglu1-mesa", MESHES),
    ("libGL.so.1", "libgl1", MESHES),
    ("libEGL.so.1", "libegl1", PICTURES),
    ("libXft.so.2", "libxft2", MESHES),
    ("libXcursor.so.1", "libxcursor1", MESHES),
    ("libXinerama.so.1", "libxinerama1", MESHES),
    ("libXfixes.so.3", "libxfixes3", MESHES),
    ("libfontconfig.so.1", "libfontconfig1", MESHES),
    ("libgomp.so.1", "libgomp1", MESHES),
)
PACKAGES = ("python3-venv", *(package for _, package, _ in LIBRARIES))
OPENGL = ("libEGL.so.1", "libGL.so.1")
DRIVERS = "apt-get install libegl-mesa0 libgl1-mesa-dri"  # drivers of OpenGL without a screen

# A sphere drawn off-screen: exit status 3 if the picture is empty.
RENDER = """
import pyvista
plotter = pyvista.Plotter(off_screen=True, window_size=(64, 64))
plotter.add_mesh(pyvista.Sphere(), color="red")
raise SystemExit(0 if plotter.screenshot(return_img=True).std() > 1 else 3)
"""
RENDER_SECONDS = 60.0


def python_problem(version: Sequence[int]) -> str:
    """Reason why Python `version` (major, minor, ...) is not supported; "" if it is supported."""
    if OLDEST <= tuple(version[:2]) <= NEWEST:
        return ""
    minors = range(NEWEST[1], OLDEST[1] - 1, -1)
    found = [name for name in (f"python3.{minor}" for minor in minors) if shutil.which(name)]
    remedy = f"make PYTHON={found[0]}" if found else "run make with PYTHON=PATH of such a version"
    return (
        f"needs Python 3.{OLDEST[1]} to 3.{NEWEST[1]}, but this is {version[0]}.{version[1]}: "
        f"{remedy}"
    )


def loads(library: str) -> bool:
    """Whether the dynamic linker finds the shared library."""
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def missing_libraries(need: str = "") -> tuple[str, ...]:
    """Shared libraries that are missing for the use `need` ("": any use); empty if not on Linux."""
    if sys.platform != "linux":
        return ()
    return tuple(library for library, _, of in LIBRARIES if need in ("", of) and not loads(library))


def install_line(libraries: Collection[str]) -> str:
    """Command that installs the Debian packages of `libraries`."""
    packages = [package for library, package, _ in LIBRARIES if library in libraries]
    return f"apt-get install {' '.join(packages)}"


def probe(script: str, seconds: float) -> str:
    """Run Python code in a separate process; returns its error in one line, "" if it succeeds."""
    try:
        done = subprocess.run(  # noqa: S603 - this interpreter and the project's script
            [sys.executable, "-c", script],
            capture_output=True, text=True, errors="replace", check=False, timeout=seconds,
            stdin=subprocess.DEVNULL,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return f"no answer within {seconds:g} s"
    if done.returncode == 0:
        return ""
    if done.returncode < 0:
        return f"killed by {signal.Signals(-done.returncode).name}"
    messages = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    return messages[-1] if messages else f"exit status {done.returncode}"


def missing_for_pictures(seconds: float = RENDER_SECONDS) -> str:
    """Reason why pyvista cannot draw off-screen, with the packages to install; "" if it can.

    The test draws in a separate process, because VTK ends the process without an exception if
    OpenGL is missing.
    """
    problem = probe(RENDER, seconds)
    if not problem:
        return ""
    problem = {"exit status 3": "the picture stays empty"}.get(problem, problem)
    return f"pyvista cannot draw off-screen ({problem}){remedy_for_pictures()}"


def remedy_for_pictures() -> str:
    """Text that names the packages to install if pyvista cannot draw; empty if not on Linux."""
    if sys.platform != "linux":
        return ""
    absent = [library for library in OPENGL if not loads(library)]
    if not absent:
        return f"; Mesa's drivers may be missing: {DRIVERS}"
    return f"; missing {', '.join(absent)}: {install_line(absent)}"


def missing_for_meshes(problem: str) -> str:
    """Message for a failed import of gmsh, with the packages to install."""
    absent = [x for x, _, of in LIBRARIES if f"{x}:" in problem or (of == MESHES and not loads(x))]
    if absent:
        return f"gmsh, which makes the meshes, needs {', '.join(absent)}: {install_line(absent)}"
    return f"gmsh, which makes the meshes, cannot be imported ({problem}): see freewheel doctor"


def require_gmsh() -> None:
    """Raise OSError with a message of one line if gmsh cannot be imported."""
    try:
        importlib.import_module("gmsh")  # by name: a check of the libraries needs no gmsh
    except ModuleNotFoundError:  # the package, not a system library
        raise
    except (ImportError, OSError) as error:
        raise OSError(missing_for_meshes(str(error))) from error
