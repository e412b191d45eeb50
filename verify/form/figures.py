"""Figures of a case, declared by kind with their data; reports/ draws them.

Convergence plots need no declaration: they are drawn from every row with an order.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from verify.core import units
from verify.core.case import Context
from verify.core.figures import Array, Curve, Curves, Figure, Profile
from verify.form.case import Case
from verify.form.quantity import Quantity
from verify.judging.profiles import along


@dataclass(frozen=True, kw_only=True)
class Overlay:
    """Figure of formulas over a parameter, with an array of the reference as dots.

    `family` returns the case for a value of the parameter. `over` are the parameter values of the
    curves, `at` those of the dots.
    """

    title: str
    x_label: str
    family: Callable[[float], Case]
    over: Sequence[float]
    quantities: tuple[Quantity, ...]
    reference: str
    at: Sequence[float]
    y_label: str = ""
    note: str = ""

    def drawn(self, context: Context) -> tuple[Curves]:
        """Curves, and dots if the reference was solved."""
        unit = self.quantities[0].unit
        cases, f, x = [self.family(s) for s in self.over], units.factor(unit), np.array(self.over)
        curves = [
            Curve(name=q.label, x=x, y=np.array([getattr(c, q.name) for c in cases]) / f,
                  style="dashes" if k else "line", colour=k)
            for k, q in enumerate(self.quantities)
        ]  # fmt: skip
        if context.fem:
            y = context.fem[-1].arrays[self.reference] / f
            name = context.inputs.method.alone
            curves.append(Curve(name=name, x=np.array(self.at), y=y, style="dots",
                                colour=len(curves)))  # fmt: skip
        label = self.y_label or f"{self.quantities[-1].symbol} [{unit}]"
        return (Curves(title=self.title, x_label=self.x_label, y_label=label,
                       curves=tuple(curves), note=self.note),)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class AlongLine:
    """Figure of a formula and an array of the reference along a line, with their difference below.

    `curve` returns the formula [SI] at given points. The array `reference` contains the values at
    the stations `at`, which are the same on every level. `part` (start, end) selects the values of
    this line if the array contains several lines. `order` is the order of convergence of the
    largest error, `scale` the natural magnitude [SI]. If the formula `neglects` an effect, it may
    differ by more than the uncertainty.
    """

    title: str
    x: tuple[str, str]  # symbol and unit
    y: tuple[str, str]
    curve: Callable[[Array], Array]
    reference: str
    at: Array
    order: float
    scale: float
    scale_name: str = ""
    points: Array | None = None  # of the curve
    part: tuple[int | None, int | None] = (None, None)
    neglects: bool = False
    note: str = ""

    def drawn(self, context: Context) -> tuple[Profile, ...]:
        """Profile along the line; empty if there are too few levels for an uncertainty."""
        if not context.converging:
            return ()
        values, u = (
            array[slice(*self.part)]
            for array in along(context, self.reference, formal=self.order, scale=self.scale)
        )
        fine = np.linspace(self.at[0], self.at[-1], 81) if self.points is None else self.points
        (x, x_unit), (y, y_unit) = self.x, self.y
        f_x, f_y = units.factor(x_unit), units.factor(y_unit)
        return (Profile(
            title=self.title, x_label=_label(x, x_unit), y_label=_label(y, y_unit), x=fine / f_x,
            y=self.curve(fine) / f_y, x_fem=self.at / f_x, y_fem=values / f_y,
            y_ref=self.curve(self.at) / f_y, u=u / f_y, scale=self.scale / f_y,
            scale_name=self.scale_name, note=self.note, neglects=self.neglects,
        ),)  # fmt: skip


@dataclass(frozen=True)
class Drawn:
    """Figures of any other kind; the function `draw` makes them from all results."""

    draw: Callable[[Context], Iterable[Figure]]

    def drawn(self, context: Context) -> tuple[Figure, ...]:
        """Figures that the function `draw` makes."""
        return tuple(self.draw(context))


def converged(draw: Callable[[Context], Figure]) -> Drawn:
    """Figure that is only drawn if there are enough levels to state an uncertainty."""
    return Drawn(lambda context: (draw(context),) if context.converging else ())


def drawn_by(
    *draw: Callable[[Context], Iterable[Figure]],
) -> Callable[[Case], tuple[Drawn, ...]]:
    """Method `figures` of a case; the functions `draw` make all of its figures."""
    return lambda _case: tuple(map(Drawn, draw))


def _label(symbol: str, unit: str) -> str:
    return symbol if unit == "1" else f"{symbol} [{unit}]"
