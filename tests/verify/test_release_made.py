"""A release is made in one go, here in a small repository, or changes nothing."""

import subprocess
from dataclasses import replace

import pytest

from tools.release import main
from verify.app import release as making
from verify.app.report import make_report
from verify.app.version_texts import CHANGES, STATED
from verify.audit.releases.store import FOLDER, ROOT, load, version
from verify.cases.ring.lame.case import LAME
from verify.core.inputs import InputError
from verify.core.results import Status

NOW = version()
NEXT = f"{NOW}.1"
ROWS = FOLDER.relative_to(ROOT) / f"{NEXT}.json.gz"


@pytest.fixture(scope="module")
def passing(of_paper):
    return replace(make_report([of_paper(LAME)], [LAME], 1.0), drift=None)


@pytest.fixture
def clone(tmp_path, monkeypatch, passing):
    """A repository with the files that a release changes, whose run is that of one case."""
    for name in (*STATED, CHANGES):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        text = (ROOT / name).read_text("utf-8")
        changed = text.replace("## Unreleased\n", "## Unreleased\n\n- A change.\n", 1)
        (tmp_path / name).write_text(changed, "utf-8")
    for key in ("GIT_CONFIG_GLOBAL", "GIT_CONFIG_SYSTEM"):
        monkeypatch.setenv(key, "/dev/null")
    git(tmp_path, "init", "-q", "-b", "main")
    for key, value in (("user.name", "A"), ("user.email", "a@b"), ("commit.gpgsign", "false")):
        git(tmp_path, "config", key, value)
    git(tmp_path, "add", ".")
    git(tmp_path, "commit", "-q", "-m", "Before")
    monkeypatch.setattr(making, "solved", lambda _jobs: passing)
    return tmp_path


def git(folder, *words):
    run = ["git", "-C", str(folder), *words]
    return subprocess.run(run, check=True, capture_output=True, text=True).stdout.strip()


def state(folder):
    """Everything that a release may change: files, commits, tags."""
    files = {path: path.read_bytes() for path in folder.rglob("*")
             if path.is_file() and ".git" not in path.parts}  # fmt: skip
    return files, git(folder, "log", "--format=%H"), git(folder, "tag"), git(folder, "status", "-s")


def test_a_release_raises_the_version_everywhere_and_is_one_commit_with_a_tag(clone, passing):
    before = (clone / CHANGES).read_text("utf-8")
    path = making.release(clone, NEXT)
    assert path == clone / ROWS
    assert load(path).rows.keys() == {row.id for row in passing.rows}
    assert version(clone) == NEXT
    for name, stated in STATED.items():
        text = (clone / name).read_text("utf-8")
        assert stated.format(NEXT) in text
        assert stated.format(NOW) not in text
    head, changes = before.split("## Unreleased\n")
    day = git(clone, "log", "-1", "--date=format:%Y-%m-%d", "--format=%ad")
    after = (clone / CHANGES).read_text("utf-8")
    assert after == f"{head}## Unreleased\n\n## {NEXT} ({day})\n{changes}"
    assert git(clone, "status", "--porcelain") == ""
    assert git(clone, "log", "--format=%s") == f"Version {NEXT}\nBefore"
    assert git(clone, "describe") == f"v{NEXT}"
    changed = git(clone, "show", "--name-only", "--format=").split()
    assert changed == sorted([*STATED, CHANGES, str(ROWS)])


def change(clone, name, old, new):
    text = (clone / name).read_text("utf-8")
    assert old in text
    (clone / name).write_text(text.replace(old, new), "utf-8")
    git(clone, "commit", "-q", "-a", "-m", "Changed")


def stored(clone):
    (clone / ROWS).parent.mkdir(parents=True)
    (clone / ROWS).touch()
    git(clone, "add", ".")
    git(clone, "commit", "-q", "-m", "Rows")


@pytest.mark.parametrize(
    ("name", "prepare", "message"),
    [
        (NOW, None, f"the version must be later than {NOW}"),
        ("0.0.9", None, f"must be later than {NOW}.*, got '0.0.9'"),
        ("next", None, "got 'next'"),
        (NEXT, lambda at: (at / CHANGES).write_text(""), "commit all changes before a release: "
                                                         f"M {CHANGES}"),
        (NEXT, lambda at: (at / "new.py").touch(), "commit all changes before a release: .. "
                                                   "new.py"),
        (NEXT, lambda at: git(at, "tag", f"v{NEXT}"), f"version {NEXT} exists already"),
        (NEXT, lambda at: stored(at), f"version {NEXT} exists already"),
        (NEXT, lambda at: change(at, CHANGES, "## Unreleased", "## To come"), "has no heading"),
        (NEXT, lambda at: change(at, CHANGES, "## Unreleased\n", "## Unreleased\n## 0\n"),
         "lists no changes"),
        (NEXT, lambda at: change(at, "CITATION.cff", f"version: {NOW}", "version: 0"),
         f"CITATION.cff: does not state version {NOW}"),
        (NEXT, lambda at: git(at, "config", "user.useConfigOnly", "true")
         + git(at, "config", "--unset", "user.email"), "git var failed: "),
    ],
)  # fmt: skip
def test_a_release_that_cannot_be_made_changes_nothing(clone, monkeypatch, name, prepare, message):
    if prepare:
        prepare(clone)
    monkeypatch.setattr(making, "solved", lambda _jobs: pytest.fail("cases are run"))
    before = state(clone)
    with pytest.raises(InputError, match=message) as error:
        making.release(clone, name)
    assert "\n" not in str(error.value)
    assert state(clone) == before


def failing(report, status):
    first, *rest = report.rows
    case = replace(report.cases[0], rows=(replace(first, status=status), *rest))
    return replace(report, cases=(case,))


@pytest.mark.parametrize("status", [Status.FAIL, Status.SKIP])
def test_a_release_with_a_row_that_does_not_pass_changes_nothing(
    clone, monkeypatch, passing, status
):
    monkeypatch.setattr(making, "solved", lambda _jobs: failing(passing, status))
    before = state(clone)
    with pytest.raises(InputError, match=f"requires that no row fails: ring-lame/.*: {status}"):
        making.release(clone, NEXT)
    assert state(clone) == before


def test_the_rows_of_a_release_are_those_of_all_cases(monkeypatch, passing):
    monkeypatch.setattr(making, "CASES", [LAME])
    rows = making.solved(1).rows
    assert {row.id: row.status for row in rows} == {row.id: row.status for row in passing.rows}


def test_files_that_change_during_the_run_are_not_released(clone, monkeypatch, passing):
    def solved(_jobs):
        change(clone, CHANGES, "## Unreleased\n", "## Unreleased\n\n- more\n")
        return passing

    monkeypatch.setattr(making, "solved", solved)
    with pytest.raises(InputError, match="the commit was changed during the run"):
        making.release(clone, NEXT)
    assert version(clone) == NOW
    assert git(clone, "status", "--porcelain") == ""


@pytest.mark.parametrize("step", ["commit", "tag"])
def test_a_failure_of_git_leaves_nothing_half_done(clone, monkeypatch, step):
    right = making._git

    def failed(root, *words):
        if words[:1] == (step,) and "--list" not in words:
            raise InputError("a release needs git: it failed")
        return right(root, *words)

    monkeypatch.setattr(making, "_git", failed)
    before = state(clone)
    with pytest.raises(InputError, match="it failed"):
        making.release(clone, NEXT)
    assert state(clone) == before


def test_a_folder_without_a_repository_is_one_line(clone, monkeypatch, capsys):
    monkeypatch.setattr("tools.release.ROOT", clone)
    assert main([]) == 2
    assert "needs one argument, the version" in capsys.readouterr().err
    (clone / ".git").rename(clone / "git")
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(clone.parent))
    assert main([NEXT]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("release: git status failed: fatal: not a git repository")
    (clone / "git").rename(clone / ".git")
    assert main([NEXT]) == 0
    assert f"tag v{NEXT}" in capsys.readouterr().out
