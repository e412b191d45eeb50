"""Finite elements of a stepped shaft: two kinds of beams, and the elastic body of revolution."""

from itertools import pairwise
from typing import Any

import numpy as np

from fem.fourier.bending_plane import bending_plane
from fem.fourier.inertia import rigid_inertia
from fem.fourier.solid import FourierSolid
from fem.fourier.vibration import RotatingSolid
from fem.fourier.vibration_mounts import Mount
from fem.plane.material import Elastic
from fem.rotor.critical import critical_speeds
from fem.rotor.model import Element, Material, Rotor, Shaft, Support
from fem.rotor.modes import modes
from fem.rotor.stepped_weak import stations, stepped_weak
from fem.rotor.weak import WeakShaft
from meshes.rotor.stepped import stepped_section
from verify.case import Level, solved
from verify.cases.rotor.step.inputs import MODES, NEAR_ONE, RATIOS, SHARES, SteppedShaft
from verify.core.figures import Field

ELEMENTS = 4  # number of elements in each piece of the shaft, times the level
FIRST = 0.03  # cell size at the corners over d_1, coarsest mesh
MAPPED = 2  # level at which the map of errors is computed
MAP_FIRST = 0.06
ROUND = 1e-9  # relative round-off of frequencies of slender shafts


def solve(q: SteppedShaft, level: int) -> Level:
    """Results of all models on the mesh of a level; level `MAPPED` also has the map of errors."""
    values = elements(q, level)
    weak = {"weak": weak_form(q, level), "weak_cone": weak_form(q, level, cone=True)}
    for name, shaft in weak.items():
        values |= _whirl(name, *shaft.whirl(q.n, count=len(MODES)))
    solid = body(q, level, FIRST)
    found, field = of_body(q, solid)
    values |= found
    values["weak_cone_split"] = weak["weak_cone"].splitting(q.n, count=len(MODES))[1]
    arrays: dict[str, Any] = {
        "near_one": np.array([_half_at_rest(q, r, q.L_2 / q.L, level, FIRST) for r in NEAR_ONE])
    }
    if level == MAPPED:
        arrays["map"] = np.array([[_errors(q, r, share) for r in RATIOS] for share in SHARES])
    return solved(1 / level, field, iteration=ROUND, **values, **arrays)


def _whirl(name: str, forward: Any, backward: Any) -> dict[str, float]:
    """Frequencies of a model, by the names of the quantities."""
    senses = (("forward", forward), ("backward", backward))
    return {f"{name}_whirl_{j}_{sense}": found[j - 1] for sense, found in senses for j in MODES}


def elements(q: SteppedShaft, level: int) -> dict[str, float]:
    """Results of Timoshenko beam elements with the nominal diameters."""
    rotor = beam(q, ELEMENTS * level)
    found = modes(rotor, q.n, 2 * len(MODES)).frequencies
    # frequencies are in pairs: backward, forward
    values = _whirl("beam", found[1::2], found[::2])
    return values | {"beam_critical": critical_speeds(rotor, 1).speeds[0]}


def beam(q: SteppedShaft, refine: int) -> Rotor:
    """Beam with nominal diameters; `refine` elements between adjacent steps and seats."""
    steel = Material(E=q.E, nu=q.nu, rho=q.rho)
    inside = [
        Element(high - low, q.d_2 if q.start < (low + high) / 2 < q.end else q.d_1, 0.0, steel)
        for low, high in pairwise(stations(q.L, (*q.seats, q.start, q.end)))
    ]
    supports = [Support(1, q.k), Support(len(inside) - 1, q.k)]
    return Rotor([Shaft(inside)], supports=supports, refine=refine)


def weak_form(q: SteppedShaft, level: int, *, cone: bool = False) -> WeakShaft:
    """Beam of the shaft as a weak form; with `cone`, its stiffness follows the 45° rule."""
    return stepped_weak(
        L=q.L, d_1=q.d_1, d_2=q.d_2, step=(q.start, q.end), seats=q.seats, k=q.k,
        reach=q.reach if cone else 0.0, E=q.E, nu=q.nu, rho=q.rho, level=level,
    )  # fmt: skip


def body(q: SteppedShaft, level: int, first: float, *, half: bool = False) -> RotatingSolid:
    """Elastic body with springs on the mean motion of each seat; if `half`, half of the body."""
    parts = [q.parts[0], (q.L_2 / 2, q.d_2, 0.0)] if half else q.parts
    seats = {"left": (0.0, q.b)} | ({} if half else {"right": (q.L - q.b, q.L)})
    mesh = stepped_section(parts, bands=seats, first=first * q.d_1, refine=level)
    solid = FourierSolid(
        mesh, Elastic(E=q.E, nu=q.nu), {"end": "z"} if half else {}, degree=2
    )  # fmt: skip
    return RotatingSolid(solid, q.rho, springs=tuple(Mount(boundary=s, k=q.k) for s in seats))


def of_body(q: SteppedShaft, solid: RotatingSolid) -> tuple[dict[str, float], Field]:
    """Values of the body (whirl, errors of mass and polar moment), and its field in mode 1."""
    found = solid.modes(q.n, len(MODES))
    values = _whirl("solid", found.forward, found.backward)
    values["solid_critical"] = solid.critical_speeds(1)[0][0]
    mass, polar, _ = rigid_inertia(solid)
    values["mass_error"], values["polar_error"] = float(mass) - q.mass, float(polar) - q.polar
    return values, _mode(solid, found.forward_shapes[:, 0])


def _mode(body: RotatingSolid, u: Any) -> Field:
    """Displacements and axial stress of mode 1 in the plane of bending."""
    plane = bending_plane(body, u)
    return Field(
        name="mode 1", points=plane.points, cells=plane.cells,
        point_data={"displacement": plane.displacement * 0.1 * np.ptp(plane.points[:, 0])},
        cell_data={"stress along z": plane.stress},
        units={"displacement": "m", "stress along z": "1"},
    )  # fmt: skip


def _half_at_rest(q: SteppedShaft, ratio: float, share: float, level: int, first: float) -> float:
    """Frequency of mode 1 at rest of the shaft with the thick part in the middle."""
    own = q.with_middle(ratio, share)
    return float(body(own, level, first, half=True).modes(0.0, 1).forward[0])


def _errors(q: SteppedShaft, ratio: float, share: float) -> tuple[float, float]:
    """Errors of mode 1 at rest: beam with nominal diameters, beam by the 45° rule."""
    exact = _half_at_rest(q, ratio, share, 1, MAP_FIRST)
    own = q.with_middle(ratio, share)
    drawn, cone = (weak_form(own, MAPPED, cone=c).whirl(0.0, count=1)[0][0] for c in (False, True))
    return drawn / exact - 1, cone / exact - 1
