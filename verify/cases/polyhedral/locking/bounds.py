"""What Hertz and the series may miss of the locked ring, stated before finite elements say so."""

from collections.abc import Callable

import numpy as np

from analytic.contact import hertz_line, pair_series
from analytic.contact.checks import Assumption
from analytic.contact.partial_slip import dundurs_beta
from verify.cases.polyhedral.locking.inputs import LockingInputs
from verify.core.case import Values

PEAK_STRESS = 2e-3  # of a largest stress: the polynomial along the fillet
BLUNT = 1e-3  # what the semi-ellipse of Hertz may miss at least
WIDTH = 64 / (45 * np.pi)  # first terms of beta kappa a: of the half-width,
PEAK = -(2 * pair_series.CATALAN - 1 / 3) / np.pi  # and of the pressure in the middle

Interval = Callable[[LockingInputs, Values], tuple[float, float] | None]

FORCES = "argued: (2 a/d)² of the curvature, (a/wall)², and 1e-3, each once"
SERIES = "a rigid flat's statics by vectors over the series under the same loads; the same slack"
CONTACT = (
    "derived: the first order in βκa, with κ of the line on which the bodies meet; argued, each "
    "once: (2 a/d)², (a/wall)², 1e-3, and what the ring strains and bends, j_D/d_e (1 + R/wall)"
)
RACE = "derived: the first order in βκa; argued: (2 a/d)² and 1e-3, each once"


def reach(q: LockingInputs, a: float, a_race: float = 0.0) -> float:
    """(2 a/d)² of the curvatures and (a/wall)², each once, and what Hertz misses at least."""
    wall = q.d_e / 2 - q.apothem
    return (2 * a / q.d) ** 2 + (2 * a_race / q.d) ** 2 + (a / wall) ** 2 + BLUNT


def within(*widths: str) -> Interval:
    """Interval of the series' error; `widths` are the keys of the half-widths that it has."""

    def interval(q: LockingInputs, v: Values) -> tuple[float, float]:
        slack = reach(q, *(v[key] for key in widths))
        return -slack, slack

    return interval


def predicted(series: str, *, hub: bool) -> Interval:
    """Interval of a rigid flat's error: its statics by vectors beside what the series makes of it.

    Pressure beyond touching pushes on the chord of two corners, the hub along the flat's normal.
    """

    def interval(q: LockingInputs, v: Values) -> tuple[float, float] | None:
        if not v[series] > 0:
            return None
        corners = q.d_i / 2 * np.exp(1j * q.half_angle * np.array([-1, 1]))
        N = max(q.p_t - v["touch"], 0.0) * float(abs(np.diff(corners))[0])
        N += q.R_b / float(np.hypot(1, q.tan_phi)) if hub else 0.0
        m, slack = N / v[series] - 1, reach(q, v["a"])
        return m - (1 + m) * slack, m + (1 + m) * slack

    return interval


def on_ring(first: float, key: str, *, elastic: bool = False) -> Interval:
    """Interval of Hertz's error on the ring: `first` times beta kappa a; `key` names a."""

    def interval(q: LockingInputs, v: Values) -> tuple[float, float]:
        R = float(hertz_line.relative_radius(R_1=q.d / 2, R_2=q.d_e / 2))
        straining = q.j_D / q.d_e * (1 + R / (q.d_e / 2 - q.apothem))
        roller = q.E if elastic else np.inf
        m = 1 / (1 + first * coupled(q, v[key], R_2=q.d_e / 2, E_1=roller, E_2=q.E)) - 1
        slack = reach(q, v[key]) + straining
        return m - slack, m + slack

    return interval


def bent(q: LockingInputs, _: Values) -> float:
    """What the hub's bending of the wall as a beam over 2 e does to a, as a share.

    It changes the ring's curvature by R e/(2 E I); a goes with the root of the relative radius.
    """
    R = float(hertz_line.relative_radius(R_1=q.d / 2, R_2=q.d_e / 2))
    wall = q.d_e / 2 - q.apothem
    return R * (q.R_b * q.e / 2) / (q.E * wall**3 / 12) / 2


def fillet_blur(q: LockingInputs, rollers: float, a: float) -> float:
    """Standard uncertainty, as a share, of a largest stress that `rollers` make a share of."""
    return (PEAK_STRESS + rollers * reach(q, a)) / 2


def on_race(first: float, key: str) -> Interval:
    """Interval of Hertz's error for the elastic roller in the rigid race."""

    def interval(q: LockingInputs, v: Values) -> tuple[float, float]:
        race = q.d_e / 2 + q.d + q.j_D / 2
        m = 1 / (1 + first * coupled(q, v[key], R_2=-race, E_1=q.E, E_2=np.inf)) - 1
        slack = (2 * v[key] / q.d) ** 2 + BLUNT
        return m - slack, m + slack

    return interval


def coupled(q: LockingInputs, a: float, *, R_2: float, E_1: float, E_2: float) -> float:
    """Beta kappa a (no unit) of the roller, body 1, on the surface of radius R_2 [m]."""
    plane: Assumption = "plane stress"
    materials = {"E_1": E_1, "nu_1": q.nu, "E_2": E_2, "nu_2": q.nu}
    kappa = pair_series.meeting_curvature(R_1=q.d / 2, R_2=R_2, **materials, assumption=plane)
    return float(dundurs_beta(**materials, assumption=plane)) * kappa * a
