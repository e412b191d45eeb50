"""Code as text that words, layout and places do not change.

Docstrings, comments, layout, messages of exceptions, descriptions of inputs and imports of the
project's own modules do not count.
"""

import ast
import sys
from collections.abc import Mapping
from typing import Any

PROJECT = ("analytic", "fem", "meshes", "verify", "reports")
FIELDS = ("quantity", "given", "count", "word", "text", "table")  # functions that declare an input
DECLARATION = "Quantity"  # of a formula: its words, and the unit of its display
FIELD_VALUES = 2  # of their arguments, which are values: default and unit
FIELD_WORDS = ("claims", "example", "what", "symbol")


def is_of_project(name: str) -> bool:
    """Whether a dotted name is a package of the project or something inside one."""
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
        node.names = [a for a in node.names if not is_of_project(a.name)]
        return node if node.names else None

    def visit_ImportFrom(self, node: ast.ImportFrom) -> Any:
        if node.level or is_of_project(node.module or ""):
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
        name = node.func.id.rpartition(".")[2] if isinstance(node.func, ast.Name) else ""
        if name == DECLARATION:
            node.args, node.keywords = [], [k for k in node.keywords if k.arg in ("role", "when")]
        elif name in FIELDS:
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
