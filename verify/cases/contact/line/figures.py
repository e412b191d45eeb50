"""Figures of a line contact: pressure profiles, errors of Hertz's theory, convergence."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from verify.case import AlongLine, Drawn, Level, converged
from verify.cases.contact.line.hertz import LineContact
from verify.cases.contact.line.reference import STATIONS, VIEW
from verify.core.case import Context
from verify.core.figures import Array, Dots, Picture, Profile, Refinement
from verify.judging.profile_checks import Points

SYMBOLS = {"p_0": "p_0", "a": "a", "approach": "δ"}


def pressure(q: LineContact, formula: Callable[[Any], Array], name: str, note: str) -> AlongLine:
    """Figure of contact pressure over x: `formula` as a line, finite elements as dots."""
    return AlongLine(
        title=f"Contact pressure by finite elements and by {name}", x=("x", "µm"), y=("p", "MPa"),
        curve=formula, reference="profile", at=STATIONS * q.a,
        points=np.linspace(0.0, 1.15 * q.a, 461), order=1.0, scale=q.p_0, scale_name="p_0",
        note=note,
    )  # fmt: skip


def extrapolated(h: Sequence[float], v: Sequence[float]) -> float:
    """Limit of the values `v` on meshes `h`, extrapolated with order 2 from the last two meshes."""
    return v[-1] + (v[-1] - v[-2]) / ((h[-2] / h[-1]) ** 2 - 1)


def refinement(limits: Callable[[Context], Mapping[str, float]], note: str) -> Drawn:
    """Figure: convergence of p_0, a and δ to the values `limits`, with lines of order 2."""

    @converged
    def drawn(context: Context) -> Refinement:
        to, levels = limits(context), {key: context.series(key) for key in SYMBOLS}
        return Refinement(
            title="Convergence of p_0, a and δ",
            x_label="cells on the half-width", y_label="|FE/limit − 1|",
            cells=4 / np.array(levels["a"][0]),
            errors=tuple(
                (SYMBOLS[key], np.abs(np.array(v) / to[key] - 1))
                for key, (_, v) in levels.items()
            ),
            order=2.0,
            note=f"Lines: slope of order 2, through the point of the finest mesh; {note}.",
        )  # fmt: skip

    return drawn


def neglected(
    symbol: str, theory: float, words: str, deviations: Callable[[Sequence[Level]], Points]
) -> Drawn:
    """Figure: error of Hertz's value of `symbol` over a/R, with the parabola that was derived."""

    @converged
    def drawn(context: Context) -> Profile:
        eps, d, u = map(np.array, deviations(context.fem))
        x = np.linspace(0.0, eps[-1], 101)
        return Profile(
            title=f"Error of Hertz's theory in {symbol}", x_label="a/R",
            y_label=f"{symbol}: Hertz/FE − 1", x=x, y=theory * x**2, x_fem=eps, y_fem=d,
            y_ref=theory * eps**2, u=u, scale=1.0,
            note=f"Line: {words} (a/R)², derived. Lower diagram: line minus dots. This difference "
            "consists of terms of (a/R)⁴ and of the mesh error (band).",
        )  # fmt: skip

    return drawn


def two_bodies(q: LineContact) -> Iterator[AlongLine | Drawn]:
    """Figures: computed pressure and Hertz's pressure, error of Hertz's theory, convergence."""
    note = (
        "Line: Hertz; dots: finite elements, finest mesh, up to x = 0.85 a; band: uncertainty of "
        "the whole profile."
    )
    yield pressure(q, q.pressure, "Hertz", note)

    def errors(context: Context) -> Dots:
        items = tuple(
            (symbol, (getattr(q, key) / context.series(key)[1][-1] - 1) * 1e3, None, "formula")
            for key, symbol in SYMBOLS.items()
        )
        return Dots(title="Error of Hertz's theory", label="Hertz/FE − 1 [1/1000]",
                    items=(*items, ("finite elements", 0.0, None, "fe")),
                    note="The rows judge each error against its derived value.")  # fmt: skip

    yield converged(errors)
    yield refinement(
        lambda context: {key: extrapolated(*context.series(key)) for key in SYMBOLS},
        "the limit is extrapolated from the two finest meshes; the coarser meshes test the order",
    )


def pictures(a: float, below: float = 1.0) -> Iterator[Picture]:
    """Pictures of stresses near a contact of half-width `a`.

    The depth drawn below the contact is `below` times the height drawn above it.
    """
    reach = 0.75 * VIEW * a
    more: dict[str, Any] = {"field": "contact", "mirror": ("x",), "displacement": "",
                            "window": (-reach, -reach * below, reach, reach)}  # fmt: skip
    yield Picture(data="shear", symbol="τ/p_0", unit="1", factor=1.0,
                  caption="Maximum in-plane shear stress over p_0 (mean value of each cell); by "
                  "Hertz, the largest value is 0.30, at a depth of 0.79 a", **more)  # fmt: skip
    yield Picture(data="von_mises", symbol="σ_v", unit="MPa", factor=1e6,
                  caption="Von Mises stress near the contact (mean value of each cell)",
                  **more)  # fmt: skip
