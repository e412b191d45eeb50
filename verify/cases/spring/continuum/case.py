"""Accordion spring, linear part, as a plane body: what the thin frame neglects."""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.spring import frame
from verify.cases.spring import figures as spring_shown
from verify.cases.spring.accordion.case import OUTPUTS, ROUND_OFF, warnings
from verify.cases.spring.accordion.case import analytic as accordion_values
from verify.cases.spring.continuum.expected import added
from verify.cases.spring.inputs import AccordionInputs, strip_of
from verify.core.case import Case, FemResult, Scan, Values
from verify.core.figures import Field
from verify.judging.checks import Approximation

DEMAND = 1e-3
LEVELS = (1, 2, 4, 8)
MOST_UNKNOWNS = 1_000_000  # some six gigabytes


def analytic(q: AccordionInputs) -> Values:
    values = dict(accordion_values(q))
    for name, wide in (("plane stress", False), ("plane strain", True)):
        for theory in ("bending", "shear", "thick"):
            values[f"{theory}, {name}"] = frame.stiffness(
                **q.path, **strip_of(q), theory=theory, plane_strain=wide
            )
    return values


def fem(q: AccordionInputs, level: int) -> FemResult:
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.spring.strip import strip

    along = cells_along(q, level)
    mesh = strip(**q.path, b=q.b, through=level, per_arc=along["arc"], per_leaf=along["leaf"])
    tail = mesh.p[:, np.unique(mesh.facets[:, mesh.boundaries["tail"]])].mean(axis=1)

    def parabola(centre: float, force: float) -> Any:
        """Shear stress of a rectangle across the face, whose resultant is `force`."""

        def traction(x: Any) -> Any:
            shape = 1.5 * (1 - (2 * (x[0] - centre) / q.b) ** 2)
            return np.array([force / (q.b * q.h) * shape, np.zeros_like(shape)])

        return traction

    values, u_it, fields = {}, {}, []
    for assumption in ("plane stress", "plane strain"):
        body = solve_plane(
            mesh,
            materials=Elastic(E=q.E, nu=q.nu),
            assumption=assumption,
            supports={"tail": "y"},
            anchors={(float(tail[0]), float(tail[1])): "x"},  # the tail's shear balances the force
            tractions={"head": parabola(0.0, 1.0), "tail": parabola(float(tail[0]), -1.0)},
            thickness=q.h,
        )
        k = -1 / (2 * body.potential_energy)
        values[f"k, {assumption}"] = k
        u_it[f"k, {assumption}"] = abs(k) * max(body.residual, ROUND_OFF)  # shares of energy
        cells = body.cells()
        fields.append(
            Field(
                name=assumption, points=cells["points"], cells=cells["cells"].astype(np.int64),
                point_data={"displacement": cells["displacement"]},
                cell_data={"stress": cells["stress"], "von_mises": cells["von_mises"]},
                units={"displacement": "m", "stress": "Pa", "von_mises": "Pa"},
            )
        )  # fmt: skip
    return FemResult(h=1 / level, values=values, u_it=u_it, fields=tuple(fields))


def too_large(q: AccordionInputs) -> str:
    """A slender strip with many segments needs more cells than memory holds."""
    along = sum(cells_along(q, LEVELS[-1])[kind] * count for kind, count in
                (("leaf", q.n), ("arc", 2 * q.n)))  # fmt: skip
    unknowns = 2 * (2 * LEVELS[-1] + 1) * (2 * along + 1)
    if unknowns <= MOST_UNKNOWNS:
        return ""
    return (
        f"n = {q.n} segments of a strip this thin need {unknowns:,} unknowns, more than "
        f"{MOST_UNKNOWNS:,}: check it without --fem, or as spring-accordion"
    )


def cells_along(q: AccordionInputs, level: int) -> dict[str, int]:
    """Cells along a leaf and an arc.

    Quadratic cells of length l bend a piece of length L with an error of (l/L)^2 (l/b)^2.
    """
    leaf = q.L1 / math.sin(q.alpha) + 2 * q.R / math.tan(q.alpha)
    lengths = {"leaf": leaf, "arc": q.R * q.alpha}
    return {k: level * max(4, round(2.2 * math.sqrt(v / q.b))) for k, v in lengths.items()}


def beyond(theory: str, assumption: str) -> Any:
    """Interval of `theory`/continuum - 1: what the thick curved frame adds, and one order more.

    The corrections are of order (b/R)^2, in closed form and not from the frames' own values; what
    comes next is smaller by b/R at least, with the corrections added up in magnitude, since they
    partly cancel. Where even that is more than half the demand, the bar is too thick for an
    estimate and its error is measured.
    """

    def interval(q: AccordionInputs, _v: Values) -> tuple[float, float] | None:
        more = added(q, wide=assumption == "plane strain")
        m = more.shear + more.curvature if theory == "bending" else 0.0
        unknown = q.b / q.R * (abs(more.shear) + abs(more.curvature))
        unknown = max(unknown, DEMAND / 100)  # nothing sharper is claimed
        return (m - unknown, m + unknown) if unknown <= DEMAND / 2 else None

    return interval


CONTINUUM = Case(
    id="spring-continuum",
    title="Accordion spring, free stage, as a plane body",
    paper="wang2023",
    place="Sec. 1.2, Eqs. 1-9",
    lead="What the thin frame neglects, measured with plane elasticity on the true centre line: "
    "shear, axial force, and the bending of a bar whose thickness is not small against its "
    "radius. The strip is taken as narrow (plane stress) and as wide (plane strain).",
    inputs=AccordionInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    scans=(
        Scan(
            vary=("b=0.05mm,0.1mm,0.2mm,0.4mm", "r=0.3mm,0.45mm,0.9mm", "nu=0.2,0.3,0.4"),
            star=True,
        ),
    ),
    checks=tuple(
        Approximation(
            name=f"stiffness, {words}, {assumption}", symbol="k", unit="N/mm",
            analytic=f"{theory}, {assumption}", fem=f"k, {assumption}", formal=4,
            interval=beyond(theory, assumption),
            source="derived: shear and curvature to (b/R)², ± b/R times these, 1e-5 at least",
            demand=DEMAND,
            demand_reason="continuum and frame are to agree within 0.1 %",
        )
        for assumption in ("plane stress", "plane strain")
        for theory, words in (("bending", "thin frame"), ("thick", "thick curved frame"))
    ),
    outputs=tuple(
        replace(out, what="true centre line, E I/(1 − ν²)", judged=True) if out.key == "k wide"
        else replace(out, judged=out.judged and out.key == "k clean")
        for out in OUTPUTS
    ),
    too_large=too_large,
    readings=(
        "the arcs' centre line has the radius r + b/2: r is measured inside",
        "a strip 56 mm wide and loops of 1 mm: E I/(1 − ν²) bounds it from above, E I from below",
    ),
    assumptions=(
        "head free, tail clamped at the end of its arc",
        "force and reaction as the parabolic shear stress of a rectangle",
    ),
    warnings=warnings,
    sketch=spring_shown.sketch,
    figures=spring_shown.continuum_figures,
    pictures=spring_shown.body_pictures,
)  # fmt: skip
