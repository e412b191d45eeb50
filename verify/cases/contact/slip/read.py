"""What is read off the contact of two rollers: tractions, and the stresses about it."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from verify.cases.contact.slip.inputs import SlipInputs
from verify.cases.contact.window import field
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.contact.solution import ContactSolution

Array = NDArray[np.float64]

ACROSS = np.linspace(-0.95, 0.95, 39)  # x/a of the profiles
AROUND = np.linspace(-1.0, 1.0, 17)  # Q/Q_max where the loop is shown, on both branches
VIEW = 3.0  # half-widths about the contact whose cells are kept


def traction(q: SlipInputs, state: "ContactSolution", name: str) -> dict[str, Array]:
    """Tangential traction at integration points, with their weights, and at `ACROSS`."""
    touch = state.touches[0]
    order = np.argsort(touch.x[0])
    loaded = touch.p > 0
    return {
        f"points, {name}": np.array([touch.along((0.0, 0.0)), touch.q, touch.weight])[:, loaded],
        f"profile, {name}": np.interp(ACROSS * q.width, touch.x[0][order], touch.traction[order]),
    }


def near(q: SlipInputs, whole: Mapping[str, Array]) -> Field:
    """The cells about the contact, with their largest shear stress."""
    from fem.plane.cell_fields import at_nodes, cut_out, largest_shear

    cells = cut_out(whole, lambda centre: np.asarray(np.abs(centre).max(axis=1) <= VIEW * q.width))
    stress = cells["stress"]
    smooth = largest_shear(at_nodes(cells["points"], cells["cells"], stress))
    return field(
        "pushed", cells, {"stress": (stress, "Pa"), "largest_shear": (largest_shear(stress), "Pa")},
        at_nodes={"shear_at_nodes": (smooth, "Pa")},
    )  # fmt: skip
