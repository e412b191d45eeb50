"""The sector of a freewheel under torque and axial load for finite elements, and its field."""

from typing import TYPE_CHECKING

import numpy as np

from fem.wedge.flat import State
from fem.wedge.pulled import Pulled
from verify.cases.freewheel.fem import pitch
from verify.core.figures import Field

if TYPE_CHECKING:
    from verify.cases.freewheel import pulled


def one_pulled(q: "pulled.Pulled") -> Pulled:
    """Pitch under the loads of `q`, with the friction of `q`."""
    return Pulled(pitch(q), L=q.L, T=q.T, F_ax=q.F_ax, mu=q.mu)


def field(state: State) -> Field:
    """Field of the sector under both loads: u_z and the shear stress along z."""
    solution = state.solution
    cells = solution.plane.cells()
    assert solution.along is not None
    corners = cells["cells"].astype(np.int64)
    u_z = solution.along.u[: len(cells["points"])]
    shear = np.hypot(*solution.along.stress().T)
    return Field(
        name="sector", points=cells["points"], cells=corners,
        point_data={"displacement": cells["displacement"], "u_z": u_z},
        cell_data={"shear_z": shear, "log_shear_z": np.log10(np.maximum(shear, 1.0) / 1e6),
                   "von_mises": cells["von_mises"]},
        units={"displacement": "m", "u_z": "m", "shear_z": "Pa", "log_shear_z": "1",
               "von_mises": "Pa"},
    )  # fmt: skip
