"""Half-space checks of a crown under the forces of its engagements."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact import slices
from analytic.contact.half_space_roller import RollerContact, press_roller
from verify.core.figures import Array
from verify.studies.design_sprag.corners import corners
from verify.studies.design_sprag.inputs import Contacts, Task
from verify.studies.design_sprag.known import Known
from verify.studies.design_sprag.model import Model

CELLS = ((48, 256), (64, 512))  # across and along; the second mesh gives the result
LIMIT = 0.02  # allowed error of the pressures by which a crown is chosen
DEEPEST = 10.0  # times z_m: largest drop in the search for unloaded ends
STEPS = 33  # of that, 7.5 % each
NARROW = CELLS[1][1] + 1  # strips about as narrow as the half-space's cells


@dataclass(frozen=True, eq=False)
class Check:
    """Check of a crown (3,) under one torque: largest pressures [Pa] by all models at force N [N].

    `which` is "nominal" for the nominal crown or "worst" for the worst crown within the tolerance.
    `twice` is the pressure by twice the number of slices, `coarse` that of the half-space with
    fewer cells.
    """

    which: str
    T: float
    crown: Array
    N: float
    contacts: Contacts
    slices: Array
    twice: float
    strips: Array
    half: RollerContact
    coarse: float

    @property
    def peak(self) -> float:
        """Largest pressure [Pa] by the half-space."""
        return self.half.peak_pressure

    @property
    def end(self) -> float:
        """Pressure [Pa] in the outermost cells of the half-space: larger value of both ends."""
        return float(max(self.half.centre_pressure[[0, -1]]))

    @property
    def judged(self) -> float:
        """Largest pressure [Pa] by the contact model with which the crown was chosen."""
        return float((self.strips if self.contacts == "strips" else self.slices).max())

    def off(self, pressure: float) -> float:
        """Relative difference of a `pressure` [Pa] from the largest pressure of the half-space."""
        return pressure / self.peak - 1

    @property
    def mid_off(self) -> float:
        """Relative difference of the contact model from the half-space, pressure at mid-length."""
        p = self.strips if self.contacts == "strips" else self.slices
        n = len(p)
        mid = np.sqrt((p[(n - 1) // 2] ** 2 + p[n // 2] ** 2) / 2)
        return float(mid / self.half.mid_pressure - 1)

    @property
    def agrees(self) -> bool:
        """Whether the ends are unloaded and `judged` differs from `peak` by at most LIMIT.

        If the ends are loaded, the pressure increases with finer cells. An agreement of the largest
        pressures is then accidental and no evidence.
        """
        return self.end == 0 and abs(self.off(self.judged)) <= LIMIT


def checks(task: Task, model: Model, crown: Array) -> Sequence[Check]:
    """For each torque: check of the nominal crown (3,), and of the worst crown in its tolerance."""
    every = corners(task, crown[None])[0]
    known = model.answers(every)
    counted = known.largest(task.wishes.contacts)
    found = []
    for k in range(len(task.torques)):
        found.append(_check(task, model, known, 0, k, "nominal"))
        if worst := int(counted[:, k].argmax()):
            found.append(_check(task, model, known, worst, k, "worst"))
    return found


def _check(task: Task, model: Model, known: Known, i: int, k: int, which: str) -> Check:
    q, N, crown = model.q, float(known.N_max[i, k]), known.crowns[i]
    E_star, R = float(model.one.parts.E_star), float(model.R[k])
    twice = slices.press_slices(
        model.gap(crown, 2 * q.slices), length=q.l, R=R, E_star=E_star, load=N
    )
    coarse, fine = (
        press_roller(model.gap(crown, cells[1]), R=R, length=q.l, E_star=E_star, load=N,
                     cells=cells)
        for cells in CELLS
    )  # fmt: skip
    return Check(
        which, task.torques[k], crown, N, task.wishes.contacts, known.slices[i, k],
        float(twice.peak_pressure.max()), known.strips[k][i], fine, coarse.peak_pressure,
    )  # fmt: skip


def unloading(model: Model, check: Check) -> float | None:
    """Smallest drop z_m [m] that unloads the ends at the same K_1 and K_2, or None."""
    k = model.torques.index(check.T)
    crowns = np.repeat(check.crown[None], STEPS, axis=0)
    crowns[:, 2] *= np.geomspace(1, DEEPEST, STEPS)
    free = np.flatnonzero(~ends_carry(model, crowns, np.full(STEPS, check.N), k))
    return float(crowns[free[0], 2]) if free.size else None


def ends_carry(model: Model, crowns: Array, loads: Array, torque: int) -> NDArray[np.bool_]:
    """Whether the ends of crowns (n, 3) are loaded under the loads (n,) [N], (n,).

    The strips are about as narrow as the cells of the half-space, so that the result is comparable
    with a `Check`. `torque` is the number of the torque that causes the loads.
    """
    return np.asarray(model.by_strips(crowns, loads, torque, NARROW)[:, 0] > 0)
