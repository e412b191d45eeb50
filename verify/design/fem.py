"""A candidate as a curved frame of finite elements, on the true centre line."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from verify.design.inputs import Demands
from verify.design.springs import Formulas, Springs

PER_ARC = (4, 8)  # elements of both meshes; the error falls with the fourth power
SHARE = 1 / 3  # of what Eq. 11 leaves for the stiffness, the formula may take


@dataclass(frozen=True)
class Verified:
    """Stiffness `k1` of finite elements [N/m], its change with the mesh, and what is allowed.

    `deviation` is formula less finite elements, a share of the latter, as is `limit`.
    """

    k1: float
    mesh: float
    deviation: float
    limit: float

    @property
    def agrees(self) -> bool:
        """Whether the formula lies within the limit, and the mesh settles that."""
        return abs(self.deviation) + self.mesh <= self.limit


def verified_by_fem(s: Springs, f: Formulas, i: int, q: Demands) -> Verified:
    """Candidate `i` under a unit force, from two meshes.

    The formula may err by a third of what Eq. 11 allows the displacement.
    """
    coarse, fine = (_stiffness(s, i, q, per_arc) for per_arc in PER_ARC)
    return Verified(
        k1=fine,
        mesh=abs(coarse / fine - 1),
        deviation=float(f.k1[i]) / fine - 1,
        limit=SHARE * q.e_max,
    )


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
    from fem.beam.section import Section
    from meshes.spring.centre_line import centre_line

    b = float(s.b[i])
    line = centre_line(
        n=int(s.n[i]), L1=float(s.L1[i]), radius=float(s.r[i]) + b / 2, alpha=float(s.alpha[i]),
        tail=q.tail, per_arc=per_arc, per_leaf=max(1, per_arc // 2),
    )  # fmt: skip
    E, A = q.E * q.width_factor, b * q.h
    strip = Section(EA=E * A, EI=E * A * b**2 / 12, GA=q.E / (2 * (1 + q.nu)) * A * 5 / 6)
    solved = solve_curved_frame(
        line.points, line.elements, sections=strip, supports={line.nodes["tail"]: "xyr"},
        loads={line.nodes["head"]: (1.0, 0.0, 0.0)},
    )  # fmt: skip
    return float(-1 / (2 * solved.potential_energy))
