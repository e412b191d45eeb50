"""The optimal crown of a sprag clutch: the paper's optimisation by kriging, at both torques."""

from dataclasses import replace
from typing import ClassVar

from verify.cases.sprag.optimum.formulas import LEVELS, CrownAtHand
from verify.cases.sprag.optimum.inputs import Optimum25Inputs, Optimum40Inputs
from verify.form.adapter import adapted


class SpragOptimum(Optimum25Inputs, CrownAtHand):  # type: ignore[misc]
    """The crown (K_1, K_2, z_m) with the lowest peak pressure of an engagement.

    It is found by 125 computed engagements, kriging, a genetic algorithm and differential
    evolution, and checked by computed engagements at the optimum. It is compared with the result of
    a search without a surrogate, and with contacts on a half-space. On a half-space, the crown that
    is optimal by slices has loaded ends.

    The paper calls the sprag without a crown the unmodified profile, and the crown of Eq. 21 the
    optimized profile. Here the crown of Eq. 21 is called the printed crown (for other inputs: the
    given crown). The optimal crowns are those computed here: the one by slices, and the one with
    unloaded ends on a half-space.
    """

    id = "sprag-optimum"
    title = "Optimal crown of a sprag clutch, 25 N m"
    place = "Sec. 3, Sec. 4.2.1, Eqs. 17-21, Figs. 9, 10, 15, 16, Table 2"


class SpragOptimum40(Optimum40Inputs, CrownAtHand):  # type: ignore[misc]
    """The optimal crown under the larger torque, with the same Q as under the smaller torque.

    The optimal crown is compared with that under the smaller torque.

    The paper calls the sprag without a crown the unmodified profile, and the crown of Eq. 22 the
    optimized profile. Here the crown of Eq. 22 is called the printed crown (for other inputs: the
    given crown). The optimal crowns are those computed here: the one by slices, and the one with
    unloaded ends on a half-space.
    """

    id = "sprag-optimum-40"
    title = "Optimal crown of a sprag clutch, 40 N m"
    place = "Sec. 3, Sec. 4.2.2, Eqs. 17-20, 22, Figs. 17, 18"
    torque: ClassVar = 40


OPTIMUM_25 = replace(adapted(SpragOptimum), levels=LEVELS)  # whose `levels` are an input
OPTIMUM_40 = replace(adapted(SpragOptimum40), levels=LEVELS)
