"""Figures declared by kind with their data; reports/ draws them.

Convergence needs no declaration: every comparison that states an order is drawn from its row.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from verify.core import units
from verify.core.case import Context
from verify.core.figures import Curve, Curves
from verify.form.case import Case
from verify.form.quantity import Quantity


@dataclass(frozen=True, kw_only=True)
class Overlay:
    """Formulas over a parameter of a family of cases, the reference's array as dots at `at`.

    `family` is the case of one value, `over` the values of the curves.
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

    def drawn(self, case: Case, context: Context) -> Curves:
        """The curves, and the dots where the reference is solved."""
        unit = self.quantities[0].unit
        cases, f, x = [self.family(s) for s in self.over], units.factor(unit), np.array(self.over)
        curves = [
            Curve(name=q.label, x=x, y=np.array([getattr(c, q.name) for c in cases]) / f,
                  style="dashes" if k else "line", colour=k)
            for k, q in enumerate(self.quantities)
        ]  # fmt: skip
        if context.fem:
            y = context.fem[-1].arrays[self.reference] / f
            curves.append(Curve(name=case.method.alone, x=np.array(self.at), y=y, style="dots",
                                colour=len(curves)))  # fmt: skip
        label = self.y_label or f"{self.quantities[-1].symbol} [{unit}]"
        return Curves(title=self.title, x_label=self.x_label, y_label=label, curves=tuple(curves),
                      note=self.note)  # fmt: skip
