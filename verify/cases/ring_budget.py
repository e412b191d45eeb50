"""Error budgets of races: what the smeared load and the plane assumption do."""

from typing import Any

from verify.budget.statement import Cause, Rerun, Statement, plane_strain
from verify.case import FemResult
from verify.cases.ring_loads_inputs import LoadsInputs


def fem_smeared(q: LoadsInputs, level: int) -> FemResult:
    """The same race with its loads spread evenly over the wall that bears them."""
    from fem.plane.material import Elastic
    from fem.plane.solve import solve_plane
    from meshes.ring.quarter import quarter_ring

    p = q.n * q.P / (2 * 3.141592653589793 * q.radius)
    ring = solve_plane(
        quarter_ring(r_i=q.r_i, r_o=q.r_o, refine=level),
        materials=Elastic(E=q.E, nu=q.nu),
        assumption="plane stress",
        supports={"x=0": "x", "y=0": "y"},
        pressures={q.loaded: p},
    )
    wall = ring.on_boundary(q.loaded)
    u = abs(float(wall.mean(wall.polar()[0])))
    return FemResult(h=1 / level, values=dict.fromkeys(("load", "between"), u))



LOADS = Statement(
    reruns=(
        Rerun(
            cause=Cause.GEOMETRY, what="loads spread evenly over the wall, not on patches",
            rows=("Eq. 6 at a load", "Eq. 6 between loads"), fem=fem_smeared,
        ),
        Rerun(
            cause=Cause.PLANE, what="plane strain instead of plane stress", shared=True,
            changes=plane_strain(),
        ),
    ),
    finer=24,
)  # fmt: skip

STATEMENTS = {"ring-loads-outer": LOADS, "ring-loads-inner": LOADS}
