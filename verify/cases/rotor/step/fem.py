"""Finite elements of a stepped shaft: two kinds of beams, and the elastic body of revolution."""

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.rotor.step.inputs import StepInputs
from verify.core.case import FemResult
from verify.core.figures import Field

if TYPE_CHECKING:
    from fem.fourier.vibration import RotatingSolid

MODES = (1, 2, 3)
ELEMENTS = 4  # in each piece of the shaft, times the level
CELLS = 10  # of the weak form along the shaft, at least, times the level
CONE = 8  # of it in a cone of the 45° rule, times the level
WITH_CONES = 2  # times CELLS: else their error of order four hides that of the cones, order two
SAME = 1e-9  # of the length: stations that differ by less are one; of a count of cells: round-off
FIRST = 0.03  # cells at the corners over d_1, coarsest mesh
MAPPED = 2  # level of the map
MAP_FIRST = 0.06
NEAR_ONE = (1.01, 1.02, 1.04, 1.07, 1.1)  # d_2/d_1 towards the shaft without a step
RATIOS = (1.1, 1.25, 1.5, 2.0, 2.5, 3.0)  # d_2/d_1 of the map
SHARES = (0.05, 0.1, 0.2, 0.35, 0.5, 0.7)  # L_2/L of the map
CUT = 0.98  # of the volume, whose stress the picture's colours span
ROUND = 1e-9  # of a frequency: what the factors of slender shafts lose


def fem(q: StepInputs, level: int) -> FemResult:
    values: dict[str, float] = {}
    fem_elements(q, level, values)
    weak = {"weak": fem_weak(q, level), "weak 45°": fem_weak(q, level, cone=True)}
    for name, shaft in weak.items():
        ahead, behind = shaft.whirl(q.n, count=len(MODES))
        for j in MODES:
            values |= {f"{name} {j} forward": ahead[j - 1], f"{name} {j} backward": behind[j - 1]}
    body = fem_body(q, level, FIRST)
    fields = fem_solid(q, body, values)
    arrays: dict[str, Any] = {
        "near one": np.array([_half_at_rest(q, r, q.L_2 / q.L, level, FIRST) for r in NEAR_ONE])
    }
    if level == MAPPED:
        arrays["map"] = np.array([[_errors(q, r, share) for r in RATIOS] for share in SHARES])
    values["weak 45° split"] = weak["weak 45°"].splitting(q.n, count=len(MODES))[1]
    u_it = {key: ROUND * abs(value) for key, value in values.items()}
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=fields)


def fem_elements(q: StepInputs, level: int, values: dict[str, float]) -> None:
    """Closed-form elements of Timoshenko's beam, as drawn."""
    from fem.rotor.critical import critical_speeds
    from fem.rotor.model import Element, Material, Rotor, Shaft, Support
    from fem.rotor.modes import modes

    steel = Material(E=q.E, nu=q.nu, rho=q.rho)
    pieces = q.pieces(cone=False)
    rotor = Rotor(
        [Shaft([Element(p.length, p.d, 0.0, steel) for p in pieces])],
        supports=[Support(1, q.k), Support(len(pieces) - 1, q.k)], refine=ELEMENTS * level,
    )  # fmt: skip
    found = modes(rotor, q.n, 2 * len(MODES)).frequencies
    for j in MODES:  # they come in pairs: backward, forward
        values[f"beam {j} backward"], values[f"beam {j} forward"] = found[2 * j - 2 : 2 * j]
    values["beam critical"] = critical_speeds(rotor, 1).speeds[0]


def fem_weak(q: StepInputs, level: int, *, cone: bool = False) -> Any:
    """The same as a weak form; with `cone`, stiff as the 45° rule says, over the steps' cones.

    Cells are of their middle's diameter: rotary inertia stays where it is, without lumps.
    """
    from skfem import MeshLine

    from fem.rotor.weak import weak_shaft

    first, last, seats = q.start, q.start + q.L_2, (q.b / 2, q.L - q.b / 2)
    reach = min((q.d_2 - q.d_1) / 2, q.L_2 / 2) if cone else 0.0
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


def _stations(q: StepInputs, inner: tuple[float, ...]) -> list[float]:
    """Ends of the shaft and the `inner` stations in order, one where some are the same."""
    found = [0.0]
    for z in sorted((*inner, q.L)):
        if z - found[-1] > SAME * q.L:
            found.append(z)
    return found


def fem_body(q: StepInputs, level: int, first: float, *, half: bool = False) -> "RotatingSolid":
    """The elastic body, its seats' mean motions on springs; `half` with symmetry at L/2."""
    from fem.fourier.solid import FourierSolid
    from fem.fourier.vibration import RotatingSolid
    from fem.fourier.vibration_mounts import Mount
    from fem.plane.material import Elastic
    from meshes.rotor.stepped import stepped_section

    parts = [q.parts[0], (q.L_2 / 2, q.d_2, 0.0)] if half else q.parts
    seats = {"left": (0.0, q.b)} | ({} if half else {"right": (q.L - q.b, q.L)})
    mesh = stepped_section(parts, bands=seats, first=first * q.d_1, refine=level)
    solid = FourierSolid(
        mesh, Elastic(E=q.E, nu=q.nu), {"end": "z"} if half else {}, degree=2
    )  # fmt: skip
    return RotatingSolid(solid, q.rho, springs=tuple(Mount(boundary=s, k=q.k) for s in seats))


def fem_solid(q: StepInputs, body: "RotatingSolid", values: dict[str, float]) -> tuple[Field, ...]:
    from fem.fourier.supports import rigid_motions

    found = body.modes(q.n, len(MODES))
    for j in MODES:
        values[f"solid {j} forward"] = found.forward[j - 1]
        values[f"solid {j} backward"] = found.backward[j - 1]
    values["solid critical"] = body.critical_speeds(1)[0][0]
    twice = np.asarray(body.T.multiply(body.T).sum(axis=0)).ravel()
    across, tilt = ((body.T.T @ rigid_motions(body.solid.basis, 1, False)) / twice[:, None]).T
    for name, found_, drawn in (
        ("mass", across @ body.M @ across, [q.rho * np.pi / 4 * d**2 * x for x, d, _ in q.parts]),
        ("polar", tilt @ body.G @ tilt, [q.rho * np.pi / 32 * d**4 * x for x, d, _ in q.parts]),
    ):
        values[f"{name} error"] = float(found_) - sum(drawn)
    return (fem_field(body, found.forward_shapes[:, 0]),)


def fem_field(body: "RotatingSolid", u: Any) -> Field:
    """The plane of the shaft in which mode 1 bends: displacements, and stress along the axis."""
    from fem.fourier.harmonic_cells import stress

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


def _half_at_rest(q: StepInputs, ratio: float, share: float, level: int, first: float) -> float:
    """Mode 1 at rest of the shaft with the thick part in the middle."""
    own = middle(q, ratio, share)
    return float(fem_body(own, level, first, half=True).modes(0.0, 1).forward[0])


def _errors(q: StepInputs, ratio: float, share: float) -> tuple[float, float]:
    """Errors of mode 1 at rest: of the beam as drawn, and by the 45° rule."""
    exact = _half_at_rest(q, ratio, share, 1, MAP_FIRST)
    own = middle(q, ratio, share)
    drawn, cone = (fem_weak(own, MAPPED, cone=c).whirl(0.0, count=1)[0][0] for c in (False, True))
    return drawn / exact - 1, cone / exact - 1


def middle(q: StepInputs, ratio: float, share: float) -> StepInputs:
    """The same shaft with another thick part, in its middle: d_2/d_1 and L_2/L."""
    return q.model_copy(update={"d_2": ratio * q.d_1, "L_2": share * q.L, "a": None})
