r"""Wind-up and shock force with uniformly loaded races, divided by the values with Fourier rings.

The half-widths of contacts are proportional to the square root of the force N. Therefore,
deflection and energy of the contact of a sprag on a race are

.. math::
    \delta = N \left[c + g \ln\frac{N_0}{N}\right], \qquad
    U = \frac{N^2}{2} \left[c - \frac{g}{2} + g \ln\frac{N_0}{N}\right],

where c follows from the model of the race at N_0, and g from the indentations of race and sprag,
which are the same in both models.

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
    """Compliances [length/force] c by Eq. 6 with indentation, c by the Fourier ring, and g.

    The deflection under N is N (c - g ln(N/N_0)). Each sprag has the radius R at the contact and
    the force N_0 = F on the length L. Both values of c contain the indentation of the sprag.
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
    """Wind-up and peak force with uniformly loaded races, divided by those with Fourier rings.

    The compliances of the `parts` in series are added. The wind-up is that under N_0. The peak
    force is that for the energy that is stored with uniformly loaded races under N_0.

    >>> windup, peak = ratios([(1.21, 1.0, 0.0)])  # without indentation: linear springs
    >>> round(windup, 12), round(peak, 12)
    (1.21, 0.909090909091)
    """
    smeared, fourier, g = np.sum(parts, axis=0).tolist()

    def excess(share: float) -> float:
        energy = share**2 * (fourier - g / 2 - g * math.log(share))
        return float(energy - (smeared - g / 2))

    return smeared / fourier, 1 / float(brentq(excess, 1e-6, 3.0))
