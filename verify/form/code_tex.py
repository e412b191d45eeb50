"""TeX of a formula, derived from the code of the method that returns it."""

import ast
import inspect
import textwrap
from collections.abc import Callable, Mapping
from typing import Any

from verify.core.module_syntax import parsed
from verify.core.tex import tex as number
from verify.form.tex import EXTREMES, FUNCTIONS


def tex_of(formula: Callable[..., Any], symbols: Mapping[str, str]) -> str:
    """TeX of a method that only returns one expression of `symbols`; otherwise empty.

    The result is also empty for a constant and for a number that is read from a solution.
    """
    if formula.__code__.co_name == "<lambda>":
        return ""
    body = parsed(textwrap.dedent(inspect.getsource(formula))).body[0]
    assert isinstance(body, ast.FunctionDef)
    last = body.body[-1]
    documented = ast.get_docstring(body) is not None
    returned = last.value if isinstance(last, ast.Return) else None
    if returned is None or isinstance(returned, ast.Constant) or len(body.body) > 1 + documented:
        return ""
    try:
        return _tex(returned, symbols)[0]
    except (KeyError, TypeError):
        return ""


def _tex(node: ast.expr, symbols: Mapping[str, str]) -> tuple[str, int]:
    """TeX of an expression, and its precedence: 1 sum, 2 product, 3 power, 4 symbol."""

    def part(of: ast.expr, binding: int) -> str:
        text, binds = _tex(of, symbols)
        return text if binds >= binding else rf"\left({text}\right)"

    match node:
        case ast.Attribute(value=ast.Name(id="self"), attr=name):
            return symbols[name], 4
        case ast.Constant(value=value):
            return _constant(float(value))  # type: ignore[arg-type]
        case ast.Name(id="pi"):
            return r"\pi", 4
        case ast.UnaryOp(op=ast.USub(), operand=of):
            return f"-{part(of, 2)}", 1
        case ast.BinOp(left=a, op=ast.Add(), right=b):
            return f"{part(a, 1)} + {part(b, 1)}", 1
        case ast.BinOp(left=a, op=ast.Sub(), right=b):
            return f"{part(a, 1)} - {part(b, 2)}", 1
        case ast.BinOp(left=a, op=ast.Mult(), right=b):
            return f"{part(a, 2)} {part(b, 2)}", 2
        case ast.BinOp(left=a, op=ast.Div(), right=b):
            return rf"\frac{{{part(a, 1)}}}{{{part(b, 1)}}}", 2
        case ast.BinOp(left=a, op=ast.Pow(), right=b):
            return rf"{part(a, 4)}^{{{part(b, 1)}}}", 3
        case ast.Call(func=ast.Name(id="sqrt"), args=[of]):
            return rf"\sqrt{{{part(of, 1)}}}", 4
        case ast.Call(func=ast.Name(id=function), args=several) if function in EXTREMES:
            return rf"\{function}\left({', '.join(part(of, 1) for of in several)}\right)", 2
        case ast.Call(func=ast.Name(id=function), args=[of]):
            return rf"\{FUNCTIONS[function]}\left({part(of, 1)}\right)", 2
    raise TypeError(node)


def _constant(value: float) -> tuple[str, int]:
    """TeX of a constant with all its digits, and its precedence (see `_tex`)."""
    digits = next(n for n in range(6, 18) if float(f"{value:.{n}g}") == value)
    text = number(value, digits)
    return text, 2 if r"\cdot" in text else 3 if "^" in text else 4
