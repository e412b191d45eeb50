"""The set-up installs what is missing, in groups, and continues where it was interrupted."""

import fcntl
import hashlib
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from verify.core import virtual_environment
from verify.core.virtual_environment import (
    DOWNLOADS,
    FAILED,
    GROUP,
    LOG,
    READY,
    SetUpError,
    install_downloaded,
    pins,
    reason,
    remove_incomplete,
    set_up,
    site_packages,
    usable,
)

ROOT = Path(__file__).parents[2]
NAMES = [f"package-{number}" for number in range(2 * GROUP + 1)]
LOCK = "".join(f"{name}==1.0 \\\n    --hash=sha256:0\n    # via x\n" for name in NAMES)
VERSION = "{}.{}".format(*sys.version_info[:2])


def add_package(folder, name, *, complete=True, version="1.0"):
    info = site_packages(folder) / f"{name.replace('-', '_')}-{version}.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")
    if complete:
        (info / "RECORD").write_text("")


@pytest.fixture
def project(tmp_path, monkeypatch):
    """An empty project whose pip installs names alone, and fails at the packages in `broken`."""
    here = SimpleNamespace(folder=tmp_path / ".venv", created=0, asked=[], broken=set())

    def create(folder):
        here.created += 1
        site_packages(folder).mkdir(parents=True)

    def pip(folder, *words):
        group = Path(words[-1])
        wanted = dict(pin.split("==") for pin in pins(group.read_text("utf-8")))
        here.asked += wanted
        if here.broken.intersection(wanted):
            raise SetUpError("no connection to the package index")
        for name, version in wanted.items():
            add_package(folder, name, version=version)

    monkeypatch.setattr(virtual_environment, "ROOT", tmp_path)
    monkeypatch.setattr(virtual_environment, "create", create)
    monkeypatch.setattr(virtual_environment, "usable", Path.is_dir)
    monkeypatch.setattr(virtual_environment, "pip", pip)
    return here


def complete(project, shared=None, lock=LOCK):
    path = project.folder.parent / "lock.txt"
    path.write_text(lock, "utf-8")
    set_up(project.folder, path, project=False, shared=shared)


def test_every_entry_of_the_lock_is_installed_once(project, capsys):
    complete(project)
    assert (project.created, project.asked) == (1, NAMES)
    assert (project.folder / READY).read_text() == f"{project.folder.parent} {VERSION}\n"
    lines = capsys.readouterr().err.splitlines()
    assert lines[1] == f"freewheel: installing packages 1 to {GROUP} of {len(NAMES)} into .venv"
    assert len(lines) == 5


def test_an_interrupted_set_up_is_continued(project):
    project.broken = {NAMES[GROUP]}
    with pytest.raises(SetUpError):
        complete(project)
    assert not (project.folder / READY).exists()
    project.broken, project.asked = set(), []
    complete(project)
    assert (project.created, project.asked) == (1, NAMES[GROUP:])


def test_a_package_whose_installation_was_killed_is_installed_again(project):
    complete(project)
    (site_packages(project.folder) / "package_3-1.0.dist-info" / "RECORD").unlink()
    project.asked = []
    complete(project)
    assert project.asked == ["package-3"]


def test_what_a_killed_pip_had_downloaded_whole_is_installed_from_there(tmp_path, monkeypatch):
    calls = []
    monkeypatch.setattr(virtual_environment, "pip", lambda folder, *words: calls.append(words))
    place = tmp_path / DOWNLOADS / "pip-unpack-x"
    place.mkdir(parents=True)
    (place / "whole-1.0-py3-none-any.whl").write_bytes(b"whole")
    (place / "part-1.0-py3-none-any.whl").write_bytes(b"who")
    digest = hashlib.sha256(b"whole").hexdigest()
    lock = f"whole==1.0 --hash=sha256:{digest}\npart==1.0 --hash=sha256:{'0' * 64}\n"
    install_downloaded(tmp_path, lock)
    assert calls == [("--no-index", str(place / "whole-1.0-py3-none-any.whl"))]
    assert not (tmp_path / DOWNLOADS).exists()


PIP = """
    import os, pathlib, sys, time
    try:
        pathlib.Path(os.environ["TMPDIR"], "a.whl").touch()
        time.sleep(float(sys.argv[1]))
    finally:
        pathlib.Path(os.environ["TMPDIR"], "a.whl").unlink()
"""
SET_UP = """
    import pathlib, sys
    from verify.core import virtual_environment
    with virtual_environment.alone():
        words = [sys.executable, *sys.argv[1:3]]
        virtual_environment.run(words, pathlib.Path(sys.argv[3]), TMPDIR=sys.argv[4])
"""


@pytest.fixture
def downloading(tmp_path):
    """Start a set-up whose pip takes some seconds: the process and what it has downloaded."""
    started = []

    def start(seconds):
        script, place = tmp_path / "pip.py", tmp_path / DOWNLOADS
        script.write_text(textwrap.dedent(PIP))
        place.mkdir()
        words = [sys.executable, "-c", textwrap.dedent(SET_UP), script, seconds, tmp_path / LOG]
        started.append(
            subprocess.Popen(
                [*map(str, words), str(place)], cwd=ROOT, start_new_session=True,
                stderr=subprocess.DEVNULL,
            )
        )  # fmt: skip
        wait_until((place / "a.whl").exists)
        return started[0], place / "a.whl"

    yield start
    for process in started:
        process.kill()
        process.wait()


def wait_until(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_an_interrupted_pip_does_not_delete_what_it_has_downloaded(downloading):
    process, wheel = downloading(60)
    os.killpg(process.pid, signal.SIGINT)
    process.wait(timeout=60)
    assert wheel.exists()


def test_a_pip_that_outlives_its_set_up_keeps_the_next_one_waiting(downloading):
    process, wheel = downloading(3)
    process.kill()
    process.wait(timeout=60)
    handle = os.open(ROOT, os.O_RDONLY)
    with pytest.raises(BlockingIOError):
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    wait_until(lambda: not wheel.exists())
    fcntl.flock(handle, fcntl.LOCK_EX)
    os.close(handle)


def test_a_changed_version_alone_is_installed(project):
    complete(project)
    project.asked = []
    complete(project, lock=LOCK.replace("package-7==1.0", "package-7==2.0"))
    assert project.asked == ["package-7"]


def test_packages_of_another_environment_are_shared_where_the_version_is_the_same(project):
    other = project.folder.with_name("other")
    add_package(other, NAMES[0])
    add_package(other, NAMES[1], version="0.9")
    complete(project, shared=other)
    assert project.asked == NAMES[1:]
    path = site_packages(project.folder) / virtual_environment.SHARED
    assert (path.parent / path.read_text().strip()).resolve() == site_packages(other)


def test_the_lock_is_split_without_a_loss():
    lock = (ROOT / "requirements.txt").read_text("utf-8")
    assert "".join(pins(lock).values()) == lock
    assert all("--hash=sha256:" in entry for entry in pins(lock).values())


def test_only_packages_with_a_record_are_complete(tmp_path):
    add_package(tmp_path, "whole")
    add_package(tmp_path, "half", complete=False)
    add_package(
        tmp_path, "~eplaced"
    )  # what pip had set aside when an exchange of versions was killed
    removed = remove_incomplete(site_packages(tmp_path))
    assert sorted(removed) == ["half-1.0.dist-info", "~eplaced-1.0.dist-info"]
    assert [path.name for path in site_packages(tmp_path).iterdir()] == ["whole-1.0.dist-info"]


@pytest.mark.parametrize(
    ("output", "expected"),
    [
        ("WARNING: Retrying (Retry(total=4)) after: x\nERROR: No matching distribution\n",
         "no connection to the package index"),
        ("WARNING: x\nERROR: No matching distribution found for a==1\n",
         "No matching distribution found for a==1"),
        ("Error: Command died\n", "Error: Command died"),
        ("", "exit status 1"),
    ],
)  # fmt: skip
def test_the_reason_of_a_failure_is_one_line(output, expected):
    assert reason(output, 1) == expected


@pytest.fixture
def environment(tmp_path):
    """An environment with the traces of pip that `usable` looks for, and a complete one's mark."""
    folder = tmp_path / "project" / ".venv"
    words = [sys.executable, "-I", "-m", "venv", "--without-pip", str(folder)]
    subprocess.run(words, check=True, timeout=60)
    (folder / "bin" / "pip").write_text(f"#!{folder}/bin/python3\n")
    (site_packages(folder) / "pip.py").write_text("")
    add_package(folder, "pip")
    (folder / READY).write_text(f"{folder.parent} {VERSION}\n")
    return folder


def is_ready(folder, *pythons):
    words = [ROOT / "tools" / "is-ready", *pythons]
    return subprocess.run(words, cwd=folder.parent, check=False, timeout=60).returncode == 0


def test_a_complete_environment_is_used(environment):
    assert usable(environment)
    assert is_ready(environment)
    assert is_ready(environment, sys.executable)


def test_a_moved_environment_is_made_again(environment):
    moved = environment.parent.rename(environment.parent.with_name("moved")) / ".venv"
    assert not usable(moved)
    assert not is_ready(moved)


def test_an_environment_whose_python_is_gone_is_made_again(environment):
    for python in environment.glob("bin/python*"):
        python.unlink()
    (environment / "bin" / "python").symlink_to("no-such-python")
    assert not usable(environment)
    assert not is_ready(environment)


def test_an_environment_of_another_python_is_made_again(environment, monkeypatch):
    (environment / READY).write_text(f"{environment.parent} 3.1\n")
    assert not is_ready(environment)
    monkeypatch.setattr(sys, "version_info", (3, 1, 0))
    assert not usable(environment)


@pytest.mark.parametrize("part", ["bin/pip", "RECORD"])
def test_an_environment_without_a_whole_pip_is_made_again(part, environment):
    next(environment.glob(f"**/{part}")).unlink()
    assert not usable(environment)


def test_what_is_in_place_of_the_environment_is_replaced(tmp_path, monkeypatch):
    made = []
    monkeypatch.setattr(virtual_environment, "run", lambda words, log: made.append((words, log)))
    folder = tmp_path / ".venv"
    (folder / "lib").mkdir(parents=True)
    virtual_environment.create(folder)
    assert list(folder.iterdir()) == []
    shutil.rmtree(folder)
    folder.symlink_to("no-such-folder")
    virtual_environment.create(folder)
    assert folder.is_dir()
    assert made[1][1] == folder / LOG


def test_a_failure_is_one_line_and_its_reason_is_stored(project, monkeypatch, capsys):
    project.folder.parent.joinpath("lock.txt").write_text(LOCK)
    project.broken = {NAMES[0]}
    monkeypatch.setattr(sys, "argv", ["virtual_environment", ".venv", "lock.txt"])
    assert virtual_environment.main() == 2
    assert capsys.readouterr().err.splitlines()[-1] == (
        "freewheel: .venv is not complete (no connection to the package index); "
        "the next make continues"
    )
    assert (project.folder / FAILED).read_text() == "no connection to the package index\n"
