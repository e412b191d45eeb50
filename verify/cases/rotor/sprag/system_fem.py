"""Systems of the ensemble as beam elements, and the clutch with unequal sprag deflections."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CLUTCH,
    DISCS,
    DRIVE,
    EXPONENT,
    GROUNDED,
    HOLLOW,
    INNER,
    NU,
    OUTER,
    RHO,
    SLICES,
    SPRAG_LENGTH,
    SPRAGS,
    E,
    layout,
)
from verify.core.figures import Array

if TYPE_CHECKING:
    from fem.rotor.whirl_systems import WhirlSystems

Damped = tuple[tuple[float, float], tuple[float, float]]  # two frequencies [rad/s], their ratios


def rotor_fem(
    parameters: Array, *, refine: int = 1, damping: Damped | None = None, offset: float = 0.0,
    anisotropy: float = 0.0,
) -> Any:  # fmt: skip
    """The rotor of `parameters` (12,), each element of Fig. 1 divided into `refine` elements.

    `offset` is the offset of the clutch over the deformation of its sprags; `anisotropy` is
    k_y/k_x - 1 of the bearings to the ground. Nodes are numbered from 0; in the paper, from 1.
    """
    from fem.rotor.damping import Rayleigh
    from fem.rotor.model import Disc, Element, Link, Material, Rotor, Shaft, Support

    s = layout(parameters)
    steel = Material(E, NU, RHO)
    sizes = zip(s.length[0].tolist(), s.d_o[0].tolist(), s.d_i[0].tolist(), strict=True)
    elements = [Element(length, d_o, d_i, steel) for length, d_o, d_i in sizes]
    k_g, k_s = float(s.k_g[0]), float(s.k_s[0])
    drive = {GROUNDED[0]: DRIVE}
    return Rotor(
        [Shaft(elements[: OUTER - 1]), Shaft(elements[OUTER - 1 :], z=float(s.z[0, OUTER]))],
        [
            Disc(node - 1, float(s.mass[0, i]), float(s.polar[0, i]), float(s.diametral[0, i]))
            for i, node in enumerate(DISCS)
        ],
        [
            Support(n - 1, k_g, kyy=k_g * (1 + anisotropy), kzz=k_g, k_turn=drive.get(n, 0.0))
            for n in GROUNDED
        ],
        [
            *(Link.bearing(a - 1, b - 1, k_s, kzz=k_s) for a, b in BETWEEN),
            Link(CLUTCH[0] - 1, CLUTCH[1] - 1, uneven_clutch_fem(parameters, offset)),
        ],
        refine=refine,
        damping=None if damping is None else Rayleigh.at(*damping),
    )  # fmt: skip


def uneven_clutch_fem(parameters: Array, offset: float) -> Array:
    """Stiffness (6, 6) of a clutch whose sprags are deformed by delta_0 (1 + offset cos psi)."""
    from fem.rotor.uneven_links import uneven_links

    s = layout(parameters)
    return uneven_links(Z=SPRAGS, slices=SLICES, L=SPRAG_LENGTH, lever=s.d_t[0], across=s.k_c[0],
                         exponent=EXPONENT, offset=offset)  # fmt: skip


def systems_fem(p: Array, *, across: bool = True, tilt: bool = True) -> "WhirlSystems":
    """Whirl systems of the parameters (m, 12).

    Without `across`, the clutch has no radial stiffness; without `tilt`, no tilting stiffness.
    """
    from fem.rotor.parts import Element, Material
    from fem.rotor.whirl_systems import Discs, Springs, WhirlSystems

    s, steel = layout(p), Material(E, NU, RHO)
    a, b = (2 * node - 2 for node in CLUTCH)
    springs = [Springs(2 * n - 2, None, s.k_g) for n in GROUNDED]
    springs += [Springs(2 * one - 2, 2 * other - 2, s.k_s) for one, other in BETWEEN]
    springs += [Springs(a, b, s.k_c)] if across else []
    springs += [Springs(a + 1, b + 1, s.k_tilt)] if tilt else []
    return WhirlSystems(
        nodes=OUTER + INNER, first=tuple(n for n in range(OUTER + INNER - 1) if n != OUTER - 1),
        length=s.length, d_o=s.d_o, d_i=s.d_i, material=steel, springs=tuple(springs),
        kappa=np.array([Element(1.0, 1.0, bore, steel).kappa for bore in HOLLOW]),
        discs=tuple(
            Discs(node - 1, s.mass[:, i], s.polar[:, i], s.diametral[:, i])
            for i, node in enumerate(DISCS)
        ),
    )  # fmt: skip
