"""Inputs of a roller freewheel under torque and axial load, with the friction that there is."""

from verify.cases.freewheel.inputs import StarInputs
from verify.core.inputs import quantity


class FrictionInputs(StarInputs):
    """The clutch of `StarInputs`, pulled along its axis while it is locked."""

    F_ax: float = quantity("600 N", "N", "F_ax", "axial load on the whole clutch", ge=0, le=1e9)
    mu: float = quantity(0.08, "1", "μ", "coefficient of friction, equal at all contacts",
                         ge=0.01, le=1)  # fmt: skip
