"""A candidate by finite elements on the true centre line: small displacements, and large ones."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verify.design.inputs import Demands
from verify.design.springs import Formulas, Springs

Array = NDArray[np.float64]
PER_ARC = (4, 8)  # elements of both meshes; the error falls with the fourth power
LARGE_PER_ARC = 4
HEAD_HELD = {"guided": "yr", "free": ""}
SHARE = 1 / 3  # of what Eq. 11 leaves for the displacement, the formula's stiffness may take
STROKE, STEPS = 1.2, 16  # of the larger of U_w and Δ, up to which the spring is compressed


@dataclass(frozen=True)
class Verified:
    """What finite elements say of one candidate.

    `k1` [N/m] at small displacements, its change with the mesh `mesh`, and `deviation`, formula
    less finite elements; `U`, `F` (k,) [m, N] the curve of the geometrically exact beam up to
    some way beyond U_w, shorter where no equilibrium was found; `delta` [m] its displacement
    under F_w, NaN where that is not reached. Shares of the finite elements' values.
    """

    k1: float
    mesh: float
    deviation: float
    U: Array
    F: Array
    delta: float
    U_w: float
    e_max: float

    @property
    def limit(self) -> float:
        """How far the formula's stiffness may be off."""
        return SHARE * self.e_max

    @property
    def agrees(self) -> bool:
        """Whether the formula's stiffness lies within the limit, and the mesh settles that."""
        return abs(self.deviation) + self.mesh <= self.limit

    @property
    def e_r(self) -> float:
        """Eq. 11 with the displacement of the large deformation: (U_w - Δ)/Δ."""
        return self.U_w / self.delta - 1

    @property
    def fits(self) -> bool:
        """Whether the true displacement keeps Eq. 11."""
        return bool(abs(self.e_r) <= self.e_max)  # a NaN does not

    @property
    def force(self) -> float:
        """Force [N] at U_w."""
        return float(np.interp(self.U_w, self.U, self.F, right=np.nan))


def verified_by_fem(s: Springs, f: Formulas, i: int, q: Demands) -> Verified:
    """Candidate `i`: its stiffness from two meshes, and its curve."""
    coarse, fine = (_stiffness(s, i, q, per_arc) for per_arc in PER_ARC)
    U_w = float(f.U_w[i])
    U, F = _curve(s, i, q, STROKE * max(U_w, float(f.delta(q.F_w)[i])))
    return Verified(
        k1=fine, mesh=abs(coarse / fine - 1), deviation=float(f.k1[i]) / fine - 1, U=U, F=F,
        delta=_reached(U, F, q.F_w), U_w=U_w, e_max=q.e_max,
    )  # fmt: skip


def verified(
    s: Springs, f: Formulas, members: Sequence[int], q: Demands, tell: Callable[[int, float], None]
) -> list[Verified]:
    """All `members`; `tell` hears how many are done, and the seconds that the rest will take."""
    found: list[Verified] = []
    start = time.monotonic()
    for done, i in enumerate(members):
        tell(done, (len(members) - done) * (time.monotonic() - start) / max(done, 1))
        found.append(verified_by_fem(s, f, i, q))
    return found


def _stiffness(s: Springs, i: int, q: Demands, per_arc: int) -> float:
    from fem.beam.curved import solve_curved_frame

    line, strip = _strip(s, i, q, per_arc)
    solved = solve_curved_frame(
        line.points, line.elements, sections=strip, loads={line.nodes["head"]: (1.0, 0.0, 0.0)},
        supports={line.nodes["tail"]: "xyr", line.nodes["head"]: HEAD_HELD[q.head]},
    )  # fmt: skip
    return float(-1 / (2 * solved.potential_energy))


def _curve(s: Springs, i: int, q: Demands, stroke: float) -> tuple[Array, Array]:
    """Displacements and forces (k,) from the origin on, as far as there is an equilibrium."""
    from fem.beam.large import LargeFrame

    line, strip = _strip(s, i, q, LARGE_PER_ARC)
    head = line.nodes["head"]
    frame = LargeFrame(
        line.points, line.elements, sections=strip,
        supports={line.nodes["tail"]: "xyr", head: HEAD_HELD[q.head]},
    )  # fmt: skip
    U, F, state = [0.0], [0.0], None
    for k in range(STEPS):
        try:
            path = frame.displaced({head: {"x": stroke / STEPS}}, [1.0], since=state)
        except ArithmeticError:
            break
        state = path.last
        U.append(stroke * (k + 1) / STEPS)
        F.append(float(state.reactions[head, 0]))
    return np.array(U), np.array(F)


def _reached(U: Array, F: Array, F_w: float) -> float:
    """Displacement at which the curve first bears F_w, between two points of it along a cubic."""
    beyond = np.flatnonzero(F_w <= F)
    if not beyond.size:
        return float("nan")
    k = min(max(int(beyond[0]) - 2, 0), max(len(U) - 4, 0))
    near = slice(k, k + 4)
    rising = np.polynomial.Polynomial.fit(F[near], U[near], min(3, len(U[near]) - 1))
    return float(rising(F_w))


def _strip(s: Springs, i: int, q: Demands, per_arc: int) -> tuple[Any, Any]:
    """Line mesh and section of candidate `i`."""
    from fem.beam.section import Section
    from meshes.spring.centre_line import centre_line

    b = float(s.b[i])
    line = centre_line(
        n=int(s.n[i]), L1=float(s.L1[i]), radius=float(s.r[i]) + b / 2, alpha=float(s.alpha[i]),
        tail=q.tail, per_arc=per_arc, per_leaf=max(2, per_arc // 2),
    )  # fmt: skip
    E, A = q.E * q.width_factor, b * q.h
    return line, Section(EA=E * A, EI=E * A * b**2 / 12, GA=q.E / (2 * (1 + q.nu)) * A * 5 / 6)
