"""What the smeared race does to a clutch: more windup, less force in a shock.

Deflection and force of a sprag's contact on a race, with the half-width as sqrt(N),

    delta = N [c + g ln(N_0/N)],   energy = N²/2 [c - g/2 + g ln(N_0/N)],

c from the models at N_0 and g of the two dents, which all models share.
"""

import math
from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq

from analytic.contact.hertz_line_approach import approach_to_centre
from verify.cases.ring.loads.formulas import SpragLoads
from verify.core.case import Context
from verify.core.figures import Table

COUNTS = (6, 8, 12, 16, 24)


def compliances(q: SpragLoads, n: int) -> tuple[float, float, float]:
    """Both c, by Lamé and Hertz and by the Fourier ring, and g [m/N]; the sprag's dent in all."""
    plane = q.E / (1 - q.nu**2)
    sprag = float(approach_to_centre(P=q.P, a=q.a, R=q.R, E_plane=plane))
    smeared = q.by_smearing(n=n) + q.dent
    ring = q.race(n=n)
    fourier = q.outward * ring.displacement(ring.r, 0.0)
    g = (1 / q.E + 1 / plane) / (math.pi * q.L)
    return (smeared + sprag) / q.F, (fourier + sprag) / q.F, g


def ratios(races: Sequence[SpragLoads], n: int) -> tuple[float, float]:
    """Windup and peak force by Lamé and Hertz over those by the Fourier ring.

    Windup under one force, the first race's; peak force for the energy that Lamé and Hertz take up
    under it.
    """
    smeared, fourier, g = np.sum([compliances(q, n) for q in races], axis=0).tolist()

    def excess(share: float) -> float:
        energy = share**2 * (fourier - g / 2 - g * math.log(share))
        return float(energy - (smeared - g / 2))

    return smeared / fourier, 1 / float(brentq(excess, 1e-6, 3.0))


def table(context: Context, both_races: Sequence[SpragLoads]) -> Table:
    """Both ratios over n: of this race alone and, for the paper's numbers, of both races."""
    q = context.inputs
    pair = both_races if context.is_paper else ()
    rows: list[tuple[str | float | None, ...]] = []
    for n in sorted({*COUNTS, q.n}):
        if not fits(q, n) or not all(fits(race, n) for race in pair):
            continue
        both = ratios(pair, n) if pair else ()
        rows.append((str(n), *(f"{x - 1:+.1%}" for x in (*ratios((q,), n), *both))))
    header = ("n", "windup, this race", "peak force, this race")
    return Table(
        title="Lamé's ring and Hertz's dent (to the wall's depth) against the Fourier ring",
        header=(*header, "windup, both races", "peak force, both races") if pair else header,
        rows=tuple(rows),
        note=f"One sprag of {q.F:.4g} N with its own dents; the peak force is that of a shock with "
        "the energy which Lamé and Hertz take up under this force. Too soft a race overestimates "
        "the windup, which is safe, and underestimates the force of a shock, which is not.",
    )


def fits(q: SpragLoads, n: int) -> bool:
    """Whether n patches leave half of the wall free."""
    return 2 * n * q.half_width <= math.pi * q.radius
