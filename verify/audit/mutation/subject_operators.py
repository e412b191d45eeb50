"""Typical mistakes in formulas, weak forms and judging, as changes of syntax-tree nodes."""

import ast
import re
from collections.abc import Iterator
from copy import deepcopy

from verify.audit.mutation.operators import (
    Around,
    Operator,
    arithmetic,
    boundary,
    comparison,
    condition,
    constant,
    dropped,
    extreme,
    function,
    name_of,
    power,
    sign,
)

ASSUMPTIONS = {"plane stress": "plane strain", "plane strain": "plane stress"}
ENDS = (
    ("_i", "_o"), ("_i", "_e"), ("_1", "_2"), ("_a", "_b"), ("_x", "_y"), ("_n", "_t"),
    ("_A", "_B"), ("_r", "_t"), ("_in", "_out"), ("_left", "_right"), ("_min", "_max"),
)  # fmt: skip
ALIKE = (("lam", "mu"), ("sin", "cos"), ("h", "b"))
RADIUS = re.compile(r"[rR](_\w+)?|\w*radius\w*")
DIAMETER = re.compile(r"[dD](_\w+)?|\w*diameter\w*")
POISSON = re.compile(r"nu(_\w+)?")
CONTACT = re.compile(r"gap|gaps|pressure|penalty|opening|traction|slip")
LINEAR = {
    "ElementTriP2": "ElementTriP1", "ElementQuad2": "ElementQuad1", "ElementQuadS2": "ElementQuad1",
    "ElementTetP2": "ElementTetP1", "ElementHex2": "ElementHex1", "ElementLineP2": "ElementLineP1",
}  # fmt: skip
COMPONENTS = {"x": "y", "y": "x", "z": "y", "n": "t", "t": "n", "r": "y", "xy": "x", "xyz": "xy"}
RULES = re.compile(r"\w*(gauss|quadrature)\w*")
STATES = {"PASS": "FAIL", "FAIL": "PASS", "SHOWN": "FAIL"}


def poisson(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace 1 - nu**2 by 1."""
    if (
        isinstance(node, ast.BinOp) and isinstance(node.op, ast.Sub)
        and isinstance(node.left, ast.Constant) and node.left.value == 1
        and isinstance(node.right, ast.BinOp) and isinstance(node.right.op, ast.Pow)
        and POISSON.fullmatch(name_of(node.right.left))
    ):  # fmt: skip
        yield deepcopy(node.left)


def diameter(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace r_i by 2 r_i or D by D / 2, which confuses radius and diameter."""
    name = name_of(node)
    if not (isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Load)):
        return
    if RADIUS.fullmatch(name):
        yield ast.BinOp(ast.Constant(2), ast.Mult(), deepcopy(node))
    elif DIAMETER.fullmatch(name):
        yield ast.BinOp(deepcopy(node), ast.Div(), ast.Constant(2))


def assumption(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace plane strain by plane stress and vice versa."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in ASSUMPTIONS:
        yield ast.Constant(ASSUMPTIONS[node.value])


def alike(node: ast.AST, around: Around) -> Iterator[ast.AST]:
    """Replace a name by a similar available name, such as r_i by r_o."""
    if not (isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Load)):
        return
    known = around.names if isinstance(node, ast.Name) else around.attributes
    for other in _others(name_of(node)):
        if other in known:
            changed = deepcopy(node)
            if isinstance(changed, ast.Name):
                changed.id = other
            else:
                changed.attr = other
            yield changed
            return


def _others(name: str) -> Iterator[str]:
    for pair in (*ALIKE, *(pair[::-1] for pair in ALIKE)):
        if name == pair[0]:
            yield pair[1]
    for one, other in (*ENDS, *(pair[::-1] for pair in ENDS)):
        if name.endswith(one) and len(name) > len(one):
            yield name.removesuffix(one) + other


def element(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace quadratic elements by linear elements with the same quadrature and mesh."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in LINEAR:
        changed = deepcopy(node)
        # the class by its library: the module need not import it
        library = ast.Call(ast.Name("__import__", ast.Load()), [ast.Constant("skfem")], [])
        changed.func = ast.Attribute(library, LINEAR[node.func.id], ast.Load())
        yield changed


def contact_sign(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Change the sign of a gap or a pressure."""
    read = isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Load)
    if read and CONTACT.fullmatch(name_of(node)):
        assert isinstance(node, ast.expr)
        yield ast.UnaryOp(ast.USub(), deepcopy(node))


def component(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Change the direction of a support, such as x to y."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in COMPONENTS:
        yield ast.Constant(COMPONENTS[node.value])


def quadrature(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Reduce the number of points or the order of a quadrature rule by one."""
    if not isinstance(node, ast.Call):
        return
    if RULES.fullmatch(name_of(node.func)) and node.args and _rule(node.args[0]):
        changed = deepcopy(node)
        changed.args[0] = _one_less(node.args[0])
        yield changed
    for n, keyword in enumerate(node.keywords):
        if keyword.arg in ("intorder", "order", "points") and _rule(keyword.value):
            changed = deepcopy(node)
            changed.keywords[n].value = _one_less(keyword.value)
            yield changed


def _rule(node: ast.expr) -> bool:
    return not isinstance(node, ast.Constant) or (isinstance(node.value, int) and node.value > 1)


def _one_less(node: ast.expr) -> ast.expr:
    return ast.BinOp(deepcopy(node), ast.Sub(), ast.Constant(1))


def state(node: ast.AST, _around: Around) -> Iterator[ast.AST]:
    """Replace the status PASS by FAIL and vice versa."""
    if isinstance(node, ast.Attribute) and name_of(node.value) == "Status" and node.attr in STATES:
        changed = deepcopy(node)
        changed.attr = STATES[node.attr]
        yield changed


# On floats < and <= differ where no computed number lies: boundaries are changed in judging alone.
FORMULAS: dict[str, Operator] = {
    "arithmetic": arithmetic, "power": power, "sign": sign, "constant": constant,
    "comparison": comparison, "function": function, "extreme": extreme, "dropped": dropped,
    "poisson": poisson, "diameter": diameter, "assumption": assumption, "alike": alike,
}  # fmt: skip
JUDGING: dict[str, Operator] = {
    "arithmetic": arithmetic, "power": power, "sign": sign, "constant": constant,
    "comparison": comparison, "boundary": boundary, "extreme": extreme, "dropped": dropped,
    "condition": condition, "state": state,
}  # fmt: skip
FINITE_ELEMENTS: dict[str, Operator] = {
    **FORMULAS, "element": element, "contact-sign": contact_sign, "component": component,
    "quadrature": quadrature,
}  # fmt: skip
