"""Exact transfer matrices of the system fitted from mid-range parameters, and its clutch."""

from math import atan, pi
from typing import Any, Literal

from analytic.rotor import transfer_model as transfer
from analytic.rotor.clutch import SpragCoupling, even_angles
from analytic.rotor.transfer_modes import natural_frequencies, transfer_critical_speeds
from analytic.rotor.transfer_response import transfer_unbalance_response
from analytic.rotor.transfer_torsion import torsional_frequencies
from verify.case import Quantity, shared
from verify.cases.rotor.sprag.inputs import SpragRotorInputs
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
from verify.core.figures import Array

MODES = 6
ORDERS = (1, 3, 5)


def rotor() -> transfer.TransferMatrixRotor:
    """Rotor fitted from mid-range parameters, without damping, for transfer matrices."""
    s = layout(CENTRAL)
    segments = tuple(
        transfer.Segment(length=length, d_o=d_o, d_i=d_i, E=E, nu=NU, rho=RHO)
        for length, d_o, d_i in zip(
            s.length[0].tolist(), s.d_o[0].tolist(), s.d_i[0].tolist(), strict=True
        )
    )
    k_g, k_s, k_c = float(s.k_g[0]), float(s.k_s[0]), float(s.k_c[0])
    clutch = transfer.StationLink(
        a=CLUTCH[0] - 1, b=CLUTCH[1] - 1, kxx=k_c, k_tilt=float(s.k_tilt[0]),
        k_turn=float(s.k_turn[0]),
    )  # fmt: skip
    return transfer.TransferMatrixRotor(
        shafts=tuple(
            transfer.SegmentedShaft(segments=own)
            for own in (segments[: OUTER - 1], segments[OUTER - 1 :])
        ),
        discs=tuple(
            transfer.StationDisc(
                node=node - 1, mass=float(s.mass[0, i]), polar=float(s.polar[0, i]),
                diametral=float(s.diametral[0, i]),
            )
            for i, node in enumerate(DISCS)
        ),
        supports=tuple(
            transfer.StationSupport(node=n - 1, kxx=k_g, k_turn=DRIVE if n == GROUNDED[0] else 0.0)
            for n in GROUNDED
        ),
        links=(*(transfer.StationLink(a=a - 1, b=b - 1, kxx=k_s) for a, b in BETWEEN), clutch),
    )  # fmt: skip


def coupling(offset: float) -> float:
    """Coupling K_xz [N/rad] of the clutch of the fitted mid-range system; rings offset along x.

    `offset` is the ratio of the offset to the sprag deflection.
    """
    return float(uneven(offset)[0, 4])


def uneven(offset: float) -> Array:
    """Stiffness K (5, 5) of the clutch of the fitted mid-range system; rings offset along x.

    `offset` is the ratio of the offset to the sprag deflection of 1 µm. K depends on this ratio
    only.
    """
    R_i, delta_0 = CENTRAL[D_2] / 2, 1e-6
    k = 2 * CENTRAL[K_C] / SPRAGS
    clutch = SpragCoupling(
        psi=even_angles(Z=SPRAGS), R_i=R_i, nu=atan(WEDGE), L=SPRAG_LENGTH, n=EXPONENT,
        k_n=k / (EXPONENT * delta_0 ** (EXPONENT - 1)), n_s=SLICES,
    )  # fmt: skip
    return clutch.stiffness([offset * delta_0, 0, 0, 0, delta_0 / (R_i * WEDGE)])


def yield_of_sprags(T: float, parameters: Array) -> Array:
    """Sprag deflection delta_0 (m,) [m] under T [N m], from K = n T/(2 d_t delta_0)."""
    s = layout(parameters)
    return EXPONENT * T / (2 * s.d_t * s.k_c)


Whirl = Literal["forward", "backward"]


class CentralSystem(SpragRotorInputs):
    """Results of the system fitted from mid-range parameters."""

    @Quantity("f_{0}", "Hz", "natural frequency {0} at speed n").over(range(1, MODES + 1))
    def frequency(self, k: int) -> float:
        return float(self._frequencies[k - 1] / (2 * pi))

    @Quantity("n_{0}", "r/min", "critical speed {0} (forward) of the system fitted from "
                                "mid-range parameters",
              safe="too low").over(ORDERS)  # fmt: skip
    def critical_forward(self, k: int) -> float:
        return self._critical("forward", k)

    @Quantity(
        "n_{0}'", "r/min",
        "critical speed {0} (backward) of the system fitted from mid-range parameters",
    ).over(ORDERS)  # fmt: skip
    def critical_backward(self, k: int) -> float:
        return self._critical("backward", k)

    @Quantity("Ω_1", "rad/s", "lowest forward critical speed of the system fitted from mid-range "
                              "parameters", role="step",
              source="Sec. 1, text before Fig. 6; forward critical speeds, written in r = x + iy",
              tex=r"\Omega,\quad M \ddot q + (C + \Omega G)\dot q + K q=f,\quad "
              r"K v=\Omega^2 (M - G_1) v,\quad C=\alpha M + \beta K,\quad "
              r"\zeta=\frac{1}{2}\left(\frac{\alpha}{\omega} + \beta \omega\right)")  # fmt: skip
    def lowest(self) -> float:
        return self.critical_forward(ORDERS[0])

    @Quantity(
        "x_{0}", "µm", "amplitude of node {0} at the speed of the test rig, without damping"
    ).over(DISCS)
    def amplitude(self, node: int) -> float:
        U = {DISCS[0] - 1: self.u_rig_1, DISCS[1] - 1: self.u_rig_2}
        response = transfer_unbalance_response(self._rotor, self.rig_speed, U)
        return float(response.amplitude(node - 1)[0])

    @Quantity("f_c", "Hz", "torsional frequency of the clutch")
    def torsion_clutch(self) -> float:
        return float(self._torsion[1] / (2 * pi))

    @Quantity("f_t", "Hz", "torsional frequency of the inner shaft")
    def torsion_shaft(self) -> float:
        return float(self._torsion[2] / (2 * pi))

    @Quantity("m", "1", "exponent of the force law of a line contact", source="Eq. 2", role="step")
    def exponent(self) -> float:
        return EXPONENT

    @Quantity("K_xx", "N/µm", "radial stiffness of the clutch in the system fitted from mid-range "
                              "parameters", role="step")  # fmt: skip
    def across(self) -> float:
        return float(CENTRAL[K_C])

    @Quantity("d_t", "mm", "ratio of the deflection of a sprag (sum of both contacts) to the angle "
                          "of twist",
              role="step")  # fmt: skip
    def d_t(self) -> float:
        return float(layout(CENTRAL).d_t[0])

    @Quantity("δ_0", "µm", "sum of the deflections of both contacts of a sprag under T",
              role="step",
              tex=r"\frac{m T}{2 d_t K_{xx}}")  # fmt: skip
    def delta_0(self) -> float:
        return float(yield_of_sprags(self.T, CENTRAL)[0])

    @Quantity("K_xz", "N", "coupling of bending and torsion due to the offset")
    def coupling(self) -> float:
        return coupling(self.offset)

    @Quantity("K_xz1", "N", "coupling of bending and torsion, first order in the offset",
              role="step",
              source="to first order in the offset",
              tex=r"(m - 1) K_{xx} d_t \Delta x/\delta_0")  # fmt: skip
    def coupling_first(self) -> float:
        return (EXPONENT - 1) * self.across * self.d_t * self.offset

    @shared
    def _rotor(self) -> transfer.TransferMatrixRotor:
        return rotor()

    def _critical(self, whirl: Whirl, k: int) -> float:
        return float(self._criticals[whirl][ORDERS.index(k)])

    @shared
    def _criticals(self) -> dict[Whirl, Any]:
        whirls: tuple[Whirl, Whirl] = ("forward", "backward")
        count = len(ORDERS)
        return {w: transfer_critical_speeds(self._rotor, count=count, whirl=w).w for w in whirls}

    @shared
    def _frequencies(self) -> Any:
        return natural_frequencies(self._rotor, self.speed, count=MODES)[0]

    @shared
    def _torsion(self) -> Any:
        return torsional_frequencies(self._rotor, count=3)
