"""Results of an engagement by time integration: peaks, work, friction, sliding."""

import math

import numpy as np

from analytic.contact.checks import Array
from analytic.sprag.balance import balance
from analytic.sprag.events import Events
from analytic.sprag.history import Engagement, Phase


def put_in(found: Engagement) -> float:
    """Work [J] of torque and springs up to the first peak, by a parabola through 3 samples."""
    ahead = found.t / found.dt - found.first_peak[0] / found.dt
    near = np.argsort(np.abs(ahead))[:3]
    kept = balance(found)
    return float(np.polyfit(ahead[near], (kept.torque + kept.blades)[near], 2)[-1])


def missing(found: Engagement) -> float:
    """Largest error of the energy balance [J]."""
    return float(np.abs(balance(found).missing).max())


def later_peak(found: Engagement) -> float:
    """Largest N [N] after the first peak and the following minimum; 0 without such a peak."""
    after = found.N[found.t > found.first_peak[0]]
    rising = np.flatnonzero(np.diff(after) > 0)
    return float(after[rising[0] :].max()) if len(rising) else 0.0


def asked(found: Engagement) -> float:
    """Required friction coefficient of sticking: largest |T|/N while both contacts stick."""
    pressed = (found.N > 0) & (found.phases == Phase.STICK).all(axis=1)
    if not pressed.any():
        return math.nan
    most = np.maximum(np.abs(found.T_i), np.abs(found.T_e))[pressed]
    return float((most / found.N[pressed]).max())


def highest(found: Events) -> tuple[float, float]:
    """Time [s] and value [N] of the largest normal force."""
    tops = found.peaks[np.argmax(found.peaks[:, 1])] if len(found.peaks) else (0.0, 0.0)
    k = int(np.argmax(found.N))
    if tops[1] >= found.N[k]:
        return float(tops[0]), float(tops[1])
    return float(found.t[k]), float(found.N[k])


def swings(found: Engagement, mu: float) -> float:
    """Relative difference of mean(N arm) and mean(N) mean(arm), with the lever arm of N.

    Means are over the second half of the time; `mu` is the friction coefficient at the inner race.
    """
    N, late = found.N, len(found.N) // 2
    at = found.table.at(found.alpha)
    outer = ((at["OA"] + at["b_i"]) * mu - at["h"]) / (at["OB"] - at["b_e"])
    arm = (at["h"] - at["b_i"] * mu - at["b_e"] * outer)[late:]
    return float(abs(np.mean(N[late:] * arm) / (N[late:].mean() * arm.mean()) - 1))


def sticks(found: Engagement) -> float:
    """Time [s] at which the inner contact first comes to rest; 0 if it never slides.

    The time is extrapolated from the parabola through the last three sliding speeds outside the
    sticking band.
    """
    slid = np.flatnonzero(found.phases[:, 0] == Phase.SLIP)
    if not len(slid):
        return 0.0
    outside = slid[np.abs(found.v_i[slid]) > found.D_V]
    k = outside[np.flatnonzero(np.diff(outside, append=np.inf) > 1)[0]]
    first, slope, bend = np.polynomial.polynomial.polyfit([-2, -1, 0], found.v_i[k - 2 : k + 1], 2)
    later = [x.real for x in np.roots([bend, slope, first]) if abs(x.imag) < 1e-9 and x.real > 0]
    return float(found.t[k] + found.dt * min(later, default=0.0))


def first_trough(found: Engagement) -> float:
    """Smallest force [N] between the first peak and the following rise."""
    behind = _behind(found)
    return float(behind[: int(np.argmax(np.diff(behind) > 0)) + 1].min())


def second_peak(found: Engagement) -> float:
    """Largest force [N] after the first minimum."""
    behind = _behind(found)
    trough = int(np.argmax(np.diff(behind) > 0))
    return float(behind[trough:].max())


def _behind(found: Engagement) -> Array:
    """Forces [N] from the first peak on."""
    return found.N[round(found.first_peak[0] / found.dt) :]


def slid(found: Engagement) -> tuple[float, float]:
    """Sliding distances [m] of the inner and the outer contact under load."""
    inner, outer = (float(found.dt * np.abs(v[found.N > 0]).sum()) for v in (found.v_i, found.v_e))
    return inner, outer


def steady(found: Engagement) -> tuple[float, float]:
    """Mean N [N] over the second half of the time, and its difference from that of the middle half.

    A Hann window reduces the effect of incomplete periods at the ends of each half.
    """
    half = len(found.N) // 2
    window = np.hanning(half)
    middle, late = (
        float(np.average(found.N[start : start + half], weights=window))
        for start in (half // 2, len(found.N) - half)
    )
    return late, abs(late - middle)


def first_slip(found: Engagement, mu: float) -> float:
    """Time [s] at which T/N of the inner contact first reaches `mu`, so that slip begins.

    The time is extrapolated linearly from the two previous steps.
    """
    k = int(np.flatnonzero(found.phases[:, 0] == Phase.SLIP)[0])
    before, last = found.T_i[k - 2 : k] / found.N[k - 2 : k]
    return float(found.t[k - 1] + (mu - last) / (last - before) * found.dt)
