"""Quantity: a formula of a source with its symbol, unit, meaning, equation and safe side."""

import inspect
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import KW_ONLY, dataclass, field, replace
from functools import partial, wraps
from itertools import count, pairwise, product
from math import isfinite
from pathlib import Path
from typing import Any, Generic, Literal, SupportsFloat, TypeVar, get_args, overload

import numpy as np

Side = Literal["too high", "too low", ""]
Role = Literal["formula", "step", "geometry"]
Form = Literal["as printed", "corrected", "small angles", ""]
Indexed = Callable[..., SupportsFloat]  # a method with arguments in addition to the instance
T = TypeVar("T")
MEMO = "="  # before the name of a computed value in an instance's __dict__: no field begins so
_numbers = count(1)
_code = [0]  # number of the code that values are computed by
solving: ContextVar[bool] = ContextVar("solving", default=False)  # whether a reference is at work
# see `changed`, `read_by` and `remembered`
_larger: ContextVar["Quantity | shared[Any] | None"] = ContextVar("larger", default=None)
_read: ContextVar["dict[Quantity | shared[Any], str] | None"] = ContextVar("read", default=None)
_begun: ContextVar[tuple[tuple[int, str], ...]] = ContextVar("begun", default=())
CHANGE = 1e-3


class CaseError(ValueError):
    """Error for a case that breaks a rule; the message names file, line, quantity and rule."""


@dataclass(eq=False)
class Quantity:
    """A formula of the source with its data, used as decorator of a method.

    The method returns the value in SI units. `equation` is its number in the source of the case;
    `source` is another source. `tex` is the right side of the equation; if it is omitted, it is
    derived from the code of a method that returns one expression. `safe` is the safe side of an
    error.

    `form_of` is the input or quantity of which this is another form (as printed, corrected, or for
    small angles); both have the same symbol and reference. `form` is the name of this form. The
    role "step" is an intermediate value that is not compared. The role "geometry" is a value that
    follows from the inputs without a theory; the reference may also read it.

    `when(case)` states whether the quantity exists at these inputs: a deflection requires a load.
    If only the solution shows whether it exists, the method returns nan, or inf for a limit that is
    not reached. The constants of a `fitted` equation have arbitrary units; therefore, its dimension
    is not checked.
    """

    symbol: str
    unit: str
    what: str
    _: KW_ONLY
    equation: str = ""
    source: str = ""
    tex: str = ""
    safe: Side = ""
    form_of: str = ""
    form: Form = ""
    role: Role = "formula"
    fitted: bool = False
    when: Callable[..., bool] | None = None
    name: str = field(default="", init=False)
    owner: str = field(default="", init=False)  # the class
    formula: Callable[[Any], SupportsFloat] = field(init=False, repr=False)

    def __call__(self, formula: Callable[[Any], SupportsFloat]) -> "Declared":
        """Declaration of the decorated method."""
        self.formula, self.name = formula, formula.__name__
        return Declared(self)

    def reads(self, number: Callable[[Any], SupportsFloat]) -> "Declared":
        """Declaration of a quantity that other code computes; its name is that of the attribute.

        For example: `alpha = Quantity("α", "deg", "clamping angle").reads(lambda q: q.state.alpha)`
        """
        self.formula = number
        return Declared(self)

    def over(self, *indices: Sequence[object]) -> "Callable[[Indexed], Family]":
        """Decorator of a method with indices; declares one quantity per combination of indices.

        In `symbol` and `what`, `{0}` is the first index and `{1}` the second; `when` also receives
        the indices.
        """
        return partial(Family.of, self, tuple(product(*indices)))

    def of(self, case: object) -> float | None:
        """Value of the quantity [SI]; None if it does not exist at the inputs of the case."""
        if self.when is not None and not self.when(case):
            return None
        return finite(getattr(case, self.name))

    @property
    def label(self) -> str:
        """Name with equation, such as "hoop stress, Eq. 9"; rows of the quantity have this name."""
        return f"{self.what}, Eq. {self.equation}" if self.equation else self.what

    def check_words(self) -> None:
        """Raise CaseError if `safe`, `form` or `role` is not one of the permitted words."""
        for name, words in ("safe", Side), ("form", Form), ("role", Role):
            if (word := getattr(self, name)) not in get_args(words):
                known = ", ".join(filter(None, get_args(words)))
                raise self.broken(f"{name} is {word!r}, and must be one of: {known}")

    def broken(self, rule: str) -> CaseError:
        """Error for a rule that this declaration breaks, with file, line and name."""
        code = inspect.unwrap(self.formula).__code__
        place = f"{Path(code.co_filename).name}:{code.co_firstlineno}"
        return CaseError(f"{place}: {self.owner}.{self.name}: {rule}")


def finite(number: SupportsFloat) -> float | None:
    """The number as float; None for nan or inf, because not all numbers of a solution exist."""
    value = float(number)
    return value if isfinite(value) else None


@dataclass(frozen=True)
class Declared:
    """Attribute of a quantity: the class returns its declaration, an instance its value [SI]."""

    quantity: Quantity

    def __set_name__(self, owner: type, name: str) -> None:
        q = self.quantity
        q.owner = owner.__name__
        if not q.name:  # of a number that is read: a method has a name
            q.name = q.formula.__name__ = name

    @overload
    def __get__(self, case: None, owner: type) -> Quantity: ...
    @overload
    def __get__(self, case: object, owner: type) -> float: ...
    def __get__(self, case: object | None, owner: type) -> Quantity | float:
        q = self.quantity
        if case is None:
            return q
        if solving.get() and q.role != "geometry":
            raise q.broken("the reference reads this formula, but must not read any formula")
        _note(q, q.name)
        factor = 1 + CHANGE if _larger.get() is q else 1.0
        return remembered(case, q.name, lambda: factor * float(q.formula(case)))


@dataclass(frozen=True)
class Family:
    """Attribute of an indexed quantity: the class returns declarations, an instance values.

    `Shaft.whirl(1, "forward")` is the declaration of the number `Shaft().whirl(1, "forward")`,
    which has the name whirl_1_forward.
    """

    members: Mapping[tuple[object, ...], Declared]

    @classmethod
    def of(cls, q: Quantity, indices: Sequence[tuple[object, ...]], method: Indexed) -> "Family":
        """Family with one quantity for each combination of indices."""

        def member(index: tuple[object, ...]) -> Declared:
            one = replace(q, symbol=q.symbol.format(*index), what=q.what.format(*index))
            one.name = "_".join(map(str, (method.__name__, *index)))
            one.formula = wraps(method)(lambda case: method(case, *index))
            if when := q.when:
                one.when = lambda case: when(case, *index)
            return Declared(one)

        return cls({index: member(index) for index in indices})

    def __set_name__(self, owner: type, name: str) -> None:
        for declared in self.members.values():
            declared.__set_name__(owner, name)
            setattr(owner, declared.quantity.name, declared)

    @overload
    def __get__(self, case: None, owner: type) -> Callable[..., Quantity]: ...
    @overload
    def __get__(self, case: object, owner: type) -> Callable[..., float]: ...
    def __get__(self, case: object | None, owner: type) -> Callable[..., Quantity | float]:
        return lambda *index: self.members[index].__get__(case, owner)


@dataclass(frozen=True)
class shared(Generic[T]):  # noqa: N801 - a decorator, as cached_property is
    """Decorator of a value that several formulas use.

    It is computed once for each instance. A reference that reads it raises CaseError.
    """

    method: Callable[[Any], T]

    @overload
    def __get__(self, case: None, owner: type) -> "shared[T]": ...
    @overload
    def __get__(self, case: object, owner: type) -> T: ...
    def __get__(self, case: object | None, owner: type) -> "shared[T] | T":
        if case is None:
            return self
        name = self.method.__name__
        if solving.get():
            raise CaseError(
                f"{owner.__name__}.{name}: the reference must not read a value that formulas share"
            )
        _note(self, name)
        return remembered(case, name, lambda: self._computed(case))

    def _computed(self, case: object) -> T:
        value: Any = self.method(case)
        larger = _larger.get() is self and isinstance(value, float | np.ndarray)
        found: T = value * (1 + CHANGE) if larger else value
        return found


def forget() -> None:
    """Discard all computed values; required after the code of a formula was replaced."""
    _code[0] = next(_numbers)


@contextmanager
def changed(q: "Quantity | shared[Any] | None") -> Iterator[None]:
    """Context in which `q` is increased by CHANGE; values that depend on it change as well.

    Afterwards, all values are restored. A shared value is only changed if it is a number or an
    array.
    """
    before, token = _code[0], _larger.set(q)
    forget()
    try:
        yield
    finally:
        _code[0] = before
        _larger.reset(token)


def read_by(compute: Callable[[], object]) -> "dict[Quantity | shared[Any], str]":
    """Quantities and shared values that a computation reads, with their names."""
    found: dict[Quantity | shared[Any], str] = {}
    token = _read.set(found)
    try:
        with changed(None):
            compute()
    finally:
        _read.reset(token)
    return found


def _note(source: "Quantity | shared[Any]", name: str) -> None:
    if (found := _read.get()) is not None:
        found[source] = name


def remembered(case: object, name: str, compute: Callable[[], T]) -> T:
    """Value of an instance, computed once, because the inputs of an instance never change.

    Raises CaseError if the computation of the value reads the value itself.
    """
    memo, key = case.__dict__, f"{MEMO}{_code[0]} {name}"
    if key not in memo:
        this, begun = (id(case), name), _begun.get()
        if this in begun:
            raise _circular(type(case), [*(n for _, n in begun[begun.index(this) :]), name])
        token = _begun.set((*begun, this))
        try:
            memo[key] = compute()
        finally:
            _begun.reset(token)
    found: T = memo[key]
    return found


def _circular(owner: type, names: Sequence[str]) -> CaseError:
    """Error for values that depend on each other in a circle."""
    rule = (
        "circular dependence: "
        f"{', '.join(f'{one} reads {other}' for one, other in pairwise(names))}"
    )
    members = (getattr(owner, name) for name in names)
    if q := next((one for one in members if isinstance(one, Quantity)), None):
        return q.broken(rule)
    return CaseError(f"{owner.__name__}.{names[0]}: {rule}")
