"""Equations of quantities with inserted numbers, checked against the code of the formulas."""

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from verify.core import units
from verify.core.figures import Equation
from verify.core.inputs import meta
from verify.form import tex as equations
from verify.form.case import Case
from verify.form.code_tex import tex_of
from verify.form.quantity import Quantity

SAME = 1e-9  # relative difference of an equation and the code of its formula
_OTHER = {"as printed": "corrected", "corrected": "as printed"}  # the form beside one
DIGITS, INPUT_DIGITS = 6, 10  # significant: inputs are displayed as they are given


class Symbol(NamedTuple):
    """A symbol as TeX, with its unit; `value` returns its value: a number [SI], a text or None."""

    name: str
    tex: str
    unit: str
    digits: int
    value: Callable[[], object]


class Symbols(NamedTuple):
    """Symbols of a case: `tex` by attribute; SI `values`, and `numbers` with units, by TeX."""

    tex: dict[str, str]
    values: dict[str, float]
    numbers: dict[str, str]


def stated(case: Case) -> tuple[Equation, ...]:
    """Equations of all quantities.

    Raises CaseError if an equation gives another number than the code of the quantity.
    """
    symbols = symbols_of(case)
    found = (equation(case, q, symbols) for q in case.present())
    return tuple(one for one in found if one is not None)


def declared(case: Case) -> Iterator[Symbol]:
    """Symbols of inputs, of quantities, and of quantities in states with a different symbol."""
    as_tex = equations.symbol_tex
    for name, field in type(case).model_fields.items():
        symbol, unit = meta(field)["symbol"], meta(field)["unit"]
        if symbol:
            yield Symbol(name, as_tex(symbol), unit, INPUT_DIGITS, partial(getattr, case, name))
    for q in case.quantities():
        yield Symbol(q.name, as_tex(q.symbol), q.unit, DIGITS, partial(q.of, case))
    for one in case.stated():
        judged, state = one.quantity, one.state
        if judged and state and state.case and state.symbol != "{}":
            symbol = as_tex(state.symbol.format(judged.symbol))
            yield Symbol(one.key, symbol, judged.unit, DIGITS, partial(judged.of, state.case))


def symbols_of(case: Case) -> Symbols:
    """Symbols whose value is a number; if several have the same TeX, only the first is included."""
    found = Symbols({}, {}, {})
    for name, tex, unit, digits, of in declared(case):
        if tex not in found.values and isinstance(value := of(), int | float):
            found.tex[name], found.values[tex] = tex, value
            found.numbers[tex] = equations.with_unit(value / units.factor(unit), unit, digits)
    return found


def equation(case: Case, q: Quantity, symbols: Symbols) -> Equation | None:
    """Equation of a quantity, with inserted numbers if it is arithmetic.

    None if no equation is stated. Raises CaseError if, at the default inputs, the equation and the
    code give different numbers. At other inputs, their results may differ by cancellation; the
    inserted numbers are then omitted.
    """
    tex, value, found = q.tex or tex_of(q.formula, symbols.tex), getattr(case, q.name), None
    if not tex:
        return None
    for part in tex.split(" = "):
        found = equations.evaluate(part, symbols.values)
        if found is None or math.isclose(found, value, rel_tol=SAME):
            continue
        if case.is_default:
            rule = (
                f"the equation {equations.plain(part)} gives {found:.10g}, but the code "
                f"gives {value:.10g}"
            )
            raise q.broken(f"{rule} [SI]")
        found = None
        break
    put_in = equations.put_in(tex.rpartition(" = ")[2], symbols.numbers)
    number = equations.with_unit(value / units.factor(q.unit), q.unit)
    symbol = equations.symbol_tex(q.symbol)
    return Equation(
        tex=equations.with_raised_stars(f"{symbol} = {tex}", (symbol, *symbols.values)),
        numbers=f"= {number}" if found is None else f"= {put_in} = {number}",
        place=_place(case, q),
        is_step=q.role == "step",
    )


def _place(case: Case, q: Quantity) -> str:
    """Place of the equation in its source, and its form if the case has several forms.

    If another quantity is declared as a form of this one ("as printed" or "corrected"), a numbered
    equation that declares no form has the other of these two forms.
    """
    if not q.equation:
        return ", ".join(filter(None, (q.source, q.form)))
    beside = next((one.form for one in case.present() if one.form_of == q.name), "")
    return ", ".join(filter(None, (f"Eq. {q.equation}", q.form or _OTHER.get(beside, ""))))
