"""General changes of code (operators): replacements for a node of the syntax tree.

An operator takes a node and the names around it, and yields all replacements. It yields none for a
node to which it does not apply. Replacements are new nodes; the given node is not changed.
"""

import ast
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass

SMALL = 1e-6  # smaller constants only limit round-off: a change has no visible effect


@dataclass(frozen=True)
class Around:
    """Possible replacements for a name: names in the same function, attributes in the module."""

    names: frozenset[str]
    attributes: frozenset[str]


Operator = Callable[[ast.AST, Around], Iterator[ast.AST]]

OPPOSITE: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
}  # fmt: skip
TURNED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
BOUNDARY: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt,
}  # fmt: skip
FUNCTIONS = {
    "sin": "cos", "cos": "sin", "tan": "sin", "sinh": "cosh", "cosh": "sinh", "tanh": "sinh",
    "asin": "acos", "acos": "asin", "arcsin": "arccos", "arccos": "arcsin", "atan": "sin",
    "arctan": "sin",
}  # fmt: skip
EXTREMES = {
    "min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "argmin": "argmax",
    "argmax": "argmin", "fmin": "fmax", "fmax": "fmin",
}  # fmt: skip
DROPPED = ("sqrt", "abs", "hypot", "floor", "ceil", "square")


def arithmetic(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace + by -, * by /, and vice versa."""
    if isinstance(node, ast.BinOp | ast.AugAssign) and type(node.op) in OPPOSITE:
        changed = deepcopy(node)
        changed.op = OPPOSITE[type(node.op)]()
        yield changed


def power(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Remove an exponent: nu instead of nu**2."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        yield deepcopy(node.left)


def sign(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Remove a minus sign."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield deepcopy(node.operand)


def constant(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace a number by twice or half the number, its negative, the next integer, or 1 % more."""
    if not isinstance(node, ast.Constant) or type(node.value) not in (int, float):
        return
    value = node.value
    assert isinstance(value, int | float)
    if isinstance(value, int):
        found = [1] if value == 0 else [value + 1, 2 * value, value / 2, -value]
    else:
        found = [1.0] if value == 0 else [1.01 * value, 2 * value, value / 2, -value]
    if value == 0 or abs(value) >= SMALL:
        for other in dict.fromkeys(found):
            yield ast.Constant(other)


def comparison(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace a comparison by its opposite."""
    yield from _compared(node, TURNED)


def boundary(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace < by <= and vice versa, which matters if both sides may be equal."""
    yield from _compared(node, BOUNDARY)


def _compared(
    node: ast.AST, others: dict[type[ast.cmpop], type[ast.cmpop]]
) -> Iterator[ast.Compare]:
    if isinstance(node, ast.Compare):
        for n, op in enumerate(node.ops):
            if type(op) in others:
                changed = deepcopy(node)
                changed.ops[n] = others[type(op)]()
                yield changed


def function(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace a function by a similar one, such as sin by cos."""
    yield from _called(node, FUNCTIONS)


def extreme(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace min by max and vice versa."""
    yield from _called(node, EXTREMES)


def _called(node: ast.AST, others: dict[str, str]) -> Iterator[ast.Call]:
    if isinstance(node, ast.Call) and (other := others.get(name_of(node.func))):
        changed = deepcopy(node)
        if isinstance(changed.func, ast.Name):
            changed.func.id = other
        elif isinstance(changed.func, ast.Attribute):
            changed.func.attr = other
        yield changed


def dropped(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace a square root, absolute value or similar function by its argument."""
    if isinstance(node, ast.Call) and name_of(node.func) in DROPPED and node.args:
        yield deepcopy(node.args[0])


def condition(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace `and` by `or` and vice versa; remove `not`."""
    if isinstance(node, ast.BoolOp):
        changed = deepcopy(node)
        changed.op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        yield changed
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
        yield deepcopy(node.operand)


def name_of(node: ast.AST) -> str:
    """Last part of a name, such as sin of np.sin; empty if the node is no name."""
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else ""
