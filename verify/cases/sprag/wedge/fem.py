"""Finite elements of a sprag clutch through its stroke: the sweep, read where formulas stand."""

import math

import numpy as np
from numpy.typing import NDArray

from verify.cases.sprag.fem import Sector, State
from verify.cases.sprag.inputs import WedgeInputs
from verify.cases.sprag.wedge.sweep import Sweep, rigid_force
from verify.core.case import FemResult
from verify.core.figures import Field

Array = NDArray[np.float64]

LEVELS = (9, 12, 15)  # cells on half a fine zone, of which contacts take 6, 8, 10
LOADS = {"N_0/4": 0.25, "N_0/2": 0.5, "N_0": 1.0, "1.8 N_0": 1.8}
GRID = np.linspace(0.2, 1.8, 9)  # of N_0, where profiles are compared
ONSET = 5e-4  # of tan(nu): to either side of the friction that just holds
SLIPS = 1  # the state, at a quarter of N_0, whose friction is lowered
# contacts end elsewhere in a cell from mesh to mesh: measured by zones 1 % wider and narrower
NOISE, PEAKS, EDGES = 1e-4, 2e-4, 6e-4  # of forces and yields, pressures and half-widths
SPLINE = 5e-6  # of a value: what splines miss
AT_FORCE = ("tan nu", "tan omega", "T", "alpha", "H", "mean i", "mean e", "race i", "race e", "p_i",
            "p_e", "a_i", "a_e")  # fmt: skip


def fem(q: WedgeInputs, level: int) -> FemResult:
    sweep, N_0 = Sweep(q, level), rigid_force(q)
    values = {name: sweep.at(name, q.T, "T") for name in ("N", "alpha")}
    for name, share in LOADS.items():
        N = share * N_0
        values |= {f"{key}, {name}": sweep.at(key, N) for key in AT_FORCE}
        values[f"N_e/N_i, {name}"] = sweep.at("N_e", N) / N - 1
        at = np.array([sweep.at("T", N)])
        values[f"theta, {name}"] = float(sweep.turn_by_energy(at)[0])
    values |= statics(sweep)
    if level <= LEVELS[0]:  # on coarse meshes all the same
        values |= onset(sweep)
    states, grid = sweep.at_states, GRID * N_0
    arrays = {
        "loads": np.array([states[k] for k in ("N", "T", "tan nu", "tan omega", "alpha", "H")]),
        "profile, alpha": np.array([sweep.at("alpha", N) for N in grid]),
        "profile, nu": np.arctan([sweep.at("tan nu", N) for N in grid]),
        "profile, omega": np.arctan([sweep.at("tan omega", N) for N in grid]),
    }
    u_it = {key: doubt(key) * abs(value) for key, value in values.items()}
    return FemResult(
        h=1 / level, values=values, u_it=u_it, arrays=arrays, fields=(field(sweep.states[-1]),)
    )


def doubt(key: str) -> float:
    """Iteration uncertainty of a value, relative."""
    if key.startswith("mean"):
        return SPLINE  # as the force, wherever it acts
    if key.startswith("N_e/N_i"):
        return 2 * NOISE  # it goes with the square of the angles
    if key.startswith(("p_", "a_")):
        return PEAKS if key.startswith("p_") else EDGES
    return NOISE


def statics(sweep: Sweep) -> dict[str, float]:
    """What balances leave at the state near N_0, relative."""
    k = len(sweep.states) - 2
    state, at = sweep.states[k], {name: v[k] for name, v in sweep.at_states.items()}
    force = np.add(*(np.array(touch.force) for touch in state.solution.touches))
    size = np.hypot(*state.solution.touches[0].force)
    return {
        "column": at["T"] / (sweep.q.z * at["N"] * at["strut nu"] * at["OA"]) - 1,
        "held": at["held"] / at["T"] - 1,
        "forces": float(np.hypot(*force)) / float(size),
        "work": float(sweep.work(at["N"])[0]) / at["U"] - 1,
    }


def onset(sweep: Sweep) -> dict[str, float]:
    """Coefficients of friction with which the sprag holds and slides out; nan where it does not."""
    state = sweep.states[SLIPS]
    tan = state.T[0] / state.N[0]
    above, below = (1 + ONSET) * tan, (1 - ONSET) * tan
    return {
        "holds": above if stays(state, above) else math.nan,
        "slides": math.nan if stays(state, below) else below,
        "N at onset": sweep.at_states["N"][SLIPS],
    }


def stays(state: State, mu: float) -> bool:
    """Whether friction `mu` holds the sprag: at both contacts some nodes stick."""
    return not Sector(state.start, state.widths, 4, mu=mu).at(state.drags).solution.slides


def field(state: State) -> Field:
    """The sector with displacements and von Mises' stress."""
    cells = state.solution.plane.cells()
    return Field(
        name="sector", points=cells["points"], cells=cells["cells"].astype(np.int64),
        point_data={"displacement": cells["displacement"]},
        cell_data={"stress": cells["stress"], "von_mises": cells["von_mises"],
                   "log_mises": np.log10(np.maximum(cells["von_mises"] / 1e6, 10.0))},
        units={"displacement": "m", "stress": "Pa", "von_mises": "Pa", "log_mises": "1"},
    )  # fmt: skip
