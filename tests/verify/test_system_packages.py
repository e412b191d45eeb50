"""System libraries are installed where that is allowed, else the one line to run is printed."""

import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

from verify.core import environment, system_packages
from verify.core.environment import LIBRARIES
from verify.core.system_packages import Machine, check, line_to_run

ROOT = Path(__file__).parents[2]
GLU, EGL = "libGLU.so.1", "libEGL.so.1"
DEBIAN_ROOT = Machine(root=True, apt=True)
UPDATE = "apt-get update"
UNREACHABLE = "Failed to fetch http://deb/InRelease Temporary failure resolving 'deb'"


@pytest.fixture
def machine(monkeypatch):
    """A machine without `lost` libraries; apt-get is recorded, and brings them if it `works`."""

    def make(*lost, works=True, ensurepip=True, outputs=None):
        missing, commands = set(lost), []
        monkeypatch.setattr(sys, "platform", "linux")
        monkeypatch.setattr(environment, "loads", lambda name: name not in missing)
        monkeypatch.setattr(system_packages, "_without_venv", lambda: not ensurepip)

        def run(words):
            commands.append(" ".join(words))
            if outputs:
                return outputs.pop(0)
            return (0, "") if works else (100, "Reading package lists...\nE: no such package\n")

        monkeypatch.setattr(system_packages, "_run", run)
        monkeypatch.setattr(system_packages.time, "sleep", lambda seconds: None)
        return commands

    return make


def test_where_nothing_is_missing_nothing_is_run(machine, capsys):
    commands = machine()
    assert check(DEBIAN_ROOT) == ""
    assert (commands, capsys.readouterr().err) == ([], "")


def test_root_on_debian_names_and_installs_what_is_missing(machine, capsys):
    commands = machine(GLU, EGL)
    assert check(DEBIAN_ROOT) == ""
    assert len(commands) == 2
    assert commands[0].endswith(" update")
    assert "DPkg::Lock::Timeout=120" in commands[1]
    assert commands[1].endswith(" install -y --no-install-recommends libglu1-mesa libegl1")
    (line,) = capsys.readouterr().err.splitlines()
    assert line.endswith("apt-get (FREEWHEEL_NO_APT=1 forbids it): libglu1-mesa libegl1")


@pytest.mark.parametrize(
    ("this", "line"),
    [
        (Machine(apt=True), f"sudo {UPDATE} && sudo apt-get install -y libglu1-mesa"),
        (
            Machine(root=True, apt=True, forbidden=True),
            f"{UPDATE} && apt-get install -y libglu1-mesa",
        ),
        (Machine(dnf=True), "sudo dnf install 'libGLU.so.1()(64bit)'"),
        (Machine(root=True, dnf=True), "dnf install 'libGLU.so.1()(64bit)'"),
        (Machine(root=True), "install the packages that contain them (in Debian: libglu1-mesa)"),
    ],
    ids=["not root", "forbidden", "fedora", "fedora, root", "no apt-get"],
)
def test_elsewhere_the_line_to_run_is_given_and_nothing_is_run(this, line, machine):
    commands = machine(GLU)
    assert check(this) == f"missing {GLU}; run: {line}"
    assert commands == []


def test_a_missing_venv_module_is_a_package_of_this_python(machine, monkeypatch):
    package = "python{}.{}-venv".format(*sys.version_info[:2])
    monkeypatch.setattr(sys, "base_prefix", "/usr")
    commands = machine(GLU, ensurepip=False)
    assert check(Machine(apt=True)).endswith(f"apt-get install -y {package} libglu1-mesa")
    assert check(DEBIAN_ROOT) == ""
    assert commands[1].endswith(f"{package} libglu1-mesa")


def test_a_python_that_apt_did_not_bring_cannot_get_venv_from_it(machine, monkeypatch):
    monkeypatch.setattr(sys, "base_prefix", "/opt/python")
    commands = machine(ensurepip=False)
    assert check(DEBIAN_ROOT).endswith(
        "has no module venv or ensurepip: set PYTHON to one that has"
    )
    assert commands == []


def test_pictures_alone_do_not_stop_the_set_up(machine, capsys):
    machine(EGL)
    assert check(Machine(apt=True)) == ""
    assert f"without {EGL} pictures are fewer; run: sudo apt-get" in capsys.readouterr().err


def test_a_failed_installation_gives_the_reason_and_the_line(machine):
    machine(GLU, works=False)
    assert check(DEBIAN_ROOT) == (
        f"apt-get failed (no such package); run: {line_to_run([GLU], '', DEBIAN_ROOT)}"
    )


def test_without_a_network_the_reason_is_that_of_the_first_step(machine):
    machine(GLU, outputs=[(0, f"W: {UNREACHABLE}\n"), (100, "E: Unable to locate package\n")])
    assert check(DEBIAN_ROOT).startswith(f"apt-get failed ({UNREACHABLE}); run: ")


def test_package_lists_in_use_are_waited_for(machine):
    locked = (100, "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1\n")
    commands = machine(GLU, outputs=[locked, locked, (0, ""), (0, "")])
    assert check(DEBIAN_ROOT) == ""
    assert [words.split()[-1] for words in commands] == ["update"] * 3 + ["libglu1-mesa"]


def test_an_interrupted_dpkg_is_repaired(machine):
    asked = f"E: dpkg was interrupted, you must manually run '{system_packages.REPAIR}'\n"
    commands = machine(GLU, outputs=[(0, ""), (100, asked), (0, ""), (0, "")])
    assert check(DEBIAN_ROOT) == ""
    assert commands[2] == system_packages.REPAIR
    assert commands[3] == commands[1]


def test_an_unsupported_python_ends_before_anything_is_installed(machine, monkeypatch):
    commands = machine(GLU)
    monkeypatch.setattr(sys, "version_info", (3, 9, 2))
    assert check(DEBIAN_ROOT).startswith("needs Python 3.11 to ")
    assert commands == []


def test_ctrl_c_is_one_line(monkeypatch, capsys):
    def interrupted(machine):
        raise KeyboardInterrupt

    monkeypatch.setattr(system_packages, "check", interrupted)
    assert system_packages.main() == 130
    (line,) = capsys.readouterr().err.splitlines()
    assert line == "freewheel: system libraries are not complete; the next make continues"


APT_GET = """
    import pathlib, sys, time
    pathlib.Path(sys.argv[1]).touch()
    try:
        time.sleep(60)
    except KeyboardInterrupt:  # dpkg is at work
        time.sleep(1)
        pathlib.Path(sys.argv[1]).write_text("ended by itself")
"""


def test_ctrl_c_lets_apt_get_end_by_itself(tmp_path):
    script, mark = tmp_path / "apt-get.py", tmp_path / "mark"
    script.write_text(textwrap.dedent(APT_GET))
    code = (
        "import sys; from verify.core.system_packages import _run; "
        "_run([sys.executable, *sys.argv[1:]])"
    )
    words = [sys.executable, "-c", code, str(script), str(mark)]
    with subprocess.Popen(
        words, cwd=ROOT, start_new_session=True, stderr=subprocess.DEVNULL
    ) as process:
        end = time.monotonic() + 60
        while not mark.exists():
            assert time.monotonic() < end
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGINT)
        process.wait(timeout=60)
    assert mark.read_text() == "ended by itself"


@pytest.mark.parametrize(
    ("os_release", "expected"),
    [
        ("ID=debian\n", True),
        ('NAME="Ubuntu"\nID=ubuntu\nID_LIKE=debian\n', True),
        ('ID=linuxmint\nID_LIKE="ubuntu debian"\n', True),
        ("ID=fedora\n", False),
        ("", False),
    ],
)
def test_debian_and_its_descendants(os_release, expected):
    assert system_packages.debian_family(os_release) == expected


@pytest.mark.parametrize(("value", "forbidden"), [("1", True), ("0", False), ("", False)])
def test_the_variable_that_forbids_apt(value, forbidden, monkeypatch):
    monkeypatch.setenv("FREEWHEEL_NO_APT", value)
    assert system_packages.this_machine().forbidden == forbidden


def bare_python(**environ):
    """Run the check without site-packages, as before there is a virtual environment."""
    return subprocess.run(
        [sys.executable, "-S", "-m", "verify.core.system_packages"],
        capture_output=True, text=True, check=False, timeout=60, cwd=ROOT,
        env={"PATH": os.environ["PATH"], **environ},
    )  # fmt: skip


def test_a_python_without_packages_runs_the_check():
    missing = [name for name, _, _ in LIBRARIES if not environment.loads(name)]
    done = bare_python(FREEWHEEL_NO_APT="1")
    assert done.stdout == ""
    assert (done.returncode, done.stderr) == (0, "") or all(name in done.stderr for name in missing)
