"""Equal rotors in ROSS and in this project: steps, discs, bearings, two shafts with 22 nodes."""

import numpy as np

from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, Support

STEEL = Material(E=211e9, nu=0.3, rho=7810.0)
OUTER = [(0.03 + 0.004 * (k % 3), 0.06 + 0.01 * (k % 4 == 2), 0.045) for k in range(11)]
INNER = [(0.035 + 0.003 * (k % 2), 0.03 + 0.006 * (k % 3 == 1), 0.0) for k in range(9)]
DISCS = [(3, 1.2, 0.0016, 0.0025), (18, 0.8, 0.0007, 0.0011)]  # node, mass, Id, Ip
GROUND = [(1, 8e7, 900.0), (5, 9e7, 1100.0), (20, 5e7, 700.0)]
BETWEEN = [(8, 13, 6e7, 400.0), (10, 15, 7e7, 500.0)]
UNLIKE = 1.3  # kyy over kxx where supports are not isotropic
NODES = len(OUTER) + len(INNER) + 2
START = sum(length for length, _, _ in OUTER[:7])  # where the inner shaft begins


def ours(kappa, *, unlike=False, damped=True):
    """The two shafts here, with ROSS's shear coefficients `kappa` by element."""
    outer, inner = (
        [Element(L, d_o, d_i, STEEL, k) for (L, d_o, d_i), k in zip(rows, own, strict=True)]
        for rows, own in ((OUTER, kappa[:11]), (INNER, kappa[11:]))
    )
    y = UNLIKE if unlike else 1.0
    c = 1.0 if damped else 0.0
    return Rotor(
        [Shaft(outer), Shaft(inner, z=START)],
        [Disc(n, m, Ip, Id) for n, m, Id, Ip in DISCS],
        [Support(n, k, k * y, cxx=c * v) for n, k, v in GROUND],
        [Link.bearing(a, b, k, kyy=k * y, cxx=c * v) for a, b, k, v in BETWEEN],
    )


def theirs(ross, *, unlike=False, damped=True):
    """The same in ROSS."""
    steel = ross.Material("steel", rho=STEEL.rho, E=STEEL.E, Poisson=STEEL.nu)
    outer, inner = (
        [ross.ShaftElement(L, d_i, d_o, material=steel) for L, d_o, d_i in rows]
        for rows in (OUTER, INNER)
    )
    y = UNLIKE if unlike else 1.0
    c = 1.0 if damped else 0.0
    bearings = [ross.BearingElement(n, kxx=k, kyy=k * y, cxx=c * v) for n, k, v in GROUND]
    bearings += [
        ross.BearingElement(a, kxx=k, kyy=k * y, cxx=c * v, n_link=b) for a, b, k, v in BETWEEN
    ]
    return ross.CoAxialRotor(
        [outer, inner], [ross.DiskElement(n, m, Id, Ip) for n, m, Id, Ip in DISCS], bearings
    )


def kappas(rotor):
    """Shear coefficients of ROSS's elements, in the order of ours."""
    return [e.kappa for shaft in rotor.shafts for e in shaft]


def bending(n):
    """The unknowns across the axis of n: all where a node has four, as in ROSS 1."""
    at = np.arange(n)
    return at if n == 4 * NODES else np.flatnonzero(np.isin(at % 6, (0, 1, 3, 4)))
