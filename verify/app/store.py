"""The command `store`: lists stored results with sizes and ages, and removes them."""

import json
import sys
import time
from dataclasses import asdict
from pathlib import Path

from verify.core.console import aligned
from verify.core.inputs import InputError
from verify.core.store import Group, Store
from verify.core.terminal import print_wrapped
from verify.jobs.cache import default_folder
from verify.jobs.earlier_files import adopt

DAY = 86400.0  # s


def run_store(*, as_json: bool, clear: str | None) -> int:
    """List the stored results. Those named by `clear` (KIND or KIND:SUBJECT) are removed first.

    Raises InputError for an unknown kind. Returns the exit status.
    """
    folder = default_folder()
    store = Store(folder)
    try:
        _adopt(folder)
        if clear is not None:
            _clear(store, clear)
        groups = store.groups()
    except OSError as error:
        raise InputError(str(error)) from error
    if as_json:
        print(json.dumps({"file": str(store.path), "groups": [asdict(one) for one in groups]}))
        return 0
    print(f"{store.path}: {sum(g.entries for g in groups):,} results, {size(groups)}")
    lines = aligned([_HEAD, *map(_line, groups)]) if groups else []
    print_wrapped(*(f"  {line}" for line in lines))
    return 0


def _adopt(folder: Path) -> None:
    """Move results of an earlier version into the store; errors are only reported."""
    try:
        if moved := adopt(folder):
            _print_message(
                f"{moved} results of an earlier version were moved into {Store(folder).path}"
            )
    except OSError as error:
        _print_message(str(error))


def _print_message(message: str) -> None:
    print(f"freewheel: {message}", file=sys.stderr)


def run_origin(case: str, code: str, *, other: bool) -> int:
    """List the stored results of a case, or the cases whose code includes a module.

    `other` is True if an option is given that applies to the whole list only; InputError is then
    raised.
    """
    from verify.app.origin import of_case, of_module

    if other:
        named = case or f"--code {code}"
        raise InputError(
            f"store {named}: --json and --clear cannot be combined with a case or with --code"
        )
    if case and code:
        raise InputError(f"store {case} --code {code}: give either a case or a module")
    print_wrapped(*(of_case(case) if case else of_module(code)))
    return 0


def _clear(store: Store, which: str) -> None:
    kind, colon, subject = which.partition(":")
    if not kind:
        raise InputError(
            "--clear requires a kind of results, or KIND:SUBJECT, such as fem:ring-lame"
        )
    if colon and not subject:
        raise InputError(
            f"--clear {which}: a subject is missing after the colon; an example is {kind}:ring-lame"
        )
    groups = store.groups()
    gone = [g for g in groups if g.kind == kind and subject in ("", g.subject)]
    if not gone:
        known = ", ".join(sorted({g.kind for g in groups})) or "none"
        raise InputError(f"--clear {which}: no such results are stored; stored kinds: {known}")
    store.clear(kind, subject)
    _print_message(f"removed: {sum(g.entries for g in gone):,} results, {size(gone)}")


def size(groups: list[Group]) -> str:
    """Total size of the groups, as text in MB."""
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
