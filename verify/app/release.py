"""Making of a release: raise the version, store the rows of a full run, commit and tag."""

import subprocess
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from verify.app.report import make_report
from verify.app.version_texts import raised
from verify.audit.releases.changes import WITHOUT
from verify.audit.releases.store import FOLDER, ROOT, is_later, path_of, store, version
from verify.cases.registry import CASES
from verify.core.inputs import InputError
from verify.core.results import Report, Status
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve


def release(root: Path, name: str, *, jobs: int = 0) -> Path:
    """Release the committed code as version `name`; returns the file with the released rows.

    Raises InputError if `name` is not a later version, if a file is not committed, if a row failed,
    or if git fails. All files are then restored.
    """
    old = version(root)
    if not is_later(name, old):
        raise InputError(
            f"the version must be later than {old} (1.0.2 is later than 1.0.1), got {name!r}"
        )
    path = path_of(name, root / FOLDER.relative_to(ROOT))
    head = _refuse_unready(root, path, name)
    texts = raised(root, old, name, time.strftime("%Y-%m-%d", time.gmtime()))
    report = solved(jobs)
    refuse_red(report)
    if _refuse_unready(root, path, name) != head:  # the run takes minutes
        raise InputError("the commit was changed during the run: repeat the release")
    with _whole(root, path, texts, head):
        store(report.rows, name, report.provenance["commit"], path.parent)
        for file, text in texts.items():
            file.write_text(text, "utf-8")
        _git(root, "add", "--", str(path), *map(str, texts))
        _git(root, "commit", "--quiet", "-m", f"Version {name}")
        _git(root, "tag", "-a", f"v{name}", "-m", f"Version {name}")
    return path


def solved(jobs: int) -> Report:
    """Solve and judge all cases, and return the report."""
    start = time.perf_counter()
    results = solve([Job(case, case.inputs(), drawn=False) for case in CASES], Where(jobs), True)
    return make_report(results, CASES, time.perf_counter() - start)


def refuse_red(report: Report) -> None:
    """Raise InputError if the report prevents a release.

    This is so if a row failed or was not run, or if a requirement was loosened without a reason.
    """
    for row in report.rows:
        if row.status in (Status.FAIL, Status.SKIP):
            raise InputError(
                f"a release requires that no row fails: {row.id}: {row.status}: {row.reason}"
            )
    if report.drift and report.drift.unexplained:
        raise InputError(f"{WITHOUT}: {report.drift.unexplained[0].row}")


def _refuse_unready(root: Path, path: Path, name: str) -> str:
    """Return the id of the present commit. Raises InputError if it cannot become this release."""
    if changed := _git(root, "status", "--porcelain"):
        raise InputError(f"commit all changes before a release: {changed.splitlines()[0]}")
    if path.exists() or _git(root, "tag", "--list", f"v{name}"):
        raise InputError(
            f"version {name} exists already (stored rows or a tag of git): give a later version"
        )
    _git(root, "var", "GIT_COMMITTER_IDENT")
    return _git(root, "rev-parse", "HEAD")


@contextmanager
def _whole(root: Path, path: Path, texts: Mapping[Path, str], head: str) -> Iterator[None]:
    """Context that restores commit, files and index if its body raises any exception."""
    before = {file: file.read_bytes() for file in texts}
    try:
        yield
    except BaseException:
        _git(root, "reset", "--quiet", "--soft", head)
        path.unlink(missing_ok=True)
        for file, content in before.items():
            file.write_bytes(content)
        _git(root, "reset", "--quiet", "--", str(path), *map(str, texts))
        raise


def _git(root: Path, *words: str) -> str:
    """Output of git in a folder. Raises InputError with the first line of its error."""
    run = ["git", "-C", str(root), *words]
    try:
        done = subprocess.run(run, capture_output=True, text=True, timeout=60, check=False)  # noqa: S603
    except (OSError, subprocess.SubprocessError) as error:
        raise InputError(f"a release requires git: {error}") from error
    if done.returncode:
        message = (done.stderr.strip() or done.stdout.strip() or "it failed").splitlines()[0]
        raise InputError(f"git {words[0]} failed: {message}")
    return done.stdout.strip()
