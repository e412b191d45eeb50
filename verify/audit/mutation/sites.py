"""Finds the nodes of a module that can be changed, and the mutants with stable ids.

Code in which no row can detect a fault is excluded: docstrings, annotations, messages, exceptions
and their conditions, assertions, tolerances and iteration counts of solvers, indices, and arrays of
which only the shape is used.
"""

import ast
import hashlib
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from verify.audit.mutation.operators import Around, Operator, name_of

SOLVERS = frozenset(
    ("xtol", "ftol", "gtol", "rtol", "atol", "tol", "maxiter", "maxfev", "limit", "epsabs",
     "epsrel", "max_step", "axis", "ndmin", "maxsize", "full_output", "disp", "seed", "strict",
     "subdivisions", "method", "decimals", "fill_value", "mode")
)  # fmt: skip
SHAPES = ("zeros_like", "ones_like", "empty_like", "full_like", "shape", "broadcast_shapes")
TAKEN = ("shape", "size", "ndim")  # of an array whose values then are of no matter
TOLD = ("__repr__", "__str__", "__reduce__", "__hash__")


@dataclass(frozen=True)
class Place:
    """Position of a node in the syntax tree: a field of `owner`, or entry `index` of this field."""

    node: ast.AST
    owner: ast.AST
    field: str
    index: int | None

    def put(self, node: ast.AST) -> None:
        """Put `node` in this place."""
        if self.index is None:
            setattr(self.owner, self.field, node)
        else:
            getattr(self.owner, self.field)[self.index] = node


@dataclass(frozen=True)
class Mutant:
    """A change of a function or of a constant of a module.

    `before` and `after` are the changed code; `number` is the number of the line.
    """

    id: str
    module: str
    function: str
    operator: str
    number: int  # of the line
    before: str
    after: str


@dataclass(frozen=True)
class Changed:
    """A mutant, with the place in the syntax tree that it changes, and the new node there."""

    mutant: Mutant
    place: Place
    node: ast.AST


@dataclass(frozen=True)
class Source:
    """A module as text and as syntax tree."""

    module: str
    path: Path
    text: str
    tree: ast.Module


@cache
def source(module: str) -> Source:
    """Source of an importable module; the module is not executed."""
    spec = find_spec(module)
    assert spec is not None
    assert spec.origin is not None
    path = Path(spec.origin)
    text = path.read_text("utf-8")
    return Source(module, path, text, ast.parse(text))


def mutants(of: Source, operators: Mapping[str, Operator]) -> list[Changed]:
    """All changes of functions, methods and plain constants of a module, in source order."""
    attributes = frozenset(n.attr for n in ast.walk(of.tree) if isinstance(n, ast.Attribute))
    found: list[Changed] = []
    seen: Counter[str] = Counter()
    for name, owner in owners(of.tree):
        around = Around(_names(owner), attributes)
        for place in _places(owner):
            for operator, changes in operators.items():
                found += [
                    _changed(of, name, operator, place, node, seen)
                    for node in changes(place.node, around)
                ]
    return found


def owners(tree: ast.Module) -> Iterator[tuple[str, ast.stmt]]:
    """Functions, methods and constants of a module with their names, such as "Ring.stress"."""
    yield from _defined(tree.body, "")


def _defined(body: list[ast.stmt], prefix: str) -> Iterator[tuple[str, ast.stmt]]:
    for item in body:
        if isinstance(item, ast.FunctionDef) and item.name not in TOLD:
            yield prefix + item.name, item
        elif isinstance(item, ast.ClassDef):
            yield from _defined(item.body, f"{prefix}{item.name}.")
        elif not prefix and (name := constant_of(item)):
            yield name, item


def constant_of(item: ast.stmt) -> str:
    """Name of the constant that a statement of a module defines; empty if it defines none."""
    target: ast.expr | None = None
    if isinstance(item, ast.Assign) and len(item.targets) == 1:
        target = item.targets[0]
    elif isinstance(item, ast.AnnAssign) and item.value is not None:
        target = item.target
    named = isinstance(target, ast.Name) and target.id.lstrip("_").isupper()
    return target.id if named and isinstance(target, ast.Name) else ""


def _names(owner: ast.stmt) -> frozenset[str]:
    nodes = list(ast.walk(owner))
    bound = {n.arg for n in nodes if isinstance(n, ast.arg)}
    return frozenset(bound | {n.id for n in nodes if isinstance(n, ast.Name)})


def _places(owner: ast.AST) -> Iterator[Place]:
    """All nodes below `owner` that may be changed, in the order of the source."""
    for field, value in ast.iter_fields(owner):
        if _left_out(owner, field):
            continue
        for index, node in enumerate(value) if isinstance(value, list) else ((None, value),):
            if isinstance(node, ast.AST) and not _no_matter(node):
                yield Place(node, owner, field, index)
                yield from _places(node)


def _left_out(owner: ast.AST, field: str) -> bool:
    if field in ("annotation", "returns", "decorator_list"):
        return True
    if isinstance(owner, ast.Attribute) and owner.attr in TAKEN:
        return field == "value"
    return isinstance(owner, ast.Subscript) and field == "slice"


def _no_matter(node: ast.AST) -> bool:
    if isinstance(node, ast.Raise | ast.Assert | ast.JoinedStr):
        return True
    if isinstance(node, ast.If) and all(isinstance(n, ast.Raise) for n in node.body):
        return not node.orelse
    if isinstance(node, ast.keyword) and node.arg in SOLVERS:
        return True
    if isinstance(node, ast.Call) and name_of(node.func) in SHAPES:
        return True
    # a docstring, or a call for its exception, whose result is unused
    return isinstance(node, ast.Expr) and not (
        isinstance(node.value, ast.Call) and isinstance(node.value.func, ast.Attribute)
    )


def _changed(
    of: Source, name: str, operator: str, place: Place, node: ast.AST, seen: Counter[str]
) -> Changed:
    ast.copy_location(node, place.node)
    ast.fix_missing_locations(node)
    number = int(getattr(place.node, "lineno", 0))
    line = of.text.splitlines()[number - 1].strip()
    digest = hashlib.sha256(line.encode()).hexdigest()[:6]
    head = f"{of.module}:{name}:{operator}:{digest}"
    seen[head] += 1
    before, after = (_short(ast.unparse(n)) for n in (place.node, node))
    mutant = Mutant(f"{head}:{seen[head]}", of.module, name, operator, number, before, after)
    return Changed(mutant, place, node)


def _short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= 70 else f"{text[:34]} … {text[-34:]}"
