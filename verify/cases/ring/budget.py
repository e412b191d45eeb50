"""Causes of error in formulas of races: discrete loads and plane assumption."""

import math
from collections.abc import Mapping
from typing import Any

from verify.cases.ring.loads.inputs import LoadsInputs
from verify.cases.ring.walls import quarter_fem
from verify.core.case import FemResult
from verify.judging.budget_statement import Cause, Left, Rerun, Statement, plane_strain

CLOSER = 4  # times as many loads
WAVE = (
    "the mean pressure and its first harmonic along a pitch replace the pressure on the contact "
    "patches, so that there is no local indentation"
)


def fem_smeared(q: LoadsInputs, level: int) -> FemResult:
    """Deflection of the race if a uniform pressure replaces the forces of the sprags."""
    p = q.n * q.P / (2 * math.pi * q.radius)
    ring = quarter_fem(q, q.r_i, q.r_o, "plane stress", level, pressures={q.loaded: p})
    wall = ring.on_boundary(q.loaded)
    u = abs(float(wall.mean(wall.polar()[0])))
    return FemResult(h=1 / level, values=dict.fromkeys(("load", "between"), u))


def fem_wave(q: LoadsInputs, level: int) -> FemResult:
    """Deflections of the race under a pressure with the mean value and the first harmonic only."""
    import numpy as np

    from fem.plane.material import Elastic
    from fem.plane.patch import polar_nodes
    from fem.plane.solve import solve_plane
    from meshes.ring.sector import half_sector
    from verify.cases.ring.loads.reference import CELLS

    mean = q.n * q.P / (2 * math.pi * q.radius)
    ring = solve_plane(
        half_sector(r_i=q.r_i, r_o=q.r_o, n=q.n, loaded=q.loaded, patch=q.half_width,
                    refine=level, cells=CELLS),
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane stress",
        supports={"load cut": "n", "free cut": "n"},
        pressures={q.loaded: lambda x: mean * (1 + 2 * np.cos(q.n * np.arctan2(x[1], x[0])))},
    )  # fmt: skip
    u = np.abs(polar_nodes(ring, q.loaded)[1])
    values = {"load": float(u[0]), "between": float(u[-1])}
    return FemResult(h=1 / (CELLS * level), values=values)


def closer(q: Any) -> Any:
    """The inputs `q` with four times as many sprags under an equal total load."""
    return q.model_copy(update={"n": CLOSER * q.n, "F": q.F / CLOSER})


LOADS = Statement(
    reruns=(
        Rerun(
            cause=Cause.GEOMETRY, what=WAVE,
            rows=("deflection by Eq. 6, compared with the displacement under a sprag",
                  "deflection by Eq. 6, compared with the displacement between sprags"),
            fem=fem_wave,
        ),
        Rerun(
            cause=Cause.GEOMETRY,
            what="in addition, the first harmonic is omitted: uniform pressure",
            rows=("deflection by Eq. 6, compared with the displacement under a sprag",
                  "deflection by Eq. 6, compared with the displacement between sprags"),
            fem=fem_smeared, after=WAVE,
        ),
        Rerun(
            cause=Cause.GEOMETRY, what="number of sprags × 4, load of each sprag / 4",
            rows=("deflection *indentation*",), inputs=closer,
        ),
        Rerun(
            cause=Cause.PLANE, what="plane strain instead of plane stress", rows=("deflection *",),
            changes=plane_strain(), shared=True,
        ),
    ),
    left=(
        Left(("deflection *indentation*",), "the indentation is that of a half-plane, relative to "
             "a point at an assumed depth; no body corresponds to this model"),
    ),
    finer=20, headline="deflection by Eq. 6, compared with the displacement under a sprag",
)  # fmt: skip

STATEMENTS: Mapping[str, Statement] = {
    "ring-lame": Statement(finer=24),
    "ring-loads-outer": LOADS,
    "ring-loads-inner": LOADS,
    "ring-loads-map": Statement(finer=7),
    "ring-rotation": Statement(finer=16),
}
