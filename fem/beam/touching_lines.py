r"""Gap and slip between a probe on one line and the nearest place of another.

With the probe x_s, the nearest place x_m(xi) and n from there to it, both surfaces half a
thickness off their lines:

.. math:: g = n\cdot(x_s - x_m) - b, \qquad
   \dot s = t\cdot(\dot x_s - \dot x_m) + \tfrac{l}{2}(\dot\phi_s + \dot\phi_m), \quad l = g + b

Over a step the slip is measured by what no rigid rotation changes: the arc length passed on the
other line and the turns of both sections against n.
"""

from dataclasses import dataclass

import numpy as np

from fem.beam.section import Array, Indices
from fem.beam.touching_neighbours import Arcs
from fem.beam.touching_pairs import Meeting
from fem.beam.touching_points import Probes, shapes
from fem.beam.touching_touch import Touch, along, outer, turned

LEAST = 0.2  # of the thickness: lines nearer than that turn by no more


@dataclass(frozen=True)
class Past:
    """Every slot's partner at the last accepted state: -1 where there was none."""

    x: Array
    member: Indices
    arc: Array
    n: Array


def past(x: Array, met: Meeting, slots: int, arcs: Arcs) -> Past:
    member, arc, n = np.full(slots, -1), np.zeros(slots), np.zeros((slots, 2))
    member[met.slot] = arcs.member[met.element]
    arc[met.slot], _ = arcs.place(met.element, met.xi)
    n[met.slot] = met.n
    return Past(x.copy(), member, arc, n)


def touch(x: Array, met: Meeting, probes: Probes, arcs: Arcs, b: float, before: Past) -> Touch:
    """Gap, slip and their slopes at the places `met`; sections are `b` thick."""
    probe = met.slot // 2
    slave, nodes = probes.nodes[probe], arcs.elements[met.element]
    p, k = nodes.shape[1], len(nodes)
    N, N1, N2 = shapes(met.xi, p)
    none = np.zeros_like(N)
    W = np.hstack([probes.shape[probe], -N])  # the probe less the place, of both elements' nodes
    W1 = np.hstack([none, N1])
    own = x[nodes]
    x1 = np.einsum("kp,kpd->kd", N1, own[:, :, :2])
    x2 = np.einsum("kp,kpd->kd", N2, own[:, :, :2])
    n, t = met.n, np.column_stack([met.n[:, 1], -met.n[:, 0]])
    apart = met.distance
    stretch = np.einsum("kd,kd->k", x1, t)
    H = stretch**2 - apart * np.einsum("kd,kd->k", n, x2)
    A, B, C = along(W, t), along(W, n), along(W1, n)
    xi = np.where(met.end, 0.0, 1 / H)[:, None] * (stretch[:, None] * A + apart[:, None] * C)
    near = np.where(np.abs(apart) < LEAST * b, np.copysign(LEAST * b, apart), apart)[:, None]
    psi = -(A - stretch[:, None] * xi) / near  # turn of n
    R = turned(np.hstack([probes.shape[probe], N]))
    turns = np.hstack([none, N1])
    half = apart[:, None] / 2
    sliding = A + half * R
    swerving = (
        outer(B, psi) - outer(along(W1, t), xi) + outer(R, B) / 2
        + half[:, :, None] * outer(turned(turns), xi)
    )  # fmt: skip
    slip, slipping = _slip(x, met, arcs, before, b, slave, nodes, (probes.shape[probe], N, N1))
    dofs = (3 * np.hstack([slave, nodes])[:, :, None] + np.arange(3)).reshape(k, 6 * p)
    sense, bend = slipping
    S = sense[:, None] * xi + b / 2 * (R + bend[:, None] * xi) - b * psi
    return Touch(
        met.slot, dofs, apart - b, B, -outer(A, psi) - outer(C, xi), sliding, swerving,
        np.where(before.member[met.slot] == arcs.member[met.element], slip, 0.0), S,
    )  # fmt: skip


def _slip(
    x: Array, met: Meeting, arcs: Arcs, before: Past, b: float, slave: Indices, nodes: Indices,
    shape: tuple[Array, Array, Array],
) -> tuple[Array, tuple[Array, Array]]:  # fmt: skip
    """Slip (k,) since the last accepted state; its slope by xi: of the arc, of the turns."""
    of_probe, N, N1 = shape
    arc, stretch = arcs.place(met.element, met.xi)
    nodes_now = x[nodes]
    x1 = np.einsum("kp,kpd->kd", N1, nodes_now[:, :, :2])
    forward = np.sign(x1[:, 0] * met.n[:, 1] - x1[:, 1] * met.n[:, 0])  # x1 along t or against
    sense = forward * arcs.sense[met.element]
    rotated = x[:, 2] - before.x[:, 2]
    old = before.n[met.slot]
    turn = np.arctan2(old[:, 0] * met.n[:, 1] - old[:, 1] * met.n[:, 0], (old * met.n).sum(axis=1))
    sections = (of_probe * rotated[slave]).sum(axis=1) + (N * rotated[nodes]).sum(axis=1)
    slip = sense * (arc - before.arc[met.slot]) + b / 2 * (sections - 2 * turn)
    return slip, (sense * stretch, (N1 * rotated[nodes]).sum(axis=1))
