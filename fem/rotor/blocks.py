"""Rotor in complex whirl coordinates, split into independent blocks.

At each node, r = (x + i y)/sqrt 2 and phi = (theta_y - i theta_x)/sqrt 2 rotate forwards; their
conjugate counterparts (x - i y)/sqrt 2, ... rotate backwards. On isotropic supports, forward and
backward coordinates are not coupled, and each problem has half the size. Bending, torsion and axial
motion are not coupled unless a link couples them. The change of coordinates is unitary: symmetric
matrices become Hermitian. Coupled damped rotors remain in the real unknowns of the nodes.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

from fem.rotor.assemble import System
from fem.rotor.elements import Array
from fem.rotor.parts import UNKNOWNS

Complex = NDArray[np.complex128]
Indices = NDArray[np.int64]

RIGID = 1e-13  # singular values of K on the scale of its diagonal, below which a motion is free
NONE = 1e-15  # a coupling, over the stiffness or mass of the unknowns, that is round-off
_HALF = np.sqrt(0.5)
# rows: r, conj r, z, phi, conj phi, theta_z; columns: x, y, z, theta_x, theta_y, theta_z
WHIRL = np.array([
    [_HALF, 1j * _HALF, 0, 0, 0, 0],
    [_HALF, -1j * _HALF, 0, 0, 0, 0],
    [0, 0, 1, 0, 0, 0],
    [0, 0, 0, -1j * _HALF, _HALF, 0],
    [0, 0, 0, 1j * _HALF, _HALF, 0],
    [0, 0, 0, 0, 0, 1],
])  # fmt: skip
SENSE = np.array([1, -1, 0, 1, -1, 0])
PLANE = np.array(["bending", "bending", "axial", "bending", "bending", "torsion"])


@dataclass(frozen=True)
class Block:
    """Independent block of unknowns `at`, with matrices (n, n).

    `at` are complex coordinates, or unknowns of the nodes if not `turned`. `sense` is 1 for a block
    of forward coordinates only, -1 for backward coordinates only, otherwise 0. `planes` names the
    kinds of motion in the block; `across` (n,) is True for unknowns of bending.
    """

    at: Indices
    M: NDArray[np.inexact]
    K: NDArray[np.inexact]
    C: NDArray[np.inexact]
    H: NDArray[np.inexact]  # i G, Hermitian
    sense: int
    planes: frozenset[str]
    across: NDArray[np.bool_]
    turned: bool = True

    @cached_property
    def undamped(self) -> bool:
        """True if K is Hermitian and there is no damping; all eigenvalues are then imaginary."""
        skew = abs(self.K - self.K.conj().T).max()
        return bool(not self.C.any() and skew <= 1e-14 * abs(self.K).max())

    @cached_property
    def supported(self) -> bool:
        """True if supports prevent all rigid motions across the axis."""
        across = np.flatnonzero(self.across)
        return not (across.size and rigid_motions(self.K[np.ix_(across, across)]).shape[1])

    def own(self, q: Complex) -> Complex:
        """Amplitudes (..., n) in the coordinates of this block, from amplitudes of the nodes."""
        return (to_whirl(q) if self.turned else q)[..., self.at]

    def real(self, v: NDArray[np.inexact], unknowns: int) -> Complex:
        """Amplitudes (..., unknowns) of the nodes, from amplitudes `v` (..., n) of this block."""
        whole = np.zeros((*v.shape[:-1], unknowns), complex)
        whole[..., self.at] = v
        return from_whirl(whole) if self.turned else whole


def rigid_motions(K: NDArray[np.inexact]) -> NDArray[np.inexact]:
    """Motions v (n, k) without elastic forces: K v = 0."""
    d = np.sqrt(abs(np.diag(K)))
    d[d == 0] = 1
    _, sizes, v = np.linalg.svd(K / np.outer(d, d))
    return np.asarray(v[sizes <= RIGID].conj().T / d[:, None])


def to_whirl(q: NDArray[np.inexact]) -> Complex:
    """Amplitudes (..., n) in complex coordinates, from amplitudes of the unknowns of nodes."""
    nodes = q.reshape(*q.shape[:-1], -1, UNKNOWNS)
    return np.asarray((nodes @ WHIRL.T).reshape(q.shape))


def from_whirl(q: NDArray[np.inexact]) -> Complex:
    """Amplitudes of the unknowns of nodes, from complex coordinates; inverse of `to_whirl`."""
    nodes = q.reshape(*q.shape[:-1], -1, UNKNOWNS)
    return np.asarray((nodes @ WHIRL.conj()).reshape(q.shape))


def blocks(system: System, speed: float = 0.0) -> list[Block]:
    """Independent blocks of `system`, with supports at `speed` [rad/s]."""
    K, C = system.at(speed)
    M_w, K_w, C_w, G_w = (_turned(A) for A in (system.M, K, C, system.G))
    linked = np.zeros(M_w.shape, bool)
    for A in (M_w, K_w, C_w, G_w):
        own = np.sqrt(abs(np.diag(A)))
        scale = np.maximum(np.outer(own, own), NONE * abs(A).max())
        linked |= abs(A) > NONE * scale
    count, of = connected_components(linked, directed=False)
    nodes = M_w.shape[0] // UNKNOWNS
    sense, plane = np.tile(SENSE, nodes), np.tile(PLANE, nodes)
    made = []
    for k in range(count):
        at = np.flatnonzero(of == k)
        turns = set(sense[at].tolist())
        M, own_K, own_C, H = (_plain(A[np.ix_(at, at)]) for A in (M_w, K_w, C_w, 1j * G_w))
        block = Block(
            at, M, own_K, own_C, H, sense=turns.pop() if len(turns) == 1 else 0,
            planes=frozenset(plane[at].tolist()), across=plane[at] == "bending",
        )  # fmt: skip
        if block.sense == 0 and not block.undamped and set(at) == set(_partner(at)):
            M, own_K, own_C, H = (A[np.ix_(at, at)] for A in (system.M, K, C, 1j * system.G))
            block = Block(at, M, own_K, own_C, H, 0, block.planes, block.across, turned=False)
        made.append(block)
    return made


def _partner(at: Indices) -> Indices:
    """Unknowns conjugate to `at`; an unknown and its conjugate belong to the same node."""
    return at + np.tile([1, -1, 0, 1, -1, 0], at.max() // UNKNOWNS + 1)[at]


def _turned(A: Array) -> Complex:
    n = A.shape[0] // UNKNOWNS
    cells = A.reshape(n, UNKNOWNS, n, UNKNOWNS)
    left = np.tensordot(cells, WHIRL, axes=(1, 1))  # n, n, 6, a
    both = np.tensordot(left, WHIRL.conj(), axes=(2, 1))  # n, n, a, b
    return np.asarray(both.transpose(0, 2, 1, 3).reshape(A.shape))


def _plain(A: Complex) -> NDArray[np.inexact]:
    """Real part if the imaginary part is zero, which halves the work; otherwise `A`."""
    return A.real.copy() if abs(A.imag).max(initial=0) <= NONE * abs(A).max(initial=0) else A
