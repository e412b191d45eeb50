"""Critical speeds without a Campbell diagram, from omega = e Omega in the equations of motion.

K v = omega^2 (M - i G/e) v is solved as an eigenvalue problem for mu = 1/omega^2, because K is
positive definite. M - i G/e may be indefinite: a thin disc can stiffen its shaft so much that a
forward critical speed no longer exists. Negative mu are not critical speeds.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from fem.rotor.blocks import Block, Complex, rigid_motions
from fem.rotor.branches import check_count, whirl_sense
from fem.rotor.elements import Array
from fem.rotor.model import Rotor
from fem.rotor.modes import normalised

WHIRLS = {"forward": (1,), "backward": (-1,), "both": (1, 0, -1)}
ABSENT = 1e-13  # 1/omega^2 over the largest, below which no speed is left


@dataclass(frozen=True)
class CriticalSpeeds:
    """Critical speeds (k,) [rad/s], ascending; shapes (k, nodes, 6) and sense of whirl (k,)."""

    speeds: Array
    shapes: Complex
    whirl: NDArray[np.int64]


def critical_speeds(
    rotor: Rotor, count: int = 4, whirl: str = "forward", excitation: float = 1.0
) -> CriticalSpeeds:
    """Speeds [rad/s] of the rotor at which `excitation` times the speed is a natural frequency.

    `whirl` is "forward", "backward" or "both". On anisotropic supports, each mode whirls in one of
    the two senses; "both" also includes modes that oscillate in a line. The sense of whirl is
    relative to a positive speed of the rotor. Damping is neglected. For the unbalance of a shaft
    with another speed ratio, `excitation` is this ratio. The result has fewer than `count` speeds
    if no more exist. Raises ValueError for supports that depend on the speed, and for a rotor
    without sufficient supports.
    """
    check_count(count)
    if whirl not in WHIRLS:
        raise ValueError(f"whirl must be one of {', '.join(WHIRLS)}, got {whirl!r}")
    if not (np.isfinite(excitation) and excitation != 0):
        raise ValueError(f"excitation must be a finite ratio other than 0, got {excitation:g}")
    if rotor.system.varying:
        raise ValueError(
            "critical speeds require supports that do not depend on the speed: "
            "use the crossings of `campbell`"
        )
    speeds, shapes = [], []
    for block in rotor.blocks:
        if "bending" in block.planes:
            own, v = _of_block(block, excitation)
            speeds.append(own)
            shapes.append(block.real(v, rotor.system.M.shape[0]))
    found, shape = np.concatenate(speeds), np.concatenate(shapes)
    sense = whirl_sense(shape) * int(np.sign(excitation))
    order = [k for k in np.argsort(found, kind="stable") if sense[k] in WHIRLS[whirl]][:count]
    return CriticalSpeeds(found[order], normalised(shape[order]), sense[order])


def check_supported(block: Block) -> None:
    """Raise ValueError if the rotor can move rigidly across its axis."""
    if not block.supported:
        raise ValueError(
            "the rotor can move rigidly across its axis: support the rotor against this motion"
        )


def _of_block(block: Block, excitation: float) -> tuple[Array, Complex]:
    """Critical speeds (k,) and vectors v (k, n) of a block; A v is orthogonal to rigid motions."""
    check_supported(block)
    K, A = block.K, block.M - block.H / excitation
    if abs(K - K.conj().T).max() > 1e-12 * abs(K).max():
        raise ValueError(
            "cross-coupled supports (kxy != kyx) have no undamped critical speeds: "
            "use the crossings of `campbell`"
        )
    free = rigid_motions(K)
    Z = np.linalg.qr(A @ free, mode="complete")[0][:, free.shape[1] :]
    mu, y = eigh(_hermitian(Z.conj().T @ A @ Z), _hermitian(Z.conj().T @ K @ Z))
    real = np.flatnonzero(mu > ABSENT * abs(mu).max())
    return 1 / (np.sqrt(mu[real]) * abs(excitation)), (Z @ y[:, real]).T


def _hermitian(A: NDArray[np.inexact]) -> NDArray[np.inexact]:
    return np.asarray((A + A.conj().T) / 2)
