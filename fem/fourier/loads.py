"""Loads of a harmonic on named boundaries, as forces work-conjugate to displacement amplitudes."""

from collections.abc import Callable, Mapping

import numpy as np
from skfem import Basis, LinearForm
from skfem.helpers import dot

from fem.plane.axis import has_area
from fem.plane.discretisation import Array, facet_basis, named_facets

Traction = tuple[float, float, float] | Callable[[Array], Array]
Tractions = Mapping[str, Traction]


@LinearForm
def pull(v, w):
    return dot(w.t, v) * w.x[0]


def turn_of(n: int) -> float:
    """Integral of cos^2(n t) over the circumference [rad]: 2 pi for n = 0, otherwise pi."""
    return 2 * np.pi if n == 0 else np.pi


def surface_load(basis: Basis, tractions: Tractions, n: int) -> Array:
    """Forces (unknowns,) of the amplitudes (t_r, t_t, t_z) [stress] of `tractions`.

    Raises ValueError for unknown boundaries, boundaries on the axis, and values that are not
    finite.
    """
    f = np.zeros(basis.N)
    for name, traction in tractions.items():
        facets = named_facets(basis.mesh, name)
        if not has_area(basis.mesh, facets):
            raise ValueError(
                f"boundary {name!r} has no area for a load, because it lies on the axis, r = 0"
            )
        side = facet_basis(basis, facets)
        x = np.asarray(side.global_coordinates())
        t = np.asarray(traction(x) if callable(traction) else np.reshape(traction, (-1, 1, 1)))
        if t.shape[0] != 3:
            raise ValueError(
                f"the traction on {name!r} must have 3 amplitudes (r, t, z), got {len(t)}"
            )
        if not np.all(np.isfinite(t)):
            raise ValueError(f"the traction on {name!r} must be finite")
        f += pull.assemble(side, t=np.broadcast_to(t, (3, *x.shape[1:])).astype(float))
    return turn_of(n) * f
