"""The system fitted from mid-range parameters as two elastic bodies of revolution."""

from math import pi
from typing import TYPE_CHECKING

import numpy as np

from verify.cases.rotor.sprag.inputs import SpragRotorInputs
from verify.cases.rotor.sprag.layout import (
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
from verify.core.figures import Array

if TYPE_CHECKING:
    from fem.fourier.vibration import RotatingSolid

REFINED = (2, 3, 5)  # number of cells along an edge of a cell of the coarsest mesh
BAND = 0.01  # m, width of the bands on the rim to which springs and discs are attached
COARSEST = 0.012  # m, cell size before refinement


def solid_fem(q: SpragRotorInputs) -> dict[str, Array]:
    """Frequencies (3, 6) [Hz] of the bodies on three meshes at `q.speed`, in ascending order.

    Further results are the frequencies (6,) of the coarsest mesh with bands of twice the width, and
    the mass [kg], the polar and the diametral moment about node 1 [kg m^2] of all rotating parts.
    """
    from fem.fourier.inertia import rigid_inertia

    bodies = [body_fem(refine, BAND) for refine in REFINED]
    return {
        "solid": np.array([frequencies_fem(body, q.speed) for body in bodies]),
        "solid, wide bands": frequencies_fem(body_fem(REFINED[0], 2 * BAND), q.speed),
        "solid, cells": np.array([float(body.solid.mesh.nelements) for body in bodies]),
        "solid, inertia": rigid_inertia(bodies[-1]),
    }


def frequencies_fem(body: "RotatingSolid", speed: float) -> Array:
    modes = body.modes(speed, 3)
    return np.sort(np.concatenate([modes.forward, modes.backward])) / (2 * pi)


def body_fem(refine: int, width: float) -> "RotatingSolid":
    """Model of both rotors, supported on bands of `width`."""
    from fem.fourier.solid import FourierSolid
    from fem.fourier.vibration import RotatingSolid
    from fem.fourier.vibration_mounts import Mount, RigidDisc
    from fem.plane.material import Elastic
    from meshes.join import join
    from meshes.rotor.stepped import stepped_section

    s = layout(CENTRAL)
    outer, inner = (
        stepped_section(parts(s, k), bands=bands(s, k, width), first=COARSEST, refine=refine)
        for k in range(2)
    )
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
    return RotatingSolid(solid, RHO, springs=tuple(springs), discs=discs)


def band(node: int) -> str:
    return f"{'outer' if node <= OUTER else 'inner'}.{node}"


def parts(s: Layout, k: int) -> list[tuple[float, float, float]]:
    """Length, diameter and bore of each element of a rotor."""
    own = slice(OUTER - 1) if k == 0 else slice(OUTER - 1, None)
    sizes = (v[0, own].tolist() for v in (s.length, s.d_o, s.d_i))
    return list(zip(*sizes, strict=True))


def bands(s: Layout, k: int, width: float) -> dict[str, tuple[float, float]]:
    """Axial intervals [m] of bands on the rim, by node, measured from the rotor's first node.

    Nodes with a bearing, a disc or the clutch have a band.
    """
    held = {*GROUNDED, *DISCS, *CLUTCH, *(n for pair in BETWEEN for n in pair)}
    first = OUTER if k else 0
    own = sorted(n for n in held if (n > OUTER) == bool(k))
    z = {n: float(s.z[0, n - 1] - s.z[0, first]) for n in own}
    return {str(n): (z[n] - width / 2, z[n] + width / 2) for n in own}
