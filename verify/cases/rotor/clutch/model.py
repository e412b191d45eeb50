"""Formulas' side of a clutch between two rotors, in its uniform state and in uneven ones.

`corrected` is what Eq. 3 becomes when the sprags' forces run along their struts, inclined by nu:

    delta = (cos psi - tan nu sin psi) dx + ... = cos(psi + nu) dx / cos nu + ...,

the same formulas with turned angles and stretched displacements. It judges what Eq. 3 leaves out.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import LINE_CONTACT, Array, Clutch
from analytic.rotor.clutch_state import under_torque
from verify.cases.rotor.clutch.inputs import ClutchInputs
from verify.cases.rotor.clutch.tilted import couplings
from verify.core.case import Values

n = LINE_CONTACT
FINE = 401  # slices that stand for none
ENTRIES = {"K_xx": (0, 0), "K_yy": (1, 1), "K_tilt": (3, 3), "K_zz": (4, 4), "K_xz": (0, 4)}
ACROSS = {"K_xy": (0, 1), "K_yz": (1, 4)}  # zero by Eq. 3 wherever the x-axis halves a clutch


@dataclass(frozen=True, kw_only=True)
class State:
    """What is uneven about a clutch: an offset along x, a crown, a gap."""

    offset: bool = False
    crowned: bool = False
    gap: bool = False


STATES: Mapping[str, State] = {
    "uniform": State(),
    "offset": State(offset=True),
    "crown": State(crowned=True),
    "gap": State(gap=True),
    "together": State(offset=True, crowned=True, gap=True),
}


def tangent(q: ClutchInputs, state: State, *, n_s: int | None = None) -> Array:
    """K (5, 5) of the formulas in a state under T."""
    clutch = q.clutch(crowned=state.crowned, gap=state.gap, n_s=n_s)
    dx = q.e if state.offset else 0.0
    return clutch.stiffness(under_torque(clutch, T=q.T, offset=(dx, 0, 0, 0)))


@lru_cache(maxsize=32)
def corrected(q: ClutchInputs, state: State) -> Array:
    """K (5, 5) with forces along the struts, and slices as fine as matters."""
    clutch = q.clutch(crowned=state.crowned, gap=state.gap, n_s=FINE)
    turned: Clutch = replace(clutch, psi=clutch.psi + q.nu)
    dx = q.e / math.cos(q.nu) if state.offset else 0.0
    K = turned.stiffness(under_torque(turned, T=q.T, offset=(dx, 0, 0, 0)))
    stretch = np.array([1.0, 1.0, 1.0, 1.0, math.cos(q.nu)]) / math.cos(q.nu)
    return np.asarray(K * np.outer(stretch, stretch))


def pinned_torsion(q: ClutchInputs, *, k: float, N: float) -> float:
    """K_zz [N m/rad] of struts held in both races: F' h^2 - F (R_i R_e cos beta - h^2)/l each.

    The distance of their ends obeys l^2 = R_i^2 + R_e^2 - 2 R_i R_e cos beta; h = R_i sin nu.
    """
    h = q.R_i * math.sin(q.nu)
    beta = q.nu - math.asin(h / q.R_e)
    length = math.sqrt(q.R_i**2 + q.R_e**2 - 2 * q.R_i * q.R_e * math.cos(beta))
    bent = (q.R_i * q.R_e * math.cos(beta) - h**2) / length
    return float(q.Z * (k / math.cos(q.nu) ** 2 * h**2 - N / math.cos(q.nu) * bent))


def analytic(q: ClutchInputs) -> Values:
    N = uniform.normal_force(T=q.T, Z=q.Z, d_t=q.d_t)
    delta_0 = uniform.approach(N=N, k_n=q.k_n)
    k = uniform.contact_stiffness(N=N, k_n=q.k_n)
    values: dict[str, Any] = {
        "N": N,
        "delta_0": delta_0,
        "twist": delta_0 / q.d_t,
        "k": k,
        "d_t": q.d_t,
        "K_xx": uniform.radial_stiffness(Z=q.Z, k=k),
        "K_yy": uniform.radial_stiffness(Z=q.Z, k=k),
        "K_zz": uniform.torsional_stiffness(Z=q.Z, k=k, d_t=q.d_t),
        "K_tilt": uniform.tilting_stiffness(Z=q.Z, k=k, L=q.L, n_s=q.n_s),
        "K_zz, pinned": pinned_torsion(q, k=float(k), N=float(N)),
        "K_xz, first order": uniform.offset_coupling(
            Z=q.Z, k=k, d_t=q.d_t, dx=q.e, delta_0=delta_0
        ),
        "T": q.T,
    }
    values |= along_struts(q) | couplings(q) | {"exponent": 1 - 1 / n}
    for name, state in STATES.items():
        K = tangent(q, state)
        values |= {f"{entry}, {name}": K[at] for entry, at in ENTRIES.items()}
        values[f"coupling, {name}"] = K[0, 4] / math.sqrt(K[0, 0] * K[4, 4])
    return {key: float(value) for key, value in values.items()}


def along_struts(q: ClutchInputs) -> dict[str, float]:
    """K_xy [N/m] and K_yz [N] of forces along the struts, zero by Eq. 3; "gap" in closed form.

    Sprags missing at psi_g leave K_xy = -k tan(nu) sum cos(2 psi_g), and K_yz = tan(nu) K_xz.
    """
    k = uniform.contact_stiffness(
        N=uniform.normal_force(T=q.T, Z=q.Z - q.missing, d_t=q.d_t), k_n=q.k_n
    )
    gone = q.angles()[: q.missing]
    K = corrected(q, STATES["together"])
    return {
        "K_xy, gap, along struts": float(-k * math.tan(q.nu) * np.cos(2 * gone).sum()),
        "K_yz, gap, along struts": float(-k * q.d_t * math.tan(q.nu) * np.cos(gone).sum()),
        **{f"{entry}, together, along struts": float(K[at]) for entry, at in ACROSS.items()},
    }


def tilted(q: ClutchInputs, state: State) -> float:
    """What the forces take from K_tilt [N m/rad] as their points on the race tilt with it.

    A force along e at a point y of the race, which turns while the force keeps its direction, does
    the work e . w x (w x y)/2 more: -N R_i cos^2 psi for a tilt about y.
    """
    clutch = q.clutch(crowned=state.crowned, gap=state.gap)
    dx = q.e if state.offset else 0.0
    N = clutch.forces(under_torque(clutch, T=q.T, offset=(dx, 0, 0, 0))).sum(-1)
    return float(q.R_i * N @ np.cos(clutch.psi) ** 2)
