r"""Accordion spring as a plane curved frame by the force method, for all end conditions.

The origin is the middle of the head, where the centre line starts along y. The force acts along x.
Under P = (F_x, F_y, M_0) at the head, the internal forces of a section at (x, y) with the tangent t
are

.. math:: M = y F_x - x F_y + M_0, \qquad N = -(F_x, F_y)\cdot t, \qquad V = -(F_x, F_y)\cdot n

and the displacement of the head is :math:`d = C P`, where C are the unit-load integrals. The
supports determine which components of d and P are zero. Gauss points on every leaf and arc make the
integrals exact to round-off.

Energy terms of the theories; each theory includes the terms of the previous one:

"bending"  M^2/(EI), as in the paper;
"thin"     in addition N^2/(EA);
"shear"    in addition 6/5 V^2/(GA) (Timoshenko beam);
"thick"    in addition the second-order terms in b/R of plane elasticity on the arcs: pure
           bending of a curved bar, and the coupling of M and N.

References
----------
.. [1] S. P. Timoshenko, Strength of Materials, part II, 3rd ed., Van Nostrand 1956, ch. XII
   (curved bars: energy with the M N term).
.. [2] S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, art. 29.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Head = Literal["free", "hinged", "guided"]
Tail = Literal["arc", "mid-leaf"]
Hold = Literal["clamped", "hinged"]
Theory = Literal["bending", "thin", "shear", "thick"]

SHEAR = 6 / 5  # energy factor of a rectangle
POINTS = 20


@dataclass(frozen=True)
class Sections:
    """Gauss points along the centre line: position, tangent (2, m), weight ds, curvature (m,)."""

    at: Array
    tangent: Array
    ds: Array
    curvature: Array


def pieces(
    *,
    n: int,
    L1: float,
    radius: float,
    alpha: float,
    tail: Tail = "arc",
    leaf: float | None = None,
) -> Iterator[tuple[float, float]]:
    """Length and turn [rad] of each leaf and arc, from the head on; turns to the left are positive.

    `leaf` is the straight length of the middle units. By default, the spring is symmetric: its
    loops extend to L1/2 + radius on both sides of the force.
    """
    if n < 3:
        raise ValueError(f"a spring must have at least 3 segments, got n={n}")
    if not (L1 > 0 and radius > 0):
        raise ValueError(f"L1 and radius must be positive, got L1={L1:g} m, radius={radius:g} m")
    if not 0 < alpha <= math.pi / 2:
        raise ValueError(f"alpha must lie in (0, 90] deg, got {math.degrees(alpha):g} deg")
    if leaf is None:
        leaf = L1 / math.sin(alpha) + 2 * radius / math.tan(alpha)
    turn = -1.0

    def arc(angle: float) -> tuple[float, float]:
        return radius * angle, turn * angle

    yield L1 / 2, 0.0
    yield arc(math.pi / 2)
    for _ in range(2, n):
        yield arc(alpha)
        yield leaf, 0.0
        turn = -turn
        yield arc(alpha)
    yield arc(math.pi / 2)
    if tail == "mid-leaf":
        yield L1 / 2, 0.0


def sections(parts: Iterator[tuple[float, float]]) -> Sections:
    """Gauss points of all `parts`; the line starts at the origin along y."""
    t, w = np.polynomial.legendre.leggauss(POINTS)
    t, w = (t + 1) / 2, w / 2
    start, heading = np.zeros(2), math.pi / 2
    at, tangent, ds, curvature = [], [], [], []
    for length, turn in parts:
        s, k = length * t, turn / length
        at.append(_advance(start, heading, s, k))
        angle = heading + k * s
        tangent.append(np.array([np.cos(angle), np.sin(angle)]))
        ds.append(length * w)
        curvature.append(np.full(POINTS, k))
        start = _advance(start, heading, np.array([length]), k)[:, 0]
        heading += turn
    return Sections(*(np.concatenate(a, axis=-1) for a in (at, tangent, ds, curvature)))


def flexibility(
    line: Sections, *, b: float, h: float, E: float, nu: float, theory: Theory
) -> Array:
    """Compliance matrix C (3, 3) of d = C P at the head, with the other end clamped."""
    if not (b > 0 and h > 0 and E > 0):
        raise ValueError(f"b, h and E must be positive, got b={b:g} m, h={h:g} m, E={E:g} Pa")
    x, y = line.at
    one, zero = np.ones_like(x), np.zeros_like(x)
    t_x, t_y = line.tangent
    M, N, V = np.array([y, -x, one]), -np.array([t_x, t_y, zero]), np.array([t_y, -t_x, zero])
    A, I = h * b, h * b**3 / 12  # noqa: E741

    def energy(p: Array, q: Array, where: Any = slice(None)) -> Array:
        product = np.einsum("im,jm,m->ij", p[:, where], q[:, where], line.ds[where])
        return np.asarray(product, dtype=np.float64)

    if theory == "bending":
        return energy(M, M) / (E * I)
    C = energy(M, M) / (E * I) + energy(N, N) / (E * A)
    if theory == "thin":
        return C
    C = C + SHEAR * energy(V, V) * 2 * (1 + nu) / (E * A)
    if theory == "shear":
        return C
    for k in np.unique(line.curvature[line.curvature != 0]):
        on = line.curvature == k
        c_NN, c_NM, c_MM = _curved_bar(1 / abs(k), b, h, E, nu)
        outer = -np.sign(k) * M  # positive where it pulls the outer fibre
        C += (c_NN - 1 / (E * A)) * energy(N, N, on) + (c_MM - 1 / (E * I)) * energy(M, M, on)
        C += c_NM * (energy(N, outer, on) + energy(outer, N, on))
    return C


def stiffness(
    *,
    n: int,
    b: float,
    h: float,
    radius: float,
    L1: float,
    alpha: float,
    E: float,
    nu: float = 0.3,
    head: Head = "free",
    tail: Tail = "arc",
    hold: Hold = "clamped",
    theory: Theory = "bending",
    plane_strain: bool = False,
    leaf: float | None = None,
) -> float:
    """Stiffness [force/length] of the head along the force.

    Parameters
    ----------
    radius
        Radius of the centre line of the arcs: r + b/2, or the inner radius r as in the paper.
    leaf
        Straight length of the middle units; by default, the spring is symmetric.
    head
        "free" (lateral motion and rotation), "hinged" (rotation only) or "guided" (neither).
    tail, hold
        Support of the tail: at the end of its "arc" or in the middle of its leaf ("mid-leaf"),
        "clamped" or "hinged".
    plane_strain
        E/(1 - nu^2) in place of E, for a strip that is much wider than its loops.

    Raises
    ------
    ValueError
        If the geometry is impossible, or if the spring can rotate freely.

    >>> strip = dict(n=10, b=0.1, h=56, L1=11.6, alpha=math.radians(80), E=206e3)
    >>> L2 = 11.6 / math.sin(math.radians(80)) + 1.0 / math.tan(math.radians(80))
    >>> round(stiffness(radius=0.45, leaf=L2, **strip), 5)  # N/mm, the lengths of Eqs. 1-9
    0.60096
    """
    shape: dict[str, Any] = {
        "n": n,
        "L1": L1,
        "radius": radius,
        "alpha": alpha,
        "tail": tail,
        "leaf": leaf,
    }
    line = sections(pieces(**shape))
    if not -1 < nu <= 0.5:
        raise ValueError(f"Poisson's ratio must lie in (-1, 0.5], got nu={nu:g}")
    if plane_strain:  # Hooke's law in the plane keeps its form, and G its value
        E, nu = E / (1 - nu**2), nu / (1 - nu)
    C = flexibility(line, b=b, h=h, E=E, nu=nu, theory=theory)
    held = {"free": [], "hinged": [1], "guided": [1, 2]}[head]
    loads = [0, *held]  # components of P that do not vanish
    if hold == "clamped":
        unit = np.linalg.solve(C[np.ix_(loads, loads)], np.eye(len(loads))[0])
        return float(unit[0])
    if head == "free":
        raise ValueError(
            "a spring with a hinged tail must have a hinged or guided head: otherwise, it can "
            "rotate freely"
        )
    # A hinged tail turns by phi, which carries no moment there: w . P = 0 and d = C P + w phi.
    x_t, y_t = end_point(**shape)
    w = np.array([y_t, -x_t, 1.0])[loads]
    system = np.block([[C[np.ix_(loads, loads)], w[:, None]], [w[None], np.zeros((1, 1))]])
    return float(np.linalg.solve(system, np.eye(len(loads) + 1)[0])[0])


def end_point(
    *,
    n: int,
    L1: float,
    radius: float,
    alpha: float,
    tail: Tail = "arc",
    leaf: float | None = None,
) -> tuple[float, float]:
    """Position [length] of the clamped end of the tail, relative to the middle of the head."""
    at, heading = np.zeros(2), math.pi / 2
    for length, turn in pieces(n=n, L1=L1, radius=radius, alpha=alpha, tail=tail, leaf=leaf):
        at = _advance(at, heading, np.array([length]), turn / length)[:, 0]
        heading += turn
    return float(at[0]), float(at[1])


def free_length(*, n: int, b: float, r: float, L1: float, alpha: float) -> float:
    """Free length L_0 [length] over all, between the outer faces of the leaves of head and tail."""
    return end_point(n=n, L1=L1, radius=r + b / 2, alpha=alpha, tail="mid-leaf")[0] + b


def _advance(start: Array, heading: float, s: Array, k: float) -> Array:
    if k == 0:
        return start[:, None] + np.outer([math.cos(heading), math.sin(heading)], s)
    end = heading + k * s
    step = np.array([np.sin(end) - math.sin(heading), math.cos(heading) - np.cos(end)])
    return start[:, None] + step / k


def _curved_bar(R: float, b: float, h: float, E: float, nu: float) -> tuple[float, float, float]:
    """Compliances c_NN, c_NM, c_MM per length of a curved rectangular bar about its centroid.

    c_MM is the solution of plane elasticity for pure bending (Golovin; [2], art. 29). Winkler's bar
    neglects the radial stress; its error is 0.1 (b/R)^2 in the opposite direction. c_NM contains
    Winkler's 1/(EAR) and a term by which the radial stress reduces the factor 1 + nu of the shear.
    Only with both terms is the deflection of a quarter ring under a radial force independent of nu:
    1 + 0.15 (b/R)^2 times that of a thin ring, as in [2], art. 33.
    """
    if not b < 2 * R:
        raise ValueError(
            f"the thickness of a bar must be less than twice its radius, got b={b:g} m, radius "
            f"{R:g} m"
        )
    A, i, o = h * b, R - b / 2, R + b / 2
    N = (o**2 - i**2) ** 2 - 4 * i**2 * o**2 * math.log(o / i) ** 2
    c_NM = (1 + SHEAR * nu) / (E * A * R)
    return 1 / (E * A), c_NM, 8 * (o**2 - i**2) / (E * h * N * R)
