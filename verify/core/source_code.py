"""Code on which a function depends, and its hash, independent of wording, names and positions.

Code is compared as a syntax tree without docstrings, comments, layout, messages of exceptions,
descriptions of inputs, and imports of project modules. A name that such an import defines is
replaced by the code of its module. Therefore, moving or renaming a module has no effect, but an
exchange of two modules changes the hash.
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

from verify.core import module_syntax as syntax
from verify.core.plain_code import PROJECT, plain
from verify.core.source_memory import remembered

CASE = "q"  # variable of a case's modules for the case with its inputs
SOLVERS = ("analytic.", "fem.", "meshes.")  # modules that use numbers only, and no case
COMPILED = "analytic.sprag.engagement"
_outside: set[Path] = set()
OF_BOTH = re.compile(r"[._](inputs|description)$")  # modules with inputs of both sides


@cache
def source_of(function: Any) -> str:
    """Hash of the code on which a `fem` function depends; see `parts_of`."""
    return remembered("reference", function, lambda: _source_of(function))


def _source_of(function: Any) -> str:
    used, reached = parts_of(function)
    return _hash(used, reached, whole=COMPILED in reached)


@cache
def whole_source_of(function: Any) -> str:
    """Hash of all code on which a function depends, including formulas; see `whole_parts_of`."""
    return remembered("formulas", function, lambda: _hash(*whole_parts_of(function), whole=True))


@cache
def modules_of(function: Any) -> tuple[str, ...]:
    """Modules that a `fem` function imports, directly or indirectly; see `parts_of`."""
    return tuple(remembered("modules", function, lambda: parts_of(function)[1]))


def whole_parts_of(function: Any) -> tuple[dict[str, str], list[str]]:
    """Code that a function uses in its module, by name, and all modules on which it depends."""
    used, start = _used(function, whole=True)
    return used, sorted(_reached(start, whole=True))


def parts_of(function: Any) -> tuple[dict[str, str], list[str]]:
    """Code that a `fem` function uses in its module, by name, and other modules it depends on.

    The other modules are those that the function imports, directly or indirectly. If COMPILED is
    one of them, the function returns results of formulas; all formulas are then included.
    """
    used, start = _used(function, whole=False)
    reached = _reached(start, whole=False)
    if COMPILED in reached:
        return whole_parts_of(function)
    return used, sorted(reached)


def group_hash(modules: Collection[str]) -> str:
    """Hash of the code of modules; names imported from one of them are replaced by their code."""
    group = frozenset(modules)
    name = f"group of {' '.join(sorted(group))}"
    return remembered(name, group_hash, lambda: _group_hash(group), group)


def _group_hash(group: frozenset[str]) -> str:
    return _digest("\n".join(sorted(_read(module, group=group)[0] for module in group)))


def forget() -> None:
    """Clear stored sources, so that files are read again; otherwise, each file is read once."""
    syntax.forget()
    for one in (
        source_of, whole_source_of, modules_of, is_module, _read, _shallow, _borrowed, _bound,
        _parts, _part,
    ):  # fmt: skip
        one.cache_clear()


def _hash(used: Mapping[str, str], reached: list[str], *, whole: bool) -> str:
    own = [used[name] for name in sorted(used)]
    hashes = (_read(module, whole=whole)[0] for module in reached)
    modules = sorted(one for one in hashes if one != EMPTY)
    return _digest("\n".join([*own, *modules]))


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _used(function: Any, *, whole: bool) -> tuple[dict[str, str], set[str]]:
    """Code that a function uses in its module, by name, and modules that this code imports.

    If a case is one class, its functions have the method `code`, which returns the used members of
    the class: module, class and names.
    """
    if hasattr(function, "code"):
        return _used_in_class(function, whole=whole)
    module = inspect.getmodule(function)
    if module is None or module.__file__ is None:
        return {}, set()
    return _used_in(module, "", [function.__name__], whole=whole)


def _used_in_class(function: Any, *, whole: bool) -> tuple[dict[str, str], set[str]]:
    """Code that a function with the method `code` uses, by name, and modules that it imports.

    A reference in a separate file reads sizes from the case. Therefore, the attributes of the case
    that the imported modules read are included.
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
        attributes = read.union(*map(_read_off_a_case, modules))
        if attributes == read:
            return found, start
        read = attributes


def _read_off_a_case(module: str) -> frozenset[str]:
    """Attributes of a case that a module reads.

    In the suite, these are attributes of the object q. In modules outside the suite, the case can
    have any name; all attributes that these modules read are included.
    """
    return syntax.attributes(module, CASE if module.startswith("verify.cases.") else "")


def _used_in(
    module: ModuleType, owner: str, names: Sequence[str], *, whole: bool
) -> tuple[dict[str, str], set[str]]:
    """Code of some names of a module, or of members of its class `owner`, and imported modules.

    Formulas that members use to compute sizes are included.
    """
    borrowed = _borrowed(module.__name__, formulas=whole or bool(owner))
    parts = _parts(module.__name__, owner)
    used: dict[str, str] = {}
    start: set[str] = set()
    queue = [f".{name}" for name in names] if owner else list(names)
    while queue:
        name = queue.pop()
        if name in borrowed:  # a helper of another case module: the whole module counts
            start |= borrowed[name]
        elif name in parts and name not in used:
            used[name], reads, imported = _part(module.__name__, owner, name, whole=whole)
            queue += reads
            start.update(imported)
    return used, start


@cache
def _parts(module: str, owner: str) -> dict[str, ast.stmt]:
    """Statements of a module by defined name; names of members of `owner` begin with a point."""
    body = syntax.tree(module).body
    if not owner:
        return {name: node for node in body for name in _defined(node)}
    members = next(n.body for n in body if isinstance(n, ast.ClassDef) and n.name == owner)
    found = {name: node for node in body for name in _defined(node) if name != owner}
    return found | {f".{name}": node for node in members for name in _defined(node)}


@cache
def _part(
    module: str, owner: str, name: str, *, whole: bool
) -> tuple[str, tuple[str, ...], tuple[str, ...]]:
    """Code that defines a name, the names that this code reads, and the modules that it imports."""
    node = _parts(module, owner)[name]
    reads = tuple(n.id for n in ast.walk(node) if isinstance(n, ast.Name))
    imported = tuple(_imported(node, module))
    return plain(node, _bound(module, whole=whole)), reads, imported


@cache
def _borrowed(module: str, *, formulas: bool) -> dict[str, frozenset[str]]:
    """Names defined by the imports of a module, with the modules to which each name refers."""
    found: dict[str, set[str]] = {}
    for one in syntax.imports(module):
        for alias in one.node.names if one.at_top else ():
            alone = copy.copy(one.node)
            alone.names = [alias]
            name = (alias.asname or alias.name).partition(".")[0]
            modules = (m for m in _imported(alone, module) if formulas or not _is_formula(m))
            found.setdefault(name, set()).update(modules)
    return {name: frozenset(modules) for name, modules in found.items()}


def _defined(node: ast.stmt) -> list[str]:
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return [node.name]
    targets = node.targets if isinstance(node, ast.Assign) else []
    targets = [node.target] if isinstance(node, ast.AnnAssign) else targets
    return [n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]


def _imported(part: ast.AST, importer: str) -> Iterator[str]:
    """Modules of analytic, fem, meshes and cases that a part of `importer` imports."""
    nodes = list(ast.walk(part))
    types = syntax.for_types(nodes)
    for item in nodes:
        if item not in types:
            yield from filter(_counts, syntax.named(item, importer))


def _imported_by(module: str, *, whole: bool) -> Iterator[str]:
    """Modules that a whole module imports and on which results depend.

    Unless `whole`, imports of analytic at the top of the module are excluded, because they belong
    to the formulas, not to the reference. Modules of inputs belong to both: sizes and loads that
    they compute also act on finite elements.
    """
    for one in syntax.imports(module):
        if not one.for_types:
            other = one.at_top and not whole and not _is_of_both(module)
            names = syntax.named(one.node, module)
            yield from (n for n in names if not (other and _is_formula(n)) and _counts(n))


def _is_of_both(module: str) -> bool:
    """Whether imports of analytic in a module belong to both the formulas and the reference."""
    return module.startswith("analytic.") or OF_BOTH.search(module) is not None


def _is_formula(name: str) -> bool:
    return name.partition(".")[0] == "analytic"


def include(folder: Path) -> None:
    """Treat modules of `folder`, outside the suite, like modules of the suite in hashes."""
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
    """Whether a dotted name is a module of the project, and not a name inside a module."""
    if "." not in name:
        return find_spec(name) is not None
    parent = find_spec(name.rpartition(".")[0])
    if parent is None or parent.submodule_search_locations is None:
        return False  # the last part is a name inside a module, which asking would import
    return find_spec(name) is not None


def is_package(name: str) -> bool:
    """Whether a module of the project is a package with modules inside it."""
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
    """Hash of a module's code, and the modules that it imports and that affect results."""
    bound = _bound(module, whole=whole, group=group)
    code = plain(syntax.tree(module), bound)
    return _digest("\n".join([code, *_exported(module, bound)])), tuple(
        _imported_by(module, whole=whole)
    )


def _exported(module: str, bound: Mapping[str, str]) -> list[str]:
    """Meanings of names that a module imports only so that other modules can import them."""
    used = syntax.names(module)
    top = (one.node for one in syntax.imports(module) if one.at_top)
    names = {alias.asname or alias.name for node in top for alias in node.names}
    only = {name for name in names if name.partition(".")[0] not in used}
    return sorted(f"{name} = {bound[name]}" for name in only & bound.keys())


@cache
def _shallow(module: str) -> str:
    """Hash of the code of a module, with imported names replaced by their original names."""
    names = {name: full for _, name, full in syntax.aliases(module) if not is_module(full)}
    own = {name: full.rpartition(".")[2] for name, full in names.items()}
    return _digest(plain(syntax.tree(module), own))[:16]


@cache
def _bound(module: str, *, whole: bool, group: frozenset[str] = frozenset()) -> Mapping[str, str]:
    """Meaning of each name that an import of a project module defines: the code of that module.

    Modules of `group` are included in addition to those of `_counts`. The code of some names is not
    included; their meaning is then the name itself. These are names of formulas that a module of
    the reference imports (see `_imported_by`), and names of all other modules.
    """
    found = {}
    others = not whole and not _is_of_both(module)
    for one, name, full in syntax.aliases(module):
        source, _, local = full.rpartition(".")
        if others and one.at_top and _is_formula(full):
            found[name] = f"formula {local}"
        elif _counts(full) or full in group:
            found[name] = _shallow(full)
        elif _counts(source) or source in group:
            found[name] = f"{_shallow(source)}.{local}"
        elif not is_module(full):
            found[name] = local
    return found


EMPTY = _digest(plain(ast.parse(""), {}))  # of a package without code
