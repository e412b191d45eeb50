"""Finite elements of a uniform shaft: two kinds of beams, and the elastic body of revolution."""

from typing import Any

import numpy as np
from skfem import MeshLine

from fem.fourier.solid import FourierSolid
from fem.fourier.vibration import RotatingSolid
from fem.plane.material import Elastic
from fem.rotor.critical import critical_speeds
from fem.rotor.model import Element, Material, Rotor, Shaft, Support
from fem.rotor.modes import modes
from fem.rotor.weak import weak_shaft
from meshes.revolution.section import section
from verify.case import Level
from verify.cases.rotor.shaft.inputs import (
    BEAMS,
    MODES,
    RATIOS,
    SLENDER,
    THEORIES,
    TurningShaft,
)

ALONG = 6  # cells along the shaft, times the level
RIGID = 1e14  # stiffness of the bearings over that of the shaft
ROUND = 1e-9  # relative round-off of frequencies of slender shafts, over all levels


def solve(q: TurningShaft, level: int) -> Level:
    """Results of all models on the mesh of a level."""
    values = elements(q, level) | weak_forms(q, level) | of_body(q, body(q, q.L, level))
    limit = np.array([_half_at_rest(q, q.d_o / ratio, level) for ratio in RATIOS])
    u_it = {key: ROUND * abs(value) for key, value in values.items()}
    for name in ("beam_timoshenko", "weak_timoshenko"):
        ahead, behind = (values[f"{name}_whirl_1_{sense}"] for sense in ("forward", "backward"))
        values[f"{name}_split"] = ahead - behind
        u_it[f"{name}_split"] = ROUND * ahead
    return Level(h=1 / level, values=values, u_it=u_it, arrays={"limit": limit})


def _whirl(name: str, forward: Any, backward: Any) -> dict[str, float]:
    """Whirl frequencies of a model, by the names of the quantities."""
    senses = (("forward", forward), ("backward", backward))
    return {f"{name}_whirl_{j}_{sense}": found[j - 1] for sense, found in senses for j in MODES}


def elements(q: TurningShaft, level: int) -> dict[str, float]:
    """Results of beam elements: whirl, critical speeds, and mode 1 of a slender shaft."""
    n = BEAMS * level
    steel = Material(E=q.E, nu=q.nu, rho=q.rho)

    def rotor(L: float, theory: str) -> Any:
        hold = RIGID * q.E * q.d_o**4 / L**3
        return Rotor(
            [Shaft([Element(L / n, q.d_o, q.d_i, steel)] * n)],
            supports=[Support(0, hold), Support(n, hold)], theory=theory,
        )  # fmt: skip

    values: dict[str, float] = {}
    for theory in THEORIES:
        own = rotor(q.L, theory)
        found = modes(own, q.n, 2 * len(MODES) + 2).frequencies
        # they come in pairs: backward, forward
        values |= _whirl(f"beam_{theory}", found[1::2], found[::2])
        whirl = "both" if theory == "euler" else "forward"
        values[f"beam_{theory}_critical"] = critical_speeds(own, 1, whirl=whirl).speeds[0]
    slender = modes(rotor(q.d_o / SLENDER, "timoshenko"), 0.0, 1)
    values["beam_slender"] = slender.frequencies[0]
    sense = modes(rotor(q.L, "timoshenko"), max(q.n, 1.0), 2).whirl
    return values | {"beam_sense": float(sense[1] - sense[0])}


def weak_forms(q: TurningShaft, level: int) -> dict[str, float]:
    """Whirl frequencies of the shaft as a beam in weak form, by all theories."""
    s = q.shaft()
    mesh = MeshLine(np.linspace(0, q.L, BEAMS * level + 1))
    values: dict[str, float] = {}
    for theory in THEORIES:
        own = weak_shaft(
            mesh, bending=q.E * s.I, shear=s.S, mass=q.rho * s.A, rotary=q.rho * s.I,
            theory=theory,
        )  # fmt: skip
        whirl = own.whirl(q.n, held=[0.0, q.L], count=len(MODES))
        values |= _whirl(f"weak_{theory}", *whirl)
    return values


def body(q: TurningShaft, L: float, level: int, *, half: bool = False) -> RotatingSolid:
    """Elastic body, supported transversely at its ends; if `half`, only the half up to L/2."""
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


def of_body(q: TurningShaft, solid: RotatingSolid) -> dict[str, float]:
    """Whirl frequencies of the body at its speed and at rest, splitting and critical speed."""
    found = solid.modes(q.n, len(MODES))
    at_rest = solid.modes(0.0, len(MODES)).forward
    return _whirl("solid", found.forward, found.backward) | {
        "solid_split": found.splitting[0],
        **{f"solid_at_rest_{j}": at_rest[j - 1] for j in MODES},
        "solid_critical": solid.critical_speeds(1)[0][0],
    }


def _half_at_rest(q: TurningShaft, L: float, level: int) -> float:
    """Frequency of mode 1 at rest of the shaft with bearings at the distance L."""
    return float(body(q, L, level, half=True).modes(0.0, 1).forward[0])
