"""Files of the project that state its version, and the heading of the change log."""

import re
from collections.abc import Mapping
from pathlib import Path

from verify.core.inputs import InputError

STATED = {  # file: how it states the version
    "pyproject.toml": '\nversion = "{}"\n',
    "CITATION.cff": "\nversion: {}\n",
    "verify/app/cli.py": '    version="{}",\n',
    "docs/pytest.md": "freewheel_verification-{}-py3",
}
CHANGES = "CHANGELOG.md"
HEADING = "\n## Unreleased\n"


def raised(root: Path, old: str, new: str, day: str) -> Mapping[Path, str]:
    """New texts of the files that state the version, and of the change log.

    In the change log, the unreleased changes get a heading with the version and the `day`.

    Raises InputError if a file does not state the old version, or if no change is listed.
    """
    return {root / name: _raised(root / name, text, old, new) for name, text in STATED.items()} | {
        root / CHANGES: _headed(root / CHANGES, f"\n## {new} ({day})\n")
    }


def _raised(path: Path, stated: str, old: str, new: str) -> str:
    before = path.read_text("utf-8")
    if stated.format(old) not in before:
        raise InputError(f"{path.name}: does not state version {old} as {stated.strip()!r}")
    return before.replace(stated.format(old), stated.format(new))


def _headed(path: Path, heading: str) -> str:
    before, found, changes = path.read_text("utf-8").partition(HEADING)
    if not found:
        raise InputError(f"{path.name}: has no heading {HEADING.strip()!r}")
    if not re.split(r"^## ", changes, maxsplit=1, flags=re.MULTILINE)[0].strip():
        raise InputError(f"{path.name}: lists no changes under {HEADING.strip()!r}")
    return f"{before}{HEADING}{heading}{changes}"
