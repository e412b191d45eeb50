"""The equation of a quantity with its numbers, checked against the code of its formula."""

import math
from typing import NamedTuple

from verify.core import units
from verify.core.figures import Equation
from verify.core.inputs import meta
from verify.form import tex as equations
from verify.form.case import Case
from verify.form.code_tex import tex_of
from verify.form.quantity import Quantity

SAME = 1e-9  # relative difference of an equation and the code of its formula
DIGITS, INPUT_DIGITS = 6, 10  # significant: inputs are displayed as they are given


class Symbols(NamedTuple):
    """TeX of a case's symbols by attribute; SI values and numbers with units by TeX."""

    tex: dict[str, str]
    values: dict[str, float]
    numbers: dict[str, str]

    def add(self, name: str, symbol: str, value: float, unit: str, digits: int) -> None:
        """Another symbol, or another value of one."""
        self.tex[name] = symbol
        self.values[symbol] = value
        self.numbers[symbol] = equations.with_unit(value / units.factor(unit), unit, digits)


def stated(case: Case) -> tuple[Equation, ...]:
    """The equations of all quantities; CaseError where one gives another number than the code."""
    symbols = symbols_of(case)
    found = (equation(case, q, symbols) for q in case.present())
    return tuple(one for one in found if one is not None)


def symbols_of(case: Case) -> Symbols:
    """The symbols of inputs and quantities; of forms of one quantity the first that is declared.

    Those of a compared state are there, too, where it has symbols different from these.
    """
    found = Symbols({}, {}, {})
    fields = type(case).model_fields
    inputs = ((name, meta(field)["symbol"], meta(field)["unit"]) for name, field in fields.items())
    for name, symbol, unit in (*inputs, *((q.name, q.symbol, q.unit) for q in case.present())):
        value, as_tex = getattr(case, name), equations.symbol_tex(symbol)
        if as_tex and isinstance(value, int | float) and as_tex not in found.values:
            found.add(name, as_tex, value, unit, INPUT_DIGITS if name in fields else DIGITS)
    for one in case.stated():
        if one.quantity and one.state and one.state.case and one.state.symbol != "{}":
            value, unit = getattr(one.state.case, one.quantity.name), one.quantity.unit
            as_tex = equations.symbol_tex(one.state.symbol.format(one.quantity.symbol))
            found.add(one.key, as_tex, value, unit, DIGITS)
    return found


def equation(case: Case, q: Quantity, symbols: Symbols) -> Equation | None:
    """The equation of a quantity, with numbers where it is arithmetic.

    None where none is stated; CaseError where it gives another number than the code on the default
    inputs. Elsewhere cancellation may part them: the numbers that are put in are then left out.
    """
    tex, value, found = q.tex or tex_of(q.formula, symbols.tex), getattr(case, q.name), None
    if not tex:
        return None
    for part in tex.split(" = "):
        found = equations.evaluate(part, symbols.values)
        if found is None or math.isclose(found, value, rel_tol=SAME):
            continue
        if case.is_default:
            rule = f"the equation {equations.plain(part)} gives {found:.10g}, the code {value:.10g}"
            raise q.broken(f"{rule} [SI]")
        found = None
        break
    put_in = equations.put_in(tex.rpartition(" = ")[2], symbols.numbers)
    number = equations.with_unit(value / units.factor(q.unit), q.unit)
    return Equation(
        tex=f"{equations.symbol_tex(q.symbol)} = {tex}",
        numbers=f"= {number}" if found is None else f"= {put_in} = {number}",
        place=f"Eq. {q.equation}" if q.equation else q.source,
        is_step=q.role == "step",
    )
