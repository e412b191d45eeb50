"""Steady vibration under rotating or alternating forces, in particular unbalance."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fem.rotor.blocks import Block, Complex, blocks
from fem.rotor.branches import check_speeds
from fem.rotor.critical import check_supported
from fem.rotor.elements import Array
from fem.rotor.many_speeds import Diagonal
from fem.rotor.model import Rotor
from fem.rotor.parts import UNKNOWNS, Link, Support

CHUNK = 2_000_000  # entries of the matrices solved together
# Speeds from which on one diagonalisation replaces the solutions of each. It pays from some 30 on;
# both agree to 1e-9, not to the last digit: the limit is higher, so that fewer speeds give the
# digits of single solutions.
MANY = 250


@dataclass(frozen=True)
class Orbit:
    """Elliptic orbit with its semi-axes [m]; `minor` is negative for backward motion.

    `inclination` [rad] is the angle between the major axis and x.
    """

    major: float
    minor: float
    inclination: float
    x: complex
    y: complex

    def points(self, count: int = 90) -> Array:
        """Positions (count, 2) over one revolution; the first is at time zero."""
        turn = np.exp(2j * np.pi * np.arange(count) / count)
        return np.column_stack([(self.x * turn).real, (self.y * turn).real])


@dataclass(frozen=True)
class Response:
    """Amplitudes `q` (speeds, unknowns) of the motion Re(q e^(i omega t)).

    `omega` (speeds,) is not negative.
    """

    rotor: Rotor
    speeds: Array
    omega: Array
    q: Complex

    def at(self, node: int) -> Complex:
        """Amplitudes (speeds, 6) of a node: x, y, z, theta_x, theta_y, theta_z."""
        self._check(node, self.rotor.stations, "node")
        return np.asarray(self.q[:, UNKNOWNS * node : UNKNOWNS * (node + 1)])

    def orbit(self, node: int, index: int = 0) -> Orbit:
        """Elliptic orbit of a node at the speed with the number `index`."""
        x, y = (complex(v) for v in self.at(node)[index, :2])
        forward, backward = (x + 1j * y) / 2, (x - 1j * y).conjugate() / 2
        turned = np.angle(forward * backward) / 2 if forward and backward else np.angle(forward)
        return Orbit(
            abs(forward) + abs(backward), abs(forward) - abs(backward), float(turned), x, y
        )

    def major(self, node: int) -> Array:
        """Semi-major axis of the orbit of a node at every speed (speeds,) [m]."""
        x, y = self.at(node)[:, 0], self.at(node)[:, 1]
        return np.asarray((abs(x + 1j * y) + abs(x - 1j * y)) / 2)

    def support_load(self, k: int) -> Complex:
        """Forces and moments (speeds, 6) of the rotor on its support with the number `k`."""
        self._check(k, len(self.rotor.supports), "support")
        support = self.rotor.supports[k]
        q = self.at(support.node)
        if isinstance(support, Support):
            return _load(support.K, support.C, q, self.omega)
        each = [support.at(float(s)) for s in self.speeds]
        return np.array([
            _load(own.K, own.C, q[i : i + 1], self.omega[i : i + 1])[0]
            for i, own in enumerate(each)
        ])  # fmt: skip

    def link_load(self, k: int) -> Complex:
        """Forces and moments (speeds, 6) of node a on node b through the link number `k`."""
        self._check(k, len(self.rotor.links), "link")
        link: Link = self.rotor.links[k]
        return _load(link.stiffness, link.damping, self.at(link.a) - self.at(link.b), self.omega)

    @staticmethod
    def _check(k: int, count: int, what: str) -> None:
        if not 0 <= k < count:
            raise ValueError(f"{what} {k} does not exist: numbers are 0 to {count - 1}")


def unbalance_response(
    rotor: Rotor, speeds: ArrayLike, unbalances: Mapping[int, complex]
) -> Response:
    """Response to `unbalances` at nodes; an unbalance is mass times eccentricity [kg m].

    The argument of a complex unbalance is its angle on the shaft. Each unbalance rotates with its
    shaft. All unbalances of one response must therefore be on shafts with the same speed ratio.
    Raises ValueError for unbalances on shafts with different ratios, for nodes that do not exist,
    and for a rotor without sufficient supports; ArithmeticError at a resonance without damping.
    """
    return unbalance_responses(rotor, speeds, [unbalances])[0]


def unbalance_responses(
    rotor: Rotor, speeds: ArrayLike, each: Sequence[Mapping[int, complex]]
) -> list[Response]:
    """Responses to several sets of unbalances, all on shafts with the same speed ratio."""
    at = check_speeds(speeds)
    forces, ratios = [], set()
    for unbalances in each:
        force, own = _turning(rotor, unbalances)
        forces.append(force)
        ratios |= own
    if len(ratios) > 1:
        raise ValueError(
            "all unbalances of a response must be on shafts with the same speed ratio: compute one "
            "response for each ratio"
        )
    omega = ratios.pop() * at
    return _responses(rotor, at, omega, [omega[:, None] ** 2 * force for force in forces])


def _turning(rotor: Rotor, unbalances: Mapping[int, complex]) -> tuple[Complex, set[float]]:
    """Unbalance forces (unknowns,) divided by omega^2, and speed ratios of the loaded shafts."""
    if not unbalances:
        raise ValueError("an unbalance response requires at least one unbalance")
    force = np.zeros(rotor.system.M.shape[0], complex)
    ratios = set()
    for node, value in unbalances.items():
        if node != int(node) or not 0 <= node < rotor.stations:
            raise ValueError(
                f"the node of an unbalance must exist, got node {node}: "
                f"nodes are 0 to {rotor.stations - 1}"
            )
        if not np.isfinite(value):
            raise ValueError(f"the unbalance at node {node} must be finite")
        force[UNKNOWNS * node] += value
        force[UNKNOWNS * node + 1] += -1j * value
        ratios.add(rotor.shafts[rotor.shaft_of[node]].ratio)
    return force, ratios


def forced_response(
    rotor: Rotor, speeds: ArrayLike, omega: ArrayLike, force: NDArray[np.inexact]
) -> Response:
    """Response to the forces Re(f e^(i omega t)) with the amplitudes `force`.

    `force` has the shape (speeds, unknowns), or (unknowns,) for all speeds. `speeds` and `omega`
    (m,) are pairs; one of them may be a single number. Forces with a negative omega rotate in the
    opposite sense; the returned amplitudes refer to |omega|.
    """
    return _responses(rotor, speeds, omega, [force])[0]


def _responses(
    rotor: Rotor, speeds: ArrayLike, omega: ArrayLike, forces: Sequence[NDArray[np.inexact]]
) -> list[Response]:
    """Results of `forced_response` for each of `forces`, solved with the same matrices."""
    at, frequency = np.broadcast_arrays(check_speeds(speeds), check_speeds(omega))
    n = rotor.system.M.shape[0]
    for force in forces:
        if force.shape[-1] != n:
            raise ValueError(f"forces must have {n} values, one per unknown, got {force.shape[-1]}")
    loads = np.array([np.broadcast_to(force, (at.size, n)) for force in forces], complex)
    q = np.zeros(loads.shape, complex)
    if rotor.system.varying:
        for i in range(at.size):
            own = slice(i, i + 1)
            for block in blocks(rotor.system, float(at[i])):
                _solve(block, at[own], frequency[own], loads[:, own], q[:, own])
    else:
        for block in rotor.blocks:
            _solve(block, at, frequency, loads, q)
    q = np.where(frequency[:, None] < 0, q.conj(), q)  # the same motion, omega > 0
    return [Response(rotor, np.asarray(at), abs(frequency), own) for own in q]


def _solve(block: Block, speeds: Array, omega: Array, loads: Complex, q: Complex) -> None:
    """Add to `q` the motions of `block` under `loads`; both are (loads, speeds, unknowns)."""
    loaded = np.flatnonzero((f := block.own(loads)).any(axis=(1, 2)))
    if not loaded.size:
        return
    check_supported(block)
    f, left = f[loaded], np.arange(omega.size)
    own = np.empty(f.shape, complex)
    if omega.size >= MANY and (modes := Diagonal.of(block, speeds, omega)) is not None:
        solved = [modes.solve(omega, each) for each in f]
        own[:] = [u for u, _ in solved]
        left = np.flatnonzero(~np.all([good for _, good in solved], axis=0))
    step = max(1, CHUNK // block.at.size**2)
    for i in range(0, left.size, step):
        some = left[i : i + step]
        own[:, some] = _direct(block, speeds[some], omega[some], f[:, some])
    q[loaded] += block.real(own, q.shape[-1])


def _direct(block: Block, speeds: Array, omega: Array, f: Complex) -> list[Complex]:
    """Motions (speeds, n) of `block` under each of `f` (loads, speeds, n)."""
    w, W = omega[:, None, None], speeds[:, None, None]
    D = (W * block.H).astype(complex, copy=False)  # in place from here on
    D += 1j * block.C
    D -= w * block.M
    D *= w
    D += block.K
    try:
        return [np.linalg.solve(D, each[..., None])[..., 0] for each in f]
    except np.linalg.LinAlgError:
        raise ArithmeticError(
            "no bounded response exists: the rotor has an undamped resonance, or an unsupported "
            "motion at zero frequency: add damping or supports"
        ) from None


def _load(K: Array, C: Array, q: Complex, omega: Array) -> Complex:
    return np.asarray(q @ K.T + 1j * omega[:, None] * (q @ C.T))
