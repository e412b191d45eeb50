"""Finite elements of a uniform shaft: two kinds of beams, and the elastic body of revolution."""

from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.rotor.shafts import Theory
from verify.cases.rotor.shaft.inputs import ShaftInputs
from verify.core.case import FemResult

if TYPE_CHECKING:
    from fem.fourier.vibration import RotatingSolid

THEORIES: tuple[Theory, ...] = ("euler", "rayleigh", "timoshenko")
MODES = (1, 2, 3)
BEAMS = 4  # elements along the shaft, times the level
ALONG = 6  # cells along the shaft, times the level
RIGID = 1e14  # bearings over the shaft's own stiffness
SLENDER = 0.03  # diameter over length of the shaft on which beams are accepted
RATIOS = (0.015, 0.03, 0.05, 0.09, 0.15)  # diameters over lengths towards the limit
ROUND = 1e-9  # of a frequency: what the factors of slender shafts lose, over all levels


def fem(q: ShaftInputs, level: int) -> FemResult:
    values: dict[str, float] = {}
    fem_elements(q, level, values)
    fem_weak(q, level, values)
    body = fem_body(q, q.L, level)
    fem_solid(q, body, values)
    arrays = {
        "limit": np.array([_half_at_rest(q, q.d_o / ratio, level) for ratio in RATIOS]),
    }
    u_it = {key: ROUND * abs(value) for key, value in values.items()}
    for name in ("beam timoshenko", "weak timoshenko"):
        ahead, behind = values[f"{name} 1 forward"], values[f"{name} 1 backward"]
        values[f"{name} split"] = ahead - behind
        u_it[f"{name} split"] = ROUND * ahead
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays)


def fem_elements(q: ShaftInputs, level: int, values: dict[str, float]) -> None:
    """Closed-form elements: whirl, critical speeds, and mode 1 of a slender shaft."""
    from fem.rotor.critical import critical_speeds
    from fem.rotor.model import Element, Material, Rotor, Shaft, Support
    from fem.rotor.modes import modes

    n = BEAMS * level
    steel = Material(E=q.E, nu=q.nu, rho=q.rho)

    def rotor(L: float, theory: str) -> Any:
        hold = RIGID * q.E * q.d_o**4 / L**3
        return Rotor(
            [Shaft([Element(L / n, q.d_o, q.d_i, steel)] * n)],
            supports=[Support(0, hold), Support(n, hold)], theory=theory,
        )  # fmt: skip

    for theory in THEORIES:
        own = rotor(q.L, theory)
        found = modes(own, q.n, 2 * len(MODES) + 2).frequencies
        for j in MODES:  # they come in pairs: backward, forward
            values[f"beam {theory} {j} backward"], values[f"beam {theory} {j} forward"] = found[
                2 * j - 2 : 2 * j
            ]
        whirl = "both" if theory == "euler" else "forward"
        values[f"beam {theory} critical"] = critical_speeds(own, 1, whirl=whirl).speeds[0]
    slender = modes(rotor(q.d_o / SLENDER, "timoshenko"), 0.0, 1)
    values["beam slender"] = slender.frequencies[0]
    sense = modes(rotor(q.L, "timoshenko"), max(q.n, 1.0), 2).whirl
    values["beam sense"] = float(sense[1] - sense[0])


def fem_weak(q: ShaftInputs, level: int, values: dict[str, float]) -> None:
    """The same shaft as a weak form."""
    from skfem import MeshLine

    from fem.rotor.weak import weak_shaft

    s = q.shaft()
    mesh = MeshLine(np.linspace(0, q.L, BEAMS * level + 1))
    for theory in THEORIES:
        own = weak_shaft(
            mesh, bending=q.E * s.I, shear=s.S, mass=q.rho * s.A, rotary=q.rho * s.I,
            theory=theory,
        )  # fmt: skip
        ahead, behind = own.whirl(q.n, held=[0.0, q.L], count=len(MODES))
        for j in MODES:
            values[f"weak {theory} {j} forward"] = ahead[j - 1]
            values[f"weak {theory} {j} backward"] = behind[j - 1]


def fem_body(q: ShaftInputs, L: float, level: int, *, half: bool = False) -> "RotatingSolid":
    """The elastic body; its ends are held across and free along, `half` with symmetry at L/2."""
    from fem.fourier.solid import FourierSolid
    from fem.fourier.vibration import RotatingSolid
    from fem.plane.material import Elastic
    from meshes.revolution.section import section

    cells = level * ALONG // (2 if half else 1)
    across = (level + 1) // 2 if half else level
    mesh = section(
        r=np.linspace(q.d_i / 2, q.d_o / 2, across + 1),
        z=np.linspace(0, L / 2 if half else L, cells + 1),
    )
    solid = FourierSolid(
        mesh, Elastic(E=q.E, nu=q.nu), {"start": "rt", "end": "z" if half else "rt"}, degree=2
    )
    return RotatingSolid(solid, q.rho)


def fem_solid(q: ShaftInputs, body: "RotatingSolid", values: dict[str, float]) -> None:
    found = body.modes(q.n, len(MODES))
    for j in MODES:
        values[f"solid {j} forward"] = found.forward[j - 1]
        values[f"solid {j} backward"] = found.backward[j - 1]
    values["solid split"] = found.splitting[0]
    at_rest = body.modes(0.0, len(MODES)).forward
    for j in MODES:
        values[f"solid {j} at rest"] = at_rest[j - 1]
    values["solid critical"] = body.critical_speeds(1)[0][0]


def _half_at_rest(q: ShaftInputs, L: float, level: int) -> float:
    """Mode 1 at rest of the shaft with its bearings at the distance L."""
    return float(fem_body(q, L, level, half=True).modes(0.0, 1).forward[0])
