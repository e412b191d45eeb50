r"""Accordion spring before and after its free tips touch: stages OA and AB of its curve.

Head and tail are whole leaves of the length L_1 = 2a. The half of the head leaf beyond the force is
free until its tip touches the next leaf (point A). The tail behaves in the same manner if it is
fixed in its middle. A pair in contact is a rigid link without friction, so that force over
displacement is piecewise linear. With the couple M per unit force at O and the couple m per unit
force between tip and leaf,

.. math::
    J = \int M^2 ds, \quad f_{FC} = \int M\,m\,ds, \quad f_{CC} = \int m^2 ds

    k_1 = \frac{EI}{J}, \quad F_A = \frac{g_0 EI}{f_{FC}}, \quad U_A = \frac{F_A}{k_1}, \quad
    k_2 = \frac{EI}{J - p f_{FC}^2/f_{CC}}

for p pairs that close simultaneously. F_A follows from the condition that F closes the gap. The
contact force F f_FC/f_CC, which keeps the gap closed, reduces the compliance by p f_FC^2/f_CC;
hence k_2.

For a free head, M = y, and m = y + a if the force between tip and leaf acts along x. With R the
radius of the arcs, beta = pi/2 + alpha, y_t = a + R cos(alpha) and straight leaves between the
arcs,

.. math::
    g_0 = R(1 + \sin\alpha) + \frac{y_t + a}{\tan\alpha} - \frac b2 \Big(1 + \frac1{\sin\alpha}\Big)

    f_{FC} = \frac{5 a^3}6 + R\Big[2a^2\beta + 3aR(1 - \cos\beta) + R^2\Big(\frac\beta2
        - \frac{\sin 2\beta}4\Big)\Big] + \frac{1}{\sin\alpha}\Big[\frac{y_t^3 + a^3}3
        + a\frac{y_t^2 - a^2}2\Big]

    f_{CC} = \frac{8 a^3}{3} + R\Big[4a^2\beta + 4aR(1 - \cos\beta) + R^2\Big(\frac\beta2
        - \frac{\sin 2\beta}4\Big)\Big] + \frac{(y_t + a)^3}{3 \sin\alpha}

with the contributions of the free half (only f_CC: a^3/3), the other half, the arc above and the
leaf down to y = -a. Both loops are equal, and the line of the force passes through both clamps.
Therefore, a tail that is fixed in its middle touches simultaneously with the head.

For a guided head, the couple and the lateral force of the guide in P = (F_x, F_y, M_0) follow from
zero rotation and zero lateral displacement. They are not zero. For even n, one side of the force
has one loop more than the other. The mean height S/L = int y ds/int ds is then not zero, and
M = y - S/L, k_1 = EI/(J - S^2/L). For odd n, the lateral force has a similar effect. The integrals
above become entries of a matrix, and the supported displacements are eliminated:

.. math:: E I\,d = A\,X, \quad X = (F_x, F_y, M_0, C_h, C_t), \quad A_{jk} = w_j^T G\, w_k

with the second moments G of `analytic.spring.wire`. By symmetry, head and tail also touch
simultaneously. A spring with a hinged head is not symmetric: its tips touch one after the other.

Direction of the force between tip and leaf: the angle between unloaded leaves and the head is 90
deg - alpha. But the loop of the head closes by rotation, and at A the leaf ahead of the tip is
nearly parallel to the head (`Stages.tilt`, within 2 deg for the spring of the paper). Therefore,
the normal at A has the direction of the force of the spring: `normal="force"`. With "leaf", the
normal of the unloaded leaf is used.

Range: small displacements, thin strip, no friction. For the spring of the paper, U_A is half of the
free length. Therefore, the result is a linear reference, not a prediction of the true curve.

References
----------
.. [1] Wang et al., Trans. Nanjing Univ. Aeronaut. Astronaut. 40 (2023) 264-272, Eq. 10: lines
   fitted to finite elements.
"""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.spring.loops import Array, Normal, Tail, line
from analytic.spring.redundant import END_COUPLES, Theory, compliances, response, turn

Head = Literal["free", "hinged", "guided"]

HELD = {"free": [], "hinged": [1], "guided": [1, 2]}
AT_ONCE = 1e-9  # relative: two tips that symmetry closes together


@dataclass(frozen=True)
class Stages:
    """Piecewise linear force-displacement curves; all arrays have the common shape of the inputs.

    The stiffness is `k1` [force/length] up to (`U_A`, `F_A`), where the first tip touches, then
    `k2` up to (`U_B`, `F_B`), where the second tip touches, then `k3`. If both tips touch
    simultaneously, B = A and k3 = k2. Displacements and forces are infinite if no tip touches.
    `top_couple` [force x length] is the couple at A at the apex of the most loaded loop, `tilt`
    [rad] the remaining angle at A between the first tip and the leaf that it touches, `gap`
    [length] the initial gap of this tip.
    """

    k1: Array
    U_A: Array
    F_A: Array
    k2: Array
    U_B: Array
    F_B: Array
    k3: Array
    gap: Array
    tilt: Array
    top_couple: Array

    @property
    def intercept(self) -> Array:
        """Force [force] at which the extended second line intersects U = 0; negative if k2 > k1."""
        return np.asarray(self.F_A - self.k2 * self.U_A)

    def force(self, U: ArrayLike) -> Array:
        """Force [force] at the displacement U [length]."""
        U = np.asarray(U, float)
        second = np.where(U > self.U_A, self.F_A + self.k2 * (U - self.U_A), self.k1 * U)
        return np.where(U > self.U_B, self.F_B + self.k3 * (U - self.U_B), second)

    def displacement(self, F: ArrayLike) -> Array:
        """Displacement [length] under the force F."""
        F = np.asarray(F, float)
        second = np.where(F > self.F_A, self.U_A + (F - self.F_A) / self.k2, F / self.k1)
        return np.where(F > self.F_B, self.U_B + (F - self.F_B) / self.k3, second)


def gap(*, L1: ArrayLike, radius: ArrayLike, b: ArrayLike, alpha: ArrayLike) -> Array:
    r"""Gap g_0 [length] along the force between the corner of a tip and the face of the next leaf.

    .. math:: g_0 = R(1 + \sin\alpha) + \frac{L_1 + R\cos\alpha}{\tan\alpha}
        - \frac b2 \Big(1 + \frac1{\sin\alpha}\Big)

    >>> round(float(gap(L1=11.6, radius=0.5, b=0.1, alpha=np.radians(80))), 3)
    2.952
    """
    L1, R, b, alpha = (np.asarray(v, float) for v in (L1, radius, b, alpha))
    sin, tan = np.sin(alpha), np.tan(alpha)
    return np.asarray(R * (1 + sin) + (L1 + R * np.cos(alpha)) / tan - b / 2 * (1 + 1 / sin))


def stages(
    *,
    n: int,
    b: ArrayLike,
    h: ArrayLike,
    radius: ArrayLike,
    L1: ArrayLike,
    alpha: ArrayLike,
    E: ArrayLike,
    nu: ArrayLike = 0.3,
    width_factor: ArrayLike = 1.0,
    head: Head = "guided",
    tail: Tail = "mid-leaf",
    leaf: ArrayLike | None = None,
    theory: Theory = "bending",
    normal: Normal = "force",
) -> Stages:
    """Stages of springs with n segments; all arguments except n may be arrays, which broadcast.

    Parameters
    ----------
    radius, leaf
        Radius of the centre line of the arcs (r + b/2, or r as in the paper), and straight
        length of the middle units; by default, the spring is symmetric.
    width_factor
        Factor of E I: 1 for a narrow strip, 1/(1 - nu^2) for a wide one. No effect on U_A.
    head
        "free" (lateral motion and rotation), "hinged" (rotation only) or "guided" (neither).
    tail
        "mid-leaf": clamped in the middle of its leaf. "arc": its whole leaf is clamped, up to the
        arc.
    theory
        "bending"; "thin" adds the axial strain, "shear" also adds 6/5 V^2/(G A).
    normal
        Direction of the force between tip and leaf: that of the "force" of the spring, or the
        normal of the unloaded "leaf".

    Raises
    ------
    ValueError
        If the geometry or the material is impossible.

    >>> paper = dict(n=10, b=0.1, h=56, radius=0.5, L1=11.6, alpha=np.radians(80), E=206e3)
    >>> s = stages(**paper, head="free")
    >>> [round(float(v), 3) for v in (s.k1, s.F_A, s.U_A, s.k2)]  # N/mm, N, mm, N/mm
    [0.56, 6.934, 12.383, 0.661]
    """
    L1, R, b, h, alpha, E, nu, factor = _checked(n, L1, radius, b, h, alpha, E, nu, width_factor)
    straight = (L1 + 2 * R * np.cos(alpha)) / np.sin(alpha) if leaf is None else leaf
    shape = line(n=n, L1=L1, radius=R, alpha=alpha, b=b, straight=straight, tail=tail,
                 normal=normal)  # fmt: skip
    A = compliances(shape, b, nu, theory)
    free = response(A, HELD[head], ())
    gaps = np.stack([shape.head.gap, shape.tail.gap], axis=-1)
    alone = _until(gaps, free.rates)  # if the other tip stays open
    first = np.argmin(alone, axis=-1)
    F_A = alone.min(axis=-1)
    rest = np.maximum(gaps - F_A[..., None] * free.rates, 0.0)
    ways = [(response(A, HELD[head], (i,)), 1 - i) for i in (0, 1)]
    k2 = _either(first, *(one.k for one, _ in ways))
    more = _either(first, *(_until(rest, one.rates)[..., other] for one, other in ways))
    both = response(A, HELD[head], (0, 1))
    at_once = more <= AT_ONCE * F_A
    k2, more = np.where(at_once, both.k, k2), np.where(at_once, 0.0, more)
    couple = free.X[..., :3] @ END_COUPLES
    turned = _either(first, *(turn(pair, couple) for pair in (shape.head, shape.tail)))
    EI, U_A = factor * E * h * b**3 / 12, F_A / free.k
    return Stages(
        k1=free.k * EI, U_A=U_A, F_A=F_A * EI, k2=k2 * EI, U_B=U_A + more / k2,
        F_B=(F_A + more) * EI, k3=both.k * EI, gap=_either(first, gaps[..., 0], gaps[..., 1]),
        tilt=np.pi / 2 - alpha - F_A * turned,
        top_couple=F_A * EI * abs(shape.tops @ couple[..., None]).max(axis=(-2, -1)),
    )  # fmt: skip


def _until(gaps: Array, rates: Array) -> Array:
    """Forces that close `gaps` at the given `rates`; infinite where a gap opens."""
    closes = rates > 0
    return np.where(closes, gaps / np.where(closes, rates, 1.0), np.inf)


def _either(first: Any, head: Array, tail: Array) -> Array:
    return np.where(first == 0, head, tail)


def _checked(n: int, *values: ArrayLike) -> tuple[Array, ...]:
    L1, R, b, h, alpha, E, nu, factor = np.broadcast_arrays(
        *(np.asarray(v, dtype=np.float64) for v in values)
    )
    if n < 4:
        raise ValueError(f"a spring with loops at both ends must have n >= 4 segments, got n={n}")
    for name, unit, value in (
        ("L1", " m", L1), ("radius", " m", R), ("b", " m", b), ("h", " m", h), ("E", " Pa", E),
        ("width_factor", "", factor),
    ):  # fmt: skip
        if not np.all(np.isfinite(value) & (value > 0)):
            raise ValueError(f"{name} must be positive and finite, got {value!s}{unit}")
    if not np.all((alpha > 0) & (alpha <= np.pi / 2)):
        raise ValueError(f"alpha must lie in (0, 90] deg, got {np.degrees(alpha)!s} deg")
    if not np.all((nu > -1) & (nu <= 0.5)):
        raise ValueError(f"Poisson's ratio must lie in (-1, 0.5], got nu={nu!s}")
    if not np.all(b < 2 * R):
        raise ValueError(
            f"the thickness b must be less than twice the radius, got b={b!s} m, radius={R!s} m"
        )
    return L1, R, b, h, alpha, E, nu, factor
