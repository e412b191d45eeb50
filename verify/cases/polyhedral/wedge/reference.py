"""Finite-element results of the wedged roller: free, at the limit, caged, released."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from verify.case import Level
from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.cases.polyhedral.wedge.limit import around_fem, least_fem, over_angles_fem
from verify.cases.polyhedral.wedge.mesh import fem_mesh
from verify.cases.polyhedral.wedge.stick import fem_stuck
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution, Touch
    from fem.contact.wedged import Wedge

Array = NDArray[np.float64]

LEVELS = (12, 16, 24)  # cells on the half-width; half of them if only forces matter
SOLVED = 1e-9  # relative to N: force balance of a body held by contact only
FAR = 20.0  # sliding distance of a race over mu times the approach, until full slip
GROWN = 150  # steps in which N and T grow together
ACROSS = np.linspace(-0.95, 0.95, 39)  # positions of the tractions over the half-width


def solve(q: WedgeInputs, level: int) -> Level:
    """Results for `level`: free, caged and released roller, limit of friction, loading in steps."""
    from fem.contact.wedged import Geometry, Wedge
    from fem.contact.wedged_states import slipping, uneven

    geometry = Geometry(q.R, q.half, q.a)
    mesh = fem_mesh(geometry, level // 2)
    free, cage = (
        Wedge(geometry, mesh, E=q.E, nu=q.nu, mu=q.mu, caged=caged) for caged in (False, True)
    )
    state, down = free.pressed(q.line_load)
    found, caught = freely(q, free, state), held_back(q, cage)
    values = found | caught
    # the residual along the bisector is an error of T
    u_it = {key: SOLVED * abs(found[key]) / math.tan(q.half) for key in ("T", "M_free", "N_per_M")}
    u_it |= {key: SOLVED * abs(caught[key]) for key in ("M_caged", "N_per_M_caged")}
    u_it["C"] = SOLVED * q.N
    values["mu_c"], u_it["mu_c"] = least_fem(q, down, found["T"] / q.N)
    stuck, jitter, growth = fem_stuck(q, level)
    grown = free.at(down, steps=GROWN)
    touch = grown.touches[0]
    along = touch.x.T @ geometry.tangent / q.a
    arrays = {"growth": growth, "grown": across(q, touch, along)}
    if level == LEVELS[-1]:
        arrays |= {
            "over angles": over_angles_fem(q, down), "around": around_fem(q, down),
            "slipping": np.array([slipping(touch), uneven(touch, math.tan(q.half))]),
        }  # fmt: skip
    return Level(
        h=1 / level, values=values | stuck, u_it=u_it | jitter, arrays=arrays,
        fields=(roller(q, grown),),
    )  # fmt: skip


def freely(q: WedgeInputs, free: "Wedge", state: "ContactSolution") -> dict[str, float]:
    """Forces of a free roller under N, and residuals along and across the bisector."""
    N, T = free.forces(state)
    lever = q.z * q.D_i / 2
    cut = sum(state.plane.reaction(f"roller.{part}")[1] for part in ("inner", "outer"))
    along, across_ = state.touches[0].force
    return {
        "T": q.b * T, "M_free": q.b * T * lever, "N_per_M": N / (T * lever),
        "along": q.b * along, "across": q.b * (cut - across_),
    }  # fmt: skip


def held_back(q: WedgeInputs, cage: "Wedge") -> dict[str, float]:
    """Forces of a roller under N that a cage holds back while the race slides into the wedge."""
    state, _ = cage.pressed(q.line_load, along=FAR * q.mu * q.a**2 / q.R)
    N, T = cage.forces(state)
    touch, lever = state.touches[0], q.z * q.D_i / 2
    C = -2 * q.b * state.plane.reaction("roller.inner")[0]
    unslipped = np.abs(q.mu * touch.p - np.abs(touch.q)) @ touch.weight
    pulled = 2 * q.b * (T * math.cos(q.half) - N * math.sin(q.half))
    return {
        "M_caged": q.b * T * lever, "N_per_M_caged": N / (T * lever), "C": C,
        "unslipped": q.b * float(unslipped), "cage": C - pulled,
    }  # fmt: skip


def across(q: WedgeInputs, touch: "Touch", s: Array) -> Array:
    """Tractions at x = `ACROSS` a, divided by tan(alpha/2) p_0, (m,); `s` is x/a of the nodes."""
    order = np.argsort(s)
    return np.interp(ACROSS, s[order], touch.traction[order]) / (math.tan(q.half) * q.p_0)


def roller(q: WedgeInputs, state: "ContactSolution") -> Field:
    """Field of half a roller under N: largest shear stress over Hertz's peak pressure."""
    from fem.plane.cell_fields import at_nodes, largest_shear

    cells = state.plane.cells()
    own = state.bodies.basis.mesh.subdomains["roller"]
    used, index = np.unique(cells["cells"][own].astype(np.int64), return_inverse=True)
    points, index = cells["points"][used], index.reshape(own.size, -1)
    stress = cells["stress"][own]
    shear = largest_shear(at_nodes(points, index, stress)) / q.p_0
    return Field(
        name="roller", points=points, cells=index,
        point_data={"displacement": cells["displacement"][used], "shear": shear,
                    "log_shear": np.log10(np.maximum(shear, 1e-9))},
        cell_data={"stress": stress},
        units={"displacement": "m", "shear": "1", "log_shear": "1", "stress": "Pa"},
    )  # fmt: skip
