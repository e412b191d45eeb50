"""Check that the equation of a quantity gives the dimension of its stated unit."""

from collections.abc import Mapping
from typing import Any

from verify.core import units
from verify.form import tex as equations
from verify.form.case import Case
from verify.form.code_tex import tex_of
from verify.form.equations import declared
from verify.form.quantity import Quantity

Powers = frozenset[tuple[str, float]]
NUMBER: Powers = frozenset()


class DimensionFaultError(Exception):
    """Error for an equation that adds or compares different dimensions."""


class Dimension:
    """A physical dimension, which can be used in arithmetic like a number.

    Plain numbers are dimensionless.
    """

    def __init__(self, powers: Powers) -> None:
        self.powers = powers

    def __add__(self, other: Any) -> "Dimension":
        return same("adds", self, other)

    __radd__ = __sub__ = __rsub__ = __add__

    def __mul__(self, other: Any, sign: int = 1) -> "Dimension":
        found = dict(self.powers)
        for name, power in of(other).powers:
            found[name] = found.get(name, 0.0) + sign * power
        return Dimension(frozenset((n, round(p, 9)) for n, p in found.items() if round(p, 9)))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> "Dimension":
        return self.__mul__(other, -1)

    def __rtruediv__(self, other: Any) -> "Dimension":
        return of(other) / self

    def __pow__(self, exponent: Any) -> "Dimension":
        if isinstance(exponent, Dimension):
            function(exponent)
            if self.powers:
                raise DimensionFaultError(f"contains {words(self.powers)} with a variable exponent")
            return self
        return Dimension(frozenset((n, p * exponent) for n, p in self.powers))

    def __rpow__(self, _base: Any) -> "Dimension":
        return function(self)

    def __neg__(self) -> "Dimension":
        return self

    __pos__ = __neg__


def of(value: Any) -> Dimension:
    """Dimension of a value; a plain number is dimensionless."""
    return value if isinstance(value, Dimension) else Dimension(NUMBER)


def same(verb: str, *values: Any) -> Dimension:
    """Common dimension of all values; zero agrees with any dimension.

    Raises DimensionFaultError.
    """
    first, *others = [of(v) for v in values if isinstance(v, Dimension) or v != 0] or [of(0)]
    if other := next((one for one in others if one.powers != first.powers), None):
        raise DimensionFaultError(f"{verb} {words(first.powers)} and {words(other.powers)}")
    return first


def function(argument: Any) -> Dimension:
    """Dimension of a sine, logarithm or exponential; its argument must be dimensionless."""
    if powers := of(argument).powers:
        raise DimensionFaultError(
            f"contains a function of {words(powers)}; the argument must be a plain number"
        )
    return Dimension(NUMBER)


FUNCTIONS = {
    **dict.fromkeys(equations.FUNCTIONS.values(), function),
    **dict.fromkeys(equations.EXTREMES, lambda *values: same("compares", *values)),
    "sqrt": lambda value: of(value) ** 0.5,
    "π": Dimension(NUMBER),
}


def powers_of(unit: str) -> Powers:
    """Powers of the base dimensions of a unit; an angle counts as a number (ratio of lengths)."""
    return frozenset(one for one in units.dimensions(unit) if one[0] != "[angle]")


def words(powers: Powers) -> str:
    """Name of a dimension, such as "a length"; without a name, its powers, such as "[length]^4".

    >>> words(powers_of("MPa")), words(powers_of("mm^4")), words(powers_of("deg"))
    ('a pressure or stress', '[length]^4', 'a number')
    """
    known = {powers_of(unit): text for unit, text in reversed(units.DIMENSIONS.items())}
    parts = (f"{name}^{power:g}".removesuffix("^1") for name, power in sorted(powers))
    return (known | {NUMBER: "a number"}).get(powers) or " ".join(parts)


def check(case: Case) -> None:
    """Raise CaseError for the first equation whose dimension differs from that of its unit."""
    symbols: dict[str, str] = {}
    known: dict[str, Dimension] = {}
    for one in declared(case):
        symbols[one.name] = one.tex
        known.setdefault(one.tex, Dimension(powers_of(one.unit)))
    for q in case.quantities():
        tex = "" if q.fitted else q.tex or tex_of(q.formula, symbols)
        if fault := _fault(q, known, tex):
            raise q.broken(fault)


def _fault(q: Quantity, known: Mapping[str, Dimension], tex: str) -> str:
    for part in tex.split(" = ") if tex else ():
        try:
            found = equations.evaluate(part, known, FUNCTIONS)
        except DimensionFaultError as error:
            return f"the equation {equations.plain(part)} {error}"
        if found is not None and of(found).powers != powers_of(q.unit):
            given, stated = words(of(found).powers), words(powers_of(q.unit))
            return (
                f"the unit {q.unit} is {stated}, but the equation {equations.plain(part)} "
                f"gives {given}"
            )
    return ""
