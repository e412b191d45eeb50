"""Kriging of the largest pressures, separate for regimes along the sprag and for each torque.

There are three regimes, from the end inwards. The first is the end strip, whose pressure decreases
steeply to zero as the crown becomes deeper. The second consists of the strips next to it, at the
end of the contact. The third consists of all other strips. Kriging uses ln K_1 and ln z_m, because
equal changes of K_1 and z_m have a smaller effect if K_1 and z_m are large.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from analytic.surrogate.box import Box
from verify.core.figures import Array
from verify.studies.design_sprag.inputs import Contacts
from verify.studies.design_sprag.known import Known

if TYPE_CHECKING:
    from analytic.surrogate.largest import Largest

EDGES = {"strips": (0, 1, 4), "slices": (0, 1)}  # positions at which regimes begin, from the end
POWER = 2.0  # of the pressure: a force per length


def logs(crowns: Array) -> Array:
    """Coordinates of kriging (ln K_1, K_2, ln z_m) of crowns (n, 3)."""
    return np.column_stack([np.log(crowns[:, 0]), crowns[:, 1], np.log(crowns[:, 2])])


def crowns_of(x: Array) -> Array:
    """Crowns (n, 3) from the coordinates of kriging (ln K_1, K_2, ln z_m)."""
    return np.column_stack([np.exp(x[:, 0]), x[:, 1], np.exp(x[:, 2])])


@dataclass(frozen=True, eq=False)
class Surrogates:
    """Kriging models of the largest pressure, one for each torque."""

    of: tuple["Largest", ...]

    def predict(self, crowns: Array) -> Array:
        """Largest pressures (n, m) [Pa] of crowns (n, 3) by kriging."""
        x = logs(crowns)
        return np.column_stack([one.predict(x) for one in self.of])


def fitted_fem(
    known: Known, contacts: Contacts, box: Box, like: Surrogates | None = None
) -> Surrogates:
    """Kriging models fitted to all evaluated crowns, with the length scales of `like` if given."""
    from analytic.surrogate.kriging import Kriging
    from analytic.surrogate.largest import Largest, fit_largest

    x, found = logs(known.crowns), []
    for k in range(known.N_max.shape[1]):
        values, present = regimes(known.counted(contacts, k), contacts, box.to_unit(x))
        if like is None or len(like.of[k].models) != len(values):
            found.append(fit_largest(x, values, box, power=POWER, present=present))
            continue
        models = tuple(
            Kriging(box=box, designs=x[there], values=p[there] ** POWER,
                    length_scales=model.length_scales)
            for p, there, model in zip(values, present, like.of[k].models, strict=True)
        )  # fmt: skip
        found.append(Largest(models, POWER))
    return Surrogates(tuple(found))


def regimes(
    along: Array, contacts: Contacts, u: Array
) -> tuple[list[Array], list[NDArray[np.bool_]]]:
    """For each regime: largest pressures (n,), and a mask of the crowns with load in this regime.

    `along` (n, strips) are pressures along the sprag. A regime is fitted to the crowns with which
    it carries load. If these crowns are too few or too similar for kriging, it is fitted to all
    crowns. A regime that carries no load with any crown is omitted.
    """
    from analytic.surrogate.terms import trend_terms

    edges = (*EDGES[contacts], along.shape[1] // 2 + 1)
    values, present = [], []
    for first, end in pairwise(edges):
        p = along[:, first:end].max(axis=1)
        there = p > 0
        if not there.any():
            continue
        terms = trend_terms(u[there])
        if len(terms) < terms.shape[1] + 2 or np.linalg.matrix_rank(terms) < terms.shape[1]:
            there = np.ones(len(p), dtype=bool)
        values.append(p)
        present.append(there)
    return values, present
