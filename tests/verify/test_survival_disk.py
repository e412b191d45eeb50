"""Disks that are full or cannot be written: one line, and everything else as it was."""

import os
import resource
import subprocess
import sys

import pytest

from verify.core.store import FILE

pytestmark = pytest.mark.xdist_group("survival disk")  # they share a cache
RUN = "import sys; from verify.app.cli import main; main(sys.argv[1:])"


@pytest.fixture
def tiny(tmp_path):
    """A file system of 256 kB."""
    yield from mounted(tmp_path / "tiny", "256k")


@pytest.fixture
def roomy(tmp_path):
    """A file system of 64 MB."""
    yield from mounted(tmp_path / "roomy", "64m")


def mounted(folder, size):
    """A file system in memory at a folder, for the time of a test."""
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "none", str(folder)]
    done = subprocess.run(mount, capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip(f"no file system can be mounted here: {done.stderr.strip()}")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


SPRING = """\
case = "spring-accordion"
[inputs]
n = 10
b = "0.1 mm"
h = "56 mm"
r = "0.45 mm"
L1 = "11.6 mm"
alpha = "80 deg"
E = "206 GPa"
nu = 0.3
"""

UNDECIDED = 3  # `check` of a spring without a working force


def verify(*arguments, cache, **more):
    return freewheel("verify", "spring-accordion", *arguments, cache=cache, **more)


def check(folder, *, cache):
    """The same finite elements without a report."""
    path = folder / "spring.toml"
    path.write_text(SPRING)
    return freewheel("check", "--fem", path, cache=cache)


def freewheel(*arguments, cache, **more):
    return subprocess.run(
        [sys.executable, "-c", RUN, *map(str, arguments)],
        env=os.environ | {"FREEWHEEL_CACHE": str(cache)},
        capture_output=True, text=True, check=False, timeout=120, **more,
    )  # fmt: skip


def said(done):
    """What stderr says apart from progress."""
    return [line for line in done.stderr.splitlines() if not line.startswith("refinement levels")]


@pytest.fixture(scope="module")
def shared(tmp_path_factory, with_equations):
    """A cache that holds everything."""
    cache = with_equations(tmp_path_factory.mktemp("shared") / "fem")
    done = verify("--out", cache.parent / "out", cache=cache)
    assert done.returncode == 0, done.stderr
    return cache


def test_a_full_cache_is_one_line_and_the_run_goes_on(tiny, tmp_path):
    (tiny / "ballast").write_bytes(bytes(200_000))
    done = check(tmp_path, cache=tiny / "fem")
    assert done.returncode == UNDECIDED
    (line,) = [line for line in said(done) if "cannot be stored" in line]
    assert line.startswith(f"freewheel: {tiny / 'fem' / FILE}: ")
    assert line.endswith("make room on its disk, or remove it to begin again: going on without")


def test_a_report_that_finds_no_space_is_one_line_and_the_old_one_stays(tiny, shared):
    old = {name: f"old {name}".encode() for name in ("report.html", "results.json", "rows.csv")}
    for name, content in old.items():
        (tiny / name).write_bytes(content)
    done = verify("--out", tiny, cache=shared)
    assert done.returncode == 2
    (line,) = said(done)
    assert line.startswith(f"freewheel: {tiny}/")
    assert line.endswith("cannot be written: No space left on device")
    assert {p.name: p.read_bytes() for p in tiny.iterdir() if p.name != ".lock"} == old


@pytest.mark.soak
def test_a_quota_on_files_is_one_line_for_the_cache_and_one_for_the_report(
    tmp_path, with_equations
):
    """RLIMIT_FSIZE: "File too large", which Python meets as an error and no signal."""
    out = tmp_path / "out"
    done = verify(
        "--out", out, "--jobs", "2", cache=with_equations(tmp_path / "fem"),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000)),
    )  # fmt: skip
    assert done.returncode == 2
    stored, written = said(done)
    assert stored.endswith(": going on without")
    assert "File too large" in written
    assert {p.name for p in out.iterdir()} <= {".lock"}


def test_a_read_only_cache_is_one_line_and_the_run_goes_on(tiny, tmp_path):
    subprocess.run(["mount", "-o", "remount,ro", str(tiny)], check=True)
    done = check(tmp_path, cache=tiny / "fem")
    assert done.returncode == UNDECIDED
    (line,) = [line for line in said(done) if "going on without" in line]
    assert "Read-only file system" in line


def test_what_a_read_only_store_has_is_not_solved_again(roomy, tmp_path):
    assert check(tmp_path, cache=roomy).returncode == UNDECIDED
    subprocess.run(["mount", "-o", "remount,ro", str(roomy)], check=True)
    done = check(tmp_path, cache=roomy)
    assert done.returncode == UNDECIDED
    assert not [line for line in done.stderr.splitlines() if line.startswith("refinement levels")]


def test_a_read_only_output_folder_is_found_before_the_work(tiny, tmp_path):
    subprocess.run(["mount", "-o", "remount,ro", str(tiny)], check=True)
    done = verify("--out", tiny / "out", cache=tmp_path / "fem")
    assert done.returncode == 2
    assert len(said(done)) == 1
    assert "Read-only file system" in said(done)[0]
    assert not (tmp_path / "fem").exists()


@pytest.mark.parametrize(
    "place",
    ["itself", *(pytest.param(p, marks=pytest.mark.soak) for p in ("parent", "store"))],
)
def test_a_file_where_the_cache_wants_a_folder_is_one_line(place, tmp_path):
    cache = tmp_path / "fem"
    if place == "itself":
        cache.touch()
    elif place == "parent":
        cache.touch()
        cache = cache / "below"
    else:
        (cache / FILE).mkdir(parents=True)
    done = check(tmp_path, cache=cache)
    assert done.returncode == UNDECIDED
    assert len(said(done)) == 1
    assert "going on" in said(done)[0]
