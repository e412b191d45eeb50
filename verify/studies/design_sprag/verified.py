"""Results of a half-space for a crown under the forces of its engagements."""

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
DEEPEST = 10.0  # times z_m, up to which one that unloads the ends is searched
STEPS = 33  # of that, 7.5 % each
NARROW = CELLS[1][1] + 1  # strips about as narrow as the half-space's cells


@dataclass(frozen=True, eq=False)
class Check:
    """A crown (3,) under one torque: largest pressures [Pa] by every model, the force N [N].

    `which` is "nominal" or "worst": the nominal crown, or the worst within its tolerance. `twice`
    is for twice the number of slices, `coarse` for the half-space with fewer cells, of which `end`
    is the last.
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
        """Pressure [Pa] at the half-space's last cell."""
        return float(max(self.half.centre_pressure[[0, -1]]))

    @property
    def judged(self) -> float:
        """Largest pressure [Pa] by the contacts that the crown was chosen by."""
        return float((self.strips if self.contacts == "strips" else self.slices).max())

    def off(self, pressure: float) -> float:
        """A largest pressure [Pa] less the half-space's, as a share."""
        return pressure / self.peak - 1

    @property
    def mid_off(self) -> float:
        """That of the middle."""
        p = self.strips if self.contacts == "strips" else self.slices
        n = len(p)
        mid = np.sqrt((p[(n - 1) // 2] ** 2 + p[n // 2] ** 2) / 2)
        return float(mid / self.half.mid_pressure - 1)

    @property
    def agrees(self) -> bool:
        """Whether the contacts used for the choice are within the limit, with unloaded ends.

        If the ends are loaded, the pressure increases with ever narrower cells: accidental
        agreement of a largest pressure is no evidence.
        """
        return self.end == 0 and abs(self.off(self.judged)) <= LIMIT


def checks(task: Task, model: Model, crown: Array) -> Sequence[Check]:
    """The nominal crown (3,) and the worst within its tolerance, under every torque."""
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
    """The least drop z_m [m] with unloaded ends, for the same K_1 and K_2; or None."""
    k = model.torques.index(check.T)
    crowns = np.repeat(check.crown[None], STEPS, axis=0)
    crowns[:, 2] *= np.geomspace(1, DEEPEST, STEPS)
    free = np.flatnonzero(~ends_carry(model, crowns, np.full(STEPS, check.N), k))
    return float(crowns[free[0], 2]) if free.size else None


def ends_carry(model: Model, crowns: Array, loads: Array, torque: int) -> NDArray[np.bool_]:
    """Whether the ends of crowns (n, 3) carry under loads (n,) [N] of a torque, (n,).

    By strips about as narrow as the half-space's cells, which each `Check` has its ends from.
    """
    return np.asarray(model.by_strips(crowns, loads, torque, NARROW)[:, 0] > 0)
