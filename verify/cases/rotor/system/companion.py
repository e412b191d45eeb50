"""A second test rotor (companion), in which bearings and shafts differ in every property.

Stiffness and damping of the bearings differ in x and y, with coupling terms. The bearings resist
tilting, the shafts rotate in opposite senses, and each shaft has two unbalances at an angle. A
wrong sign or conjugate that has no effect on the default rotor changes the results of the second
test rotor.
"""

from typing import TypeVar

import numpy as np

from verify.cases.rotor.description import LinkInputs, ShaftInputs, SupportInputs, UnbalanceInputs
from verify.cases.rotor.system.inputs import RPM, CoaxialRotor

T = TypeVar("T", bound=CoaxialRotor)


def companion(form: type[T]) -> T:
    """The second test rotor as an instance of the case class `form` (of formulas or reference)."""
    turned = np.deg2rad
    return form(
        speed=5200 * RPM,
        shafts=(
            ShaftInputs(name="outer", start=form().shafts[0].start),
            ShaftInputs(name="inner", ratio=-1.3),
        ),
        supports=(
            SupportInputs(node=1, k=6e7, kyy=2.5e7, kxy=1e7, c=3000.0, cyy=600.0, k_tilt=3e4,
                          c_tilt=40.0),
            SupportInputs(node=6, k=3e7, kyy=4.5e7, kxy=-6e6, c=1500.0, cyy=4000.0),
            SupportInputs(node=14, k=4e7, c=2500.0, k_tilt=2e4, c_tilt=30.0),
        ),
        links=(
            LinkInputs(node=5, to=11, k=5e7, kyy=2e7, kxy=8e6, c=9000.0, cyy=4000.0, k_tilt=2e4,
                       c_tilt=50.0),
        ),
        unbalances=(
            UnbalanceInputs(node=2, value=20e-6, angle=turned(40.0)),
            UnbalanceInputs(node=4, value=14e-6, angle=turned(130.0)),
            UnbalanceInputs(node=7, value=30e-6, angle=turned(-70.0)),
            UnbalanceInputs(node=13, value=40e-6, angle=turned(20.0)),
        ),
    )  # fmt: skip
