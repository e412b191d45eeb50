r"""Races under sprag forces as uniformly loaded rings (Huang 2018, Eq. 6).

The n forces N on the length l are replaced by the uniform pressure N n/(2 pi R l) on the loaded
wall of radius R. The deflections of Lamé's ring in plane stress are

.. math::
    \delta_{BI} = \frac{N n}{2\pi l E}\left[\frac{R_i^2 + R_{id}^2}{R_i^2 - R_{id}^2} - \nu\right],
    \qquad
    \delta_{BE} = \frac{N n}{2\pi l E}\left[\frac{R_{ed}^2 + R_e^2}{R_{ed}^2 - R_e^2} + \nu\right].

`loaded_race` contains the effects of single forces: bending between them, and an indentation under
each of them.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive
from analytic.contact.hertz_line_approach import approach_to_depth
from analytic.ring import lame
from analytic.ring.fourier_ring import Wall
from analytic.ring.loaded_race import LoadedRace


def race_deflection(
    *,
    P: ArrayLike,
    n: ArrayLike,
    r_i: ArrayLike,
    r_o: ArrayLike,
    E: ArrayLike,
    nu: float,
    loaded: Wall,
    ends: Literal["plane stress", "plane strain"] = "plane stress",
) -> Array:
    """Deflection [length] of the loaded wall under n line loads `P` [force/length].

    The value is positive for both walls; `P` is N/l. The loaded wall is the bore of the outer race
    (second formula of Eq. 6) or the rim of the inner race (first formula). Eq. 6 applies to plane
    stress.

    >>> wall = dict(r_i=1.0, r_o=2.0, E=1.0, nu=0.25)
    >>> u = race_deflection(P=2 * np.pi, n=1, loaded="bore", **wall)
    >>> round(float(u), 12)  # (4 + 1)/(4 - 1) + 1/4
    1.916666666667
    """
    P, n = positive(P, "load per length", "N/m"), positive(n, "number of loads", "")
    if loaded not in ("bore", "rim"):
        raise ValueError(f"the loaded wall must be 'bore' or 'rim', got {loaded!r}")
    r = np.asarray(r_i if loaded == "bore" else r_o, dtype=np.float64)
    p = n * P / (2 * np.pi * r)
    outer = loaded == "bore"
    u = lame.radial_displacement(
        r, r_i=r_i, r_o=r_o, p_i=p if outer else 0.0, p_o=0.0 if outer else p, E=E, nu=nu,
        ends=ends,
    )  # fmt: skip
    return u if outer else -u


@dataclass(frozen=True, kw_only=True)
class SmearedError:
    """Relative errors of the uniformly loaded ring; the reference is the Fourier ring."""

    load: float  # at the load, without the indentation down to the depth of the wall
    between: float
    total: float  # at a load, of the uniformly loaded ring plus indentation


def smeared_error(
    *, n: int, ratio: float, a_r: float, nu: float = 0.3, loaded: Wall = "bore"
) -> SmearedError:
    """Errors of Eq. 6 on the loaded wall; `ratio` is r_o/r_i, `a_r` half-width over radius.

    The indentation is that of a half plane down to the depth of the wall. Plane stress, without
    units. The mean over the loaded wall has no error, because Lamé's ring is the mean of the
    Fourier ring.
    """
    r_i, r_o = (1.0, ratio) if loaded == "bore" else (1 / ratio, 1.0)
    race = LoadedRace(
        r_i=r_i, r_o=r_o, E=1.0, nu=nu, assumption="plane stress", loaded=loaded, n=n, P=1.0, a=a_r
    )
    outward = 1.0 if loaded == "bore" else -1.0
    load, between = (outward * float(u) for u in race.at(race.r, [0.0, np.pi / n]).u_r)
    dent = float(
        approach_to_depth(r_o - r_i, P=1.0, a=a_r, E=1.0, nu=nu, assumption="plane stress")
    )
    smeared = float(race_deflection(P=1.0, n=n, r_i=r_i, r_o=r_o, E=1.0, nu=nu, loaded=loaded))
    return SmearedError(
        load=smeared / (load - dent) - 1,
        between=smeared / between - 1,
        total=(smeared + dent) / load - 1,
    )
