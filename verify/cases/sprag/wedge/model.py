"""Model of a wedged sprag: elastic bodies, and bounds of the expected errors of its formulas."""

from functools import lru_cache

import numpy as np

from analytic.bounds.sprag.wedge import Bounds
from analytic.bounds.sprag.wedge_sizes import Race, Sizes
from analytic.sprag.closure import wedged
from analytic.sprag.elastic import ElasticSpragClutch
from analytic.sprag.parts import SpragClutchParts
from verify.cases.sprag.inputs import WedgeInputs

MESHES = 5e-4  # error of angles of user sprags; the meshes of the case were refined to convergence


@lru_cache(maxsize=32)
def bodies(q: WedgeInputs) -> ElasticSpragClutch:
    """The clutch whose parts deflect as elastic bodies."""
    return ElasticSpragClutch(
        SpragClutchParts(
            sprag=q.sprag, n_s=q.z, l=q.l, b=q.b, R_id=q.R_id, R_ed=q.R_ed, E=q.E, nu=q.nu
        )
    )


def rigid_force(q: WedgeInputs) -> float:
    """Normal force [N] of a sprag in a rigid clutch, N_0 = T/(n_s R_i tan(nu_0))."""
    return float(q.T / (q.z * q.R_i * np.tan(q.nu_0)))


@lru_cache(maxsize=256)
def bounds(q: WedgeInputs, N: float) -> Bounds:
    """Bounds of the expected errors of all formulas at the normal force N [N]."""
    one = bodies(q)
    a_i, a_e = one.half_widths(np.asarray(N))
    inner, outer = (
        Race(race.mean, float(race.at(a)), float(race.under(a)))
        for race, a in zip(one.races, (a_i, a_e), strict=True)
    )
    sizes = Sizes(
        R_id=q.R_id, R_i=q.R_i, R_e=q.R_e, R_ed=q.R_ed, r_i=q.r_i, r_e=float(q.sprag.r_e),
        nu_0=q.nu_0, z=q.z, b=q.b, l=q.l, E=q.E, nu=q.nu, E_plane=one.E_plane,
    )  # fmt: skip
    return Bounds(
        sizes=sizes, N=N, at=wedged(one.clutch, N), a=(float(a_i), float(a_e)),
        races=(inner, outer), column=one.column, meshes=0.0 if q == WedgeInputs() else MESHES,
    )  # fmt: skip
