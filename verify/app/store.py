"""The command `store`: stored results, their sizes and ages, and their removal."""

import json
import time
from dataclasses import asdict
from pathlib import Path

from verify.core.console import aligned
from verify.core.inputs import InputError
from verify.jobs.cache import default_folder
from verify.jobs.store import Group, Store

LEVELS = "level"  # results of finite elements on one mesh, a file each
DAY = 86400.0  # s


def run_store(*, as_json: bool, clear: str) -> int:
    """List the store, or remove a kind or KIND:SUBJECT first; InputError for an unknown kind."""
    folder = default_folder()
    groups = [*levels(folder), *Store(folder).groups()]
    if clear:
        groups = cleared(folder, groups, clear)
    if as_json:
        print(json.dumps({"folder": str(folder), "groups": [asdict(one) for one in groups]}))
        return 0
    print(f"{folder}: {sum(g.entries for g in groups):,} results, {size(groups)}")
    for line in aligned([_HEAD, *map(_line, groups)]) if groups else []:
        print(f"  {line}")
    return 0


def levels(folder: Path) -> list[Group]:
    """The stored levels by case."""
    found = []
    for place in sorted(path for path in folder.glob("*") if path.is_dir()):
        stats = [path.stat() for path in place.glob("*.npz")]
        if stats and place.name != "pictures":
            times = [stat.st_mtime for stat in stats]
            found.append(Group(LEVELS, place.name, len(stats), sum(s.st_size for s in stats),
                               min(times), max(times)))  # fmt: skip
    return found


def cleared(folder: Path, groups: list[Group], which: str) -> list[Group]:
    """What is left after the groups of a kind, or of KIND:SUBJECT, were removed."""
    kind, _, subject = which.partition(":")
    gone = [g for g in groups if g.kind == kind and subject in ("", g.subject)]
    if not gone:
        known = ", ".join(sorted({g.kind for g in groups})) or "none"
        raise InputError(f"--clear {which}: nothing of this kind is stored; kinds: {known}")
    for group in gone:
        if kind == LEVELS:
            for path in (folder / group.subject).glob("*.npz"):
                path.unlink(missing_ok=True)
    if kind != LEVELS:
        Store(folder).clear(kind, subject)
    print(f"removed: {sum(g.entries for g in gone):,} results, {size(gone)}")
    return [g for g in groups if g not in gone]


def size(groups: list[Group]) -> str:
    """Their bytes in MB."""
    return f"{sum(g.size for g in groups) / 1e6:.1f} MB"


_HEAD = ("kind", "subject", "results", "MB", "oldest", "newest")


def _line(group: Group) -> tuple[str, ...]:
    return (
        group.kind, group.subject, f"{group.entries:,}", f"{group.size / 1e6:.1f}",
        _age(group.oldest), _age(group.newest),
    )  # fmt: skip


def _age(made: float) -> str:
    days = (time.time() - made) / DAY
    return f"{days:.0f} d" if days >= 1 else f"{24 * max(days, 0.0):.1f} h"
