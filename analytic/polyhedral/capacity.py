r"""Torque of the polyhedral ring clutch, with the load transfer by the elastic ring.

At the friction limit (grip = mu, or tan(alpha/2) of free rollers), the torque M_t and the hub force
R are proportional to the roller force N, as in the paper,

.. math:: M_t = \text{grip}\, N z \frac{D_i}{2}, \qquad
          R = \frac{M_t}{z\,(r + r_1)\sin(\psi + \varphi_1)} = \kappa N.

R is inclined from the normal of the flat by phi_1 towards mid-flat, so that its angle with the
radius through its contact is psi + phi_1. In Eq. 16, the rollers carry the whole pressure and hub
force. Here, their share follows from the deflection of the ring (`locking`),

.. math:: p(N) = \frac{1}{u_p}\left[\frac{j_D}{2} + u_N(a) N + \delta(N) - \kappa u_{h1} N\right]

where u_h1 is the displacement by a unit hub force. If :math:`\kappa u_{h1} N` increases with N as
fast as :math:`u_N N + \delta`, no additional pressure is needed: pressure does not limit the
torque.

All forces per unit length. Range: see `locking`.
"""

from dataclasses import dataclass
from math import atan2, cos, hypot, inf, sin

from scipy.optimize import brentq, minimize_scalar

from analytic.contact.checks import not_negative, positive
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import RollerContact

GROWTH, MOST = 1.25, 60  # steps of N in search of the pressure, and how many
START = 1e-3  # start, as a share of the force of the whole pressure
STEP = 1e-3  # relative change of N in difference quotients


@dataclass(frozen=True)
class Driven:
    """Locked ring with a hub that drives it: the hub force R is proportional to the roller force N.

    The hub touches each flat at the distance e [length] from its middle, with the friction
    coefficient tan_phi. `grip` is the ratio of tangential to normal force of a roller on the race
    D_i.

    >>> from analytic.polyhedral.locking import Roller
    >>> from analytic.polyhedral.sector import Sector
    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> contact = RollerContact(ring, Roller(d=10.0, j_D=0.06), 210e3, 0.3, "plane stress")
    >>> hub = Driven(contact, grip=0.08, D_i=100.06, e=9.0, tan_phi=0.05)
    >>> round(hub.kappa, 3), round(hub.force(30.0), 1)
    (0.379, 238.9)
    """

    contact: RollerContact
    grip: float
    D_i: float
    e: float
    tan_phi: float

    def __post_init__(self) -> None:
        positive(self.grip, "the grip of the rollers", "")
        positive(self.D_i, "the race's diameter D_i", "m")
        not_negative(self.tan_phi, "the hub's friction", "")

    @property
    def kappa(self) -> float:
        """Ratio R/N of hub force to roller force."""
        apothem = self.contact.sector.apothem
        turn = atan2(self.e, apothem) + atan2(self.tan_phi, 1)
        return self.grip * self.D_i / (2 * hypot(self.e, apothem) * sin(turn))

    @property
    def lift(self) -> float:
        """Displacement of mid-flat by the hub force for N = 1 [length]."""
        normal = self.kappa * cos(atan2(self.tan_phi, 1))
        hub = hub_force(
            sector=self.contact.sector, e=self.e, normal=normal, along=-normal * self.tan_phi
        )
        return self.contact.lift(hub)

    def pressure(self, N: float) -> float:
        """Pressure [stress] at which each roller carries N; it may decrease with increasing N.

        It decreases with N if the hub wedges the rollers. Then, the state with this N cannot be
        reached at this pressure; see `required_pressure`.
        """
        return self._pressure(float(positive(N, "the roller's force N", "N/m")), self.lift)

    def required_pressure(self, N: float) -> float:
        """Smallest pressure [stress] at which the rollers carry N or more."""
        if self.rises(N):
            return self.pressure(N)
        return self._peak(0.0, N, self.lift)[1]

    def rises(self, N: float) -> bool:
        """True if the pressure increases with N."""
        return self._stiffness(N) > self.lift

    def force_sensitivity(self, N: float) -> float:
        """Relative decrease of N per relative increase of u_N N + delta, at constant pressure."""
        return self.contact.closure(N) / N / (self._stiffness(N) - self.lift)

    def pressure_sensitivity(self, N: float) -> float:
        """Relative change of the pressure per relative change of u_N N + delta, at constant N."""
        return self.contact.closure(N) / (self.contact.growth * self.pressure(N))

    def force(self, p: float) -> float:
        """Force N of a roller under the pressure p; 0 without contact, inf without equilibrium."""
        contact, lift = self.contact, self.lift
        p = float(positive(p, "the pressure p", "Pa"))
        if p * contact.growth <= contact.roller.j_D / 2:
            return 0.0
        low, before = 0.0, contact.roller.j_D / 2 / contact.growth
        high = START * p * contact.sector.d_i
        for _ in range(MOST):
            found = self._pressure(high, lift)
            falls = found <= before
            end, most = self._peak(low / GROWTH, high, lift) if falls else (high, found)
            if most >= p:
                start = max(low / GROWTH, 1e-9 * end)
                if self._pressure(start, lift) >= p:
                    return 0.0  # touches by round-off
                return float(brentq(lambda N: self._pressure(N, lift) - p, start, end, rtol=1e-12))
            if falls:
                return inf
            low, before, high = high, found, high * GROWTH
        return inf

    def _stiffness(self, N: float) -> float:
        """Derivative of u_N N + delta by N [length²/force]."""
        up, down = (self.contact.closure(N * (1 + step)) for step in (STEP, -STEP))
        return (up - down) / (2 * STEP * N)

    def _peak(self, low: float, high: float, lift: float) -> tuple[float, float]:
        """Force N between `low` and `high` with the largest pressure, and this pressure."""
        found = minimize_scalar(
            lambda N: -self._pressure(N, lift), bounds=(max(low, 1e-9 * high), high),
            method="bounded", options={"xatol": 1e-9 * high},
        )  # fmt: skip
        return float(found.x), float(-found.fun)

    def _pressure(self, N: float, lift: float) -> float:
        contact = self.contact
        return (contact.roller.j_D / 2 + contact.closure(N) - lift * N) / contact.growth
