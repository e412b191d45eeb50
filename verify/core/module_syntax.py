"""Syntax trees of modules and their import statements; each process reads a module once."""

import ast
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from itertools import accumulate
from pathlib import Path
from threading import Lock

from verify.core.plain_code import is_of_project

STUB = "__init__.pyi"  # of a package that imports its public names at first use
_PARSING = Lock()


@dataclass(frozen=True)
class Imported:
    """An import statement of a module.

    `at_top` is True for a statement at the top level, `for_types` for one that only type checkers
    execute.
    """

    node: ast.Import | ast.ImportFrom
    at_top: bool
    for_types: bool


def file_of(module: str) -> Path:
    """File of a module, even if it is not imported; for a package, its stub if there is one."""
    file = getattr(sys.modules.get(module), "__file__", None)
    if file is None:
        spec = find_spec(module)
        assert spec is not None
        file = spec.origin
    assert file is not None
    stub = Path(file).with_name(STUB)
    return stub if Path(file).name == "__init__.py" and stub.exists() else Path(file)


def parsed(source: str) -> ast.Module:
    """Syntax tree of a source text; only one thread at a time makes a tree.

    If two threads made trees at the same time, Python 3.11 would add up the depths of both trees
    and raise SystemError.
    """
    with _PARSING:
        return ast.parse(source)


@cache
def tree(module: str) -> ast.Module:
    """Syntax tree of a module; it must not be changed."""
    return parsed(file_of(module).read_text("utf-8"))


@cache
def nodes(module: str) -> tuple[ast.AST, ...]:
    """All nodes of the syntax tree of a module, in the order of `ast.walk`."""
    return tuple(ast.walk(tree(module)))


@cache
def imports(module: str) -> tuple[Imported, ...]:
    """All import statements of a module, including those inside functions."""
    top = tree(module)
    types = for_types(nodes(module))
    return tuple(
        Imported(node, node in top.body, node in types)
        for node in nodes(module) if isinstance(node, ast.Import | ast.ImportFrom)
    )  # fmt: skip


@cache
def names(module: str) -> frozenset[str]:
    """Names that the code of a module reads or binds, except in import statements."""
    return frozenset(n.id for n in nodes(module) if isinstance(n, ast.Name))


@cache
def attributes(module: str, owner: str) -> frozenset[str]:
    """Attributes that a module reads from objects called `owner`.

    If `owner` is empty, these are the attributes read from any object.
    """
    read = [n for n in nodes(module) if isinstance(n, ast.Attribute)]
    return frozenset(n.attr for n in read if not owner or last_name(n.value) == owner)


def for_types(among: Iterable[ast.AST]) -> set[ast.AST]:
    """All nodes in the blocks `if TYPE_CHECKING:` of `among`, which only type checkers execute."""
    guarded = (n for n in among if isinstance(n, ast.If) and last_name(n.test) == "TYPE_CHECKING")
    return {item for guard in guarded for part in guard.body for item in ast.walk(part)}


def last_name(node: ast.expr) -> str:
    """Last part of a dotted name."""
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def named(item: ast.AST, importer: str) -> Iterator[str]:
    """Modules, and names in modules, that an import statement contains.

    A public name of a package is replaced by the name that the stub of the package imports. The
    whole package, with all its names, is included only if a statement imports the package or all
    its names.
    """
    if isinstance(item, ast.Import):
        for alias in item.names:
            yield alias.name
            if not alias.asname:  # binds its packages, whose public names it can reach
                yield from accumulate(alias.name.split(".")[:-1], "{}.{}".format)
    elif isinstance(item, ast.ImportFrom):
        source = origin(item, importer)
        for alias in item.names:
            full = _home(source, alias.name)
            if full.rpartition(".")[0] != source or not _has_part(source, alias.name):
                yield full.rpartition(".")[0]
            yield full


def public_names(stub: ast.Module) -> Mapping[str, str]:
    """Full name of each public name of a package, from the stub of the package."""
    return {
        alias.asname or alias.name: f"{node.module}.{alias.name}"
        for node in stub.body if isinstance(node, ast.ImportFrom) for alias in node.names
    }  # fmt: skip


def _home(source: str, name: str) -> str:
    return _public(source).get(name, f"{source}.{name}")


@cache
def _public(module: str) -> Mapping[str, str]:
    """Full names of the public names of a package; empty for a package without a stub."""
    if not is_of_project(module) or file_of(module).name != STUB:
        return {}
    return public_names(tree(module))


def _has_part(package: str, name: str) -> bool:
    """Whether a package with public names has a module with this name."""
    if not _public(package):
        return False
    folder = file_of(package).parent
    return (folder / f"{name}.py").exists() or (folder / name).is_dir()


def origin(item: ast.ImportFrom, importer: str) -> str:
    """Module from which a statement imports."""
    parent = importer.rsplit(".", item.level)[0] if item.level else ""
    return ".".join(filter(None, (parent, item.module)))


@cache
def aliases(module: str) -> tuple[tuple[Imported, str, str], ...]:
    """Names that imports of project modules bind, each with its import and its full name."""
    return tuple(
        (one, alias.asname or alias.name, full)
        for one in imports(module)
        for alias in one.node.names
        if is_of_project(full := _full_name(one.node, alias, module))
    )


def _full_name(node: ast.Import | ast.ImportFrom, alias: ast.alias, importer: str) -> str:
    if isinstance(node, ast.ImportFrom):
        return _home(origin(node, importer), alias.name)
    return alias.name


def forget() -> None:
    """Clear all stored trees, so that the files are read again."""
    for one in (tree, nodes, imports, names, attributes, aliases, _public):
        one.cache_clear()
