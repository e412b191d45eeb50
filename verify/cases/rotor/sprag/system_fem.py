"""One system of the ensemble as a rotor of beam elements, and its clutch under an uneven load."""

from typing import Any

import numpy as np

from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CLUTCH,
    DISCS,
    DRIVE,
    EXPONENT,
    GROUNDED,
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

Damped = tuple[tuple[float, float], tuple[float, float]]  # two frequencies [rad/s], their ratios


def rotor_fem(
    parameters: Array, *, refine: int = 1, damping: Damped | None = None, offset: float = 0.0,
    anisotropy: float = 0.0,
) -> Any:  # fmt: skip
    """The rotor of `parameters` (12,), every element of Fig. 1 cut into `refine`.

    `offset` is that of the clutch over its sprags' deformation, `anisotropy` k_y/k_x - 1 of the
    bearings to the ground. Nodes count from zero: the paper's less one.
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
            Link(CLUTCH[0] - 1, CLUTCH[1] - 1, uneven_clutch(parameters, offset)),
        ],
        refine=refine,
        damping=None if damping is None else Rayleigh.at(*damping),
    )  # fmt: skip


def uneven_clutch(parameters: Array, offset: float) -> Array:
    """K (6, 6) of sprags whose deformation is delta_0 (1 + offset cos psi), all on one contact law.

    K = sum k_j J J^T over sprags and slices with J = (cos, sin, 0, -x sin, x cos, d_t), and
    k_j = k (1 + offset cos psi)^(n - 1), Z k/2 being the even clutch's stiffness across.
    """
    s = layout(parameters)
    psi = 2 * np.pi * np.arange(SPRAGS)[:, None] / SPRAGS
    x = SPRAG_LENGTH * ((np.arange(SLICES) + 0.5) / SLICES - 0.5)[None, :]
    c, sine, x = (np.asarray(a) for a in np.broadcast_arrays(np.cos(psi), np.sin(psi), x))
    J = np.stack([c, sine, 0 * c, -x * sine, x * c, np.full(c.shape, s.d_t[0])], axis=-1)
    k = 2 * s.k_c[0] / (SPRAGS * SLICES) * (1 + offset * c) ** (EXPONENT - 1)
    return np.asarray(np.einsum("jk,jka,jkb->ab", k, J, J, optimize=True))
