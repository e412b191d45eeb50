"""The fitted mid-range system as refined beams; on the mesh of the paper, also the ensemble."""

from math import pi
from typing import Any

import numpy as np

from fem.rotor.ensemble import Ensemble
from verify.case import Level
from verify.cases.rotor.sprag.ensemble_fem import elasticities_fem, ensemble_fem
from verify.cases.rotor.sprag.inputs import RPM, SpragRotorInputs
from verify.cases.rotor.sprag.layout import CENTRAL, DISCS
from verify.cases.rotor.sprag.response_fem import responses_fem
from verify.cases.rotor.sprag.solid_fem import solid_fem
from verify.cases.rotor.sprag.system_fem import rotor_fem, systems_fem, uneven_clutch_fem
from verify.core.figures import Array

LEVELS = (1, 2, 4, 8)  # number of beam elements in each element of the paper
ORDERS = (1, 3, 5)
MODES = 6
ROUND_OFF = 1e-10  # relative error of frequencies and amplitudes: condition of K times epsilon
SWEPT = np.linspace(0, 40_000, 41) * RPM


def solve(q: SpragRotorInputs, level: int) -> Level:
    """Beam results of a level; on the mesh of the paper, also ensemble, responses and bodies."""
    values = beams_fem(q, level)
    arrays: dict[str, Any] = {}
    if level == LEVELS[0]:
        ensemble = ensemble_fem(q.members)
        arrays = ensemble_arrays_fem(ensemble)
        arrays |= responses_fem(q, ensemble.members) | drawn_fem(q) | solid_fem(q)
    u_it = {key: ROUND_OFF * abs(value) for key, value in values.items()}
    return Level(h=1 / level, values=values, u_it=u_it, arrays=arrays)


def ensemble_arrays_fem(found: Ensemble) -> dict[str, Any]:
    """Arrays of members, critical speeds, elasticities, and success of the initial values."""
    starts = {"start met": found.met, "start in range": found.kept}
    slopes = elasticities_fem(found.members)
    return {
        "members": found.members, "elasticities": slopes, **starts, **critical_fem(found.members),
    }  # fmt: skip


def beams_fem(q: SpragRotorInputs, refine: int) -> dict[str, float]:
    """Beam results that the transfer matrices also compute."""
    from fem.rotor.critical import critical_speeds
    from fem.rotor.modes import modes
    from fem.rotor.response import unbalance_response

    rotor = rotor_fem(CENTRAL, refine=refine)
    values: dict[str, Any] = {}
    w = modes(rotor, q.speed, MODES).frequencies
    values |= {f"frequency_{i + 1}": w[i] / (2 * pi) for i in range(MODES)}
    for whirl in ("forward", "backward"):
        speeds = critical_speeds(rotor, len(ORDERS), whirl).speeds
        values |= {f"critical_{whirl}_{k}": v for k, v in zip(ORDERS, speeds, strict=True)}
    turning = modes(rotor, 0.0, 3, "torsion").frequencies / (2 * pi)
    values |= {"torsion_clutch": turning[1], "torsion_shaft": turning[2]}
    U = {DISCS[0] - 1: q.u_rig_1, DISCS[1] - 1: q.u_rig_2}
    response = unbalance_response(rotor, q.rig_speed, U)
    values |= {f"amplitude_{n}": response.major(n - 1)[0] for n in DISCS}
    values["coupling"] = uneven_clutch_fem(CENTRAL, q.offset)[0, 5]
    return {key: float(v) for key, v in values.items()}


def critical_fem(members: Array) -> dict[str, Array]:
    """Three critical speeds of each member, (m, 3), by the name of the variant.

    The variants are both senses of whirl, and omitted parts of the clutch stiffness.
    """
    from fem.rotor.critical import critical_speeds

    count = len(ORDERS)
    rotors = [rotor_fem(p) for p in members]
    found = {
        whirl: np.array([critical_speeds(rotor, count, whirl).speeds for rotor in rotors])
        for whirl in ("forward", "backward")
    }
    for name, left_out in (
        ("without clutch", {"across": False, "tilt": False}),
        ("without clutch across", {"across": False}),
        ("without clutch in tilt", {"tilt": False}),
    ):
        found[name] = systems_fem(members, **left_out).critical_speeds(count)[0]
    return {f"critical, {name}": speeds for name, speeds in found.items()}


def drawn_fem(q: SpragRotorInputs) -> dict[str, Array]:
    """Frequency branches, whirl and mode shapes of the fitted mid-range system, for figures."""
    from fem.rotor.campbell import campbell
    from fem.rotor.modes import modes

    rotor = rotor_fem(CENTRAL, refine=2)
    swept = campbell(rotor, SWEPT, MODES)
    found = modes(rotor, q.speed, MODES)
    nodes = rotor.stations
    return {
        "swept": SWEPT, "branches": swept.frequencies / (2 * pi),
        "branches, whirl": swept.whirl[-1], "shapes": found.shapes[:, :nodes, :2],
        "shapes, whirl": found.whirl,
    }  # fmt: skip
