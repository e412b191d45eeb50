"""Converts docstrings for Sphinx: marks up plain text, and keeps the types of signatures.

The docstrings are written for `help()`. Parts that reStructuredText would misread are marked up
here: absolute values |x|, indented lines of code or tables, a plural ending after a code word.
"""

import ast
import inspect
import re
import sys
import textwrap
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

CODE = re.compile(r"(``[^`]*``|(?::[a-z]+:)?`[^`]*`)")
ITEM = re.compile(r'("[^"]+")  +(\S.*)')
INDENT = "    "
VALUES = ("attribute", "data", "property")
PACKAGES = ("analytic", "fem", "meshes", "verify")
_values: dict[str, list[str]] = {}


def setup(app: Any) -> dict[str, bool]:
    app.connect("autodoc-process-docstring", mark, priority=100)  # before napoleon
    app.connect("autodoc-process-docstring", restore, priority=900)
    app.connect("autodoc-process-signature", signature)
    app.connect("doctree-read", exact)
    return {"parallel_read_safe": True}


def mark(_app: Any, what: str, name: str, _thing: Any, _options: Any, lines: list[str]) -> None:
    """Mark up the lines of a docstring in place."""
    lines[:] = with_examples(with_items(lines))
    marked: list[str] = []
    verbatim = False
    for number, line in enumerate(lines):
        before = _last_full(lines[:number])
        if not line.strip():
            marked.append(line)
            continue
        if not line.startswith(INDENT):
            verbatim = False
        elif not verbatim and not lines[number - 1].strip() and _is_text(lines[:number], before):
            marked += ["::", ""]
            verbatim = True
        in_block = verbatim or line.startswith((INDENT, ">>>", ".. math"))
        marked.append(line if in_block else _plain(line))
    lines[:] = marked
    if what in VALUES:
        _values[name] = marked
        lines.clear()


def restore(_app: Any, what: str, name: str, _thing: Any, _options: Any, lines: list[str]) -> None:
    """The text of a property, which napoleon would split into type and text at a colon."""
    if what in VALUES:
        lines[:] = _values.pop(name)


def with_items(lines: list[str]) -> list[str]:
    """Lines that explain a value, such as '"thin"   and N^2/(EA)', as items of a list."""
    found: list[str] = []
    in_item = False
    for line in lines:
        item = ITEM.match(line)
        if item:
            found += ([] if in_item else [""]) + [f"- {item[1]}: {item[2]}"]
        elif in_item and line.startswith(INDENT):
            found.append(f"  {line.strip()}")
            continue
        else:
            found.append(line)
        in_item = bool(item)
    return found


def with_examples(lines: list[str]) -> list[str]:
    """Adds a heading before a doctest that follows sections; it separates doctest and section."""
    first = next((n for n, line in enumerate(lines) if line.startswith(">>>")), None)
    before = lines[:first]
    sections = any(set(line) == {"-"} for line in before if line)
    if first is None or not sections or "Examples" in before:
        return lines
    return [*before, "Examples", "--------", *lines[first:]]


def _last_full(lines: list[str]) -> str:
    return next((line for line in reversed(lines) if line.strip()), "")


def _is_text(lines: list[str], before: str) -> bool:
    """Whether an indented line after the given lines is outside directives and sections."""
    if before.startswith((" ", "..", "-", ":")) or before.endswith("::") or not before:
        return False
    return not any(set(line) == {"-"} for line in lines[-3:] if line.strip())


def _plain(line: str) -> str:
    """A line of text with escaped bars; a code word may have an ending."""
    parts = CODE.split(line)
    for at in range(0, len(parts), 2):
        text = parts[at].replace("|", r"\|").replace("**", r"\*\*")
        parts[at] = rf"\ {text}" if at and re.match(r"[\w(']", text) else text
    return "".join(parts)


def signature(
    _app: Any, what: str, _name: str, thing: Any, _options: Any, _args: str, _returns: str
) -> tuple[str, str] | None:
    """Arguments and result with types as written in the source: `ArrayLike` is not expanded."""
    if what in {"function", "method"}:
        return _of_function(thing, drop_first=what == "method")
    if what == "class" and is_dataclass(thing):
        return _of_dataclass(thing), ""
    return None


def exact(_app: Any, tree: Any) -> None:
    """Makes a type refer to its stated name only, not to an equal name in another module."""
    from sphinx import addnodes

    for reference in tree.findall(addnodes.pending_xref):
        if reference.get("refdomain") == "py" and not reference.get("refspecific"):
            reference.attributes.pop("refspecific", None)


def _of_function(function: Any, *, drop_first: bool) -> tuple[str, str] | None:
    try:
        source = textwrap.dedent(inspect.getsource(inspect.unwrap(function)))
        node = ast.parse(source).body[0]
    except (OSError, TypeError, SyntaxError):
        return None
    if not isinstance(node, ast.FunctionDef):
        return None
    static = any(getattr(d, "id", "") == "staticmethod" for d in node.decorator_list)
    if drop_first and not static and node.args.args:
        node.args.args = node.args.args[1:]
    qualified = Qualified(getattr(inspect.unwrap(function), "__globals__", {}))
    for argument in ast.walk(node.args):
        if isinstance(argument, ast.arg) and argument.annotation:
            argument.annotation = qualified.visit(argument.annotation)
    returns = ast.unparse(qualified.visit(node.returns)) if node.returns else ""
    return f"({ast.unparse(node.args)})", returns


class Qualified(ast.NodeTransformer):
    """Adds modules to classes of this project in an annotation; pages do not print the modules."""

    def __init__(self, names: Mapping[str, Any]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.expr:
        found = self.names.get(node.id)
        if isinstance(found, type) and found.__module__.partition(".")[0] in PACKAGES:
            return ast.UnaryOp(ast.Invert(), ast.Name(f"{found.__module__}.{found.__qualname__}"))
        return node


def _of_dataclass(thing: type) -> str:
    written: dict[str, ast.AnnAssign] = {}
    for base in reversed(thing.__mro__):
        written |= _annotations(base)
    known = [f for f in fields(thing) if f.init and f.name in written]
    parts = ["*"] if known and all(f.kw_only for f in known) else []
    parts += [_argument(written[f.name]) for f in known]
    return f"({', '.join(parts)})"


def _annotations(base: type) -> dict[str, ast.AnnAssign]:
    try:
        node = ast.parse(textwrap.dedent(inspect.getsource(base))).body[0]
    except (OSError, TypeError, SyntaxError):
        return {}
    qualified = Qualified(vars(sys.modules[base.__module__]))
    found = [one for one in getattr(node, "body", ()) if isinstance(one, ast.AnnAssign)]
    for one in found:
        one.annotation = qualified.visit(one.annotation)
    return {one.target.id: one for one in found if isinstance(one.target, ast.Name)}


def _argument(one: ast.AnnAssign) -> str:
    value = f" = {ast.unparse(one.value)}" if one.value else ""
    return f"{ast.unparse(one.target)}: {ast.unparse(one.annotation)}{value}"
