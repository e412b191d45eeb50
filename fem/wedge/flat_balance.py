"""Relative residuals of the states of a roller between flat and race."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from fem.wedge.flat_course import FlatCourse

if TYPE_CHECKING:
    from fem.contact.solution import Touch

Array = NDArray[np.float64]


def balance(course: FlatCourse, T: float) -> dict[str, float]:
    """Relative residuals of statics, of rolling, and of the solver under the torque `T` [N m].

    Most values are relative differences: of F_t/N from tan(psi/2) at flat and race, of the torques
    on race and cam from `T`, and of the wind-up by rolling from the wind-up by energy. "unlike_N"
    and "unlike_F_t" compare N and F_t at the race with N and F_t at the flat. "forces" is the
    unbalanced force on the roller in the most heavily loaded state, divided by a contact force.
    """
    q, place = course.q, course.place(T)
    tan, torque = math.tan(place.psi / 2), np.array([T])
    N, F_t, on_race = course.at("N", T), course.at("F_t", T), course.at("F_t race", T)
    on_cam = q.z * (N * place.x - F_t * q.flat)
    rolling, energy = course.torsion_by_rolling(torque)[0], course.torsion_by_energy(torque)[0]
    touches = course.last.solution.touches
    force, size = np.add(*(np.array(t.force) for t in touches)), np.hypot(*touches[0].force)
    return {
        "share_flat": course.share(T) / tan - 1,
        "share_race": course.share(T, " race") / tan - 1,
        "torque_race": q.z * q.race * on_race / T - 1,
        "torque_cam": on_cam / T - 1,
        "rolling": float(rolling / energy - 1),
        "forces": float(np.hypot(*force)) / float(size),
        "unlike_N": course.at("N race", T) / N - 1,
        "unlike_F_t": on_race / F_t - 1,
    }


def over_hertz(touch: "Touch", at: Array) -> Array:
    """Pressure divided by Hertz's peak pressure, at distances of `at` half-widths from the centre.

    The half-width is calculated from the moments of the pressure.
    """
    s, load = touch.along(), touch.p * touch.weight
    a, P = touch.half_width(), load.sum()
    order = np.argsort(s)
    return np.asarray(np.interp(at * a, s[order], touch.p[order]) * np.pi * a / (2 * P))
