"""A compressed candidate: geometrically exact beam with self-contact."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from verify.studies.design.inputs import Demands
from verify.studies.design.springs import Formulas, Springs
from verify.studies.design.strip import HEAD_HELD, strip

Array = NDArray[np.float64]
PER_ARC = 4
PARTS = 10  # of the working displacement, so that U_w is one of the states
ROUND_OFF = 1e-9  # of the stroke, which often is a multiple of these parts

NEAR = 0.7  # of the closed form's U_A; large displacements bring it forward by up to an eighth


@dataclass(frozen=True)
class Curve:
    """Force-displacement curve of a compressed spring, `U` [m] and `F` [N], arrays (k,).

    The first point is (0, 0). `touches` [m] is the first displacement at which leaves touch, inf if
    they do not touch. `height` [m] is the largest transverse height of the spring up to U_w.
    `couple` [N m] is the largest bending couple at U_w. `whole` is False if no equilibrium was
    found before the end of the stroke; the behaviour beyond the last point is then unknown.
    """

    U: Array
    F: Array
    touches: float
    height: float = 0.0
    couple: float = 0.0
    whole: bool = True

    def force(self, U: float) -> float:
        """Force [N] at displacement U [m]; NaN beyond the end of the curve."""
        return float(np.interp(U, self.U, self.F, right=np.nan))

    def displacement(self, F: float) -> float:
        """Displacement [m] at which the force first reaches F [N]; NaN if it never reaches F.

        The curve is interpolated by a cubic through the neighbouring points.
        """
        beyond = np.flatnonzero(F <= self.F)
        if not beyond.size:
            return float("nan")
        k = min(max(int(beyond[0]) - 2, 0), max(len(self.U) - 4, 0))
        near = slice(k, k + 4)
        degree = min(3, len(self.U[near]) - 1)
        return float(np.polynomial.Polynomial.fit(self.F[near], self.U[near], degree)(F))


def compressed(s: Springs, f: Formulas, i: int, q: Demands, *, stroke: float) -> Curve:
    """Force-displacement curve of candidate `i` under a prescribed displacement of its head.

    The displacement increases in steps of U_w / 10 to beyond `stroke` [m]. Contact between leaves
    is only computed if `stroke` exceeds 0.7 U_A of the closed form.
    """
    from fem.beam.large import LargeFrame
    from fem.beam.touching import SelfContact

    U_w = float(f.U_w[i])
    near = stroke > NEAR * float(f.U_A[i])
    line, section = strip(s, i, q, PER_ARC, tips=near)
    head = line.nodes["head"]
    contacts = [
        SelfContact(line.points, line.elements, thickness=float(s.b[i]), EA=section.EA,
                    friction=q.friction)
    ] if near else []  # fmt: skip
    frame = LargeFrame(
        line.points, line.elements, sections=section, terms=contacts,
        supports={line.nodes["tail"]: "xyr", head: HEAD_HELD[q.head]},
    )  # fmt: skip
    U, F, touches, state = [0.0], [0.0], float("inf"), None
    height, couple = float(np.ptp(line.points[:, 1])), 0.0
    stroke *= 1 - ROUND_OFF
    while U[-1] < stroke:
        try:
            state = frame.displaced({head: {"x": U_w / PARTS}}, [1.0], since=state).last
        except ArithmeticError:  # missing parts of the curve are reported as unknown (`unsolved`)
            break
        U.append(len(U) / PARTS * U_w)  # so is U_w itself one of them, to its last bit
        F.append(float(state.reactions[head, 0]))
        if any(contact.record.normal.size for contact in contacts):
            touches = min(touches, U[-1])
        if len(U) <= PARTS + 1:
            height = max(height, float(np.ptp(line.points[:, 1] + state.u[:, 1])))
            couple = float(abs(frame.section_forces(state)[1][..., 2]).max())
    return Curve(np.array(U), np.array(F), touches, height + float(s.b[i]), couple,
                 whole=U[-1] >= stroke)  # fmt: skip
