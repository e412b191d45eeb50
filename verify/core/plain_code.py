"""Code as a text without the parts that have no effect on results.

Docstrings, comments, layout, messages of exceptions, descriptions of inputs and imports of project
modules are ignored.
"""

import ast
import copy
from collections.abc import Callable, Mapping
from typing import Any

PROJECT = ("analytic", "fem", "meshes", "verify", "reports")
FIELDS = ("quantity", "given", "count", "word", "text", "table")  # functions that declare an input
DECLARATION = "Quantity"  # of a formula: its words, and the unit of its display
FIELD_VALUES = 2  # of their arguments, which are values: default and unit
DECLARED = ("role", "when")  # arguments of a declaration that count
FIELD_WORDS = ("claims", "example", "what", "symbol")


def is_of_project(name: str) -> bool:
    """Whether a dotted name is a package of the project, or a name inside such a package."""
    return name.partition(".")[0] in PROJECT


Bound = Mapping[str, str]  # meaning of each imported name


def plain(node: ast.AST, bound: Bound) -> str:
    """Text of a syntax tree without docstrings, messages and positions; the tree is not changed.

    The text equals that of `ast.dump` in Python 3.11: it includes empty lists, which Python 3.13
    omits, and excludes `type_params`, which Python 3.12 added.
    """
    kind = type(node)
    changed = _CHANGED[kind](node, bound) if kind in _CHANGED else {}
    fields = []
    for name in kind._fields:
        value = changed[name] if name in changed else getattr(node, name, None)
        if name == "type_params" or (value is None and getattr(kind, name, ...) is None):
            continue
        if isinstance(value, list):
            items = _without_docstring(value) if name == "body" else value
            text = f"[{', '.join([_text(item, bound) for item in items if not _is_ours(item)])}]"
        else:
            text = _text(value, bound)
        fields.append(f"{name}={text}")
    return f"{kind.__name__}({', '.join(fields)})"


def _text(value: object, bound: Bound) -> str:
    return plain(value, bound) if isinstance(value, ast.AST) else repr(value)


def _is_ours(node: object) -> bool:
    """Whether a statement imports only modules of the project."""
    if isinstance(node, ast.ImportFrom):
        return bool(node.level) or is_of_project(node.module or "")
    return isinstance(node, ast.Import) and all(is_of_project(a.name) for a in node.names)


def _import(node: Any, _bound: Bound) -> dict[str, object]:
    return {"names": [alias for alias in node.names if not is_of_project(alias.name)]}


def _name(node: Any, bound: Bound) -> dict[str, object]:
    return {"id": bound.get(node.id, node.id)}


def _raise(node: Any, _bound: Bound) -> dict[str, object]:
    if not isinstance(node.exc, ast.Call):
        return {}
    raised = copy.copy(node.exc)
    raised.args = [argument for argument in raised.args if not _is_text(argument)]
    return {"exc": raised}


def _assert(_node: Any, _bound: Bound) -> dict[str, object]:
    return {"msg": None}


def _call(node: Any, bound: Bound) -> dict[str, object]:
    """Fields, without texts, that replace those of a call that declares an input or a formula."""
    called = node.func.id if isinstance(node.func, ast.Name) else ""
    name = bound.get(called, called).rpartition(".")[2]
    if name == DECLARATION:
        return {"args": [], "keywords": [k for k in node.keywords if k.arg in DECLARED]}
    if name not in FIELDS:
        return {}
    values = [a for i, a in enumerate(node.args) if i < FIELD_VALUES or not _is_text(a)]
    return {"args": values, "keywords": [k for k in node.keywords if k.arg not in FIELD_WORDS]}


# replacements of fields of these nodes
_CHANGED: dict[type[ast.AST], Callable[[Any, Bound], dict[str, object]]] = {
    ast.Import: _import, ast.Name: _name, ast.Raise: _raise, ast.Assert: _assert, ast.Call: _call,
}  # fmt: skip


def _without_docstring(body: list[ast.stmt]) -> list[ast.stmt]:
    first = body[0] if body else None
    is_docstring = (
        isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        and isinstance(first.value.value, str)
    )  # fmt: skip
    return body[1:] if is_docstring else body


def _is_text(node: ast.expr) -> bool:
    """Whether an argument is a message: a text, a formatted text, or joined texts."""
    if isinstance(node, ast.BinOp):
        return _is_text(node.left) or _is_text(node.right)
    return isinstance(node, ast.JoinedStr) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )
