"""Set-up of a virtual environment from a lock file with hashes.

An interrupted set-up is continued. Only the standard library is used: the module is run as a script
(arguments: FOLDER LOCK) by the Python of the new environment. Packages are installed in small
groups. Files that a killed set-up has downloaded are not downloaded again, even if the index does
not let `pip` cache them. The exit status is 0, or 2 after one line with the reason.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from importlib.metadata import distributions
from pathlib import Path

ROOT = Path(__file__).parents[2]
READY = ".ready"  # in a complete environment: its parent folder and Python, read by tools/is-ready
LOG = "pip.txt"  # output of the last pip
FAILED = "failed.txt"  # why the last set-up ended early
SHARED = "shared.pth"
DOWNLOADS = "downloads"  # pip's temporary files, with complete downloads of a killed pip
GROUP = 8  # packages that one pip installs
PIN = re.compile(r"([A-Za-z0-9._-]+)==([^\s;\\]+)")
HASH = re.compile(r"--hash=sha256:([0-9a-f]{64})")
PIP = (
    "-I",
    "-m",
    "pip",
    "install",
    "--quiet",
    "--no-input",
    "--disable-pip-version-check",
    "--no-deps",
)
NO_NETWORK = ("Retrying (", "Temporary failure", "No route to host")


class SetUpError(Exception):
    """Error of the set-up; the message states the reason in one line."""


def pins(lock: str) -> dict[str, str]:
    """Entries of the lock file, including hashes, by name and version ("numpy==2.4.6")."""
    entries = re.split(r"^(?=[A-Za-z0-9])", lock, flags=re.MULTILINE)[1:]
    matches = ((PIN.match(entry), entry) for entry in entries)
    return {match[0]: entry for match, entry in matches if match}


def installed(site: Path) -> set[str]:
    """Names and versions ("numpy==2.4.6") of the packages in a site-packages folder."""
    found = distributions(path=[str(site)])
    return {f"{normalized(d.metadata['Name'])}=={d.version}" for d in found}


def normalized(name: str) -> str:
    """Name of a package in the spelling of the lock file."""
    return re.sub(r"[-_.]+", "-", name).lower()


def remove_incomplete(site: Path) -> list[str]:
    """Remove packages whose installation was killed, so that they are installed again.

    pip writes RECORD last. Before it replaces a package, it renames the old one to a name with "~".
    Returns the names of the removed packages.
    """
    found = site.glob("*.dist-info")
    killed = [x for x in found if not (x / "RECORD").is_file() or x.name.startswith("~")]
    for info in killed:
        shutil.rmtree(info)
    return [info.name for info in killed]


def usable(folder: Path) -> bool:
    """Whether `folder` contains an environment with pip, made there for this Python version."""
    pip = folder / "bin" / "pip"
    try:
        made_here = f"{folder}/bin/python" in pip.read_text("utf-8", "replace")
        words = [
            str(folder / "bin" / "python"),
            "-Ic",
            "import pip, sys; print(*sys.version_info[:2])",
        ]
        done = subprocess.run(words, capture_output=True, text=True, check=False)  # noqa: S603
    except OSError:
        return False
    same = done.stdout.split() == [str(number) for number in sys.version_info[:2]]
    whole = all((info / "RECORD").is_file() for info in site_packages(folder).glob("pip-*"))
    return made_here and done.returncode == 0 and same and whole


def site_packages(folder: Path) -> Path:
    version = "python{}.{}".format(*sys.version_info[:2])
    return folder / "lib" / version / "site-packages"


def create(folder: Path) -> None:
    """Make an empty environment with pip; it replaces the present content of `folder`."""
    if folder.is_symlink() or folder.is_file():
        folder.unlink()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    run([sys.executable, "-I", "-m", "venv", str(folder)], folder / LOG)


def run(words: list[str], log: Path, **environ: str) -> None:
    """Run a command with its output in `log`. Raises SetUpError with the reason if it fails.

    Ctrl-C kills the command immediately, so that pip does not delete its downloads. The command
    also holds the lock of `alone`: if only this process is killed, the next set-up waits for the
    end of the command.
    """
    with log.open("w", encoding="utf-8") as output:
        done = subprocess.run(  # noqa: S603 - the project's command
            words, stdout=output, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, check=False,
            env={**os.environ, **environ}, close_fds=False, preexec_fn=ignore_interrupts,
        )  # fmt: skip
    if done.returncode:
        raise SetUpError(reason(log.read_text("utf-8", "replace"), done.returncode))


def ignore_interrupts() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def reason(output: str, status: int) -> str:
    """Reason why pip or venv failed, in one line, from its output."""
    if any(sign in output for sign in NO_NETWORK):
        return "no connection to the package index"
    errors = [line[7:] for line in output.splitlines() if line.startswith("ERROR: ")]
    lines = errors or [line for line in output.splitlines() if line.strip()]
    return lines[-1].strip() if lines else f"exit status {status}"


def install(folder: Path, lock: str, others: set[str]) -> None:
    """Install the locked packages that neither `folder` nor `others` contains.

    Print the progress.
    """
    install_downloaded(folder, lock)
    there = installed(site_packages(folder)) | others
    todo = [entry for name, entry in pins(lock).items() if name not in there]
    with tempfile.TemporaryDirectory() as place:
        for start in range(0, len(todo), GROUP):
            group = Path(place) / "requirements.txt"
            group.write_text("".join(todo[start : start + GROUP]), "utf-8")
            last = min(start + GROUP, len(todo))
            print_message(
                f"installing packages {start + 1} to {last} of {len(todo)} into {folder.name}"
            )
            pip(folder, "--require-hashes", "-r", str(group))


def install_downloaded(folder: Path, lock: str) -> None:
    """Install the downloads that an interrupted pip completed, if their hashes are locked."""
    hashes = set(HASH.findall(lock))
    found = sorted((folder / DOWNLOADS).rglob("*.whl"))
    whole = [x for x in found if hashlib.sha256(x.read_bytes()).hexdigest() in hashes]
    once = {path.name: str(path) for path in whole}
    if once:
        print_message(f"installing packages that were downloaded before: {len(once)}")
        pip(folder, "--no-index", *once.values())
    shutil.rmtree(folder / DOWNLOADS, ignore_errors=True)


def pip(folder: Path, *words: str) -> None:
    temporary = folder / DOWNLOADS
    temporary.mkdir(exist_ok=True)
    command = [str(folder / "bin" / "python"), *PIP, *words]
    run(command, folder / LOG, TMPDIR=str(temporary))


@contextlib.contextmanager
def alone() -> Iterator[None]:
    """Context in which no other set-up of this folder runs; first waits until others have ended."""
    try:
        import fcntl
    except ImportError:  # not on this system
        yield
        return
    handle = os.open(ROOT, os.O_RDONLY)
    os.set_inheritable(handle, True)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            print_message("another set-up of this folder is running: waiting for its end")
            fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)


def set_up(folder: Path, lock: Path, *, project: bool, shared: Path | None) -> None:
    """Make or complete the environment `folder` from the lock file `lock`.

    With `project`, the project itself is installed in editable mode. Packages of the environment
    `shared` are used if their versions agree with the lock file.
    """
    for name in (READY, FAILED):
        (folder / name).unlink(missing_ok=True)
    if not usable(folder):
        print_message(f"making {folder.name} with Python {sys.version.split()[0]}, about a minute")
        create(folder)
    remove_incomplete(site_packages(folder))
    others: set[str] = set()
    if shared is not None:
        relative = os.path.relpath(site_packages(shared), site_packages(folder))
        (site_packages(folder) / SHARED).write_text(f"{relative}\n", "utf-8")
        others = installed(site_packages(shared))
    install(folder, lock.read_text("utf-8"), others)
    if project:
        pip(folder, "--no-build-isolation", "-e", str(ROOT))
    shutil.rmtree(folder / DOWNLOADS, ignore_errors=True)
    version = "{}.{}".format(*sys.version_info[:2])
    (folder / READY).write_text(f"{ROOT} {version}\n", "utf-8")
    print_message(f"{folder.name} is complete")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("lock", type=Path)
    parser.add_argument("--project", action="store_true", help="also install the project itself")
    parser.add_argument(
        "--shared", type=Path, help="environment whose packages are used if their versions agree"
    )
    words = parser.parse_args()
    folder = ROOT / words.folder
    shared = ROOT / words.shared if words.shared else None
    try:
        with alone():
            set_up(folder, ROOT / words.lock, project=words.project, shared=shared)
    except KeyboardInterrupt:
        print_message(f"the set-up of {folder.name} was interrupted; the next make continues it")
        return 130
    except (SetUpError, OSError) as error:
        if folder.is_dir():
            (folder / FAILED).write_text(f"{error}\n", "utf-8")
        print_message(
            f"the set-up of {folder.name} is not complete ({error}); the next make continues it"
        )
        return 2
    return 0


def print_message(message: str) -> None:
    print(f"freewheel: {message}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
