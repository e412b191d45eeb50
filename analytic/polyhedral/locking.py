r"""Forces of the rollers between the polyhedral ring and its race.

A roller is located above the middle of each flat. Pressure p and hub force displace the ring
outwards there. The roller force N per unit length displaces it inwards, with its local indentation:

.. math:: u_p\,p + u_h - u_N(a)\,N - \delta(N) = \frac{j_D}{2}, \qquad
          a = \sqrt{\frac{4 N R}{\pi E^*}}, \quad \frac{1}{R} = \frac{2}{d} + \frac{2}{d_e}.

delta is the compression of the roller between both contacts, 0 for a rigid roller; the race is
rigid. The force of the pressure on a flat is :math:`p\,d_i\sin(\pi/z)` per unit length. The
incremental load-transfer ratio

.. math:: \eta = \frac{1}{d_i\sin(\pi/z)}\,\frac{dN}{dp}

is the fraction of an additional pressure force that acts on the roller; the hoop force of the ring
carries the rest. For a large number of corners, it increases to a value above 1, the pressure ratio
of a round ring in a rigid housing,

.. math:: \eta \to \frac{2\, d_i d_e}{(1 - \nu')\, d_e^2 + (1 + \nu')\, d_i^2},

which is 1.027 for d_i = 0.9 d_e and nu' = 0.3. It exceeds 1 because the pressure compresses the
wall in thickness, and the wall then tends to expand along the circumference.

Range: frictionless contacts of a half-width much smaller than d and the wall thickness; rollers at
mid-flat.
"""

from dataclasses import dataclass

import numpy as np

from analytic.contact import hertz_line
from analytic.contact.checks import Assumption, finite, in_plane, positive
from analytic.contact.hertz_line_approach import approach_to_centre
from analytic.polyhedral.bore_pressure import rim_displacement
from analytic.polyhedral.hub_force import HubForce
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector

STEPS, CLOSE = 40, 1e-12
FIRST = 1e-4  # relative to the outside radius: half-width with which the search starts
NUDGE = 1e-3  # relative change of N in the difference quotient of the compression


@dataclass(frozen=True, kw_only=True)
class Roller:
    """Roller of diameter d; the gap between ring and race is wider than the roller by j_D/2."""

    d: float
    j_D: float
    E: float = np.inf  # rigid
    nu: float = 0.0

    def __post_init__(self) -> None:
        positive(self.d, "the roller's diameter d", "m")
        positive(self.j_D, "the play j_D", "m")


@dataclass(frozen=True, kw_only=True)
class Locked:
    """State of rollers under load; all forces per unit length."""

    N: float  # of one roller [force per length]; 0 before it touches
    a: float  # half-width of its contact on the ring [length]
    a_race: float  # and on the race, 0 for a rigid roller
    touch: float  # pressure [stress] at which the rollers are reached, with the hub's force on
    efficiency: float  # share of a further pressure's force on the flat; 0 before it touches
    hub_share: float  # share of a further hub force, of its resultant; 0 without a hub


@dataclass(frozen=True)
class RollerContact:
    """Contact of ring and roller under N per unit length, and the deflection of the ring."""

    sector: Sector
    roller: Roller
    E: float
    nu: float
    assumption: Assumption

    @property
    def E_plane(self) -> float:
        """Modulus E' of the ring in plane stress or plane strain."""
        E = positive(self.E, "Young's modulus", "Pa")
        return float(in_plane(E, self.nu, self.assumption)[0])

    @property
    def growth(self) -> float:
        """Outward displacement u_p of mid-flat per unit pressure [length per stress]."""
        grown = rim_displacement(
            0.0, sector=self.sector, p=1.0, E=self.E, nu=self.nu, assumption=self.assumption
        )
        return float(grown.real[0])

    def lift(self, hub: HubForce) -> float:
        """Outward displacement u_h of mid-flat by the hub force [length]."""
        return float(hub.rim_displacement(0.0).real[0]) / self.E_plane

    def half_width(self, N: float) -> float:
        """Half-width a of the contact on the ring [length]."""
        R = hertz_line.relative_radius(R_1=self.roller.d / 2, R_2=self.sector.r_e)
        E_star = hertz_line.contact_modulus(
            E_1=self.E,
            nu_1=self.nu,
            E_2=self.roller.E,
            nu_2=self.roller.nu,
            assumption=self.assumption,
        )
        return float(hertz_line.half_width(P=N, R=R, E_star=E_star))

    def closure(self, N: float) -> float:
        """Inward displacement of the rim plus compression of the roller, u_N N + delta [length]."""
        a = self.half_width(N)
        load = roller_load(sector=self.sector, a=a)
        dent = load.rim_displacement(0.0, E=self.E, nu=self.nu, assumption=self.assumption)
        return float(-N * dent[0]) + self._squeeze(N, a)

    def half_width_on_race(self, N: float) -> float:
        """Half-width [length] of the contact of roller and rigid race; 0 for a rigid roller."""
        if np.isinf(self.roller.E):
            return 0.0
        race = self.sector.r_e + self.roller.d + self.roller.j_D / 2
        R = hertz_line.relative_radius(R_1=self.roller.d / 2, R_2=-race)
        return float(hertz_line.half_width(P=N, R=R, E_star=self._roller_modulus))

    @property
    def _roller_modulus(self) -> float:
        return float(in_plane(self.roller.E, self.roller.nu, self.assumption)[0])

    def _squeeze(self, N: float, a: float) -> float:
        if np.isinf(self.roller.E):
            return 0.0
        widths = [a, self.half_width_on_race(N)]
        if max(widths) >= self.roller.d / 2:
            raise ValueError(
                f"N={N:g} N/m is too large for a roller of d={self.roller.d:g} m: the half-width "
                f"of its contacts would be {max(widths):.2g} m and must be less than d/2"
            )
        ends = approach_to_centre(
            P=N, a=widths, R=self.roller.d / 2, E_plane=self._roller_modulus
        )  # fmt: skip
        return float(ends.sum())


def locked(
    *,
    sector: Sector,
    roller: Roller,
    p: float,
    E: float,
    nu: float,
    assumption: Assumption,
    hub: HubForce | None = None,
) -> Locked:
    """Roller force, pressure that closes the clearance, and load-transfer ratios of a locked ring.

    >>> ring = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)
    >>> steel = {"E": 210e3, "nu": 0.3, "assumption": "plane stress"}
    >>> state = locked(sector=ring, roller=Roller(d=10.0, j_D=0.06), p=30.0, **steel)
    >>> round(state.N, 1), round(state.touch, 2), round(state.efficiency, 3)
    (185.9, 20.26, 0.541)
    """
    p = float(finite(p, "the pressure p", "Pa"))
    contact = RollerContact(sector, roller, E, nu, assumption)
    u_p, E_plane = contact.growth, contact.E_plane
    u_h = 0.0 if hub is None else contact.lift(hub)
    gap = roller.j_D / 2 - u_h
    touch, closing = gap / u_p, u_p * p - gap
    if closing <= 0:
        return Locked(N=0.0, a=0.0, a_race=0.0, touch=touch, efficiency=0.0, hub_share=0.0)
    N = _force(contact, closing, E_plane)
    up, down = (contact.closure(N * (1 + step)) for step in (NUDGE, -NUDGE))
    compliance = (up - down) / (2 * NUDGE * N)
    side = sector.d_i * np.sin(sector.half_angle)
    return Locked(
        N=N,
        a=contact.half_width(N),
        a_race=contact.half_width_on_race(N),
        touch=touch,
        efficiency=float(u_p / compliance / side),
        hub_share=0.0 if hub is None else u_h / compliance / hub.resultant,
    )


def _force(contact: RollerContact, closing: float, E_plane: float) -> float:
    """Force N at which u_N N + delta is `closing`, by Newton's method with an estimated slope."""
    bodies = 1 / E_plane if np.isinf(contact.roller.E) else 3 / E_plane
    N = E_plane * (FIRST * contact.sector.r_e) ** 2 / contact.roller.d
    for _ in range(STEPS):
        closure = contact.closure(N)
        change = (closing - closure) / (closure / N - bodies / np.pi)
        N = max(N + change, N / 10)
        if abs(change) <= CLOSE * N:
            return float(N)
    raise ArithmeticError(
        f"the force of the roller did not converge: N={N:g} N/m after {STEPS} steps"
    )
