"""Finite elements of a roller's end face: bodies of revolution, one solution per harmonic."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import Level
from verify.cases.contact.roller import profiles
from verify.cases.contact.window import grid, named
from verify.core.figures import Array, Field

if TYPE_CHECKING:
    from fem.fourier.compliance import SurfaceCompliance
    from fem.fourier.contact import PatchContact
    from verify.cases.contact.roller.end import EndFace

CROWNS = ("flat", "crowned")
ACROSS = 4  # cells on Hertz's half-width, a level
WIDE = (1.5, 2.0, 3.0)  # of the half-width, the patch, until the contact fits
DEEP = 0.4  # of the half-width, the first cell at the end of the contact along the roller
EDGE = 1e-3  # distance from the ring's edge over its radius at which its slope is taken


def solve_fem(q: "EndFace", level: int) -> Level:
    """Results of the roller with end face and of the control model, without and with crown.

    The results include the pressure near the edge of a ring on a longer shaft.
    """
    from fem.fourier.shrunk import edge_slope

    values: dict[str, float] = {}
    u_it: dict[str, float] = {}
    arrays: dict[str, Array] = {}
    race = compliance_fem(q, level, race=True, overhang=q.overhang)
    for name, overhang in (("end", 0.0), ("control", q.overhang)):
        roller = compliance_fem(q, level, race=False, overhang=overhang)
        for crown in CROWNS:
            found = contact_fem(q, level, (roller, race), crown)
            here = read(q, found)
            beside = [
                read(q, contact_fem(q, level, (roller, race), crown, more))["F_d"]
                for more in (-1, 1)
            ]
            state = f"{name}_{crown}"
            # the contact boundary follows cells; effect of other cell sizes across on the ends
            u_it[f"F_d_{state}"] = max(abs(F_d - here["F_d"]) for F_d in beside)
            values |= named(here, f"_{state}")
            arrays |= {
                f"y_{state}": found.z, f"q_{state}": found.line_load, f"p_{state}": found.ridge,
            }  # fmt: skip
            if (name, crown) == ("end", "flat"):
                fields = (patch(found),)
    distance, pressure = edge_fem(level)
    values["sharpness"] = edge_slope(distance, pressure, EDGE)
    arrays |= {"edge_distance": distance, "edge_pressure": pressure}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def stations_fem(q: "EndFace", level: int) -> Array:
    """Coordinates [m] of nodes from mid-length to the end, closest at the end; one is l/2 - d."""
    from meshes.revolution.section import stations

    found = stations(start=q.L / 2, end=0.0, first=DEEP * q.b, growth=1.6, refine=level)
    found[1 + np.argmin(np.abs(found[1:-1] - (q.L / 2 - q.d)))] = q.L / 2 - q.d
    return found


def compliance_fem(q: "EndFace", level: int, *, race: bool, overhang: float) -> "SurfaceCompliance":
    """Surface compliance of the race or of the roller, loaded on two opposite sides."""
    from fem.fourier.compliance import harmonics, surface_compliance
    from fem.fourier.solid import FourierSolid
    from fem.plane.material import Elastic
    from meshes.revolution.cylinder import half_cylinder

    R, E, nu = (q.R_2, q.E_2, q.nu_2) if race else (q.R_1, q.E_1, q.nu_1)
    z, cell = stations_fem(q, level), q.b / (ACROSS * level)
    mesh = half_cylinder(R=R, contact=z, overhang=overhang, first=level * cell, refine=level)
    solid = FourierSolid(mesh, Elastic(E=E, nu=nu), {"start": "z"}, degree=2)
    orders = harmonics(places=2, highest=2 * np.pi * R / cell)
    return surface_compliance(solid, "rim", stations=z, orders=orders)


def contact_fem(q: "EndFace", level: int, bodies: Any, crown: str, more: int = 0) -> "PatchContact":
    """Contact of the half y >= 0 of roller and race, with `more` additional cells in width."""
    from fem.fourier.contact import NarrowPatchError, patch_contact

    gap = profiles.gap(q) if crown == "crowned" else np.zeros_like
    for wide in WIDE:
        across = np.linspace(0.0, wide * q.b, round(wide * ACROSS * level) + more + 1)
        try:
            return patch_contact(bodies, across=across, load=q.F / 2, crown=gap)
        except NarrowPatchError:
            if wide == WIDE[-1]:
                raise
    raise AssertionError


def read(q: "EndFace", found: "PatchContact") -> dict[str, float]:
    """Values of a contact: pressure and line load at mid-length, and load near both ends."""
    q_mid, p_mid = float(np.interp(0.0, found.z, found.line_load)), found.ridge_at(0.0)
    return {
        "p_mid": p_mid,
        "q_mid": q_mid,
        "local": p_mid / math.sqrt(q_mid * q.E_star / (np.pi * q.R)),
        "F_d": 2 * found.load_between(q.L / 2 - q.d, q.L / 2),
    }


def edge_fem(level: int) -> tuple[Array, Array]:
    """Pressures of a ring on a longer shaft, and their distances from the edge of the ring."""
    from skfem import MeshQuad1

    from fem.fourier.shrunk import shrink_pressure
    from fem.fourier.solid import FourierSolid
    from fem.plane.material import Elastic
    from meshes.revolution.cylinder import half_cylinder
    from meshes.revolution.section import stations

    fine: dict[str, Any] = {"first": 4e-5 / level, "growth": 1.5, "refine": 2}
    nodes = stations(start=1.0, end=0.0, **fine)
    z = nodes[::2]
    shaft = half_cylinder(R=1.0, contact=nodes, overhang=0.5, first=fine["first"], refine=2)
    ring = MeshQuad1.init_tensor(stations(start=1.0, end=2.0, **fine), nodes)
    ring = ring.with_boundaries({"bore": lambda x: x[0] == 1, "start": lambda x: x[1] == 0})
    pressure = shrink_pressure([
        (FourierSolid(mesh, Elastic(E=1.0, nu=0.3), {"start": "z"}, degree=2), name)
        for mesh, name in ((shaft, "rim"), (ring, "bore"))
    ], z)  # fmt: skip
    return 1 - (z[1:] + z[:-1]) / 2, pressure


def patch(found: "PatchContact") -> Field:
    """Field of the pressure on both halves of the contact patch."""
    s = np.concatenate([-found.across[:0:-1], found.across])
    y = np.concatenate([-found.stations[:0:-1], found.stations])
    p = np.hstack([found.p[:, ::-1], found.p])
    p = np.vstack([p[::-1], p])
    return grid("patch", y, s, p.T.ravel())
