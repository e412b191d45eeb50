"""Finite-element results of a sprag clutch over its stroke, at the states of the formulas."""

import math

import numpy as np
from numpy.typing import NDArray

from fem.wedge.races import Sector, State
from meshes.sprag.wedged import Place
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge.sweep import Sweep, rigid_force
from verify.core.case import FemResult
from verify.form.fields import plane_field

Array = NDArray[np.float64]

LEVELS = (9, 12, 15)  # cells on half a fine zone, of which contacts take 6, 8, 10
GRID = np.linspace(0.2, 1.8, 9)  # forces of the compared profiles over N_0
ONSET = 5e-4  # relative to tan(nu): friction below and above the limit
SLIPS = 1  # the state, at a quarter of N_0, whose friction is lowered
# contacts end at another place in a cell on each mesh: measured by zones 1 % wider and narrower
NOISE, PEAKS, EDGES = 1e-4, 2e-4, 6e-4  # for forces and deflections; pressures; half-widths
SPLINE = 5e-6  # relative error of splines
# the states of the stroke, and names of values in the sweep
STROKE = {"quarter": 0.25, "half": 0.5, "rigid": 1.0, "most": 1.8}  # over N_0
AT_FORCE = {"mu_i": "tan nu", "mu_e": "tan omega", "T": "T", "alpha": "alpha", "H": "H",
            "mean_i": "mean i", "mean_e": "mean e", "race_i": "race i", "race_e": "race e",
            "p_i": "p_i", "p_e": "p_e", "a_i": "a_i", "a_e": "a_e"}  # fmt: skip


def solve(q: WedgeInputs, level: int) -> FemResult:
    """Results of a mesh: values under T and over the stroke, balances, curves over N."""
    sweep, N_0 = Sweep(q, level), rigid_force(q)
    values = {name: sweep.at(name, q.T, "T") for name in ("N", "alpha")}
    for name, share in STROKE.items():
        N = share * N_0
        values |= {f"{key}_{name}": sweep.at(of, N) for key, of in AT_FORCE.items()}
        values[f"excess_{name}"] = sweep.at("N_e", N) / N - 1
        at = np.array([sweep.at("T", N)])
        values[f"theta_{name}"] = float(sweep.turn_by_energy(at)[0])
    values["secant_rigid"] = values["T_rigid"] / values["theta_rigid"]
    values |= statics(sweep)
    if level <= LEVELS[0]:  # equal for all contacts on coarse meshes
        values |= onset(sweep)
    states, grid = sweep.at_states, GRID * N_0
    arrays = {
        "loads": np.array([states[k] for k in ("N", "T", "tan nu", "tan omega", "alpha", "H")]),
        "profile_alpha": np.array([sweep.at("alpha", N) for N in grid]),
        "profile_nu": np.arctan([sweep.at("tan nu", N) for N in grid]),
        "profile_omega": np.arctan([sweep.at("tan omega", N) for N in grid]),
    }
    u_it = {key: doubt(key) * abs(value) for key, value in values.items()}
    field = plane_field(sweep.states[-1].solution.plane, "stress", "von_mises", "log_mises",
                        name="sector")  # fmt: skip
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=(field,))


def doubt(key: str) -> float:
    """Relative uncertainty of the value `key` due to iteration."""
    if key.startswith("mean"):
        return SPLINE  # error of the force, for any position
    if key.startswith("excess"):
        return 2 * NOISE  # it is proportional to the square of the angles
    if key.startswith(("p_", "a_")):
        return PEAKS if key.startswith("p_") else EDGES
    return NOISE


def statics(sweep: Sweep) -> dict[str, float]:
    """Relative residuals, by name, of the balances of forces, torques and work near N_0."""
    k = len(sweep.states) - 2
    state, at = sweep.states[k], {name: v[k] for name, v in sweep.at_states.items()}
    force = np.add(*(np.array(touch.force) for touch in state.solution.touches))
    size = np.hypot(*state.solution.touches[0].force)
    return {
        "column": at["T"] / (sweep.z * at["N"] * at["strut nu"] * at["OA"]) - 1,
        "held": at["held"] / at["T"] - 1,
        "forces": float(np.hypot(*force)) / float(size),
        "work": float(sweep.work(at["N"])[0]) / at["U"] - 1,
    }


def onset(sweep: Sweep) -> dict[str, float]:
    """Two friction coefficients near T_i/N_i between which slip begins, and the normal force [N].

    "holds" is above T_i/N_i, "slides" below. "holds" is nan if the sprag slips with it, and
    "slides" is nan if the sprag holds with it.
    """
    state = sweep.states[SLIPS]
    tan = state.T[0] / state.N[0]
    above, below = (1 + ONSET) * tan, (1 - ONSET) * tan
    return {
        "holds": above if stays(state, above) else math.nan,
        "slides": math.nan if stays(state, below) else below,
        "N_at_onset": sweep.at_states["N"][SLIPS],
    }


def stays(state: State[Place], mu: float) -> bool:
    """Whether the sprag holds with friction `mu`, that is, some nodes of each contact stick."""
    sector = Sector(state.sector.q, state.start, state.widths, 4, mu=mu)
    return not sector.at(state.drags).solution.slides
