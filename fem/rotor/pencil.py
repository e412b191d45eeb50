"""Eigenvalues of (lambda^2 M + lambda (C + Omega G) + K) v = 0 for many speeds at once.

Undamped problems: lambda = i omega, with Hermitian K, M and H = i G. With mu = 1/omega,

    mu^2 K v = M v - mu Omega H v.

In the coordinates of the modes at zero speed, K becomes the unit matrix and M becomes diag b^2. The
problem is then the Hermitian standard problem

    [[-Omega H, b], [b, 0]] [v; w] = mu [v; w].

This form requires a positive definite K and permits unknowns without mass. If K permits a rigid
motion, the problem for omega has the same form, with M in the place of K. All other problems,
damped or with an asymmetric K, are linearised in the same two forms and solved by a general solver.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, eigh, solve_triangular

from fem.rotor.blocks import Block, Complex, Indices, rigid_motions
from fem.rotor.elements import Array

STILL = 1e-6  # relative to a state, below which it has no motion
NUDGE = 1e-13  # off an eigenvalue, so that its matrix can be factorised
ABSENT = 1e-14  # eigenvalues of the second matrix, over the largest, that are zero


@dataclass(frozen=True)
class Spectrum:
    """Eigenvalues (speeds, k), and a function `take` that returns eigenvectors at one speed.

    `take(i, at)` returns the vectors (n, j) and states (m, j) of the eigenvalues with the numbers
    `at` at the speed with the number `i`. States have length 1 and are orthonormal for undamped
    problems. Their products show which eigenvalues at two speeds belong to the same branch.
    """

    values: Complex
    take: Callable[[int, Indices], tuple[NDArray[np.inexact], NDArray[np.inexact]]]


def spectrum(block: Block, speeds: Array) -> Spectrum:
    """All eigenvalues of `block` at every speed [rad/s], including infinite eigenvalues."""
    if block.undamped:
        return _undamped(block, speeds)
    return _general(block, speeds)


def _undamped(block: Block, speeds: Array) -> Spectrum:
    held = not rigid_motions(block.K).shape[1]
    A, B = (block.K, block.M) if held else (block.M, block.K)
    try:
        lower = cholesky(A, lower=True)
    except np.linalg.LinAlgError:
        raise ArithmeticError(
            "the stiffness matrix of the rotor is not positive definite: check supports and links"
            if held
            else "unknowns without mass are left free: add supports or masses for these unknowns"
        ) from None
    inner = solve_triangular(lower, solve_triangular(lower, B, lower=True).conj().T, lower=True)
    squares, turn = eigh((inner + inner.conj().T) / 2)
    if squares[0] < -1e-9 * squares[-1]:
        raise ArithmeticError(
            "the stiffness and mass matrices of the rotor must not have negative eigenvalues: "
            "check the coefficients of links and supports, and the masses"
        )
    b = np.sqrt(np.where(squares > ABSENT * squares[-1], squares, 0.0))
    half = solve_triangular(lower, block.H, lower=True)
    H = solve_triangular(lower, half.conj().T, lower=True)
    H = (-1 if held else 1) * (turn.conj().T @ H @ turn)
    n = b.size
    S = np.zeros((speeds.size, 2 * n, 2 * n), H.dtype)
    S[:, range(n), range(n, 2 * n)] = S[:, range(n, 2 * n), range(n)] = b
    S[:, :n, :n] = speeds[:, None, None] * H
    values, states = np.linalg.eigh(S)
    back = solve_triangular(lower, turn, lower=True, trans="C")

    def take(i: int, at: Indices) -> tuple[NDArray[np.inexact], NDArray[np.inexact]]:
        own = states[i][:, at]
        v, w = own[:n], own[n:]
        rests = np.linalg.norm(v, axis=0) < STILL  # a rigid motion
        return back @ np.where(rests, w, v), own

    return Spectrum(_imaginary(_inverse(values) if held else values), take)


def _general(block: Block, speeds: Array) -> Spectrum:
    held = not rigid_motions(block.K).shape[1]
    n = block.K.shape[0]
    A, B = (block.K, block.M) if held else (block.M, block.K)
    try:
        rest = np.linalg.solve(A, np.hstack([block.C, _gyroscopic(block), B]))
    except np.linalg.LinAlgError:
        raise ArithmeticError(
            "every unknown without mass must be supported: add a support or a mass"
        ) from None
    C, G, B = rest[:, :n], rest[:, n : 2 * n], rest[:, 2 * n :]
    S = np.zeros((speeds.size, 2 * n, 2 * n), rest.dtype)
    S[:, :n, :n] = -(C + speeds[:, None, None] * G)
    S[:, :n, n:] = -B
    S[:, range(n, 2 * n), range(n)] = 1
    values: Complex = np.linalg.eigvals(S).astype(complex)
    if held:
        values = np.where(_vanishing(values), complex(0, np.inf), 1 / _nonzero(values))
    scale = np.sqrt(abs(np.diag(block.K)) + abs(np.diag(block.M)))[:, None]

    def take(i: int, at: Indices) -> tuple[Complex, Complex]:
        v = _null_vectors(block, float(speeds[i]), values[i, at])
        own = scale * v
        return v, own / np.linalg.norm(own, axis=0)

    return Spectrum(values, take)


def _null_vectors(block: Block, speed: float, values: Complex) -> Complex:
    """Eigenvectors (n, k) for known eigenvalues, by one step of inverse iteration.

    The matrix is singular to round-off. Therefore one step leaves a relative error of the order of
    `NUDGE` divided by the distance of the eigenvalues.
    """
    size = max(abs(values).max(), 1.0)
    lam = (values + NUDGE * (abs(values) + NUDGE * size))[:, None, None]
    d = np.sqrt(abs(np.diag(block.K)) + np.mean(abs(values)) ** 2 * abs(np.diag(block.M)))
    D = (block.C + speed * _gyroscopic(block)) / np.outer(d, d)
    P = lam * (lam * (block.M / np.outer(d, d)) + D) + block.K / np.outer(d, d)
    v = np.random.default_rng(0).standard_normal((values.size, d.size, 1)) + 0j
    v = np.linalg.solve(P, v)[:, :, 0]
    return np.asarray((v / np.linalg.norm(v, axis=1, keepdims=True) / d).T)


def _gyroscopic(block: Block) -> NDArray[np.inexact]:
    """Gyroscopic matrix G = -i H, real if possible."""
    G = -1j * block.H
    return G if G.imag.any() else G.real


def _inverse(mu: Array) -> Array:
    return np.where(_vanishing(mu), np.inf, 1 / _nonzero(mu))


def _vanishing(mu: NDArray[np.inexact]) -> NDArray[np.bool_]:
    """True where 1/mu is an infinite eigenvalue, which belongs to unknowns without mass."""
    return np.asarray(abs(mu) <= ABSENT * abs(mu).max(axis=-1, keepdims=True))


def _nonzero(mu: NDArray[np.inexact]) -> NDArray[np.inexact]:
    return np.where(_vanishing(mu), 1, mu)


def _imaginary(omega: Array) -> Complex:
    values = np.zeros(omega.shape, complex)
    values.imag = omega
    return values
