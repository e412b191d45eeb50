r"""Exact large bending of an accordion spring: the elastica of its leaves and arcs.

A force (F_x, F_y) and a couple M_0 act on the head at the origin, the middle of its leaf, where the
centre line starts along y. Before leaves touch, there is no other load: the force is equal in all
sections, and the couple follows from the displaced position of the section. The only unknown
function is the rotation :math:`\psi(s)` of the sections:

.. math::

   E I\,\psi' = -(M_0 - x F_y + y F_x), \qquad x' + i y' = (1 + \varepsilon + i\gamma)\,e^{i\phi},
   \qquad \phi = \phi_0 + \psi,

.. math::

   \varepsilon = N/(EA), \quad \gamma = V/(GA), \quad N + i V = -(F_x + i F_y)\,e^{-i\phi}

(Reissner's beam with algebraic strains; EA and GA may be infinite). Every piece has Gauss points.
With the matrix S of integrals along the line, the equations and their derivatives are products of
matrices. Newton's method solves for :math:`\psi` and the unknowns of the head together.

Range: no contact between leaves; a narrow strip, or a wide strip with E/(1 - nu^2) in place of E.

References
----------
.. [1] E. Reissner, On one-dimensional finite-strain beam theory: the plane problem, J. Appl. Math.
   Phys. (ZAMP) 23 (1972) 795-804.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Head = Literal["free", "hinged", "guided"]

POINTS = 6  # on each leaf and arc
TURN, COUPLE, F_X, F_Y = range(4)  # the head's rotation, couple and forces
CONVERGED, ITERATIONS = 1e-12, 30  # of the rotations [rad]
HELD_OFF = {  # unknowns of the head if its movement along x is given
    "free": (TURN, F_X),
    "hinged": (TURN, F_X, F_Y),
    "guided": (COUPLE, F_X, F_Y),
}


@dataclass(frozen=True)
class State:
    """Equilibrium state of a spring; its head is displaced by `U` along x and `drift` along y.

    `head` (4,) contains the rotation, couple and force (F_x, F_y) of the head, `psi` (m,) the
    rotations and `at` (2, m) the positions of the Gauss points relative to the head. `J` (3, 4)
    contains the derivatives of rotation, x and y of the tail, relative to the head, with respect to
    `head`.
    """

    U: float
    drift: float
    head: Array
    psi: Array
    at: Array
    J: Array

    @property
    def F(self) -> float:
        """Force [force] along x."""
        return float(self.head[F_X])


class Elastica:
    """Elastica of leaves and arcs (length, turn), clamped at its end and loaded at its start.

    `analytic.spring.frame.pieces` returns the pieces of an accordion spring.
    """

    def __init__(
        self,
        parts: Iterable[tuple[float, float]],
        *,
        EI: float,
        EA: float = math.inf,
        GA: float = math.inf,
    ) -> None:
        if not (EI > 0 and EA > 0 and GA > 0):
            raise ValueError(f"EI, EA and GA must be positive, got {EI:g}, {EA:g}, {GA:g}")
        self.EI, self._stretch, self._shear = EI, 1 / EA, 1 / GA
        lengths, turns = np.array(list(parts), dtype=np.float64).T
        t, w, inside = _rule()
        self.w = np.outer(lengths, w).ravel()
        before = np.repeat(np.tri(len(lengths), k=-1), POINTS, axis=0)
        self.S = np.repeat(before, POINTS, axis=1) * self.w + np.kron(np.diag(lengths), inside)
        heading = math.pi / 2 + np.cumsum(turns) - turns
        self.phi = (heading[:, None] + np.outer(turns, t)).ravel()
        self._SS, self._wS = self.S @ self.S, self.w @ self.S
        self._tail = np.array([0.0, self.w @ np.cos(self.phi), self.w @ np.sin(self.phi)])

    def path(self, head: Head, U: Iterable[float]) -> list[State]:
        """States at the displacements `U` [length] of a head that is free, hinged or guided.

        The step between two states should be at most a twentieth of the length of the spring.
        Raises ArithmeticError if no equilibrium is found.
        """
        states = [self.unloaded()]
        for u in U:
            states.append(self.displaced(head, u, states[-2:]))
        return states[1:]

    def unloaded(self) -> State:
        """State of the spring without load."""
        zero = np.zeros(4)
        return self._solve(np.zeros_like(self.w), zero, (), (), np.zeros(3))

    def displaced(
        self, head: Head, U: float, near: Sequence[State], *, aside: float = 0.0
    ) -> State:
        """State at the displacement U [length], computed from one or two neighbouring states.

        A head that is not free is fixed at the lateral position `aside` along y [length].
        """
        psi, P = near[-1].psi, near[-1].head
        if len(near) == 2 and near[1].U != near[0].U:
            share = (U - near[1].U) / (near[1].U - near[0].U)
            psi, P = psi + share * (psi - near[0].psi), P + share * (P - near[0].head)
        held = (0, 1) if head == "free" else (0, 1, 2)
        return self._solve(psi, P, HELD_OFF[head], held, np.array([0.0, -U, -aside]))

    def pushed(self, F: tuple[float, float], near: State, *, couple: float = 0.0) -> State:
        """State under a dead force (F_x, F_y) and a couple on a free head.

        The iteration begins at the state `near`.
        """
        P = np.array([near.head[TURN], couple, *F])
        return self._solve(near.psi, P, (TURN,), (0,), np.zeros(3))

    def linear_load(self) -> float:
        r"""Buckling force along x of a spring with a free head, without prior deformation.

        1/F is the largest eigenvalue of :math:`\psi = F (1 w S - S S)\, c\, \psi/EI`, where psi is
        zero at the tail and c is the cosine of the angle of the centre line. Axial and shear
        strains under F are included.
        """
        cos, sin, F = np.cos(self.phi), np.sin(self.phi), 0.0
        for _ in range(3):  # F/EA is small
            c = cos + F * (self._stretch * sin**2 + self._shear * cos**2)
            operator = (self._wS - self._SS) * c / self.EI
            F = float(1 / np.linalg.eigvals(operator).real.max())
        return F

    def _solve(
        self, psi: Array, P: Array, columns: tuple[int, ...], rows: tuple[int, ...], moved: Array
    ) -> State:
        """State by Newton's method, with the unknowns psi and `columns` of P.

        The displacement of the tail is `moved` in the components `rows`.
        """
        P = P.copy()
        for _ in range(ITERATIONS):
            equations = self._equations(psi, P)
            try:
                step, change, J = self._correction(equations, columns, rows, moved)
            except np.linalg.LinAlgError:  # by rounding, if a step before was too large
                break
            if not np.abs(step).max() < 1e3:
                break
            psi, P = psi + step, P + change
            if np.abs(step).max() < CONVERGED:
                went = equations[3] - self._tail
                return State(float(-went[1]), float(-went[2]), P, psi, equations[-1], J)
        raise ArithmeticError(
            f"no equilibrium of the spring was found near F = {P[F_X]:g}, U = {-moved[1]:g}: use "
            "smaller steps of U"
        )

    def _correction(
        self,
        equations: tuple[Array, ...],
        columns: tuple[int, ...],
        rows: tuple[int, ...],
        moved: Array,
    ) -> tuple[Array, Array, Array]:
        """Newton corrections of psi (m,) and of P (4,), and derivatives (3, 4) of the tail by P."""
        residual, A, B, tail, by_psi, by_P, _ = equations
        Z = np.linalg.solve(A, np.column_stack([residual, B]))
        J = by_psi @ Z[:, 1:] + by_P
        missing = tail - self._tail - moved - by_psi @ Z[:, 0]
        change = np.zeros(4)
        if columns:
            change[list(columns)] = -np.linalg.solve(J[np.ix_(rows, columns)], missing[list(rows)])
        return Z[:, 1:] @ change - Z[:, 0], change, J

    def _equations(self, psi: Array, P: Array) -> tuple[Array, ...]:
        """Residual (m,) with its derivatives by psi and -P; tail (3,) with those by psi and P.

        The last value contains the positions of the Gauss points.
        """
        turn, couple, F_x, F_y = P
        S, EI, one = self.S, self.EI, np.ones_like(psi)
        c, s = np.cos(self.phi + psi), np.sin(self.phi + psi)
        f, f_psi, f_F = self._slopes(c, s, F_x, F_y)
        x, y = S @ f[0], S @ f[1]
        bent = couple - F_y * x + F_x * y  # minus the bending moment
        residual = psi - turn + S @ bent / EI
        q = (F_x * f_psi[1] - F_y * f_psi[0]) / EI
        A = np.eye(psi.size) + self._SS * q
        arm = F_x * f_F[1] - F_y * f_F[0]  # (2, m): the share of the stretch by the force
        by_F = np.stack([y + S @ arm[0], -x + S @ arm[1]])
        B = np.column_stack([one, -(S @ one) / EI, -(S @ by_F[0]) / EI, -(S @ by_F[1]) / EI])
        w = self.w
        tail = np.array([turn - w @ bent / EI, w @ f[0], w @ f[1]])
        by_psi = np.stack([-self._wS * q, w * f_psi[0], w * f_psi[1]])
        by_P = np.zeros((3, 4))
        by_P[0] = 1.0, -w.sum() / EI, -(w @ by_F[0]) / EI, -(w @ by_F[1]) / EI
        by_P[1:, F_X:] = f_F @ w
        return residual, A, B, tail, by_psi, by_P, np.stack([x, y])

    def _slopes(self, c: Array, s: Array, F_x: float, F_y: float) -> tuple[Array, Array, Array]:
        """Derivatives (x', y') (2, m) along the line, and their derivatives by psi and by F.

        The derivatives by psi have the shape (2, m), those by F the shape (component, force, m).
        """
        a, g = self._stretch, self._shear
        N, V = -(F_x * c + F_y * s), F_x * s - F_y * c
        eps, gamma = a * N, g * V
        f = np.stack([(1 + eps) * c - gamma * s, (1 + eps) * s + gamma * c])
        along, across = a * V - gamma, 1 + eps - g * N  # dN/dpsi = V, dV/dpsi = -N
        by_psi = np.stack([along * c - across * s, along * s + across * c])
        xx, xy, yy = -a * c * c - g * s * s, (g - a) * c * s, -a * s * s - g * c * c
        return f, by_psi, np.stack([np.stack([xx, xy]), np.stack([xy, yy])])


def _rule() -> tuple[Array, Array, Array]:
    """Gauss points and weights on (0, 1), and the matrix of integrals from 0 to each point."""
    z, w = np.polynomial.legendre.leggauss(POINTS)
    legendre = np.polynomial.legendre
    series = [legendre.legint(row, lbnd=-1) / 2 for row in np.eye(POINTS)]
    integrals = np.column_stack([legendre.legval(z, one) for one in series])
    inside = integrals @ np.linalg.inv(legendre.legvander(z, POINTS - 1))
    return (z + 1) / 2, w / 2, inside
