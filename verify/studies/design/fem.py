"""Finite-element results for the members of a Pareto front."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf, isnan

from analytic.spring.energy import curvature_factor
from verify.studies.design.compressed import Curve, compressed
from verify.studies.design.inputs import Demands
from verify.studies.design.springs import Formulas, Springs
from verify.studies.design.strip import HEAD_HELD, strip

PER_ARC = (4, 8)  # elements of both meshes; the error falls with the fourth power
SHARE = 1 / 3  # allowed error of the formula's stiffness, as a share of the margin of Eq. 11
ROUNDING = 1e-9  # of a displacement
STROKE = 1.1  # times the larger of U_w and Δ: largest computed displacement


@dataclass(frozen=True)
class Verified:
    """Finite-element results of one candidate.

    `k1` [N/m] is the stiffness at small displacements, and `mesh` its relative change from the
    coarse to the fine mesh. `deviation` is (formula - finite elements) / finite elements for this
    stiffness. `curve` is the curve for large displacements. `stress` [Pa] is the bending stress
    under F_w in the deformed state. `room` [m] and `sigma` [Pa] are the permissible height and
    stress of the task.
    """

    k1: float
    mesh: float
    deviation: float
    curve: Curve
    delta: float
    U_w: float
    e_max: float
    stress: float = 0.0
    room: float = inf
    sigma: float = inf

    @property
    def too_high(self) -> bool:
        """Whether the height of the spring at U_w exceeds the available space."""
        return self.curve.height > self.room

    @property
    def overstressed(self) -> bool:
        """Whether the stress under F_w exceeds the permissible stress."""
        return self.stress > self.sigma

    @property
    def unsolved(self) -> bool:
        """Whether the computed curve ends before U_w or F_w because no equilibrium was found."""
        end = float(self.curve.U[-1]) * (1 + ROUNDING)
        return not self.curve.whole and (self.U_w > end or isnan(self.delta))

    @property
    def limit(self) -> float:
        """Permissible relative error of the formula's stiffness."""
        return SHARE * self.e_max

    @property
    def agrees(self) -> bool:
        """Whether the formula's stiffness error plus the mesh error is at most `limit`."""
        return abs(self.deviation) + self.mesh <= self.limit

    @property
    def e_r(self) -> float:
        """Displacement error of Eq. 11, (U_w - Δ)/Δ, with Δ of finite elements under F_w.

        The result is NaN if the curve does not reach F_w.
        """
        return self.U_w / self.delta - 1

    @property
    def fits(self) -> bool:
        """Whether Eq. 11 holds, no leaves touch up to U_w, and space and strength are sufficient.

        A spring without an equilibrium up to U_w does not fit, because its behaviour is unknown.
        """
        if self.too_high or self.overstressed or self.curve.touches <= self.U_w or self.unsolved:
            return False
        return abs(self.e_r) <= self.e_max  # False for NaN


def verified_by_fem(s: Springs, f: Formulas, i: int, q: Demands) -> Verified:
    """Finite-element results of candidate `i`: stiffness, force-displacement curve, stress."""
    coarse, fine = (_stiffness(s, i, q, per_arc) for per_arc in PER_ARC)
    U_w = float(f.U_w[i])
    curve = compressed(s, f, i, q, stroke=STROKE * max(U_w, float(f.delta(q.F_w)[i])))
    return Verified(
        k1=fine, mesh=abs(coarse / fine - 1), deviation=float(f.k1[i]) / fine - 1, curve=curve,
        delta=curve.displacement(q.F_w), U_w=U_w, e_max=q.e_max,
        stress=_stress(s, i, q, curve, U_w), room=inf if q.room is None else q.room,
        sigma=q.sigma,
    )  # fmt: skip


def _stress(s: Springs, i: int, q: Demands, curve: Curve, U_w: float) -> float:
    """Bending stress [Pa] at the inside of an arc under F_w.

    The bending couple computed at U_w is scaled by the ratio of F_w to the force at U_w.
    """
    b, force = float(s.b[i]), curve.force(U_w)
    share = q.F_w / force if force > 0 else 1.0
    bent = float(curvature_factor(b=b, r=float(s.r[i])))
    return bent * 6 * share * curve.couple / (q.h * b**2)


def verified(
    s: Springs,
    f: Formulas,
    members: Sequence[int],
    q: Demands,
    notify: Callable[[int, float], None],
) -> list[Verified]:
    """Finite-element results of all candidates in `members`.

    `notify` receives the number of solved members and the estimated remaining time [s].
    """
    found: list[Verified] = []
    start = time.monotonic()
    for done, i in enumerate(members):
        notify(done, (len(members) - done) * (time.monotonic() - start) / max(done, 1))
        found.append(verified_by_fem(s, f, i, q))
    return found


def _stiffness(s: Springs, i: int, q: Demands, per_arc: int) -> float:
    from fem.beam.curved import solve_curved_frame

    line, section = strip(s, i, q, per_arc)
    solved = solve_curved_frame(
        line.points, line.elements, sections=section,
        loads={line.nodes["head"]: (1.0, 0.0, 0.0)},
        supports={line.nodes["tail"]: "xyr", line.nodes["head"]: HEAD_HELD[q.head]},
    )  # fmt: skip
    return float(-1 / (2 * solved.potential_energy))
