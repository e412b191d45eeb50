"""Which code a function depends on, and a hash of it that words, names and places do not change.

Code is compared as a syntax tree without docstrings, comments, layout, messages of exceptions,
descriptions of inputs and imports of the project's own modules. A name that such an import binds
stands for the code of its module, so that a module can be moved or renamed, and two modules
cannot be swapped unnoticed.
"""

import ast
import copy
import hashlib
import inspect
import re
import sys
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import Any

from verify.core.plain_code import PROJECT, is_of_project, plain

CASE = "q"  # what a case's modules call the case with its inputs
SOLVERS = ("analytic.", "fem.", "meshes.")  # take numbers, and no case
COMPILED = "analytic.sprag.engagement"
_outside: set[Path] = set()
OF_BOTH = re.compile(r"[._](inputs|description)$")  # modules that make what both sides take


@cache
def source_of(function: Any) -> str:
    """Hash of a `fem` function: itself, the names of its module it uses, the modules it reaches."""
    used, reached = parts_of(function)
    return _hash(used, reached, whole=COMPILED in reached)


@cache
def whole_source_of(function: Any) -> str:
    """Hash of a function, the names of its module it uses, and all formulas these reach."""
    return _hash(*whole_parts_of(function), whole=True)


def whole_parts_of(function: Any) -> tuple[dict[str, str], list[str]]:
    """Code of a function and of the names of its module it uses, and all modules it reaches."""
    used, start = _used(function, whole=True)
    return used, sorted(_reached(start, whole=True))


def parts_of(function: Any) -> tuple[dict[str, str], list[str]]:
    """Code of a `fem` function and of the names of its module it uses, and modules it reaches.

    Where it reaches COMPILED, its results are the formulas' own and all formulas count.
    """
    used, start = _used(function, whole=False)
    reached = _reached(start, whole=False)
    if COMPILED in reached:
        return whole_parts_of(function)
    return used, sorted(reached)


def group_hash(modules: Collection[str]) -> str:
    """Hash of some modules' code, in which names imported from each other stand for their code."""
    group = frozenset(modules)
    return _digest("\n".join(sorted(_read(module, group=group)[0] for module in group)))


def forget() -> None:
    """Read the sources again: processes read a module once."""
    for one in (source_of, whole_source_of, is_module, _read, _shallow, _attributes):
        one.cache_clear()


def _hash(used: Mapping[str, str], reached: list[str], *, whole: bool) -> str:
    own = [used[name] for name in sorted(used)]
    hashes = (_read(module, whole=whole)[0] for module in reached)
    modules = sorted(one for one in hashes if one != EMPTY)
    return _digest("\n".join([*own, *modules]))


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _used(function: Any, *, whole: bool) -> tuple[dict[str, str], set[str]]:
    """Code of the names that a function's module gives it, and the modules that these import.

    The function of a case that is one class names its parts by `code`: module, class, members.
    """
    if hasattr(function, "code"):
        return _used_in_class(function, whole=whole)
    module = inspect.getmodule(function)
    if module is None or module.__file__ is None:
        return {}, set()
    return _used_in(module, "", [function.__name__], whole=whole)


def _used_in_class(function: Any, *, whole: bool) -> tuple[dict[str, str], set[str]]:
    """The same of a function that names its parts, and of the members that its modules read.

    A reference in a file of its own reads sizes off the case: attributes of the case's modules.
    """
    read: frozenset[str] = frozenset()
    while True:
        found: dict[str, str] = {}
        start: set[str] = set()
        for module, owner, members in function.code(read):
            more, reached = _used_in(sys.modules[module], owner, members, whole=whole)
            found |= {f"{owner}.{name}": code for name, code in more.items()}
            start |= reached
        modules = (m for m in _reached(start, whole=whole) if not m.startswith(SOLVERS))
        attributes = read.union(*map(_attributes, modules))
        if attributes == read:
            return found, start
        read = attributes


@cache
def _attributes(module: str) -> frozenset[str]:
    """The attributes that a module reads off a case: in the suite the object called q.

    Modules outside the suite may call it anything: all that they read.
    """
    nodes = [n for n in ast.walk(_tree(module)) if isinstance(n, ast.Attribute)]
    if module.startswith("verify.cases."):
        nodes = [n for n in nodes if _name(n.value) == CASE]
    return frozenset(n.attr for n in nodes)


def _name(node: ast.expr) -> str:
    """The last part of a dotted name."""
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def _used_in(
    module: ModuleType, owner: str, names: Sequence[str], *, whole: bool
) -> tuple[dict[str, str], set[str]]:
    """The same of some names of a module, or of members of its class `owner`.

    Formulas that members use, of which sizes are made, count.
    """
    tree = ast.parse(Path(module.__file__ or "").read_text("utf-8"))
    bound = _bound(tree, module.__name__, whole=whole)
    own = {name: node for node in tree.body for name in _defined(node)}
    borrowed: dict[str, set[str]] = {}  # names that the module's own imports bind
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom):
            for alias in node.names:
                name = (alias.asname or alias.name).partition(".")[0]
                alone = copy.copy(node)
                alone.names = [alias]
                found = _imported(alone, module.__name__)
                found = (m for m in found if whole or owner or not _is_formula(m))
                borrowed.setdefault(name, set()).update(found)
    used: dict[str, str] = {}
    start: set[str] = set()
    queue = list(names)
    if owner:
        body = next(n.body for n in tree.body if isinstance(n, ast.ClassDef) and n.name == owner)
        del own[owner]  # its other members do not count
        members = {f".{name}": node for node in body for name in _defined(node)}
        own, queue = own | members, [f".{name}" for name in names]
    while queue:
        name = queue.pop()
        if name in borrowed:  # a helper of another case module: all of that module
            start |= borrowed[name]
        elif name in own and name not in used:
            queue += [n.id for n in ast.walk(own[name]) if isinstance(n, ast.Name)]
            start.update(_imported(own[name], module.__name__))
            used[name] = plain(own[name], bound)
    return used, start


def _defined(node: ast.stmt) -> list[str]:
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return [node.name]
    targets = node.targets if isinstance(node, ast.Assign) else []
    targets = [node.target] if isinstance(node, ast.AnnAssign) else targets
    return [n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]


def _imported(node: ast.AST, importer: str, *, whole: bool = False) -> Iterator[str]:
    """Modules of analytic, fem, meshes and the cases that `node`, a part of `importer`, imports.

    But for `whole`, without what a module imports of analytic at its top: the other side's. Modules
    of inputs are both sides': sizes and loads that they compute act on finite elements, too.
    """
    formulas = () if whole else _formulas(node, importer)
    types = _for_types(node)
    for item in ast.walk(node):
        if item in types:
            continue
        names = list(_names(item, importer))
        kept = (n for n in names if not (item in formulas and _is_formula(n)))
        yield from (n for n in kept if _counts(n))


def _for_types(node: ast.AST) -> set[ast.AST]:
    """The imports of a part of a module that only type checkers execute."""
    guarded = (
        n for n in ast.walk(node) if isinstance(n, ast.If) and _name(n.test) == "TYPE_CHECKING"
    )
    return {item for guard in guarded for part in guard.body for item in ast.walk(part)}


def _formulas(node: ast.AST, importer: str) -> Collection[ast.AST]:
    """The statements of a module whose imports of analytic do not count: the other side's."""
    both = importer.startswith("analytic.") or OF_BOTH.search(importer)
    return node.body if isinstance(node, ast.Module) and not both else ()


def _names(item: ast.AST, importer: str) -> Iterator[str]:
    """Modules and names inside modules that an import statement names."""
    if isinstance(item, ast.Import):
        yield from (alias.name for alias in item.names)
    elif isinstance(item, ast.ImportFrom):
        source = _source(item, importer)
        yield source
        yield from (f"{source}.{alias.name}" for alias in item.names)


def _source(item: ast.ImportFrom, importer: str) -> str:
    parent = importer.rsplit(".", item.level)[0] if item.level else ""
    return ".".join(filter(None, (parent, item.module)))


def _is_formula(name: str) -> bool:
    return name.partition(".")[0] == "analytic"


def include(folder: Path) -> None:
    """Have modules of a folder outside the suite count, as those of the suite's cases do."""
    _outside.add(folder)


def _is_outside(package: str) -> bool:
    if not _outside:
        return False
    spec = find_spec(package)
    return spec is not None and spec.origin is not None and Path(spec.origin).parent in _outside


def _counts(name: str) -> bool:
    """Whether `name` is a module on which a finite-element result may depend."""
    package = name.partition(".")[0]
    if package not in PROJECT and _is_outside(package):
        return is_module(name)
    if not (package in ("analytic", "fem", "meshes") or name.startswith("verify.cases.")):
        return False
    return is_module(name)


@cache
def is_module(name: str) -> bool:
    """Whether a dotted name is a module of the project, not a name inside one."""
    if "." not in name:
        return find_spec(name) is not None
    parent = find_spec(name.rpartition(".")[0])
    if parent is None or parent.submodule_search_locations is None:
        return False  # the last part is a name inside a module, which asking would import
    return find_spec(name) is not None


def is_package(name: str) -> bool:
    """Whether a module of the project has modules inside it."""
    spec = find_spec(name)
    return spec is not None and spec.submodule_search_locations is not None


def _reached(start: set[str], *, whole: bool) -> set[str]:
    found: set[str] = set()
    queue = list(start)
    while queue:
        name = queue.pop()
        if name not in found:
            found.add(name)
            queue += _read(name, whole=whole)[1]
    return found


@cache
def _read(
    module: str, *, whole: bool = False, group: frozenset[str] = frozenset()
) -> tuple[str, tuple[str, ...]]:
    """Hash of a module's code, and the modules that count among what it imports."""
    tree = _tree(module)
    imported = tuple(_imported(tree, module, whole=whole))
    bound = _bound(tree, module, whole=whole, group=group)
    exported = _exported(tree, bound)
    return _digest("\n".join([plain(tree, bound), *exported])), imported


def _exported(tree: ast.Module, bound: Mapping[str, str]) -> list[str]:
    """What the names stand for that a module imports only for others to import from it."""
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    imports = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    names = {alias.asname or alias.name for node in imports for alias in node.names}
    only = {name for name in names if name.partition(".")[0] not in used}
    return sorted(f"{name} = {bound[name]}" for name in only & bound.keys())


def _tree(module: str) -> ast.Module:
    spec = find_spec(module)
    assert spec is not None
    assert spec.origin is not None
    return ast.parse(Path(spec.origin).read_text("utf-8"))


@cache
def _shallow(module: str) -> str:
    """Hash of a module's code in which imported names stand for themselves, however renamed."""
    tree = _tree(module)
    names = {name: full for _, name, full in _aliases(tree, module) if not is_module(full)}
    return _digest(plain(tree, {name: full.rpartition(".")[2] for name, full in names.items()}))[
        :16
    ]


def _bound(
    tree: ast.Module, importer: str, *, whole: bool, group: frozenset[str] = frozenset()
) -> Mapping[str, str]:
    """What each name that an import of the project's modules binds stands for: their code.

    Modules of `group` count besides those of `_counts`. A name of the other side, whose code does
    not count (`_imported`), and one of any other module stand for themselves alone.
    """
    found = {}
    formulas = () if whole else _formulas(tree, importer)
    for item, name, full in _aliases(tree, importer):
        source, _, own = full.rpartition(".")
        if item in formulas and _is_formula(full):
            found[name] = f"formula {own}"
        elif _counts(full) or full in group:
            found[name] = _shallow(full)
        elif _counts(source) or source in group:
            found[name] = f"{_shallow(source)}.{own}"
        elif not is_module(full):
            found[name] = own
    return found


def _aliases(tree: ast.Module, importer: str) -> Iterator[tuple[ast.AST, str, str]]:
    """Each name that imports of the project's modules bind, with its statement and full name."""
    for item in ast.walk(tree):
        if not isinstance(item, ast.Import | ast.ImportFrom):
            continue
        source = f"{_source(item, importer)}." if isinstance(item, ast.ImportFrom) else ""
        for alias in item.names:
            if is_of_project(full := source + alias.name):
                yield item, alias.asname or alias.name, full


EMPTY = _digest(plain(ast.parse(""), {}))  # of a package without code
