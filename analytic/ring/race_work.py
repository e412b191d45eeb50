"""Race under Hertz patches: hoop force in its sections and strain energy."""

import numpy as np

from analytic.ring import loaded_race
from analytic.ring.loaded_race import LoadedRace

POINTS = 24  # of the rule over the patch


def cut_force(race: LoadedRace) -> float:
    """Hoop force [force per length] in a cut midway between two loads, positive in tension.

    The equilibrium of the sector between two cuts gives the magnitude P <cos theta>/(2 sin(pi/n)),
    where <cos theta> is the mean over the load of a patch.
    """
    outward = 1.0 if race.loaded == "bore" else -1.0
    along = loaded_race.share(race.alpha) * race.P
    return float(outward * along / (2 * np.sin(np.pi / race.n)))


def strain_energy(race: LoadedRace) -> float:
    """Strain energy [force] of the whole race per unit length: half the work of the pressures.

    It is computed by Gauss' rule for the semi-ellipse with `POINTS` points on each patch.
    """
    turn = np.arange(1, POINTS + 1) * np.pi / (POINTS + 1)
    weight = 2 / (POINTS + 1) * np.sin(turn) ** 2
    u = race.at(race.r, race.alpha * np.cos(turn)).u_r
    return float(race.n * race.P / 2 * abs(u @ weight))
