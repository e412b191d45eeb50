"""Profile of a crown with given parameters, and pressures under a given force."""

from itertools import product

import numpy as np

from analytic.contact.sliced import SlicedContact
from analytic.sprag.closure import wedged
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.engagement.model import crowned_for, gap, in_slices, parts
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import Crown, with_crown
from verify.core.figures import Array

LOW, HIGH = (1.0, 0.4, 5e-6), (5.0, 0.7, 25e-6)  # Eq. 19
DEEP: tuple[Crown, ...] = (  # printed crowns with free ends at the first force peak, 25 N m
    (5, 0.7, 15e-6), (5, 0.5, 15e-6), (3, 0.4, 10e-6), (2.80, 0.7, 11.8e-6),
)  # fmt: skip


def label(crown: Crown) -> str:
    return f"({crown[0]:g}, {crown[1]:g}, {crown[2] * 1e6:g} µm)"


def unit(q: EngagementInputs) -> float:
    """Factor 2 Q/(π l E') [m] of K_1 in Eq. 1."""
    return crowned_for(q) / (np.pi * q.l * float(parts(q).E_star))


def box(q: EngagementInputs) -> tuple[Array, Array]:
    """Lower and upper bounds of (K_1, K_2, z_m) by Eq. 19, each of shape (3,).

    The bounds of z_m are scaled by the ratio of unit(q) to that of the clutch of the paper.
    """
    scale = np.array([1.0, 1.0, unit(q) / unit(EngagementInputs())])
    return np.array(LOW) * scale, np.array(HIGH) * scale


def factorial(q: EngagementInputs, levels: int) -> Array:
    """Full factorial of crowns with `levels` values per parameter in `box`, (levels³, 3)."""
    axes = [np.linspace(low, high, levels) for low, high in zip(*box(q), strict=True)]
    return np.array(list(product(*axes)))


def gaps(q: EngagementInputs, crowns: Array) -> Array:
    """Drops [m] of the crowns (n, 3) at the slices, shape (n, slices)."""
    return np.array([gap(with_crown(q, crown)) for crown in crowns])


def radius(q: EngagementInputs, N: float) -> float:
    """Relative radius [m] of the inner contact under N [N]."""
    one = built(q)
    return one.radii(wedged(one.clutch, N))[0]


def pressed(q: EngagementInputs, N: float, crown: Crown | None = None) -> SlicedContact:
    """Inner contact under N [N], with the crown of the clutch or with `crown` if given."""
    z = gap(with_crown(q, crown)) if crown else gap(q)
    return in_slices(q, z, radius(q, N), N)


def even(q: EngagementInputs, N: float) -> float:
    """Hertz's pressure [Pa] under N [N], uniformly distributed over the length."""
    return float(np.sqrt(N * float(parts(q).E_star) / (np.pi * q.l * radius(q, N))))
