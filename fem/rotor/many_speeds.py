"""Responses at many speeds by one diagonalisation, instead of one factorisation per speed.

If the frequency of forces is a constant multiple of the speed, omega = rho Omega, the matrix of a
block is

    D = K + i omega C - omega^2 A,  A = M - H / rho.

The modes V of A v = mu K v, with V^H K V = 1, make all terms diagonal except the damping. The
damping of bearings has a low rank, C = P Q^H:

    V^H D V = d + i omega (V^H P) (V^H Q)^H,  d = 1 - omega^2 mu.

With Woodbury's formula, only systems of the size of this rank must be solved. Then one correction
with the residual of D follows; the size of this correction indicates whether the result is as
accurate as a direct solution.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from fem.rotor.blocks import Block, Complex
from fem.rotor.elements import Array

RATIO = 1e-14  # omega / Omega of speeds that are in one ratio differ by less
SKEW = 1e-14  # relative asymmetry of K that counts as symmetric
RANK = 1e-14  # singular values of C, over the largest, that are round-off
SPARSE = 4  # times the rank of C may fit into the unknowns: beyond, little is saved
NEAR = 1e-6  # |d| of an undamped resonance, where the terms of the formula cancel
GOOD = 1e-8  # relative to the motion: a larger correction leaves more than round-off behind


@dataclass(frozen=True)
class Diagonal:
    """Modes of a block: shapes `V` (n, n), eigenvalues `mu` (n,), and damping C of the modes.

    The eigenvalues satisfy A V = K V diag(mu). C is `left` (n, r) times `right` (n, r)^H.
    """

    block: Block
    A: NDArray[np.inexact]
    V: NDArray[np.inexact]
    mu: Array
    left: NDArray[np.inexact]
    right: NDArray[np.inexact]

    @classmethod
    def of(cls, block: Block, speeds: Array, omega: Array) -> Self | None:
        """Modes of `block` for `speeds` and frequencies `omega` (m,); None if not applicable.

        The method is applicable if the ratio of frequency to speed is constant, K is Hermitian and
        prevents all rigid motions, and C has a low rank.
        """
        ratio = _ratio(speeds, omega)
        skew = abs(block.K - block.K.conj().T).max()
        if ratio is None or skew > SKEW * abs(block.K).max():
            return None
        U, size, W = np.linalg.svd(block.C)
        rank = int((size > RANK * size[0]).sum()) if size[0] else 0
        if SPARSE * rank > size.size:
            return None
        A = block.M - block.H / ratio
        try:
            mu, V = eigh(A, block.K)
        except np.linalg.LinAlgError:  # a motion without any support
            return None
        turned = V.conj().T
        left, right = turned @ (U[:, :rank] * size[:rank]), turned @ W[:rank].conj().T
        return cls(block, A, V, mu, left, right)

    def solve(self, omega: Array, f: Complex) -> tuple[Complex, NDArray[np.bool_]]:
        """Amplitudes (m, n) under `f` (m, n) at `omega` (m,), and mask (m,) of accurate results."""
        square, C = omega[:, None] ** 2, 1j * omega[:, None]
        q = self._decoupled(omega, f @ self.V.conj())
        u = q @ self.V.T
        D_u = u @ self.block.K.T - square * (u @ self.A.T)
        if self.left.size:
            D_u += C * (u @ self.block.C.T)
        more = self._decoupled(omega, (f - D_u) @ self.V.conj())
        sizes = np.linalg.norm(more, axis=1), np.linalg.norm(q, axis=1)
        is_regular = abs(1 - square * self.mu).min(axis=1) > NEAR
        return u + more @ self.V.T, is_regular & (sizes[0] <= GOOD * sizes[1])

    def _decoupled(self, omega: Array, f: Complex) -> Complex:
        """Amplitudes (m, n) of the modes under `f` (m, n)."""
        d = 1 - omega[:, None] ** 2 * self.mu
        d[abs(d) <= NEAR] = NEAR  # not taken
        q, rank = f / d, self.left.shape[1]
        if not rank:
            return np.asarray(q)
        pairs = self.right.conj()[:, :, None] * self.left[:, None]
        small = 1j * omega[:, None] * ((1 / d) @ pairs.reshape(-1, rank**2))
        small = small.reshape(-1, rank, rank) + np.eye(rank)
        drag = np.linalg.solve(small, (q @ self.right.conj())[..., None])[..., 0]
        return np.asarray(q - 1j * omega[:, None] * (drag @ self.left.T) / d)


def _ratio(speeds: Array, omega: Array) -> float | None:
    """Ratio omega / speeds if it is the same for all speeds and not zero, otherwise None."""
    fastest = int(np.argmax(abs(speeds)))
    if not speeds[fastest] or not omega[fastest]:
        return None
    ratio = float(omega[fastest] / speeds[fastest])
    return ratio if np.all(abs(omega - ratio * speeds) <= RATIO * abs(omega)) else None
