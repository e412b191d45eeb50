r"""Contact points of a wedged sprag whose ends move laterally and rotate.

Eccentric forces bend a column into an S shape. Relative to the core, its ends rotate by psi
(anticlockwise) and move by u towards the side of A. The races move by u_r in the same direction
under T = N tan(nu). Surfaces touch where they are parallel. With the radii r and r_e of the sprag
at the contacts, the centres of pressure move by

.. math::
    s_A &= -R_A \left(\psi_A + \frac{u_A - u_{rA}}{OA}\right)
           + \frac{m R_A}{8}\left(\frac{a}{r}\right)^2, \qquad
    \frac{1}{R_A} = \frac{1}{r} + \frac{1}{OA}, \\
    s_B &= R_B \left(\psi_B + \frac{u_B - u_{rB}}{OB}\right), \qquad
    \frac{1}{R_B} = \frac{1}{r_e} - \frac{1}{OB},

where the last term of s_A is due to the spiral, whose curvature decreases to one side (plane
contact with a cubic gap). The angle beta between both contacts changes, as do tan(nu) and
tan(omega), by the fraction

.. math:: \frac{s_A}{OA} - \frac{s_B}{OB} .

Strains are small, and equilibrium refers to the positions of the undeformed ends: the displacement
of the forces by u is neglected, as in finite elements with small strains.
"""

from dataclasses import astuple, dataclass
from typing import Protocol

import numpy as np

from analytic.contact.checks import Array
from analytic.sprag.column import Column
from analytic.sprag.goursat import displaced, flamant, forces_along, rest, turns

Pair = tuple[float, float]  # of the inner and the outer contact

DEGREE = 32  # of the polynomials: error of 2 % of the rotation of the ends of a column


class Triangle(Protocol):
    """Contact geometry of a wedged sprag: radii OA, OB, polar radius rho [m], angle beta [rad]."""

    @property
    def OA(self) -> Array: ...
    @property
    def OB(self) -> Array: ...
    @property
    def rho(self) -> Array: ...
    @property
    def beta(self) -> Array: ...


@dataclass(frozen=True, kw_only=True)
class Ends:
    """Displacements of the column ends to the side of A [P/E'], and rotations [P/E' per length]."""

    moved: Pair
    turned: Pair


@dataclass(frozen=True, kw_only=True)
class Shift:
    """Relative change of the angle between both contacts, split into its causes."""

    turned: float
    moved: float
    inner_race: float
    outer_race: float
    spiral: float

    @property
    def whole(self) -> float:
        return float(sum(astuple(self)))

    @property
    def size(self) -> float:
        """Sum of the absolute values of all parts."""
        return float(sum(map(abs, astuple(self))))


def ends(column: Column, *, turned: float, alpha_b: float, a: Pair, nu: float) -> Ends | None:
    """Displacements and rotations of the ends of a column, relative to its core.

    The forces act through Hertz patches of half-widths `a` [length]. The result is None if a
    contact lies beyond a flank.
    """
    outline = column.outline(turned=turned, alpha_b=alpha_b)
    if outline is None:
        return None
    kappa = 3 - 4 * nu
    double_G = (kappa + 1) / 4  # of a body with E' = 1
    forces = forces_along(outline)
    others = rest(outline, forces, DEGREE)

    def at(z: complex, *which: int) -> tuple[complex, float]:
        """Displacement and rotation at z due to the forces `which` and the polynomial remainder."""
        there = np.array([z])
        fields = [*(flamant(there, forces[i]) for i in which), others(there)]
        u = sum(complex(displaced(there, f, kappa)[0]) for f in fields) / double_G
        return u, sum(float(turns(f, kappa)[0]) for f in fields) / double_G

    core = column.core
    u_0, psi_0 = at(core, 0, 1)
    moved, turn = [], []
    normals = column.normal(turned), outline.B / abs(outline.B)
    for i, ((z, F), half, up) in enumerate(zip(forces, a, normals, strict=True)):
        u, psi = at(z, 1 - i)
        along = complex(-1j * up)  # to the side of A
        F_t = (F * np.conj(along)).real
        own = F_t * (2 / np.pi * (np.log(2 / half) + 0.5) + 1 / (2 * np.pi * double_G))
        rigid = u_0 + 1j * psi_0 * (z - core)
        moved.append(float(own + ((u - rigid) * np.conj(along)).real))
        turn.append(psi - psi_0)
    return Ends(moved=(moved[0], moved[1]), turned=(turn[0], turn[1]))


def shift(at: Triangle, ends: Ends, *, column: Column, a: Pair, P: float, races: Pair) -> Shift:
    """Relative change of the angle between both contacts of a sprag under P = N/(l E') [length].

    `races` [length] are the lateral displacements of the inner race towards the side of A and of
    the outer race away from this side. Both values are positive.
    """
    OA, OB, beta = float(at.OA), float(at.OB), float(at.beta)
    m, r_e = float(np.asarray(column.sprag.m)), float(np.asarray(column.sprag.r_e))
    r = float(at.rho * np.hypot(1, m))
    R_A, R_B = 1 / (1 / r + 1 / OA), 1 / (1 / r_e - 1 / OB)
    psi_A, psi_B = (P * psi for psi in ends.turned)
    u_A, u_B = (P * u for u in ends.moved)
    return Shift(
        turned=-(R_A * psi_A / OA + R_B * psi_B / OB) / beta,
        moved=-(R_A * u_A / OA**2 + R_B * u_B / OB**2) / beta,
        inner_race=R_A * races[0] / OA**2 / beta,
        outer_race=-R_B * races[1] / OB**2 / beta,
        spiral=m * R_A / 8 * (a[0] / r) ** 2 / OA / beta,
    )
