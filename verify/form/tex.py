r"""Equations in TeX: with inserted numbers, evaluated, or as plain text.

Inserted numbers have their units (210 GPa · 0.06 mm).
"""

import math
import re
from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

from verify.core.tex import tex as number

T = TypeVar("T")
_NAMES = """alpha beta gamma delta varepsilon zeta eta theta kappa lambda mu nu xi pi rho sigma
    tau varphi chi psi omega Gamma Delta Theta Lambda Sigma Phi Psi Omega"""
GREEK = dict(zip("αβγδεζηθκλμνξπρστφχψωΓΔΘΛΣΦΨΩ", _NAMES.split(), strict=True))
LETTER = {rf"\{name}": letter for letter, name in GREEK.items()}
FUNCTIONS = {"log": "ln", "sqrt": "sqrt", "sin": "sin", "cos": "cos", "tan": "tan", "exp": "exp",
             "asin": "arcsin", "acos": "arccos", "atan": "arctan"}  # fmt: skip
EXTREMES = {"min": min, "max": max}
OPENS = {rf"\{name}" for name in (*FUNCTIONS.values(), *EXTREMES, "frac", "left")} | {"("}
TOKENS = r"\\mathrm\{[^}]*\}|\\[A-Za-z]+|\\.|\s+|\d+(?:\.\d+)?|."


def symbol_tex(symbol: str) -> str:
    r"""TeX of a symbol: σ_t gives \sigma_t, p_1r gives p_{1r}.

    >>> symbol_tex("σ_max"), symbol_tex("Δd_m"), symbol_tex("u_r(r_i)")
    ('\\sigma_{max}', '\\Delta d_m', 'u_r(r_i)')
    """
    with_subscripts = re.sub(
        r"_([^\W_]+)", lambda m: m[0] if len(m[1]) == 1 else f"_{{{m[1]}}}", symbol
    )
    return re.sub(
        f"([{''.join(GREEK)}])(?=([A-Za-zα-ωΑ-Ω]?))",
        lambda m: rf"\{GREEK[m[1]]}" + (" " if m[2] else ""), with_subscripts,
    )  # fmt: skip


def with_raised_stars(tex: str, symbols: Iterable[str]) -> str:
    r"""TeX of the equation for display: the star of a symbol, such as E*, becomes an exponent.

    >>> with_raised_stars(r"\pi E* l K_1*^2", ["l", "E*", "K_1*"])
    '\\pi E^* l K_1^{*2}'
    """
    starred = sorted({s for s in symbols if "*" in s}, key=len, reverse=True)
    if not starred:
        return tex
    names = "|".join(map(re.escape, starred))
    raised = re.sub(names, lambda m: m[0].replace("*", "^*"), tex)
    return re.sub(r"\^\*\^(?:\{([^{}]*)\}|(\w))", lambda m: f"^{{*{m[1] or m[2]}}}", raised)


def with_unit(value: float, unit: str, digits: int = 6) -> str:
    r"""TeX of a number with its unit.

    >>> with_unit(30.0, "MPa m^0.5"), with_unit(2.0, "mm^2")
    ('30\\,\\mathrm{MPa m}^{0.5}', '2\\,\\mathrm{mm^2}')
    """
    if unit == "1":
        return number(value, digits)
    upright = re.sub(r"\^(\d\.\d)", r"}^{\1}\\mathrm{", rf"\mathrm{{{unit}}}")
    return rf"{number(value, digits)}\,{upright}".removesuffix(r"\mathrm{}")


def put_in(tex: str, numbers: Mapping[str, str]) -> str:
    r"""TeX of the equation with `numbers` inserted for its symbols and dots between factors.

    >>> put_in(r"\frac{E j_D}{d_m^2}", {"E": "210", "j_D": "0.06", "d_m": r"76\,\mathrm{mm}"})
    '\\frac{210 \\cdot 0.06}{\\left(76\\,\\mathrm{mm}\\right)^2}'
    """
    names = "|".join(map(re.escape, sorted(numbers, key=len, reverse=True)))
    out, closed = "", False  # closed: the text before ends a factor
    for match in re.finditer(rf"(?:{names})(?!_|(?<=[A-Za-z]{{2}})[A-Za-z])|{TOKENS}", tex):
        token = match[0]
        value = numbers.get(token)
        if token.isspace():
            continue
        operand = value is not None or token[0].isalnum() or token in LETTER
        dot = r" \cdot " if closed and (operand or token in OPENS) else ""
        closed = operand or token in (")", "}")
        if value is not None and (value.startswith("-") or tex[match.end() :].startswith("^")):
            value = rf"\left({value}\right)" if value.strip("0123456789.") else value
        spaced = f" {token} " if token in ("+", "-", "=") else token
        letters = out[-1:].isalpha() and token[0].isalpha()  # \ln x must not become \lnx
        out += dot + (" " if letters and not dot else "") + (spaced if value is None else value)
    return out.replace("( - ", "(-").strip()


def plain(tex: str) -> str:
    """The equation as one line of text, for the terminal."""
    text = re.sub(r"\\mathrm\{([^}]*)\}", r"\1", tex).replace(r"\,", " ").replace(r"\ ", " ")
    text = (
        re.sub(r"\\left|\\right|\\quad", "", text).replace(r" \cdot ", "·").replace(r"\cdot", "·")
    )
    text = re.sub(r"_\{([^{}]*)\}", r"_\1", text)
    fraction = r"\\frac\{([^{}]*)\}\{([^{}]*)\}"
    while (
        flat := re.sub(fraction, _over, re.sub(r"(\\sqrt|\^)\{([^{}]*)\}", r"\1(\2)", text))
    ) != text:
        text = flat
    text = re.sub(r"\\[A-Za-z]+", lambda m: LETTER.get(m[0], m[0][1:]), text)
    return re.sub(r"  +", " ", text).strip()


def _over(match: re.Match[str]) -> str:
    """Fraction a/b in one line, in brackets where the surrounding text requires them."""
    above, below = (
        m if re.fullmatch(r"[\w.\\]+|\([^()]*\)", m) else f"({m})" for m in match.groups()
    )
    before, after = match.string[: match.start()], match.string[match.end() :]
    inside = after.startswith("^") or before[-1:].isalpha()
    return f"({above}/{below})" if inside else f"{above}/{below}"


ARITHMETIC: Mapping[str, Any] = (
    {name: getattr(math, code) for code, name in FUNCTIONS.items()} | EXTREMES | {"π": math.pi}
)


def evaluate(
    tex: str, values: Mapping[str, T], arithmetic: Mapping[str, Any] = ARITHMETIC
) -> T | None:
    """Value of the equation for the given `values` of the symbols, such as numbers [SI].

    None if the equation is more than arithmetic, or if it has no value (root of a negative number).
    """
    variables = {f"x{k}": value for k, value in enumerate(values.values())}
    text = plain(put_in(tex, {s: f"({name})" for s, name in zip(values, variables, strict=True)}))
    code = text.replace("·", "*").replace("^", "**")
    if re.search(r"[\d)]\s*\(", code):  # a function of something, as under an integral
        return None
    try:
        found = eval(code, {"__builtins__": {}}, {**arithmetic, **variables})  # noqa: S307 - TeX of the case
    except (SyntaxError, NameError, TypeError, AttributeError, ValueError, ArithmeticError):
        return None
    return None if isinstance(found, complex | tuple) else found
