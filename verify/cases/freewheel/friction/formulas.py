"""Formulas of a freewheel's friction (Nagler, Lohrengel, Eqs. 1, 8 to 10), and what is expected.

What the clutch does at its limit follows from Coulomb's law and energy. Slip is along the
resultant, so that u_z of it and R phi are as F_z and F_t. Where a drive keeps the torque up, the
ring creeps by that. Where the ring is held, rollers are let out instead: R phi is made up by what
both approaches lose, dd_i + dd_o = -tan(alpha) R dphi, until none is left.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.freewheel import criterion, tilt
from analytic.freewheel.state import at_normal_force, loaded
from verify.cases.freewheel.bounds import Bounds, Interval, times
from verify.cases.freewheel.pulled import Pulled
from verify.core.case import Values

Array = NDArray[np.float64]

WIDEST = 0.04  # interval at the limit: near tan(alpha) = mu it says nothing
GRID = np.linspace(0.0, 1.0, 401)  # of N, along which rollers are let out


def analytic(q: Pulled) -> Values:
    state = q.under(q.T)
    alpha, N, F_a = state.alpha, state.N, q.F_ax / q.z
    F_t = q.T / q.cam.torque_on_race(F_t=1.0)
    mu_req = criterion.required_friction(alpha=alpha, T=q.T, F_ax=q.F_ax, R=q.R)
    e = tilt.offset(F_a=F_a, F_n=N, r=q.r, alpha=alpha)
    values: dict[str, Any] = {
        "alpha": alpha, "N": N, "F_t": F_t, "F_a": F_a,
        "mu_t": criterion.required_friction(alpha=alpha, T=q.T, F_ax=0.0, R=q.R),
        "mu_req": mu_req, "safety": criterion.safety(mu=q.mu, mu_req=mu_req),
        "Eq. 8 printed": criterion.required_friction_of_contact(F_n=N, F_t=F_t, F_a=q.F_ax),
        "e": e, "peak": tilt.peak_factor(e=e, L=q.L), "pressure": tilt.pressure_factor(e=e, L=q.L),
    }  # fmt: skip
    limit = criterion.largest_axial_load(alpha=alpha, T=q.T, R=q.R, mu=q.mu)
    if limit > 0:
        values |= {"F_lim": limit, "creep": q.T / (q.R * limit), "u_out": slipped(q)[0][0]}
    return {key: float(value) for key, value in values.items()}


def slipped(q: Pulled) -> tuple[Array, Array]:
    """Axial slip (m,) [m] of a ring held about the axis, and T (m,) over that before, backwards.

    The first is where nothing is left.
    """
    state = at_normal_force(q.clutch, GRID * loaded(q.clutch, q.T).N)
    tan = np.tan(state.alpha)
    slope = np.sqrt((q.mu / tan) ** 2 - 1) / tan
    d = state.d_i + state.d_o
    lost = np.diff(d) * (slope[1:] + slope[:-1]) / 2
    rest = np.concatenate([np.cumsum(lost[::-1])[::-1], [0.0]])
    return rest, np.asarray(state.T / state.T[-1])


def lever(q: Pulled) -> float:
    """F_a/F_t = F_ax R/T."""
    return q.F_ax * q.R / q.T


def one_contact(q: Pulled, _values: Values) -> Interval:
    """Of F_t/N where both contacts count by themselves."""
    return _wider(q, _bounds(q).slope(tilted=True))


def both_contacts(q: Pulled, _values: Values) -> Interval:
    return _wider(q, _bounds(q).slope())


def normal_force(q: Pulled, _values: Values) -> Interval:
    return _wider(q, _bounds(q).force())


def _wider(q: Pulled, interval: Interval) -> Interval:
    """With what friction along the surfaces does to the angle.

    A tangential force moves nothing across itself where a body is its own mirror image. Contacts
    on flats are off their middle by psi, some 2 tan(alpha), F_t is tan(alpha) of N, and the bodies'
    shape makes less than half of an approach: by size, approaches change by tan² alpha of
    themselves at most. From alpha_0 on tan² alpha is linear in them.
    """
    tan, least = (math.tan(float(a)) for a in (_bounds(q).state.alpha, q.cam.alpha0))
    rest = (tan**2 - least**2) / 2
    return interval[0] - rest, interval[1] + rest


def whole_load(q: Pulled, _values: Values) -> Interval:
    """Eq. 8 with the F_ax of Eq. 9: z times the axial force of a roller."""
    more = math.hypot(1.0, q.z * lever(q)) / math.hypot(1.0, lever(q))
    return times(one_contact(q, _values), more, 1e-6)


def two_tangents(q: Pulled, _values: Values) -> Interval:
    """Eq. 8 as it stands calls tan(alpha) what is mu_req."""
    return times(both_contacts(q, _values), math.hypot(1.0, lever(q)), 1e-6)


def limit_load(q: Pulled, values: Values) -> Interval | None:
    """Of F_ax at the limit, from the slope's: none where that alone nearly lets the roller out."""
    return _through(q, values, lambda tan: math.sqrt((q.mu / tan) ** 2 - 1))


def limit_creep(q: Pulled, values: Values) -> Interval | None:
    """Of F_t/F_z at the limit."""
    return _through(q, values, lambda tan: 1 / math.sqrt((q.mu / tan) ** 2 - 1))


def _through(q: Pulled, values: Values, of) -> Interval | None:  # type: ignore[no-untyped-def]
    own = math.tan(values["alpha"])
    ends = [own / (1 + m) for m in one_contact(q, values)]
    if max(ends) >= q.mu:
        return None
    found = [of(own) / of(tan) - 1 for tan in ends]
    return (min(found), max(found)) if max(found) - min(found) < WIDEST else None


def _bounds(q: Pulled) -> Bounds:
    return Bounds(q, loaded(q.clutch, q.T))
