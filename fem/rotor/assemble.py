"""Assembly of the matrices of a rotor from its parts: M q'' + (C + Omega G) q' + K q = f."""

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from fem.rotor.elements import (
    Array,
    Sections,
    bar_mass,
    bar_stiffness,
    bending_stiffness,
    rotary_mass,
    translational_mass,
)
from fem.rotor.parts import UNKNOWNS, Element, SpeedSupport, Support

if TYPE_CHECKING:
    from fem.rotor.model import Rotor

Indices = NDArray[np.int64]

X, Y, Z, TX, TY, TZ = range(UNKNOWNS)
# Both planes as (u, phi) with phi = du/dz: unknowns of a node and their signs.
PLANES = (((X, TY), (1.0, 1.0)), ((Y, TX), (1.0, -1.0)))


@dataclass(frozen=True)
class System:
    """Assembled matrices (n, n) with six unknowns per node.

    `z` and `shaft` (nodes,) are the axial position and the shaft of each node. `varying` are the
    supports that depend on the speed. `ends` (elements, 2) are the nodes of the beam elements;
    `given` (elements,) is the index of the rotor's element of which each beam element is a part.
    """

    M: Array
    K: Array
    C: Array
    G: Array
    z: Array
    shaft: Indices
    ends: Indices
    given: Indices
    varying: tuple[SpeedSupport, ...]

    def at(self, speed: float) -> tuple[Array, Array]:
        """Matrices K and C (n, n) with the supports at `speed` [rad/s]."""
        if not self.varying:
            return self.K, self.C
        K, C = self.K.copy(), self.C.copy()
        for varying in self.varying:
            own, at = varying.at(speed), _of(varying.node)
            K[at, at] += own.K
            C[at, at] += own.C
        return K, C


def assemble(rotor: "Rotor") -> System:
    """Assembled matrices of `rotor`.

    Inner nodes of refined elements follow the numbered nodes.
    """
    z, shaft, ends, given = _nodes(rotor)
    sections = _sections(rotor, given)
    n = UNKNOWNS * z.size
    M, K, C, G = (np.zeros((n, n)) for _ in range(4))
    _add_shafts(M, K, ends, sections)
    ratio = np.array([s.ratio for s in rotor.shafts])[shaft]
    _add_gyroscopic(G, ends, 2 * rotary_mass(sections), ratio[ends[:, 0]])
    for disc in rotor.discs:
        at = UNKNOWNS * disc.node
        own = [disc.mass] * 3 + [disc.diametral] * 2 + [disc.polar]
        M[range(at, at + UNKNOWNS), range(at, at + UNKNOWNS)] += own
        G[at + TX, at + TY] += disc.polar * ratio[disc.node]
        G[at + TY, at + TX] -= disc.polar * ratio[disc.node]
    for support in rotor.supports:
        if isinstance(support, Support):
            K[_of(support.node), _of(support.node)] += support.K
            C[_of(support.node), _of(support.node)] += support.C
    for link in rotor.links:
        for left, right, sign in ((link.a, link.a, 1), (link.b, link.b, 1),
                                  (link.a, link.b, -1), (link.b, link.a, -1)):  # fmt: skip
            K[_of(left), _of(right)] += sign * link.stiffness
            C[_of(left), _of(right)] += sign * link.damping
    if rotor.damping is not None:
        C += rotor.damping.matrix(M, K)
    varying = tuple(s for s in rotor.supports if isinstance(s, SpeedSupport))
    return System(M, K, C, G, z, shaft, ends, given, varying)


def _of(node: int) -> slice:
    return slice(UNKNOWNS * node, UNKNOWNS * (node + 1))


def _nodes(rotor: "Rotor") -> tuple[Array, Indices, Indices, Indices]:
    """Axial positions and shafts of all nodes; nodes and given element of each beam element."""
    z, shaft = list(rotor.z), list(rotor.shaft_of)
    ends, given, number = [], [], 0
    for k, own in enumerate(rotor.shafts):
        for i, element in enumerate(own.elements):
            left = int(rotor.first_nodes[k]) + i
            inner = list(range(len(z), len(z) + rotor.refine - 1))
            z += [rotor.z[left] + element.length * j / rotor.refine for j in range(1, rotor.refine)]
            shaft += [k] * len(inner)
            chain = [left, *inner, left + 1]
            ends += list(pairwise(chain))
            given += [number] * rotor.refine
            number += 1
    return np.array(z), np.array(shaft), np.array(ends), np.array(given)


def _sections(rotor: "Rotor", given: Indices) -> Sections:
    elements: list[Element] = [e for s in rotor.shafts for e in s.elements]

    def of(value: list[float]) -> Array:
        return np.asarray(value, float)[given]

    shear = [
        e.kappa * e.material.G * e.area if rotor.theory == "timoshenko" else np.inf
        for e in elements
    ]
    turns = 0.0 if rotor.theory == "euler" else 1.0
    return Sections(
        L=of([e.length / rotor.refine for e in elements]),
        EI=of([e.material.E * e.inertia for e in elements]), shear=of(shear),
        EA=of([e.material.E * e.area for e in elements]),
        GJ=of([2 * e.material.G * e.inertia for e in elements]),
        mass=of([e.material.rho * e.area for e in elements]),
        rotary=turns * of([e.material.rho * e.inertia for e in elements]),
        polar=of([2 * e.material.rho * e.inertia for e in elements]),
    )  # fmt: skip


def _add_shafts(M: Array, K: Array, ends: Indices, s: Sections) -> None:
    bending, mass = bending_stiffness(s), translational_mass(s) + rotary_mass(s)
    for own, signs in PLANES:
        at = (UNKNOWNS * ends[:, :, None] + np.array(own)).reshape(-1, 4)
        sign = np.outer(np.tile(signs, 2), np.tile(signs, 2))
        np.add.at(K, (at[:, :, None], at[:, None, :]), sign * bending)
        np.add.at(M, (at[:, :, None], at[:, None, :]), sign * mass)
    for own_dof, stiffness, density in ((Z, s.EA, s.mass), (TZ, s.GJ, s.polar)):
        at = UNKNOWNS * ends + own_dof
        np.add.at(K, (at[:, :, None], at[:, None, :]), bar_stiffness(stiffness, s.L))
        np.add.at(M, (at[:, :, None], at[:, None, :]), bar_mass(density, s.L))


def _add_gyroscopic(G: Array, ends: Indices, G_1: Array, ratio: Array) -> None:
    """Add the gyroscopic terms of both planes in (u, phi) to G.

    The terms are M_xx u_x'' + Omega G_1 u_y' and M_yy u_y'' - Omega G_1 u_x'.
    """
    (x, sign_x), (y, sign_y) = PLANES
    at_x = (UNKNOWNS * ends[:, :, None] + np.array(x)).reshape(-1, 4)
    at_y = (UNKNOWNS * ends[:, :, None] + np.array(y)).reshape(-1, 4)
    own = ratio[:, None, None] * G_1 * np.outer(np.tile(sign_x, 2), np.tile(sign_y, 2))
    np.add.at(G, (at_x[:, :, None], at_y[:, None, :]), own)
    np.add.at(G, (at_y[:, :, None], at_x[:, None, :]), -own.swapaxes(1, 2))
