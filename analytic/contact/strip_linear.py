r"""Newton's linear systems for many cases of strips: J ds - dDelta = -g on the loaded strips.

J is the sum of the logarithmic influence of all strips (one matrix for all cases), of bands of near
strips (which differ between cases) and of a diagonal. `conjugate_gradients` does not form J. It
replaces the bands by symmetric ones, which neglects a part of the change of half-width from strip
to strip. A projection conserves the sum of the loads. `direct` forms and uses the full matrix.
"""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array

STEPS = 5  # of conjugate gradients: 1e-3 left, as Newton's next iteration needs
PRODUCT = 1_000_000  # multiplications of one call of BLAS

Mask = NDArray[np.bool_]
Single = NDArray[np.float32]
Real = TypeVar("Real", Array, Single)


@dataclass(frozen=True)
class System:
    """Linear system of a Newton step; `push` is -g on the loaded strips, shape (N, n).

    `far` are matrices (n, n) shared by all cases; `bands` has the shape (M, N, n), and its first
    band is the diagonal. `carries` (N, n) marks the loaded strips. `missing` (N,) is the remaining
    error of the load, or None if the approach is given.
    """

    far: tuple[Array, ...]
    bands: Array
    s: Array
    push: Array
    carries: Mask
    missing: Array | None


def direct(system: System) -> tuple[Array, Array]:
    """Newton steps of the loads (N, n) and of the approach (N,), by elimination."""
    J, push = _dense(system), system.push
    if system.missing is None:
        return np.asarray(np.linalg.solve(J, push[..., None])[..., 0]), np.zeros(len(push))
    both = np.linalg.solve(J, np.stack([push, system.carries.astype(np.float64)], axis=-1))
    sums = both.sum(axis=1)
    rise = np.asarray((system.missing - sums[:, 0]) / sums[:, 1])
    return np.asarray(both[..., 0] + rise[:, None] * both[..., 1]), rise


def product(x: Real, matrix: Real) -> Real:
    """Product `x @ matrix`, in blocks that a BLAS computes in the calling thread.

    Threads that each used a multi-threaded BLAS took twenty times as long.
    """
    out = np.empty((len(x), matrix.shape[1]), dtype=x.dtype)
    rows = max(1, PRODUCT // matrix.size)
    for i in range(0, len(x), rows):
        np.matmul(x[i : i + rows], matrix, out=out[i : i + rows])
    return out


def conjugate_gradients(system: System) -> tuple[Array, Array]:
    """Newton steps of the loads (N, n) and of the approach (N,), to a relative error of about 1e-3.

    The systems are scaled to a right-hand side of 1 and solved in single precision; higher accuracy
    is not needed.
    """
    single, n = np.float32, system.s.shape[-1]
    free = system.missing is None
    missing = np.zeros(len(system.s)) if system.missing is None else system.missing
    scale = np.maximum(np.abs(system.push).max(axis=-1), np.abs(missing))
    scale[scale == 0] = 1.0
    own, s = system.bands[0].astype(single), system.s.astype(single)
    inverse = np.where(system.carries, 1 / own, single(0))
    share = inverse / inverse.sum(axis=-1, keepdims=True)
    constant, linear = (matrix.astype(single) for matrix in _shared(system))
    both = np.hstack([constant, linear])

    def apply(x: Single) -> Single:
        image = product(x, both)
        out = product(s * x, linear)
        out += image[:, :n]
        out += s * image[:, n:]
        out += own * x
        return out

    residual = (system.push / scale[:, None]).astype(single)
    step = share * (missing / scale).astype(single)[:, None]
    if missing.any():
        residual -= apply(step)
    direction, old = step, np.ones(len(s), dtype=single)
    for count in range(STEPS):
        z = inverse * residual
        if not free:
            z -= share * z.sum(axis=-1)[:, None]
        new = np.einsum("cj,cj->c", z, residual)
        direction = z if count == 0 else z + (new / old)[:, None] * direction
        image = apply(direction)
        work = np.einsum("cj,cj->c", direction, image)
        along = (new / np.where(work > 0, work, single(np.inf)))[:, None]
        step += along * direction
        image *= along
        residual -= image
        old = np.where(new > 0, new, single(np.inf))
    rise = -(share * residual).sum(axis=-1) * scale
    return step * scale[:, None], np.zeros(len(s)) if free else rise


def _shared(system: System) -> tuple[Array, Array]:
    """Matrices A, B (n, n) of J_jk = A_jk + B_jk s_k off the diagonal, fitted to the bands."""
    far, bands, s = system.far, system.bands, system.s
    n = s.shape[-1]
    constant, linear = far[0].copy(), 2 * far[1] if len(far) > 1 else np.zeros((n, n))
    mean = s.mean()
    spread = s - mean
    slopes = np.tensordot(bands[1:], spread, 2) / max(float((spread**2).sum()), 1e-300)
    for m, (level, slope) in enumerate(
        zip(bands[1:].mean(axis=(1, 2)), slopes, strict=True), start=1
    ):
        for matrix, value in ((constant, level - slope * mean), (linear, slope)):
            flat = matrix.reshape(-1)
            flat[m * n :: n + 1] += value
            flat[m : n * (n - m) : n + 1] += value
    return constant, linear / 2


def _dense(system: System) -> Array:
    """Matrices J (N, n, n); strips without load have a very large diagonal element."""
    far, bands = system.far, system.bands
    _, cases, n = bands.shape
    J = np.empty((cases, n, n))
    J[:] = far[0]
    if len(far) > 1:
        J += 2 * far[1] * system.s[:, None, :]
    flat = J.reshape(cases, n * n)
    for m in range(1, len(bands)):
        flat[:, m * n :: n + 1] += bands[m, :, :-m]
        flat[:, m : n * (n - m) : n + 1] += bands[m, :, m:]
    flat[:, :: n + 1] = np.where(system.carries, bands[0], 1e30)
    return J
