"""The central system as two elastic bodies of revolution with the beams' springs and discs."""

from math import pi

import numpy as np

from verify.cases.rotor_sprag_inputs import SpragRotorInputs
from verify.cases.rotor_sprag_layout import (
    BETWEEN,
    CENTRAL,
    CLUTCH,
    DISCS,
    GROUNDED,
    NU,
    OUTER,
    RHO,
    E,
    Layout,
    layout,
)
from verify.shown import Array

REFINED = (2, 3, 5)  # cells along an edge of the coarsest
BAND = 0.01  # m of the rim that springs and discs hold on to
COARSEST = 0.012  # m


def solid_fem(q: SpragRotorInputs) -> dict[str, Array]:
    """Frequencies (3, 6) [Hz] on three meshes at the speed of comparison, both whirls by size."""
    from fem.fourier.solid import FourierSolid
    from fem.fourier.vibration import RotatingSolid
    from fem.fourier.vibration_mounts import Mount, RigidDisc
    from fem.plane.material import Elastic
    from meshes.join import join
    from meshes.rotor.stepped import stepped_section

    s = layout(CENTRAL)
    found, cells = [], []
    for refine in REFINED:
        outer = stepped_section(
            parts(s, 0), bands=bands(s, 0), first=COARSEST, refine=refine
        )  # fmt: skip
        inner = stepped_section(parts(s, 1), bands=bands(s, 1), first=COARSEST, refine=refine)
        mesh = join({"outer": outer, "inner": inner.translated((0.0, float(s.z[0, OUTER])))})
        springs = [Mount(boundary=band(n), k=float(s.k_g[0])) for n in GROUNDED]
        springs += [Mount(boundary=band(a), to=band(b), k=float(s.k_s[0])) for a, b in BETWEEN]
        a, b = CLUTCH
        springs.append(
            Mount(boundary=band(a), to=band(b), k=float(s.k_c[0]), k_tilt=float(s.k_tilt[0]))
        )
        discs = tuple(
            RigidDisc(boundary=band(n), mass=float(s.mass[0, i]), polar=float(s.polar[0, i]),
                      diametral=float(s.diametral[0, i]))
            for i, n in enumerate(DISCS)
        )  # fmt: skip
        solid = FourierSolid(mesh, Elastic(E=E, nu=NU), degree=2)
        modes = RotatingSolid(solid, RHO, springs=tuple(springs), discs=discs).modes(q.speed, 3)
        found.append(np.sort(np.concatenate([modes.forward, modes.backward])) / (2 * pi))
        cells.append(float(mesh.nelements))
    return {"solid": np.array(found), "solid, cells": np.array(cells)}


def band(node: int) -> str:
    return f"{'outer' if node <= OUTER else 'inner'}.{node}"


def parts(s: Layout, k: int) -> list[tuple[float, float, float]]:
    """Length, diameter and bore of each element of a rotor."""
    own = slice(OUTER - 1) if k == 0 else slice(OUTER - 1, None)
    sizes = (v[0, own].tolist() for v in (s.length, s.d_o, s.d_i))
    return list(zip(*sizes, strict=True))


def bands(s: Layout, k: int) -> dict[str, tuple[float, float]]:
    """Bands on a rotor's rim, from its own first node on, about every node that holds something."""
    held = {*GROUNDED, *DISCS, *CLUTCH, *(n for pair in BETWEEN for n in pair)}
    first = OUTER if k else 0
    own = sorted(n for n in held if (n > OUTER) == bool(k))
    z = {n: float(s.z[0, n - 1] - s.z[0, first]) for n in own}
    return {str(n): (z[n] - BAND / 2, z[n] + BAND / 2) for n in own}
