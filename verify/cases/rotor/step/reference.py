"""Finite elements of a stepped shaft: two kinds of beams, and the elastic body of revolution."""

from itertools import pairwise
from typing import Any

import numpy as np
from skfem import MeshLine

from fem.fourier.harmonic_cells import stress
from fem.fourier.solid import FourierSolid
from fem.fourier.supports import rigid_motions
from fem.fourier.vibration import RotatingSolid
from fem.fourier.vibration_mounts import Mount
from fem.plane.material import Elastic
from fem.rotor.critical import critical_speeds
from fem.rotor.model import Element, Material, Rotor, Shaft, Support
from fem.rotor.modes import modes
from fem.rotor.weak import weak_shaft
from meshes.rotor.stepped import stepped_section
from verify.case import Level, solved
from verify.cases.rotor.step.inputs import MODES, NEAR_ONE, RATIOS, SHARES, SteppedShaft
from verify.core.figures import Field

ELEMENTS = 4  # in each piece of the shaft, times the level
CELLS = 10  # of the weak form along the shaft, at least, times the level
CONE = 8  # of it in a cone of the 45° rule, times the level
WITH_CONES = 2  # times CELLS: else their error of order four hides that of the cones, order two
SAME = 1e-9  # of the length: stations that differ by less are one; of a count of cells: round-off
FIRST = 0.03  # cells at the corners over d_1, coarsest mesh
MAPPED = 2  # level of the map
MAP_FIRST = 0.06
CUT = 0.98  # of the volume, whose stress the picture's colours span
ROUND = 1e-9  # of a frequency: what the factors of slender shafts lose


def solve(q: SteppedShaft, level: int) -> Level:
    """All models on one level; the map of errors on one of them."""
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
    """Frequencies of a model by the quantities' names."""
    ways = (("forward", forward), ("backward", backward))
    return {f"{name}_whirl_{j}_{way}": found[j - 1] for way, found in ways for j in MODES}


def elements(q: SteppedShaft, level: int) -> dict[str, float]:
    """Closed-form elements of Timoshenko's beam, as drawn."""
    steel = Material(E=q.E, nu=q.nu, rho=q.rho)
    pieces = q.pieces(cone=False)
    rotor = Rotor(
        [Shaft([Element(p.length, p.d, 0.0, steel) for p in pieces])],
        supports=[Support(1, q.k), Support(len(pieces) - 1, q.k)], refine=ELEMENTS * level,
    )  # fmt: skip
    found = modes(rotor, q.n, 2 * len(MODES)).frequencies
    # they come in pairs: backward, forward
    values = _whirl("beam", found[1::2], found[::2])
    return values | {"beam_critical": critical_speeds(rotor, 1).speeds[0]}


def weak_form(q: SteppedShaft, level: int, *, cone: bool = False) -> Any:
    """The same as a weak form; with `cone`, stiff as the 45° rule says, over the steps' cones.

    Cells are of their middle's diameter: rotary inertia stays where it is, without lumps.
    """
    first, last, seats = q.start, q.start + q.L_2, (q.b / 2, q.L - q.b / 2)
    reach = q.reach if cone else 0.0
    z = [0.0]
    for low, high in pairwise(_stations(q, (*seats, first, first + reach, last - reach, last))):
        depth = min((low + high) / 2 - first, last - (low + high) / 2)
        cells = (WITH_CONES if cone else 1) * CELLS * (high - low) / q.L
        n = CONE if 0 < depth < reach else int(np.ceil(cells - SAME))
        z += np.linspace(low, high, level * n + 1)[1:].tolist()
    inwards = np.minimum(m := (np.array(z[1:]) + z[:-1]) / 2, first + last - m) - first
    d = np.where(inwards > 0, q.d_2, q.d_1)
    stiff = np.where(inwards > 0, np.minimum(d, q.d_1 + 2 * inwards), d) if cone else d
    kappa = 6 * (1 + q.nu) ** 2 / (7 + 12 * q.nu + 4 * q.nu**2)  # Hutchinson's, solid
    own = weak_shaft(
        MeshLine(np.array(z)), bending=q.E * np.pi / 64 * stiff**4,
        shear=kappa * q.E / (2 * (1 + q.nu)) * np.pi / 4 * stiff**2,
        mass=q.rho * np.pi / 4 * d**2, rotary=q.rho * np.pi / 64 * d**4,
    )  # fmt: skip
    return own.on_springs(dict.fromkeys(seats, q.k))


def _stations(q: SteppedShaft, inner: tuple[float, ...]) -> list[float]:
    """Ends of the shaft and the `inner` stations in order, one where some are the same."""
    found = [0.0]
    for z in sorted((*inner, q.L)):
        if z - found[-1] > SAME * q.L:
            found.append(z)
    return found


def body(q: SteppedShaft, level: int, first: float, *, half: bool = False) -> RotatingSolid:
    """The elastic body, its seats' mean motions on springs; `half` with symmetry at L/2."""
    parts = [q.parts[0], (q.L_2 / 2, q.d_2, 0.0)] if half else q.parts
    seats = {"left": (0.0, q.b)} | ({} if half else {"right": (q.L - q.b, q.L)})
    mesh = stepped_section(parts, bands=seats, first=first * q.d_1, refine=level)
    solid = FourierSolid(
        mesh, Elastic(E=q.E, nu=q.nu), {"end": "z"} if half else {}, degree=2
    )  # fmt: skip
    return RotatingSolid(solid, q.rho, springs=tuple(Mount(boundary=s, k=q.k) for s in seats))


def of_body(q: SteppedShaft, solid: RotatingSolid) -> tuple[dict[str, float], Field]:
    """Its whirl, and what its mass and polar moment differ by from those of its parts."""
    found = solid.modes(q.n, len(MODES))
    values = _whirl("solid", found.forward, found.backward)
    values["solid_critical"] = solid.critical_speeds(1)[0][0]
    twice = np.asarray(solid.T.multiply(solid.T).sum(axis=0)).ravel()
    across, tilt = ((solid.T.T @ rigid_motions(solid.solid.basis, 1, False)) / twice[:, None]).T
    values["mass_error"] = float(across @ solid.M @ across) - q.mass
    values["polar_error"] = float(tilt @ solid.G @ tilt) - q.polar
    return values, _mode(solid, found.forward_shapes[:, 0])


def _mode(body: RotatingSolid, u: Any) -> Field:
    """The plane of the shaft in which mode 1 bends: displacements, and stress along the axis."""
    cells, mesh = body.solid.cells, body.solid.mesh
    sigma = stress(cells.strain(u, 1), cells.lam[:, None], cells.mu[:, None])[..., 2]
    volume = cells.dx.sum(axis=1)
    mean = (sigma * cells.dx).sum(axis=1) / volume
    order = np.argsort(abs(mean))
    below = np.cumsum(volume[order]) <= CUT * volume.sum()  # not the corners' own peaks
    mean = np.clip(mean / abs(mean[order][below][-1]), -1, 1)
    U, _, W = u[body.solid.basis.nodal_dofs]
    r, z = mesh.p
    top = max(abs(U).max(), abs(W).max())
    shift = np.column_stack([np.tile(W, 2) * np.repeat([1, -1], W.size), np.tile(U, 2)])
    return Field(
        name="mode 1", points=np.column_stack([np.tile(z, 2), np.concatenate([r, -r])]),
        cells=np.hstack([mesh.t, mesh.t + r.size]).T.astype(np.int64),
        point_data={"displacement": shift / top * 0.1 * np.ptp(z)},
        cell_data={"stress along z": np.concatenate([mean, -mean])},
        units={"displacement": "m", "stress along z": "1"},
    )  # fmt: skip


def _half_at_rest(q: SteppedShaft, ratio: float, share: float, level: int, first: float) -> float:
    """Mode 1 at rest of the shaft with the thick part in the middle."""
    own = q.with_middle(ratio, share)
    return float(body(own, level, first, half=True).modes(0.0, 1).forward[0])


def _errors(q: SteppedShaft, ratio: float, share: float) -> tuple[float, float]:
    """Errors of mode 1 at rest: of the beam as drawn, and by the 45° rule."""
    exact = _half_at_rest(q, ratio, share, 1, MAP_FIRST)
    own = q.with_middle(ratio, share)
    drawn, cone = (weak_form(own, MAPPED, cone=c).whirl(0.0, count=1)[0][0] for c in (False, True))
    return drawn / exact - 1, cone / exact - 1
