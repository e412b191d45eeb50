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
from collections.abc import Collection, Iterator, Mapping
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

COMPILED = "analytic.sprag.engagement"
OF_BOTH = re.compile(r"[._](inputs|description)$")  # modules that make what both sides take
PROJECT = ("analytic", "fem", "meshes", "verify", "reports")
FIELDS = ("quantity", "count", "word", "text", "table")  # functions that declare an input
FIELD_VALUES = 2  # of their arguments, which are values: default and unit
FIELD_WORDS = ("claims", "example", "what", "symbol")


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


def module_hash(module: str) -> str:
    """Hash of a module's own code."""
    return _read(module)[0]


def text_hash(text: str) -> str:
    """Hash of the code of a text, whose imports of the project's modules do not count."""
    return _digest(plain(ast.parse(text), {}))


def forget() -> None:
    """Read the sources again: processes read a module once."""
    for one in (source_of, whole_source_of, is_module, _read, _shallow):
        one.cache_clear()


def _hash(used: Mapping[str, str], reached: list[str], *, whole: bool) -> str:
    own = [used[name] for name in sorted(used)]
    hashes = (_read(module, whole=whole)[0] for module in reached)
    modules = sorted(one for one in hashes if one != EMPTY)
    return _digest("\n".join([*own, *modules]))


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _used(function: Any, *, whole: bool) -> tuple[dict[str, str], set[str]]:
    """Code of the names that a function's module gives it, and the modules that these import."""
    module = inspect.getmodule(function)
    if module is None or module.__file__ is None:
        return {}, set()
    tree = ast.parse(Path(module.__file__).read_text("utf-8"))
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
                found = (m for m in found if whole or not _is_formula(m))
                borrowed.setdefault(name, set()).update(found)
    used: dict[str, str] = {}
    start: set[str] = set()
    queue = [function.__name__]
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
    for item in ast.walk(node):
        names = list(_names(item, importer))
        kept = (n for n in names if not (item in formulas and _is_formula(n)))
        yield from (n for n in kept if _counts(n))


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


def _counts(name: str) -> bool:
    """Whether `name` is a module on which a finite-element result may depend."""
    package = name.partition(".")[0]
    if not (package in ("analytic", "fem", "meshes") or name.startswith("verify.cases.")):
        return False
    return is_module(name)


@cache
def is_module(name: str) -> bool:
    """Whether a dotted name is a module of the project, not a name inside one."""
    parent = find_spec(name.rpartition(".")[0] or name)
    if parent is None or parent.submodule_search_locations is None:
        return False  # the last part is a name inside a module, which asking would import
    return find_spec(name) is not None


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
def _read(module: str, *, whole: bool = False) -> tuple[str, tuple[str, ...]]:
    """Hash of a module's code, and the modules that count among what it imports."""
    tree = _tree(module)
    imported = tuple(_imported(tree, module, whole=whole))
    return _digest(plain(tree, _bound(tree, module, whole=whole))), imported


def _tree(module: str) -> ast.Module:
    spec = find_spec(module)
    assert spec is not None
    assert spec.origin is not None
    return ast.parse(Path(spec.origin).read_text("utf-8"))


@cache
def _shallow(module: str) -> str:
    """Hash of a module's code in which imported names stand for themselves."""
    return _digest(plain(_tree(module), {}))[:16]


def _bound(tree: ast.Module, importer: str, *, whole: bool) -> Mapping[str, str]:
    """What each name that an import of the project's modules binds stands for: their code.

    A name of the other side, whose code does not count (`_imported`), stands for itself alone.
    """
    found = {}
    formulas = () if whole else _formulas(tree, importer)
    for item in ast.walk(tree):
        if not isinstance(item, ast.Import | ast.ImportFrom):
            continue
        for alias in item.names:
            full = alias.name
            if isinstance(item, ast.ImportFrom):
                full = f"{_source(item, importer)}.{alias.name}"
            if not _counts_package(full):
                continue
            name = alias.asname or alias.name
            if item in formulas and _is_formula(full):
                found[name] = f"formula {alias.name}"
            elif _counts(full):
                found[name] = _shallow(full)
            elif _counts(full.rpartition(".")[0]):
                found[name] = f"{_shallow(full.rpartition('.')[0])}.{alias.name}"
    return found


def _counts_package(name: str) -> bool:
    return name.partition(".")[0] in PROJECT


class _Plain(ast.NodeTransformer):
    """Removes words and places: docstrings, messages, descriptions, the project's imports."""

    def __init__(self, bound: Mapping[str, str]) -> None:
        self.bound = bound

    def visit(self, node: ast.AST) -> Any:
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = _without_docstring(body)  # type: ignore[attr-defined]
        return super().visit(node)

    def visit_Import(self, node: ast.Import) -> Any:
        node.names = [a for a in node.names if not _counts_package(a.name)]
        return node if node.names else None

    def visit_ImportFrom(self, node: ast.ImportFrom) -> Any:
        if node.level or _counts_package(node.module or ""):
            return None
        return node

    def visit_Name(self, node: ast.Name) -> Any:
        node.id = self.bound.get(node.id, node.id)
        return node

    def visit_Raise(self, node: ast.Raise) -> Any:
        self.generic_visit(node)
        if isinstance(node.exc, ast.Call):
            node.exc.args = [a for a in node.exc.args if not _is_text(a)]
        return node

    def visit_Assert(self, node: ast.Assert) -> Any:
        self.generic_visit(node)
        node.msg = None
        return node

    def visit_Call(self, node: ast.Call) -> Any:
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id.rpartition(".")[2] in FIELDS:
            node.args = [a for i, a in enumerate(node.args) if i < FIELD_VALUES or not _is_text(a)]
            node.keywords = [k for k in node.keywords if k.arg not in FIELD_WORDS]
        return node


def _without_docstring(body: list[ast.stmt]) -> list[ast.stmt]:
    first = body[0] if body else None
    is_docstring = (
        isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        and isinstance(first.value.value, str)
    )  # fmt: skip
    return body[1:] if is_docstring else body


def _is_text(node: ast.expr) -> bool:
    """Whether an argument is a message: a text, a formatted text or texts in a row."""
    if isinstance(node, ast.BinOp):
        return _is_text(node.left) or _is_text(node.right)
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


def plain(node: ast.AST, bound: Mapping[str, str]) -> str:
    """Text of a syntax tree without words and places; `bound` maps names of imports. Changes it."""
    return dump(_Plain(bound).visit(node))


def dump(node: ast.AST) -> str:
    """Text of a syntax tree, the same in every version of Python from 3.11 on.

    Python 3.12 added `type_params`, and 3.13 leaves empty fields out unless `show_empty` is set.
    """
    whole: dict[str, Any] = {"show_empty": True} if sys.version_info >= (3, 13) else {}
    return ast.dump(node, **whole).replace(", type_params=[]", "")


EMPTY = text_hash("")  # of a package without code
