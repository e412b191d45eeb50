"""Buckling of a compressed frame whose head is released before loading, or in a loaded state."""

import math
from dataclasses import replace

import numpy as np
from scipy.optimize import brentq

from fem.beam.at_rest import AtRest
from fem.beam.large_state import BeamState
from fem.beam.pressed import PLACES, PressedFrame, let_go
from fem.beam.section import Array

Held = tuple[BeamState, tuple[Array, Array]]  # with the head's stiffness and its rounding

LOCATED = 1e-13  # relative to the displacement
ITERATIONS = 3  # inverse iterations from a mode of six digits: each adds two digits to its load
NEAR, STEP = 0.85, 1.25  # of the linear load's displacement; from one displacement to the next


def linear_load(one: PressedFrame) -> tuple[float, float]:
    """Linearised buckling load of the frame with a free head [force], and its round-off error.

    The deformation of the frame before buckling is neglected. The round-off error is the change in
    the last step of inverse iteration, plus the error due to rounded node coordinates.
    """
    frame = one.frame("")
    rest, e = frame.rest(), frame.elements
    at_rest = AtRest(e, *e.strains(rest.exact), ~rest.held)
    push = (np.arange(rest.held.size) == 3 * one.head).astype(float)
    stress = e.moduli * at_rest.strains(at_rest.solve(push))
    G = at_rest.stiffness(stress, replace(e, moduli=0 * e.moduli))
    mode = at_rest.lowest(G, push)
    loads = [at_rest.load(mode, G)]
    for _ in range(ITERATIONS):
        mode = at_rest.solve(-(G @ mode.astype(float)))
        mode /= abs(mode).max()
        loads.append(at_rest.load(mode, G))
    return loads[-1], abs(loads[-1] - loads[-2]) + PLACES * loads[-1]


def buckling_state(one: PressedFrame, until: float) -> tuple[float, float, BeamState | None]:
    """Smallest displacement of a guided head at which the head buckles if it is released there.

    The results are this displacement, its round-off error, and the state. The displacement is NaN
    and the state None if the head does not buckle up to `until`. The first displacement of the
    search is near the linearised buckling load. A lower critical point is not missed, because the
    sign of the determinant is compared with that of the unloaded state.
    """
    load, _ = linear_load(one)
    rest, at = one.guided.rest(), 0.0
    before = rest, one.head_stiffness(rest)
    u = min(NEAR * load * float(np.linalg.inv(before[1][0])[0, 0]), until / STEP)
    while at < until:
        here = _held(one, before, u - at)
        if let_go(here[1][0], "free") <= 0:
            return _located(one, before, here, at, u)
        before, at, u = here, u, min(STEP * u, until)
    return math.nan, 0.0, None


def _held(one: PressedFrame, since: Held, step: float) -> Held:
    """State after the further displacement `step` from `since`, and stiffness of the head."""
    state = one.compressed([step], since[0])[0]
    return state, one.head_stiffness(state)


def _located(
    one: PressedFrame, before: Held, beyond: Held, at: float, u: float
) -> tuple[float, float, BeamState]:
    """Critical point between the states `before` and `beyond`, at the displacements `at` and `u`.

    Between these states, the determinant is accurate to round-off, so that noise does not cause
    additional roots.
    """
    found = {0.0: before, u - at: beyond}

    def determinant(step: float) -> float:
        if step not in found:
            near = min(found, key=lambda known: abs(known - step))
            found[step] = _held(one, found[near], step - near)
        return let_go(found[step][1][0], "free")

    step = float(brentq(determinant, 0.0, u - at, xtol=LOCATED * u, rtol=1e-13))
    slope = determinant(0.0) / step
    here, (S, rounding) = found[step]
    lost = abs(np.linalg.det(S + rounding) - np.linalg.det(S))
    return at + step, float(lost) / slope + (LOCATED + PLACES) * u, here
