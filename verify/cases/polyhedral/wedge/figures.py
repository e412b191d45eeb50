"""Figures of the wedged roller: limit of friction, torques, stick zone, traction, shear."""

import math
from collections.abc import Iterator

import numpy as np

from verify.case import AlongLine, Drawn, converged
from verify.cases.polyhedral.wedge.formulas import WedgeFormulas
from verify.cases.polyhedral.wedge.limit import ANY
from verify.cases.polyhedral.wedge.reference import ACROSS
from verify.cases.polyhedral.wedge.stick import GROWTH
from verify.core.case import Context
from verify.core.figures import Curves, Dots, Picture
from verify.form.plots import dashes, dots, line, plot


def figures(self: WedgeFormulas) -> Iterator[AlongLine | Drawn]:
    """Figures of limit, torques, stick zone and traction; none without finite elements."""
    yield converged(_limit)
    yield converged(lambda context: _torques(self, context))
    yield AlongLine(
        title="Stick zone of a roller pressed without friction, then loaded tangentially",
        x=("T/(μN)", "1"), y=("c/a", "1"), curve=lambda k: np.sqrt(1 - k),
        points=np.linspace(0.0, 1.0, 201), at=GROWTH, reference="growth", order=1, scale=1.0,
        neglects=True,
        note=f"A free roller is in equilibrium at T/(μN) = tan(α/2)/μ = {self.wedged:.3f}.",
    )  # fmt: skip
    yield AlongLine(
        title="Tangential traction on a roller while N and T grow together", x=("x/a", "1"),
        y=("q/(p_0 tan(α/2))", "1"), curve=lambda x: np.sqrt(1 - x**2),
        points=np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201)), at=ACROSS, reference="grown",
        order=1, scale=1.0, neglects=True,
        note="The whole contact sticks, so that q = tan(α/2) p everywhere. Small deviations have "
        "two causes: the curvature of the roller (a part of the order a/R that is odd in x) and "
        "the finite number of load steps.",
    )  # fmt: skip


def _limit(context: Context) -> Curves:
    share, left, ratio = context.fem[-1].arrays["over angles"]
    stays, unit = left > ANY, np.array([0.0, 1.0])
    return plot(
        "Friction force of a roller, divided by its limit μN", "tan(α/2)/μ", "T/(μN)",
        line("free roller, T = N tan(α/2)", unit, unit),
        dashes("caged roller, T = μN (Eq. 3 as printed)", 1.5 * unit, unit**0, 1),
        dots("FE, free roller", share[stays], ratio[stays]),
        dots("FE, expelled roller (N = 0)", share[~stays], ratio[~stays], 2),
        note="The wedge angle varies at a constant μ. Beyond tan(α/2)/μ = 1, a free roller is "
        "expelled.",
    )  # fmt: skip


def _torques(q: WedgeFormulas, context: Context) -> Dots:
    fe = context.fem[-1].values
    return Dots(
        title="Torque of all rollers", label="M_t [N m]",
        items=(
            ("caged rollers that slip, Eq. 3", q.M_caged, None, "formula"),
            ("caged rollers that slip, FE", fe["M_caged"], None, "fe"),
            ("free rollers, T = N tan(α/2)", q.M_free, None, "formula"),
            ("free rollers, FE", fe["M_free"], None, "fe"),
        ),
        note="All torques are for the same normal force N.",
    )  # fmt: skip


def pictures(self: WedgeFormulas) -> Iterator[Picture]:
    """Pictures of the largest shear stress in the roller and near a contact."""
    x, y, w = self.R * math.sin(self.half), self.R * math.cos(self.half), 3.0 * self.a
    yield Picture(
        field="roller", data="log_shear", symbol="τ_max/p_0", unit="1", factor=1.0, decades=True,
        displacement="", mirror=("y",), caption="Maximum shear stress in the roller, divided "
        "by p_0 (logarithmic scale). The stress is concentrated between the two contacts",
    )  # fmt: skip
    yield Picture(
        field="roller", data="shear", symbol="τ_max/p_0", unit="1", factor=1.0, displacement="",
        caption="Maximum shear stress near the upper contact, divided by p_0",
        window=(x - w, y - 1.5 * w, x + w, y + 0.5 * w),
    )  # fmt: skip
