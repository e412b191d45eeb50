"""The central system by exact transfer matrices, and its clutch under an uneven load."""

from math import atan, pi
from typing import Any

import numpy as np

from analytic.rotor import transfer_model as transfer
from analytic.rotor.clutch import Clutch, even_angles
from analytic.rotor.transfer_modes import critical_speeds, natural_frequencies
from analytic.rotor.transfer_response import unbalance_response
from analytic.rotor.transfer_torsion import torsional_frequencies
from verify.cases.rotor.sprag.inputs import PRINTED, SpragRotorInputs
from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CENTRAL,
    CLUTCH,
    D_2,
    DISCS,
    DRIVE,
    EXPONENT,
    GROUNDED,
    K_C,
    NU,
    OUTER,
    RHO,
    SLICES,
    SPRAG_LENGTH,
    SPRAGS,
    WEDGE,
    E,
    layout,
)
from verify.core.case import Values
from verify.core.figures import Array

MODES = 6
ORDERS = (1, 3, 5)


def rotor() -> transfer.Rotor:
    """The central system without damping."""
    s = layout(CENTRAL)
    segments = tuple(
        transfer.Segment(length=length, d_o=d_o, d_i=d_i, E=E, nu=NU, rho=RHO)
        for length, d_o, d_i in zip(
            s.length[0].tolist(), s.d_o[0].tolist(), s.d_i[0].tolist(), strict=True
        )
    )
    k_g, k_s, k_c = float(s.k_g[0]), float(s.k_s[0]), float(s.k_c[0])
    clutch = transfer.Link(
        a=CLUTCH[0] - 1, b=CLUTCH[1] - 1, kxx=k_c, k_tilt=float(s.k_tilt[0]),
        k_turn=float(s.k_turn[0]),
    )  # fmt: skip
    return transfer.Rotor(
        shafts=tuple(
            transfer.Shaft(segments=own) for own in (segments[: OUTER - 1], segments[OUTER - 1 :])
        ),
        discs=tuple(
            transfer.Disc(
                node=node - 1, mass=float(s.mass[0, i]), polar=float(s.polar[0, i]),
                diametral=float(s.diametral[0, i]),
            )
            for i, node in enumerate(DISCS)
        ),
        supports=tuple(
            transfer.Support(node=n - 1, kxx=k_g, k_turn=DRIVE if n == GROUNDED[0] else 0.0)
            for n in GROUNDED
        ),
        links=(*(transfer.Link(a=a - 1, b=b - 1, kxx=k_s) for a, b in BETWEEN), clutch),
    )  # fmt: skip


def coupling(offset: float) -> float:
    """K_xz [N/rad] of the central clutch, its rings `offset` times the yield apart along x."""
    return float(uneven(offset)[0, 4])


def uneven(offset: float) -> Array:
    """K (5, 5) of the central clutch about a yield of 1 µm; only its share of it matters."""
    R_i, delta_0 = CENTRAL[D_2] / 2, 1e-6
    k = 2 * CENTRAL[K_C] / SPRAGS
    clutch = Clutch(
        psi=even_angles(Z=SPRAGS), R_i=R_i, nu=atan(WEDGE), L=SPRAG_LENGTH, n=EXPONENT,
        k_n=k / (EXPONENT * delta_0 ** (EXPONENT - 1)), n_s=SLICES,
    )  # fmt: skip
    return clutch.stiffness([offset * delta_0, 0, 0, 0, delta_0 / (R_i * WEDGE)])


def yield_of_sprags(T: float, parameters: Array) -> Array:
    """delta_0 (m,) [m] under T [N m]: K = n T/(2 d_t delta_0) solved for it."""
    s = layout(parameters)
    return EXPONENT * T / (2 * s.d_t * s.k_c)


def analytic(q: SpragRotorInputs) -> Values:
    central = rotor()
    found: dict[str, Any] = {}
    w = natural_frequencies(central, q.speed, count=MODES)[0]
    found |= {f"natural frequency {i + 1}": w[i] / (2 * pi) for i in range(MODES)}
    for whirl in ("forward", "backward"):
        speeds = critical_speeds(central, count=len(ORDERS), whirl=whirl).w
        found |= {f"{whirl} critical {k}": v for k, v in zip(ORDERS, speeds, strict=True)}
    turning = torsional_frequencies(central, count=3)
    response = unbalance_response(
        central, q.rig_speed, {DISCS[0] - 1: q.u_rig_1, DISCS[1] - 1: q.u_rig_2}
    )
    found |= {f"amplitude {n}": response.amplitude(n - 1)[0] for n in DISCS}
    return {key: float(v) for key, v in found.items()} | {
        "torsion, clutch": float(turning[1] / (2 * pi)),
        "torsion, shaft": float(turning[2] / (2 * pi)),
        "coupling": coupling(q.offset),
        "across": float(CENTRAL[K_C]),
        "yield": float(yield_of_sprags(q.T, CENTRAL)[0]),
        "printed 1": PRINTED[0],
        "off printed": float(
            np.abs([found[f"forward critical {k}"] / r - 1
                    for k, r in zip(ORDERS, PRINTED, strict=True)]).max()
        ),
    }  # fmt: skip
