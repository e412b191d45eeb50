"""Critical points of an equilibrium path, and linearised buckling."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.sparse.linalg import eigsh

from fem.beam.large_balance import Balance, ConvergenceError, Tangent, reduced
from fem.beam.large_newton import equilibrium
from fem.beam.large_state import BeamState, Path
from fem.beam.section import Array

ASYMMETRY = 1e-5  # share of the loads' work in a mode, above which it is that of a limit point
WIDTH = 1e-9  # width of the bracket, relative to the step
MAX_SECTIONS = 60


@dataclass(frozen=True)
class CriticalPoint:
    """Point at which a path loses or regains stability.

    The largest displacement of `mode` (n, 3) is 1 [length]. `limit` is True for a limit point,
    False for a bifurcation. `width` is the width of the interval of the load factor that contains
    the point.
    """

    state: BeamState
    mode: Array
    limit: bool
    width: float

    @property
    def factor(self) -> float:
        return self.state.factor


@dataclass(frozen=True)
class _Plane:
    """Step control by the progress along a fixed direction."""

    normal: Array
    progress: float
    kink = math.inf

    def correct(self, moved: Array, step: Array, push: Array) -> float:
        missing = self.progress - float(self.normal @ (moved + step))
        return missing / float(self.normal @ push)

    def speed(self, push: Array, moved: Array) -> float:
        return float(self.normal @ moved) / float(self.normal @ push)


@dataclass(frozen=True)
class _Place:
    state: BeamState
    tangent: Tangent
    lowest: float  # eigenvalue of the smallest size
    mode: Array


def critical_points(balance: Balance, path: Path) -> Iterator[CriticalPoint]:
    """Critical points, where pivots change sign, located to 1e-9 of a step of the path."""
    states = [path.start, *path.states]
    for before, after in pairwise(states):
        low, high = _look(balance, before), _look(balance, after)
        normal = balance.weights * _moved(before, after)
        while low.state.negative != high.state.negative:
            first, second = _section(balance, low, high, normal)
            best = min(first, second, key=lambda place: abs(place.lowest))
            yield CriticalPoint(
                best.state, _scaled(best.mode), _does_work(balance, best),
                abs(second.state.factor - first.state.factor),
            )  # fmt: skip
            low = second


def _section(balance: Balance, low: _Place, high: _Place, normal: Array) -> tuple[_Place, _Place]:
    """States before and after the first change of the number of negative pivots."""
    whole = float(normal @ _moved(low.state, high.state))
    for k in range(MAX_SECTIONS):
        gap = float(normal @ _moved(low.state, high.state))
        if gap < WIDTH * whole:
            break
        share = 0.5
        if low.lowest * high.lowest < 0 and k % 3:  # every third step is a bisection
            share = float(np.clip(low.lowest / (low.lowest - high.lowest), 1e-4, 1 - 1e-4))
        try:
            middle = _between(balance, low.state, high.state, share, _Plane(normal, share * gap))
        except ConvergenceError:
            break  # so near to the critical point that the tangent is singular
        if middle.state.negative == low.state.negative:
            low = middle
        else:
            high = middle
    return low, high


def _between(
    balance: Balance, low: BeamState, high: BeamState, share: float, plane: _Plane
) -> _Place:
    step, change = share * _moved(low, high), share * (high.factor - low.factor)
    stress = balance.respond(low.exact, low.factor).predict(step)
    try:
        u, factor, found, _ = equilibrium(balance, low, step, change, stress, plane)
    finally:
        for term in balance.terms:
            term.reject()
    loading = balance.base.plus(factor, balance.pattern)
    return _look(balance, replace(
        low, factor=factor, exact=u, loading=loading, internal=found.internal,
        strain_energy=found.strain_energy, term_energy=found.term_energy,
    ))  # fmt: skip


def _look(balance: Balance, state: BeamState) -> _Place:
    """Tangent at a state, and its eigenvalue with the smallest magnitude, by inverse iteration."""
    tangent = balance.factorise(state.exact, balance.respond(state.exact, state.factor).K)
    weights = np.where(balance.held, 0.0, balance.weights)
    mode = np.where(balance.held, 0.0, np.cos(np.arange(weights.size)))  # no symmetry
    lowest = before = math.inf
    for _ in range(100):
        grown = tangent.solve(weights * mode)
        lowest = float(weights * mode @ mode) / float(weights * mode @ grown)
        mode = grown / math.sqrt(float(weights * grown @ grown))
        if abs(lowest - before) < 1e-9 * abs(lowest):
            break
        before = lowest
    return _Place(replace(state, negative=tangent.negative), tangent, lowest, mode)


def _does_work(balance: Balance, place: _Place) -> bool:
    """True if the loads or prescribed displacements do work on the mode."""
    push = balance.pattern.forces(place.state.exact) - place.tangent.K @ balance.pattern.moved
    push = np.where(balance.held, 0.0, push)
    scale = np.sqrt(balance.weights)
    size = float(np.linalg.norm(push / scale) * np.linalg.norm(place.mode * scale))
    return abs(float(push @ place.mode)) > ASYMMETRY * size


def linear_buckling(balance: Balance, count: int) -> tuple[Array, Array]:
    """Smallest positive factors (count,) with singular K_0 + factor x K_g, and modes (count, n, 3).

    K_g is the geometric stiffness for the section forces of the linear solution.
    """
    start = np.zeros((len(balance.points), 3), np.longdouble)
    K = balance.respond(start, 0.0).K
    push, free = balance.factorise(start, K).push, ~balance.held
    stress = balance.elements.linear_forces(push.reshape(-1, 3))
    K_g = balance.elements.initial_stress_stiffness(stress)
    N, V, M = abs(stress.reshape(-1, 3)).max(axis=0)
    if not max(N, V) > 1e-9 * M / balance.length:
        raise ValueError(
            "the loads must cause an axial or a shear force: otherwise the frame does not buckle"
        )
    if not count < free.sum() - 1:
        raise ValueError(f"{count} modes need more than {free.sum()} unknowns: refine the mesh")
    inverse, shapes = eigsh(
        -reduced(K_g, free), count, M=reduced(K, free), which="LA", v0=np.ones(int(free.sum()))
    )
    if not inverse.min() > 0:
        raise ValueError(
            f"the frame has fewer than {count} positive buckling factors for these loads"
        )
    modes = np.zeros((count, free.size))
    modes[:, free] = shapes.T[::-1]
    return 1 / inverse[::-1], np.array([_scaled(mode) for mode in modes])


def _moved(before: BeamState, after: BeamState) -> Array:
    return (after.exact - before.exact).astype(float).ravel()


def _scaled(mode: Array) -> Array:
    """Mode (n, 3), scaled to the largest displacement +1."""
    shape = mode.reshape(-1, 3)
    at = abs(shape[:, :2]).argmax()
    return shape / shape[:, :2].ravel()[at]
