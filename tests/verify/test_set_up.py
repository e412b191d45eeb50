"""The set-up: system libraries if permitted, groups of packages, continuation after a stop."""

import fcntl
import hashlib
import os
import signal
import subprocess
import sys
import textwrap
import time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest

from verify.core import environment, system_packages, virtual_environment
from verify.core.system_packages import Machine, check, line_to_run
from verify.core.virtual_environment import GROUP, LOG, READY, pins, site_packages, usable

ROOT = Path(__file__).parents[2]
GLU, EGL = "libGLU.so.1", "libEGL.so.1"
DEBIAN_ROOT = Machine(root=True, apt=True)
UPDATE = "apt-get update"


@pytest.fixture
def machine(monkeypatch):
    """A machine without `lost` libraries; apt-get is recorded, with these statuses and texts."""

    def make(*lost, outputs=()):
        commands, answers = [], list(outputs)

        def run(words):
            commands.append(" ".join(words))
            return answers.pop(0) if answers else (0, "")

        monkeypatch.setattr(sys, "platform", "linux")
        monkeypatch.setattr(environment, "loads", lambda name: name not in lost)
        monkeypatch.setattr(system_packages, "_without_venv", lambda: False)
        monkeypatch.setattr(system_packages.time, "sleep", lambda seconds: None)
        monkeypatch.setattr(system_packages, "_run", run)
        return commands

    return make


def test_root_on_debian_names_and_installs_what_is_missing(machine, capsys):
    commands = machine(GLU, EGL)
    assert check(DEBIAN_ROOT) == ""
    update, install = commands
    assert update.endswith(" update")
    assert install.endswith(" install -y --no-install-recommends libglu1-mesa libegl1")
    (line,) = capsys.readouterr().err.splitlines()
    assert line.endswith("apt-get (FREEWHEEL_NO_APT=1 forbids it): libglu1-mesa libegl1")
    # package lists in use are waited for
    locked = (100, "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1\n")
    commands = machine(GLU, outputs=[locked, locked])
    assert check(DEBIAN_ROOT) == ""
    assert [words.split()[-1] for words in commands] == ["update"] * 3 + ["libglu1-mesa"]
    # an interrupted dpkg is repaired
    asked = f"E: dpkg was interrupted, you must manually run '{system_packages.REPAIR}'\n"
    commands = machine(GLU, outputs=[(0, ""), (100, asked)])
    assert check(DEBIAN_ROOT) == ""
    assert commands[2:] == [system_packages.REPAIR, commands[1]]
    # what fails has the reason of its first step
    offline = "Failed to fetch http://deb/InRelease Temporary failure resolving 'deb'"
    machine(GLU, outputs=[(0, f"W: {offline}\n"), (100, "E: Unable to locate package\n")])
    line = line_to_run([GLU], "", DEBIAN_ROOT)
    assert check(DEBIAN_ROOT) == f"apt-get failed ({offline}); run: {line}"


def test_elsewhere_the_line_to_run_is_given_and_nothing_is_run(machine):
    for this, line in (
        (Machine(apt=True), f"sudo {UPDATE} && sudo apt-get install -y libglu1-mesa"),
        (replace(DEBIAN_ROOT, forbidden=True), f"{UPDATE} && apt-get install -y libglu1-mesa"),
        (Machine(dnf=True), "sudo dnf install 'libGLU.so.1()(64bit)'"),
        (Machine(root=True), "install the packages that contain them (in Debian: libglu1-mesa)"),
    ):
        commands = machine(GLU)
        assert check(this) == f"missing {GLU}; run: {line}"
        assert commands == []


# Programs that the set-up starts

SLOW = """
    import pathlib, sys, time
    pathlib.Path(sys.argv[1]).touch()
    try:
        time.sleep(3)
    except KeyboardInterrupt:
        time.sleep(1)
    pathlib.Path(sys.argv[1]).write_text("ended by itself")
"""
APT = "from verify.core.system_packages import _run; _run(words)"
PIP = f"""
    import pathlib
    from verify.core import virtual_environment
    with virtual_environment.alone():
        virtual_environment.run(words, pathlib.Path(sys.argv[2]).parent / {LOG!r})
"""


def wait_until(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.mark.parametrize("text", [APT, PIP], ids=["ctrl-c of apt-get", "a kill of the set-up"])
def test_a_program_that_is_installing_ends_by_itself(text, tmp_path):
    """Dpkg may be at work; and a pip that outlives its set-up makes the next one wait."""
    script, mark = tmp_path / "slow.py", tmp_path / "mark"
    script.write_text(textwrap.dedent(SLOW))
    code = f"import sys; words = [sys.executable, *sys.argv[1:]]\n{textwrap.dedent(text)}"
    with subprocess.Popen(
        [sys.executable, "-c", code, str(script), str(mark)],
        cwd=ROOT, start_new_session=True, stderr=subprocess.DEVNULL,
    ) as process:  # fmt: skip
        wait_until(mark.exists)
        if text == APT:
            os.killpg(process.pid, signal.SIGINT)
        else:
            process.kill()
        process.wait(timeout=60)
    if text == PIP:
        handle = os.open(ROOT, os.O_RDONLY)
        with pytest.raises(BlockingIOError):
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        fcntl.flock(handle, fcntl.LOCK_EX)
        os.close(handle)
    assert mark.read_text() == "ended by itself"


# The virtual environment

NAMES = [f"package-{number}" for number in range(2 * GROUP + 1)]
LOCK = "".join(f"{name}==1.0 \\\n    --hash=sha256:0\n    # via x\n" for name in NAMES)
VERSION = "{}.{}".format(*sys.version_info[:2])


def add_package(folder, name, version="1.0"):
    info = site_packages(folder) / f"{name.replace('-', '_')}-{version}.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")
    (info / "RECORD").write_text("")


@pytest.fixture
def project(tmp_path, monkeypatch):
    """An empty project whose pip installs names alone, and fails at the packages in `broken`."""
    here = SimpleNamespace(folder=tmp_path / ".venv", created=0, asked=[], broken=set())

    def create(folder):
        here.created += 1
        site_packages(folder).mkdir(parents=True)

    def pip(folder, *words):
        wanted = dict(pin.split("==") for pin in pins(Path(words[-1]).read_text("utf-8")))
        here.asked += wanted
        if here.broken.intersection(wanted):
            raise virtual_environment.SetUpError("no connection to the package index")
        for name, version in wanted.items():
            add_package(folder, name, version=version)

    for name, replacement in {"ROOT": tmp_path, "create": create, "usable": Path.is_dir,
                              "pip": pip}.items():  # fmt: skip
        monkeypatch.setattr(virtual_environment, name, replacement)
    return here


def complete(project, lock=LOCK):
    """The packages that pip is called with."""
    path = project.folder.parent / "lock.txt"
    path.write_text(lock, "utf-8")
    project.asked = []
    virtual_environment.set_up(project.folder, path, project=False, shared=None)
    return project.asked


def test_every_entry_of_the_lock_is_installed_once(project, capsys):
    assert (complete(project), project.created) == (NAMES, 1)
    assert (project.folder / READY).read_text() == f"{project.folder.parent} {VERSION}\n"
    lines = capsys.readouterr().err.splitlines()
    assert lines[1] == f"freewheel: installing packages 1 to {GROUP} of {len(NAMES)} into .venv"
    # what was changed, or killed while it was installed
    assert complete(project, lock=LOCK.replace("package-7==1.0", "package-7==2.0")) == ["package-7"]
    (site_packages(project.folder) / "package_3-1.0.dist-info" / "RECORD").unlink()
    assert "package-3" in complete(project)
    lock = (ROOT / "requirements.txt").read_text("utf-8")
    assert "".join(pins(lock).values()) == lock
    assert all("--hash=sha256:" in entry for entry in pins(lock).values())


def test_an_interrupted_set_up_is_continued(project, monkeypatch, capsys):
    project.broken = {NAMES[GROUP]}
    project.folder.parent.joinpath("lock.txt").write_text(LOCK)
    monkeypatch.setattr(sys, "argv", ["virtual_environment", ".venv", "lock.txt"])
    monkeypatch.chdir(project.folder.parent)
    assert virtual_environment.main() == 2
    assert "not complete (no connection to the package index)" in capsys.readouterr().err
    assert (
        project.folder / virtual_environment.FAILED
    ).read_text() == "no connection to the package index\n"
    assert not (project.folder / READY).exists()
    project.broken = set()
    assert (complete(project), project.created) == (NAMES[GROUP:], 1)


def is_ready(folder, *pythons):
    words = [ROOT / "tools" / "is-ready", *pythons]
    return subprocess.run(words, cwd=folder.parent, check=False, timeout=60).returncode == 0


def test_an_environment_is_used_where_it_is_whole_and_of_this_python_and_place(
    tmp_path, monkeypatch
):
    folder = tmp_path / "project" / ".venv"
    words = [sys.executable, "-I", "-m", "venv", "--without-pip", str(folder)]
    subprocess.run(words, check=True, timeout=60)
    # the traces of pip that `usable` looks for, and a complete one's mark
    (folder / "bin" / "pip").write_text(f"#!{folder}/bin/python3\n")
    (site_packages(folder) / "pip.py").write_text("")
    add_package(folder, "pip")
    (folder / READY).write_text(f"{folder.parent} {VERSION}\n")
    assert usable(folder)
    assert is_ready(folder, sys.executable)
    with monkeypatch.context() as patch:
        patch.setattr(sys, "version_info", (3, 1, 0))
        assert not usable(folder)
    moved = folder.parent.rename(tmp_path / "moved") / ".venv"
    assert not usable(moved)
    assert not is_ready(moved)
    moved.parent.rename(folder.parent)
    (folder / "bin" / "pip").unlink()
    assert not usable(folder)
    (folder / READY).write_text(f"{folder.parent} 3.1\n")
    assert not is_ready(folder)


def test_what_a_killed_pip_had_downloaded_whole_is_installed_from_there(tmp_path, monkeypatch):
    calls = []
    monkeypatch.setattr(virtual_environment, "pip", lambda folder, *words: calls.append(words))
    place = tmp_path / virtual_environment.DOWNLOADS / "pip-unpack-x"
    place.mkdir(parents=True)
    (place / "whole-1.0-py3-none-any.whl").write_bytes(b"whole")
    (place / "part-1.0-py3-none-any.whl").write_bytes(b"who")
    digest = hashlib.sha256(b"whole").hexdigest()
    lock = f"whole==1.0 --hash=sha256:{digest}\npart==1.0 --hash=sha256:{'0' * 64}\n"
    virtual_environment.install_downloaded(tmp_path, lock)
    assert calls == [("--no-index", str(place / "whole-1.0-py3-none-any.whl"))]
    assert not (tmp_path / virtual_environment.DOWNLOADS).exists()
