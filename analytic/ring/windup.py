r"""Wind-up and shock of a clutch with uniformly loaded races, over those with Fourier rings.

Deflection and energy of a sprag's contact on a race under its force N, half-widths growing with
the root of N,

.. math::
    \delta = N \left[c + g \ln\frac{N_0}{N}\right], \qquad
    U = \frac{N^2}{2} \left[c - \frac{g}{2} + g \ln\frac{N_0}{N}\right],

c from the models at N_0 and g of the two indentations, which all models share.

Range: half-widths much smaller than the sprag and the wall; races in plane stress, sprags in plane
strain, of one material.
"""

import math
from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq

from analytic.contact.hertz_line_approach import approach_to_centre, approach_to_depth
from analytic.ring.loaded_race import LoadedRace
from analytic.ring.smeared import race_deflection

Compliances = tuple[float, float, float]


def compliances(race: LoadedRace, *, R: float, F: float, L: float) -> Compliances:
    """Both c, by Eq. 6 with Hertz's indentation and by the Fourier ring, and g [length per force].

    Each sprag has the radius R at the contact, carries N_0 = F on the length L, and both c contain
    its indentation.
    """
    plane = race.E / (1 - race.nu**2)
    sprag = float(approach_to_centre(P=race.P, a=race.a, R=R, E_plane=plane))
    dent = float(approach_to_depth(
        race.r_o - race.r_i, P=race.P, a=race.a, E=race.E, nu=race.nu, assumption="plane stress"
    ))  # fmt: skip
    smeared = float(race_deflection(
        P=race.P, n=race.n, r_i=race.r_i, r_o=race.r_o, E=race.E, nu=race.nu, loaded=race.loaded
    )) + dent  # fmt: skip
    fourier = (1.0 if race.loaded == "bore" else -1.0) * race.displacement(race.r, 0.0)
    g = (1 / race.E + 1 / plane) / (math.pi * L)
    return (smeared + sprag) / F, (fourier + sprag) / F, g


def ratios(parts: Sequence[Compliances]) -> tuple[float, float]:
    """Wind-up and peak force (no unit) with uniformly loaded races over those with Fourier rings.

    The compliances of the `parts` in line add up. Wind-up under N_0; peak force for the energy that
    uniformly loaded races take up under N_0.

    >>> windup, peak = ratios([(1.21, 1.0, 0.0)])  # without indentation: linear springs
    >>> round(windup, 12), round(peak, 12)
    (1.21, 0.909090909091)
    """
    smeared, fourier, g = np.sum(parts, axis=0).tolist()

    def excess(share: float) -> float:
        energy = share**2 * (fourier - g / 2 - g * math.log(share))
        return float(energy - (smeared - g / 2))

    return smeared / fourier, 1 / float(brentq(excess, 1e-6, 3.0))
