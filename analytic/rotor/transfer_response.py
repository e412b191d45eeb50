"""Steady response of a rotor to unbalance, by exact transfer matrices with damped bearings."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.rotor.transfer_bending import Bending
from analytic.rotor.transfer_model import Spring, StationLink, StationSupport, TransferMatrixRotor
from analytic.rotor.transfer_supported import check_supported

Complex = NDArray[np.complex128]
Array = NDArray[np.float64]


@dataclass(frozen=True)
class TransferResponse:
    """Response of a rotor to unbalance at the rotor speeds `speeds` [rad/s].

    The excitation rotates at `w` >= 0 [rad/s]. `unknowns` (speeds, 4 * nodes) are (r+, phi+ L) and
    then (r-, phi- L), with r = r+ e^{iwt} + conj(r-) e^{-iwt}.
    """

    speeds: Array
    w: Array
    unknowns: Complex
    bending: Bending

    def at(self, node: int) -> tuple[Complex, Complex]:
        """Components r+ and r- [m] of the deflection of a station, each (speeds,)."""
        half = self.unknowns.shape[1] // 2
        return self.unknowns[:, 2 * node], self.unknowns[:, half + 2 * node]

    def amplitude(self, node: int) -> Array:
        """Major half-axis [m] of the orbit of a station, (speeds,)."""
        plus, minus = self.at(node)
        return np.asarray(np.abs(plus) + np.abs(minus))

    def force(self, spring: Spring) -> tuple[Complex, Complex]:
        """Components F+ and F- [N] of the force on a support, or on a link at its station `a`."""
        if isinstance(spring, StationSupport):
            plus, minus = self.at(spring.node)
        else:
            assert isinstance(spring, StationLink)
            (pa, ma), (pb, mb) = self.at(spring.a), self.at(spring.b)
            plus, minus = pa - pb, ma - mb
        (k, d), (c, e) = spring.stiffness, spring.damping
        mean, other, turned = k + 1j * self.w * c, d + 1j * self.w * e, np.conj(d)
        return mean * plus + other * minus, (
            turned + 1j * self.w * np.conj(e)
        ) * plus + mean * minus

    def load(self, spring: Spring) -> Array:
        """Largest force [N] of a bearing during a revolution, (speeds,)."""
        plus, minus = self.force(spring)
        return np.asarray(np.abs(plus) + np.abs(minus))


Response = TransferResponse  # its name in version 0.1


def transfer_unbalance_response(
    rotor: TransferMatrixRotor,
    speeds: ArrayLike,
    unbalances: Mapping[int, complex],
    *,
    excitation: float = 1.0,
) -> TransferResponse:
    """Response to unbalances m e [kg m] at stations; each is a complex number with its phase.

    They rotate at `excitation` times the rotor speed, where `excitation` is the speed ratio of
    their shaft. Raises ValueError if a station is unknown, there is no unbalance, or a speed is
    negative or not finite.
    """
    Omega = np.atleast_1d(np.asarray(speeds, dtype=np.float64))
    if not (np.isfinite(Omega) & (Omega >= 0)).all():
        raise ValueError("speeds must be finite and not negative")
    if not unbalances:
        raise ValueError("at least one unbalance at a station must be given, got none")
    check_supported(rotor)
    w = abs(excitation) * Omega
    top = np.array([w.max(), -w.max()])
    bending = Bending.up_to(rotor, top, np.full(2, Omega.max()))
    force = np.zeros((Omega.size, 4 * bending.nodes), dtype=np.complex128)
    for node, value in unbalances.items():
        if not 0 <= node < rotor.stations:
            raise ValueError(
                f"an unbalance must be at an existing station, got {node}, the last station is "
                f"{rotor.stations - 1}"
            )
        if excitation > 0:
            force[:, 2 * node] += value * w**2
        else:  # backward whirl
            force[:, 2 * bending.nodes + 2 * node] += np.conj(value) * w**2
    return TransferResponse(Omega, w, _solved(bending, w, Omega, force), bending)


unbalance_response = transfer_unbalance_response  # its name in version 0.1


def _solved(bending: Bending, w: Array, Omega: Array, force: Complex) -> Complex:
    """Unknowns (speeds, 4 * nodes); on isotropic bearings, each whirl sense separately."""
    if not bending.rotor.isotropic:
        D = bending.coupled(w, Omega, damped=True)
        return np.asarray(np.linalg.solve(D, force[..., None])[..., 0])
    found = np.zeros_like(force)
    C, half = bending.dampers[0], force.shape[1] // 2
    for sign, part in ((1, slice(None, half)), (-1, slice(half, None))):
        if force[:, part].any():
            D = bending.stiffness(sign * w, Omega) + 1j * w[:, None, None] * C
            found[:, part] = np.linalg.solve(D, force[:, part, None])[..., 0]
    return found
