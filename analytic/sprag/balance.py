"""Energy balance of an engagement: kinetic and elastic energy, damping, friction."""

from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array
from analytic.sprag.history import Engagement

HISTORY = ("t", "N", "T_i", "v_i", "alpha", "theta_i", "theta_e")
ENERGIES = ("torque", "blades", "kinetic", "elastic", "support", "damping", "friction", "missing")


@dataclass(frozen=True, kw_only=True, eq=False)
class Balance:
    """Energies and works [J] of the whole clutch since the start of an engagement, (steps,)."""

    torque: Array  # put in by the torque
    blades: Array  # work of the blades, whose other end the equations of motion do not specify
    kinetic: Array
    elastic: Array  # of contacts, races and sprags
    support: Array  # of the spring behind the outer race
    damping: Array
    friction: Array

    @property
    def missing(self) -> Array:
        """Energy error [J]: work done minus energy stored and lost; due only to the time step."""
        kept = self.kinetic + self.elastic + self.support
        return np.asarray(self.torque + self.blades - self.damping - self.friction - kept)


def balance(engagement: Engagement) -> Balance:
    """Energies and works [J] of an engagement since its start, at all time steps."""
    y, table, motion = engagement.states, engagement.table, engagement.motion
    inner, outer, phi, turn = y[:, 4:8].T
    g = table.at(engagement.alpha)
    sprags = motion.m_g * (g["OC_g"] * phi) ** 2 + motion.I_g * (turn - phi) ** 2
    races = motion.I_bi * inner**2 + motion.I_be * outer**2

    def since_start(energy: Array) -> Array:
        return np.asarray(energy - energy[0])

    return Balance(
        torque=y[:, 8],
        blades=y[:, 9],
        damping=y[:, 10],
        friction=y[:, 11],
        kinetic=since_start((races + table.n_s * sprags) / 2),
        elastic=since_start(table.n_s * g["W"]),
        support=since_start(motion.k_out * engagement.theta_e**2 / 2),
    )


def sampled(engagement: Engagement, most: int) -> dict[str, Array]:
    """Histories of an engagement by name, reduced to less than twice `most` samples.

    The histories contain the time t [s], forces N, T_i [N], sliding speed v_i [m/s], angles [rad],
    and the energies and works [J] of `Balance`.
    """
    every = max(len(engagement.t) // most, 1)
    energies = balance(engagement)
    columns = {name: getattr(engagement, name) for name in HISTORY}
    columns |= {name: getattr(energies, name) for name in ENERGIES}
    return {name: np.asarray(column[::every]) for name, column in columns.items()}
