"""What Hertz and the series may miss of the locked ring, stated before finite elements say so."""

import numpy as np

from analytic.contact import hertz_line, pair_series
from analytic.contact.checks import Assumption
from analytic.contact.partial_slip import dundurs_beta
from verify.case import Expected, about
from verify.cases.polyhedral.locking.inputs import LockingInputs

PEAK_STRESS = 2e-3  # of a largest stress: the polynomial along the fillet
BLUNT = 1e-3  # what the semi-ellipse of Hertz may miss at least
WIDTH = 64 / (45 * np.pi)  # first terms of beta kappa a: of the half-width,
PEAK = -(2 * pair_series.CATALAN - 1 / 3) / np.pi  # and of the pressure in the middle

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


def within(q: LockingInputs, *widths: float) -> Expected:
    """Error of the series, where contacts have these half-widths [m]."""
    return about(0.0, reach(q, *widths), FORCES)


def of_rigid_flat(
    q: LockingInputs, series: float, *, touch: float, a: float, hub: bool
) -> Expected:
    """Error of a rigid flat: its statics by vectors beside what the series makes of it.

    Pressure beyond touching pushes on the chord of two corners, the hub along the flat's normal.
    """
    if not series > 0:
        return Expected(0.0, 0.0, SERIES, sharp=False)
    corners = q.d_i / 2 * np.exp(1j * q.half_angle * np.array([-1, 1]))
    N = max(q.p_t - touch, 0.0) * float(abs(np.diff(corners))[0])
    N += q.R_b / float(np.hypot(1, q.tan_phi)) if hub else 0.0
    m, slack = N / series - 1, reach(q, a)
    return Expected(m - (1 + m) * slack, m + (1 + m) * slack, SERIES)


def on_ring(q: LockingInputs, first: float, a: float, *, elastic: bool = False) -> Expected:
    """Hertz's error on the ring: `first` times beta kappa a."""
    R = float(hertz_line.relative_radius(R_1=q.d / 2, R_2=q.d_e / 2))
    straining = q.j_D / q.d_e * (1 + R / (q.d_e / 2 - q.apothem))
    roller = q.E if elastic else np.inf
    m = 1 / (1 + first * coupled(q, a, R_2=q.d_e / 2, E_1=roller, E_2=q.E)) - 1
    return about(m, reach(q, a) + straining, CONTACT)


def on_race(q: LockingInputs, a: float) -> Expected:
    """Hertz's error of the half-width of the elastic roller in the rigid race."""
    race = q.d_e / 2 + q.d + q.j_D / 2
    m = 1 / (1 + WIDTH * coupled(q, a, R_2=-race, E_1=q.E, E_2=np.inf)) - 1
    return about(m, (2 * a / q.d) ** 2 + BLUNT, RACE)


def bent(q: LockingInputs) -> float:
    """What the hub's bending of the wall as a beam over 2 e does to a, as a share.

    It changes the ring's curvature by R e/(2 E I); a goes with the root of the relative radius.
    """
    R = float(hertz_line.relative_radius(R_1=q.d / 2, R_2=q.d_e / 2))
    wall = q.d_e / 2 - q.apothem
    return R * (q.R_b * q.e / 2) / (q.E * wall**3 / 12) / 2


def fillet_blur(q: LockingInputs, rollers: float, a: float) -> float:
    """Standard uncertainty, as a share, of a largest stress that `rollers` make a share of."""
    return (PEAK_STRESS + rollers * reach(q, a)) / 2


def coupled(q: LockingInputs, a: float, *, R_2: float, E_1: float, E_2: float) -> float:
    """Beta kappa a (no unit) of the roller, body 1, on the surface of radius R_2 [m]."""
    plane: Assumption = "plane stress"
    materials = {"E_1": E_1, "nu_1": q.nu, "E_2": E_2, "nu_2": q.nu}
    kappa = pair_series.meeting_curvature(R_1=q.d / 2, R_2=R_2, **materials, assumption=plane)
    return float(dundurs_beta(**materials, assumption=plane)) * kappa * a
