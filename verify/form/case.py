"""A case: inputs, formulas, an independent reference, and comparisons.

The reference shares no code with the formulas. A case is one class. Its fields are the inputs, its
quantities are the formulas of the source. An instance is the problem with numbers:
`CurvedBar().sigma_i` is a stress in Pa.
"""

from collections.abc import Generator, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import ConfigDict

from verify.core import units
from verify.core.case import Check, Context, Dynamic, FemResult, Portion, Scan
from verify.core.figures import Equation, Field, Figure, Picture, Sketch, Table
from verify.core.inputs import Inputs, meta
from verify.core.references import Method
from verify.form.comparisons import Comparison
from verify.form.quantity import MEMO, CaseError, Declared, Family, Quantity, remembered, shared

MESHES = (1, 2, 3, 4)


def solved(
    mesh_size: float, *fields: Field, iteration: float | Mapping[str, float] = 0.0,
    **values: float | NDArray[np.float64],
) -> FemResult:  # fmt: skip
    """Result of one level of the reference: numbers and arrays in SI units (name: value).

    `mesh_size` is relative to a constant length. `iteration` is the relative uncertainty of the
    numbers due to iteration or round-off: one value for all, or one for each by name.
    """
    numbers = {k: float(v) for k, v in values.items() if np.ndim(v) == 0}
    arrays = {k: np.asarray(v) for k, v in values.items() if k not in numbers}
    by_name = iteration if isinstance(iteration, Mapping) else dict.fromkeys(numbers, iteration)
    u_it = {k: by_name[k] * abs(v) for k, v in numbers.items() if k in by_name}
    return FemResult(h=mesh_size, values=numbers, u_it=u_it, arrays=arrays, fields=fields)


class Drawing(Protocol):
    """A declared figure or picture with its content; `verify.form.figures` contains the kinds."""

    def drawn(self, context: Context) -> Sequence[Figure]:
        """Figures to draw; empty if there is nothing to draw."""
        ...


class Case(Inputs):
    """Base class of every case, in the suite and outside it.

    The docstring of a case is the first paragraph of its page.
    """

    model_config = ConfigDict(ignored_types=(Declared, Family, shared))

    id: ClassVar[str] = ""  # by default the name of the file
    title: ClassVar[str] = ""  # empty if the class only holds inputs that cases share
    source: ClassVar[str] = ""  # key of a paper of the suite
    place: ClassVar[str] = ""
    method: ClassVar[Method] = Method()  # of the reference
    if TYPE_CHECKING:  # MESHES by default, and no attribute: an input may have the name, too
        levels: ClassVar[tuple[int, ...]]
    readings: ClassVar[tuple[str, ...]] = ()
    assumptions: ClassVar[tuple[str, ...]] = ()
    scans: ClassVar[tuple[Scan, ...]] = ()  # regions over which sweeps measure the formulas
    portions: ClassVar[tuple[Portion, ...]] = ()  # parts of the reference solved separately
    dynamic: ClassVar[Dynamic | None] = None  # transient part for `check --dynamic`
    time_limit: ClassVar[float] = 600.0  # s, of a level or the formulas of a case outside the suite

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        """Check the declaration when the class is made.

        Raises CaseError for a wrong unit or word, or for a symbol that is used twice.
        """
        cls.id = vars(cls).get("id", cls.__module__.rpartition(".")[2].replace("_", "-"))
        names = {meta(field)["symbol"]: name for name, field in cls.model_fields.items()}
        for q in cls.quantities():
            if (other := names.setdefault(q.symbol, q.name)) not in (q.name, q.form_of):
                raise q.broken(f"the symbol {q.symbol} is already used by {other}")
            q.check_words()
            try:
                units.factor(q.unit)
            except ValueError as error:
                raise q.broken(str(error)) from error

    def reference(self, level: int) -> FemResult:
        """Result of one level; meshes and finite elements must be imported inside this method."""
        raise NotImplementedError

    def comparisons(self) -> Iterable[Comparison | Check]:
        """Comparisons, stated before the reference is solved."""
        return ()

    def figures(self) -> Iterable[Drawing]:
        """Figures in addition to the convergence plots, which need no declaration."""
        return ()

    def pictures(self) -> Iterable[Picture]:
        """Pictures of fields of the finest level."""
        return ()

    def laws(self) -> Iterable[Equation]:
        """Equations of the source that belong to no quantity, such as equations of motion."""
        return ()

    def tables(self, context: Context) -> Iterable[Table]:  # noqa: ARG002
        """Tables of the case's page."""
        return ()

    def sketch(self) -> Sketch | None:
        """Sketch of the part with its dimensions and loads."""
        return None

    def warnings(self) -> Iterable[str]:
        """Warnings if the inputs are outside the range of validity of the formulas."""
        return ()

    def advice(self) -> Iterable[str]:
        """Recommendations for the user, the most important one first."""
        return ()

    def summary(self) -> Mapping[str, Any]:
        """Recommendations for programs, which `check` adds to its JSON output."""
        return {}

    def refusal(self) -> str:
        """Reason why the reference cannot solve these inputs; its rows are then skipped."""
        return ""

    def stated(self) -> tuple[Comparison, ...]:
        """Comparisons at these inputs; `comparisons` is called only once."""

        def made() -> tuple[Comparison, ...]:
            found: object = self.comparisons()
            if not isinstance(found, Iterable):
                code = type(self).comparisons.__code__
                place = f"{Path(code.co_filename).name}:{code.co_firstlineno}"
                rule = f"must yield comparisons, got {type(found).__name__}"
                raise CaseError(f"{place}: {type(self).__name__}.comparisons: {rule}")
            return tuple(c if isinstance(c, Comparison) else Comparison(check=c) for c in found)

        return remembered(self, "comparisons", made)

    @property
    def is_default(self) -> bool:
        """Whether the inputs are the default inputs, to which printed numbers refer."""
        return self == type(self)()

    def at(self, **changes: float) -> Self:
        """The case with changed inputs [SI units], validated."""
        inputs = {name: getattr(self, name) for name in type(self).model_fields}
        states = {n: v for n, v in vars(self).items() if n in type(self).__class_vars__}
        return type(self)(**(inputs | changes)).variant(**states)

    def variant(self, **attributes: Any) -> Self:
        """The case with changed class attributes that formulas read, such as the end conditions.

        Raises ValueError if the class has no such attribute.
        """
        if unknown := attributes.keys() - type(self).__class_vars__:
            name = ", ".join(sorted(unknown))
            raise ValueError(f"{type(self).__name__} has no class attribute {name}")
        return self.model_copy(update=attributes)

    def shown(self, name: str, digits: int = 4) -> str:
        """Text of an input or a quantity in its unit, for sentences: "76 mm"."""
        units_of = {n: meta(field)["unit"] for n, field in type(self).model_fields.items()}
        unit = units_of.get(name) or next(q.unit for q in self.quantities() if q.name == name)
        return f"{getattr(self, name) / units.factor(unit):.{digits}g} {unit}".removesuffix(" 1")

    @classmethod
    def quantities(cls) -> tuple[Quantity, ...]:
        """Quantities in the order of the class; quantities of base classes come first."""
        found = {k: v for base in reversed(cls.__mro__) for k, v in vars(base).items()}
        declared = (
            d for one in found.values()
            for d in (one.members.values() if isinstance(one, Family) else (one,))
            if isinstance(d, Declared)
        )  # fmt: skip
        return tuple({d.quantity.name: d.quantity for d in declared}.values())

    def present(self) -> tuple[Quantity, ...]:
        """Quantities that exist for these inputs."""
        return tuple(q for q in self.quantities() if q.of(self) is not None)

    def __eq__(self, other: object) -> bool:
        """Whether inputs and class attributes are equal; computed values follow from these."""
        return isinstance(other, Case) and type(self) is type(other) and self._own == other._own

    @property
    def _own(self) -> dict[str, Any]:
        return {k: v for k, v in self.__dict__.items() if not k.startswith(MEMO)}

    def __iter__(self) -> Generator[tuple[str, Any], None, None]:
        """Pairs of name and value of the inputs only, for `dict(case)`."""
        yield from ((name, getattr(self, name)) for name in type(self).model_fields)

    def __copy__(self) -> Self:
        """Copy without computed values; `model_copy` would transfer these to other inputs."""
        copied = super().__copy__()
        for key in [key for key in copied.__dict__ if key.startswith(MEMO)]:
            del copied.__dict__[key]
        return copied

    def __getstate__(self) -> dict[Any, Any]:
        state = super().__getstate__()
        fields = {k: v for k, v in state["__dict__"].items() if not k.startswith(MEMO)}
        return state | {"__dict__": fields}
