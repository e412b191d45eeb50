"""Stiffness of links around a shaft; all links have the same force law, but unequal loads."""

import numpy as np

from fem.rotor.elements import Array


def uneven_links(
    *, Z: int, slices: int, L: float, lever: float, across: float, exponent: float, offset: float
) -> Array:
    """Stiffness K (6, 6) of Z links with the deformations delta_0 (1 + offset cos psi).

    K = sum k_j J J^T over links and slices with J = (cos, sin, 0, -x sin, x cos, lever), and k_j =
    k (1 + offset cos psi)^(exponent - 1) for a slice at the angle psi and the axial position x. The
    lateral stiffness of equally loaded links is `across` = Z `slices` k/2 [N/m]. `L` is the length
    of the links [m], `lever` the deformation per angle of twist [m].

    >>> K = uneven_links(Z=4, slices=2, L=1.0, lever=0.5, across=2.0, exponent=1.1, offset=0.0)
    >>> K.diagonal().round(12).tolist()
    [2.0, 2.0, 0.0, 0.125, 0.125, 1.0]
    """
    psi = 2 * np.pi * np.arange(Z)[:, None] / Z
    x = L * ((np.arange(slices) + 0.5) / slices - 0.5)[None, :]
    c, sine, x = (np.asarray(a) for a in np.broadcast_arrays(np.cos(psi), np.sin(psi), x))
    J = np.stack([c, sine, 0 * c, -x * sine, x * c, np.full(c.shape, lever)], axis=-1)
    k = 2 * across / (Z * slices) * (1 + offset * c) ** (exponent - 1)
    return np.asarray(np.einsum("jk,jka,jkb->ab", k, J, J, optimize=True))
