r"""Gap and slip between a probe on one line and the nearest point of another line.

x_s is the position of the probe, x_m(xi) the nearest point and n the unit vector from x_m to x_s.
Both surfaces are at half a thickness from their lines:

.. math:: g = n\cdot(x_s - x_m) - b, \qquad
   \dot s = t\cdot(\dot x_s - \dot x_m) + \tfrac{l}{2}(\dot\phi_s + \dot\phi_m), \quad l = g + b

The slip of a step does not include rigid rotations. It consists of the arc length travelled on the
other line, and the rotations of both sections relative to n.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.beam.section import Array, Indices
from fem.beam.touching_neighbours import Arcs
from fem.beam.touching_pairs import Meeting
from fem.beam.touching_points import Places, Probes, places
from fem.beam.touching_touch import Touch, along, outer, turned

PARALLEL = 1e-6  # relative curvature x thickness below which lines count as parallel
LEAST = 0.2  # relative to the thickness: lines nearer than that turn by no more


@dataclass(frozen=True)
class Past:
    """Contact partner of each slot in the last accepted state; `member` is -1 without a partner."""

    x: Array
    member: Indices
    own_arc: Array
    arc: Array
    n: Array


def past(x: Array, met: Meeting, probes: Probes, arcs: Arcs) -> Past:
    slots = 2 * len(probes.length)
    member, own_arc, arc, n = np.full(slots, -1), *np.zeros((2, slots)), np.zeros((slots, 2))
    member[met.slot] = arcs.member[met.element]
    own_arc[met.slot], _ = arcs.place(probes.element[met.slot // 2], met.eta)
    arc[met.slot], _ = arcs.place(met.element, met.xi)
    n[met.slot] = met.n
    return Past(x.copy(), member, own_arc, arc, n)


def touch(x: Array, met: Meeting, probes: Probes, arcs: Arcs, b: float, before: Past) -> Touch:
    """Gap, slip and their derivatives at the contacts `met`; sections have the thickness b."""
    probe = met.slot // 2
    own = places(x, probes.nodes[probe], met.eta)
    other = places(x, arcs.elements[met.element], met.xi)
    k, p = own.nodes.shape
    n, t = met.n, np.column_stack([met.n[:, 1], -met.n[:, 0]])
    none = np.zeros((k, p))
    own_1, other_1 = np.hstack([own.N1, none]), np.hstack([none, other.N1])
    W = np.hstack([own.N, -other.N])  # the probe less the place, of both elements' nodes
    A, B = along(W, t), along(W, n)
    C_own, C = along(own_1, n), along(other_1, n)
    limit = np.where(np.abs(met.distance) < LEAST * b, np.copysign(LEAST * b, met.distance),
                     met.distance)  # fmt: skip
    a, c = (own.slope * t).sum(axis=1), (other.slope * t).sum(axis=1)
    # the gap is stationary at both points unless they are fixed: slopes over eta and xi
    H_own, H = (
        a**2 / limit + (own.second * n).sum(axis=1) + probes.ease[probe],
        c**2 / limit - (other.second * n).sum(1),
    )
    eta, xi = _follow(
        (H_own, -a * c / limit, H),
        (A * (a / limit)[:, None] + C_own, -A * (c / limit)[:, None] - C),
        (~met.held, ~met.end), a,
    )  # fmt: skip
    psi = -(A + a[:, None] * eta - c[:, None] * xi) / limit[:, None]  # turn of n
    R = turned(np.hstack([own.N, other.N]))
    half = met.distance[:, None] / 2
    swerving = (
        outer(B, psi) + outer(along(own_1, t), eta) - outer(along(other_1, t), xi)
        + outer(R, B - met.easing[:, None] * eta) / 2
        + half[:, :, None] * (outer(turned(own_1), eta) + outer(turned(other_1), xi))
    )  # fmt: skip
    slip, (by_eta, by_xi) = _slip(x, met, (own, other), probes, arcs, b, before)
    known = before.member[met.slot] == arcs.member[met.element]
    return Touch(
        slot=met.slot,
        dofs=(3 * np.hstack([own.nodes, other.nodes])[:, :, None] + np.arange(3)).reshape(k, 6 * p),
        gap=met.distance + met.eased - b,
        opening=B,
        turning=outer(C_own, eta) - outer(C, xi) - outer(A, psi),
        sliding=A + half * R,
        swerving=swerving,
        slip=np.where(known, slip, 0.0),
        slipping=by_eta[:, None] * eta + by_xi[:, None] * xi + b / 2 * R - b * psi,
    )


def _follow(
    H: tuple[Array, Array, Array], slopes: tuple[Array, Array],
    free: tuple[NDArray[np.bool_], NDArray[np.bool_]], a: Array,
) -> tuple[Array, Array]:  # fmt: skip
    """Derivatives (k, m) of eta and xi with respect to the unknowns, zero for fixed parameters."""
    H_11, H_12, H_22 = H
    one, two = free
    # places of parallel lines diverge: there the tangent holds the probe in its place
    det = H_11 * H_22 - H_12**2
    curved = np.where(two, det - PARALLEL * H_12**2, H_11 - PARALLEL * a**2)
    one = one & (curved > 0)
    two = two & (H_22 > 0)
    H_12 = np.where(one & two, H_12, 0.0)
    H_11, H_22 = np.where(one, H_11, np.inf), np.where(two, H_22, np.inf)
    both = one & two
    inverse = 1 / np.where(both, det, 1.0)
    cross = H_12 * inverse
    eta_1, xi_2 = -1 / H_11, -1 / H_22
    eta_1[both], xi_2[both] = -(H_22 * inverse)[both], -(H_11 * inverse)[both]
    by_eta, by_xi = slopes
    eta = eta_1[:, None] * by_eta + cross[:, None] * by_xi
    return eta, cross[:, None] * by_eta + xi_2[:, None] * by_xi


def _slip(
    x: Array, met: Meeting, both: tuple[Places, Places], probes: Probes, arcs: Arcs, b: float,
    before: Past,
) -> tuple[Array, tuple[Array, Array]]:  # fmt: skip
    """Slip (k,) since the last accepted state, and its derivatives with respect to eta and xi."""
    elements = probes.element[met.slot // 2], met.element
    rotated = x[:, 2] - before.x[:, 2]
    old, slopes = before.n[met.slot], []
    turn = np.arctan2(old[:, 0] * met.n[:, 1] - old[:, 1] * met.n[:, 0], (old * met.n).sum(axis=1))
    slip = -b * turn
    for way, element, place, line, since in zip(
        (-1, 1), elements, (met.eta, met.xi), both, (before.own_arc, before.arc), strict=True
    ):
        arc, stretch = arcs.place(element, place)
        # whether the line runs along t or against it
        forward = np.sign(line.slope[:, 0] * met.n[:, 1] - line.slope[:, 1] * met.n[:, 0])
        sense = way * forward * arcs.sense[element]
        slip += sense * (arc - since[met.slot]) + b / 2 * (line.N * rotated[line.nodes]).sum(axis=1)
        slopes.append(sense * stretch + b / 2 * (line.N1 * rotated[line.nodes]).sum(axis=1))
    return slip, (slopes[0], slopes[1])
