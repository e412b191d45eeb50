"""Syntax trees of modules and their import statements, read once a process."""

import ast
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from threading import Lock

from verify.core.plain_code import is_of_project

_PARSING = Lock()


@dataclass(frozen=True)
class Imported:
    """An import statement of a module: at its top, and whether type checkers alone execute it."""

    node: ast.Import | ast.ImportFrom
    at_top: bool
    for_types: bool


def file_of(module: str) -> Path:
    """The file of a module, imported or not."""
    file = getattr(sys.modules.get(module), "__file__", None)
    if file is None:
        spec = find_spec(module)
        assert spec is not None
        file = spec.origin
    assert file is not None
    return Path(file)


def parsed(source: str) -> ast.Module:
    """The syntax tree of a source, in one thread at a time.

    Python 3.11 counts the depth of all trees that it makes together: where threads take turns
    within two of them it raises SystemError.
    """
    with _PARSING:
        return ast.parse(source)


@cache
def tree(module: str) -> ast.Module:
    """The syntax tree of a module, which nobody may change."""
    return parsed(file_of(module).read_text("utf-8"))


@cache
def nodes(module: str) -> tuple[ast.AST, ...]:
    """All nodes of that tree, in the order of `ast.walk`."""
    return tuple(ast.walk(tree(module)))


@cache
def imports(module: str) -> tuple[Imported, ...]:
    """All import statements of a module, also those inside functions."""
    top = tree(module)
    types = for_types(nodes(module))
    return tuple(
        Imported(node, node in top.body, node in types)
        for node in nodes(module) if isinstance(node, ast.Import | ast.ImportFrom)
    )  # fmt: skip


@cache
def names(module: str) -> frozenset[str]:
    """The names that a module's code reads or binds, except its imports."""
    return frozenset(n.id for n in nodes(module) if isinstance(n, ast.Name))


@cache
def attributes(module: str, owner: str) -> frozenset[str]:
    """The attributes that a module reads off objects called `owner`, off any where it is empty."""
    read = [n for n in nodes(module) if isinstance(n, ast.Attribute)]
    return frozenset(n.attr for n in read if not owner or last_name(n.value) == owner)


def for_types(among: Iterable[ast.AST]) -> set[ast.AST]:
    """What only type checkers execute of some nodes of a module."""
    guarded = (n for n in among if isinstance(n, ast.If) and last_name(n.test) == "TYPE_CHECKING")
    return {item for guard in guarded for part in guard.body for item in ast.walk(part)}


def last_name(node: ast.expr) -> str:
    """The last part of a dotted name."""
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def named(item: ast.AST, importer: str) -> Iterator[str]:
    """Modules and names inside modules that an import statement names."""
    if isinstance(item, ast.Import):
        yield from (alias.name for alias in item.names)
    elif isinstance(item, ast.ImportFrom):
        source = origin(item, importer)
        yield source
        yield from (f"{source}.{alias.name}" for alias in item.names)


def origin(item: ast.ImportFrom, importer: str) -> str:
    """The module from which a statement imports."""
    parent = importer.rsplit(".", item.level)[0] if item.level else ""
    return ".".join(filter(None, (parent, item.module)))


@cache
def aliases(module: str) -> tuple[tuple[Imported, str, str], ...]:
    """Each name that imports of the project's modules bind, with its statement and full name."""
    return tuple(
        (one, alias.asname or alias.name, full)
        for one in imports(module)
        for alias in one.node.names
        if is_of_project(full := _full_name(one.node, alias, module))
    )


def _full_name(node: ast.Import | ast.ImportFrom, alias: ast.alias, importer: str) -> str:
    source = f"{origin(node, importer)}." if isinstance(node, ast.ImportFrom) else ""
    return source + alias.name


def forget() -> None:
    """Read the files again."""
    for one in (tree, nodes, imports, names, attributes, aliases):
        one.cache_clear()
