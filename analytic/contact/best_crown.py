r"""Optimal logarithmic crown: the lowest peak pressure among crowns with unloaded ends.

At an end that carries load, the pressure has no maximum (`strips`), although a model with few
strips has one. Therefore, a crown is admissible only if the last strip at each end, whose width is
about the half-width b, carries no load. (A contact that ends nearer to the end of the roller can
have a peak pressure that is lower by some per cent. But then, the slightest overload or tilt loads
the end.)
Differential evolution searches the admissible crowns for the lowest peak pressure; all contacts of
a generation are solved at once. K_1, K_2 and z_m/A_1 are rounded to three digits, with the factor
:math:`A_1 = W/(\pi l E^*)` of Lundberg's crown. The optimum is flat: a change of a
parameter by tens of per cent may change the peak pressure by only a tenth of a per cent.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import OptimizeResult, differential_evolution

from analytic.contact import strips
from analytic.contact.checks import Array, finite, positive
from analytic.contact.crown import logarithmic, slice_centres

LOW = (0.5, 0.2, 2.0)  # K_1, K_2, z_m/A_1
HIGH = (100.0, 1.0, 300.0)  # for a light load at a large tilt the optimum tends to a parabola
GENERATIONS, CROWNS = 40, 10  # CROWNS a generation for each of the three parameters
PATIENCE = 8  # generations
DIGITS = 3
# of a peak over Hertz's pressure of a uniform load: smaller differences count as equal. Strips
# cause 1e-12; crowns that differ only outside of the contact differ by less than that
PEAK_DECIMALS = 9
STRIPS = (60, 200)  # fewest and most
LOADED = 1e3  # beyond every peak over Hertz's pressure of a uniform load


@dataclass(frozen=True)
class BestCrown:
    """Parameters K_1, K_2, z_m [length] of an optimal crown, and its peak pressure [stress].

    `free` states whether the ends are unloaded. If no crown has unloaded ends, this is the crown
    with the lowest end load.
    """

    K_1: float
    K_2: float
    z_m: float
    peak: float
    free: bool


def best_crown(
    *, load: float, length: float, R: float, E_star: float, tilt: ArrayLike = 0.0
) -> BestCrown:
    """Optimal crown of a roller for `load` [force].

    If `tilt` [rad] contains several angles, the highest peak pressure of all angles is minimised,
    and the ends must be unloaded at every angle. Search range: K_1 from 0.5 to 100, K_2 from 0.2 to
    1, z_m from 2 to 300 A_1. Raises ValueError for invalid inputs and ArithmeticError if the strips
    do not converge.

    >>> straight = best_crown(load=3407.0, length=9e-3, R=2.95e-3, E_star=113e9)
    >>> straight.free, bool(1.0 < straight.peak / 2.149e9 < 1.06)  # Hertz's of a uniform load
    (True, True)
    """
    load, length = float(positive(load, "load", "N")), float(positive(length, "length", "m"))
    E_star = float(positive(E_star, "contact modulus", "Pa"))
    angles = finite(tilt, "tilt", "rad").ravel()
    if not angles.size:
        raise ValueError("tilt must contain at least one angle [rad], got none")
    b = np.sqrt(4 * load * float(positive(R, "relative radius", "m")) / (np.pi * E_star * length))
    y = slice_centres(length=length, slices=int(np.clip(round(length / b), *STRIPS)))
    lean = np.unique(np.abs(angles))[:, None] * y  # the crown is the same at both ends
    unit = load / (np.pi * length * E_star)
    even = np.sqrt(load * E_star / (np.pi * length * R))

    def cost(logs: Array) -> Array:
        K_1, K_2, z_m = _rounded(np.exp(logs))[:, :, None]
        z = logarithmic(
            y, K_1=K_1, K_2=K_2, z_m=z_m * unit, load=load, length=length, E_star=E_star
        )
        found = strips.press_strips(
            z[:, None] + lean, length=length, R=R, E_star=E_star, load=load, tolerance=1e-8
        )
        ends = (found.q[..., 0] + found.q[..., -1]).max(axis=-1) * length / load
        # crowns with loaded ends rank after all crowns with unloaded ends
        cost = np.where(ends > 0, LOADED + ends, found.peak.max(axis=-1) / even)
        return np.asarray(np.round(cost, PEAK_DECIMALS))

    cost(np.log([[1.0], [1.0], [10.0]]))  # raises the errors of strips before the search
    found = differential_evolution(
        cost, list(zip(np.log(LOW), np.log(HIGH), strict=True)), vectorized=True,
        updating="deferred", init="sobol", polish=False, maxiter=GENERATIONS, popsize=CROWNS,
        tol=1e-6, rng=np.random.default_rng(1), callback=_hopeless,
    )  # fmt: skip
    K_1, K_2, z_m = (float(v) for v in _rounded(np.exp(found.x)))
    z = logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m * unit, load=load, length=length, E_star=E_star)
    peak = strips.press_strips(z + lean, length=length, R=R, E_star=E_star, load=load).peak.max()
    return BestCrown(K_1, K_2, z_m * unit, float(peak), bool(found.fun < LOADED))


def _hopeless(intermediate_result: OptimizeResult) -> bool:
    """True if no crown has unloaded ends after PATIENCE generations: the search then stops."""
    return bool(intermediate_result.nit >= PATIENCE and intermediate_result.fun >= LOADED)


def _rounded(values: Array) -> Array:
    """`values` rounded to DIGITS significant digits, with K_2 at most 1."""
    step = 10.0 ** (np.floor(np.log10(values)) - DIGITS + 1)
    found = np.round(values / step) * step
    found[1] = np.minimum(found[1], 1.0)
    return np.asarray(found)
