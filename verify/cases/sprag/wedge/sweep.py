"""Finite-element states of a sector of a sprag clutch over its stroke, with interpolation.

The normal forces of the states range from nearly zero to above 1.8 N_0. The normal force of a
rigid clutch is N_0 = T/(n_s R_i tan(nu_0)).
"""

import math
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise

import numpy as np

from fem.wedge.races import State
from fem.wedge.start import COARSE, Start
from fem.wedge.stroke import Stroke, half_width
from meshes.sprag.wedged import Place
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.stroke import at_force

SHARES = (0.03, 0.22, 0.5, 1.0, 1.86)  # forces of the states over N_0
GROWS = 0.965  # power of N with which rotations grow
FINER = 8  # cells for the width of contacts


def rigid_force(q: WedgeInputs) -> float:
    """Normal force [N] of a sprag in a rigid clutch, N_0 = T/(n_s R_i tan(nu_0))."""
    return q.T / (q.z * q.R_i * math.tan(q.nu_0))


@lru_cache(maxsize=16)
def starts_by_fem(q: WedgeInputs) -> tuple[Start[Place], ...]:
    """Initial iterates of all states, in order of increasing load.

    Raises ArithmeticError if the sprag has no equilibrium.
    """
    now = at_force(q, SHARES[-1] * rigid_force(q) / q.l)
    found = [now]
    for above, share in pairwise(reversed(SHARES)):
        guess = now.turned(now.place.alpha * (share / above) ** GROWS)
        now = Start.after(guess.state(COARSE))
        found.append(now)
    # on coarse meshes all contacts are too narrow by the same factor
    fine, coarse = now.state(FINER).widths, now.widths
    share_i, share_e = (f / c for f, c in zip(fine, coarse, strict=True))
    return tuple(
        replace(s, widths=(share_i * s.widths[0], share_e * s.widths[1])) for s in reversed(found)
    )


class Sweep(Stroke):
    """States of the sector on meshes of `cells` cells, and splines over ln N between the states."""

    def __init__(self, q: WedgeInputs, cells: int) -> None:
        self.z = q.z
        self.states = [start.state(cells) for start in starts_by_fem(q)]
        rows = [read(q, state) for state in self.states]
        self.at_states = {name: np.array([row[name] for row in rows]) for name in rows[0]}


def read(q: WedgeInputs, state: State[Place]) -> dict[str, float]:
    """Results of a state, by name: torque [N m], forces [N], lengths, angles, pressures, U [J].

    Forces act on one sprag; the energy is that of one pitch.
    """
    (N, N_e), (T_i, T_e), (p_i, p_e) = state.N, state.T, state.peaks
    a_i, a_e = map(half_width, state.solution.touches)
    place, (nu, omega) = state.place, state.angles
    (m_i, m_e), (c_i, c_e) = state.race_mean, state.race_at_contact
    return {
        "T": state.torque * q.l, "held": state.held * q.l, "N": N * q.l, "N_e": N_e * q.l,
        "T_i": T_i * q.l, "T_e": T_e * q.l, "tan nu": math.tan(nu), "tan omega": math.tan(omega),
        "alpha": place.alpha, "OC_e": place.D, "H": place.H, "OA": place.OA, "OB": place.OB,
        "beta": place.beta, "strut nu": math.tan(place.strut[0]), "a_i": a_i, "a_e": a_e,
        "p_i": p_i, "p_e": p_e, "mean i": -m_i, "mean e": m_e, "race i": -c_i, "race e": c_e,
        "U": state.energy * q.l,
    }  # fmt: skip
