"""Bending moment diagram of an accordion spring: Eqs. 1, 3 and 5 of Wang et al. 2023."""

import numpy as np

from analytic.spring.energy import Array, apex_moments, leaf_length


def moment_diagram(
    *, n: int, L1: float, r: float, b: float, alpha: float, per_piece: int = 9
) -> tuple[Array, Array]:
    r"""Arc lengths [length] and moments per force [length] at `per_piece` points of every piece.

    The pieces are: leaf and arc of the head; arc, leaf and arc of each middle unit; arc of the
    tail. The columns 0 and -1 of ``reshape(-1, per_piece)`` are the ends of the pieces. Both arrays
    have the shape (per_piece (3 n - 3),). With the couple T at the apex before a unit and s = +1,
    -1, ...:

    .. math::
        M/F = x, \quad L_1/2 + r\sin\theta; \qquad
        T + s r (1-\cos\theta), \quad T + s (A + x\sin\alpha), \quad
        T + s (A + L_2\sin\alpha + r(\cos(\alpha-\theta) - \cos\alpha))

    Raises ValueError for arguments that `apex_moments` rejects.

    >>> s, m = moment_diagram(n=4, L1=2.0, r=0.5, b=0.1, alpha=np.pi / 2, per_piece=3)
    >>> m[:6].round(3).tolist()
    [0.0, 0.5, 1.0, 1.0, 1.354, 1.5]
    """
    T = apex_moments(n=n, L1=L1, r=r, b=b, alpha=alpha)
    L2 = float(leaf_length(L1=L1, r=r, b=b, alpha=alpha))
    A, t = r * (1 - np.cos(alpha)), np.linspace(0, 1, per_piece)
    quarter, turn = np.pi / 2 * t, alpha * t
    lengths = [L1 / 2, r * np.pi / 2]
    moments = [L1 / 2 * t, L1 / 2 + r * np.sin(quarter)]
    for i in range(2, n):
        s, start = (1 if i % 2 else -1), T[i - 2]
        lengths += [r * alpha, L2, r * alpha]
        moments += [
            start + s * r * (1 - np.cos(turn)),
            start + s * (A + L2 * t * np.sin(alpha)),
            start + s * (A + L2 * np.sin(alpha) + r * (np.cos(alpha - turn) - np.cos(alpha))),
        ]
    lengths.append(r * np.pi / 2)
    moments.append(T[-1] + (1 if n % 2 else -1) * r * (1 - np.cos(quarter)))
    starts = np.concatenate([[0.0], np.cumsum(lengths)[:-1]])
    return (starts[:, None] + np.outer(lengths, t)).ravel(), np.concatenate(moments)
