r"""Polyhedral ring clutch: torque and all intermediate values, from its parts.

`PolyhedralClutch` evaluates Eqs. 2 to 21 in the order of the paper. Two definitions in the paper
are ambiguous: the lever arm of the hub contact ("exact", or "d_i/2" as in the paper) and the
direction on which the hub force is projected (the "normal" of the flat, or the "radius" as in the
first design of the paper). K is 1 as in the paper, or the result of a model of the ring. If a wedge
angle alpha is given, the ratio of tangential to normal force of a roller is tan(alpha/2). If none
is given, the rollers are at the friction limit mu N, as in Eqs. 4 and 17 to 21. For rollers without
a cage, this corresponds to alpha = 2 arctan mu, the largest angle that holds.
"""

from dataclasses import dataclass
from math import inf, sqrt, tan
from typing import Literal, get_args

from analytic.contact import hertz_line
from analytic.contact.checks import not_negative, positive
from analytic.polyhedral import expansion, forces, torque, wedging
from analytic.polyhedral.parts import PolyhedralParts

Lever = Literal["exact", "d_i/2"]
Gamma = Literal["normal", "radius"]


@dataclass(frozen=True)
class PolyhedralClutch:
    """Polyhedral ring clutch under the total pressure p_t [Pa]; SI units, forces per roller.

    E and nu apply to ring, rollers and race. mu is the friction coefficient of the rollers, phi_1
    the friction angle of the hub, M_wanted [N m] a target torque. Raises ValueError for invalid
    values. `remarks` states if the ring does not touch the rollers, the rollers are expelled or the
    hub locks by itself.

    >>> parts = PolyhedralParts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)
    >>> steel = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": 0.05}
    >>> round(PolyhedralClutch(parts, **steel, lever="d_i/2", gamma="radius").M_t, 1)  # N m
    443.9
    """

    parts: PolyhedralParts
    p_t: float
    E: float
    nu: float
    mu: float
    phi_1: float
    K: float = 1.0
    alpha: float | None = None
    M_wanted: float | None = None
    lever: Lever = "exact"
    gamma: Gamma = "normal"

    def __post_init__(self) -> None:
        not_negative(self.p_t, "total pressure p_t", "Pa")
        if self.M_wanted is not None:
            positive(self.M_wanted, "target torque", "N m")
        for name, known in (("lever", Lever), ("gamma", Gamma)):
            if (given := getattr(self, name)) not in get_args(known):
                raise ValueError(
                    f"{name} must be one of {', '.join(get_args(known))}, got {given!r}"
                )
        self.parts.hub_must_release(self.phi_1)
        _ = self.N, self.wedges, self.p_0_race  # raises the errors of the formulas

    @property
    def sigma_t(self) -> float:
        """Hoop stress [Pa] of a round ring whose expansion closes the clearance (Eq. 9)."""
        parts = self.parts
        return float(expansion.hoop_stress(j_D=parts.j_D, d_m=parts.d_m, E=self.E))

    @property
    def p_1(self) -> float:
        """Pressure [Pa] that causes sigma_t (Eq. 10)."""
        return float(expansion.pressure(sigma=self.sigma_t, **self._ring))

    @property
    def p_1r(self) -> float:
        """Pressure [Pa] at which the polygonal ring reaches the rollers (Eq. 11)."""
        return float(positive(self.K, "correction K", "")) * self.p_1

    @property
    def sigma_tr(self) -> float:
        """Mean hoop stress [Pa] in the corners under the pressure p_1r (Eq. 12)."""
        return float(expansion.mean_hoop_stress(p=self.p_1r, **self._ring))

    @property
    def p_2(self) -> float:
        """Blocking pressure [Pa], which acts on the rollers (Eq. 19)."""
        return float(torque.blocking_pressure(p_t=self.p_t, p_1r=self.p_1r))

    @property
    def F(self) -> float:
        """Force [N] of the blocking pressure on one side of the polygon (Eq. 13)."""
        parts = self.parts
        return float(forces.pressure_force(p_2=self.p_2, b=parts.b, d_i=parts.d_i, z=parts.z))

    @property
    def wedges(self) -> bool:
        """True if the rollers hold: with a cage, or free with tan(alpha/2) < mu (Eq. 2)."""
        return self.alpha is None or bool(wedging.holds(alpha=self.alpha, mu=self.mu))

    @property
    def grip(self) -> float:
        """Ratio of tangential to normal force: mu, or tan(alpha/2) of a free roller that holds."""
        free = self.alpha is not None and self.wedges
        return tan(self.alpha / 2) if self.alpha is not None and free else self.mu

    @property
    def arm(self) -> float:
        """Lever arm r + r_1 [m] of the hub contact, by the selected definition."""
        parts = self.parts
        exact = float(forces.contact_radius(apothem=parts.apothem, psi=parts.psi))
        return exact if self.lever == "exact" else parts.d_i / 2

    @property
    def direction(self) -> float:
        """Angle gamma [rad] between the flat's normal and the direction on which R is projected."""
        return 0.0 if self.gamma == "normal" else self.parts.psi

    @property
    def hub_share(self) -> float:
        """Share of the hub force in the normal force N of the rollers.

        If the share is at least 1, pressure does not limit the torque.
        """
        hub = {"lever": self.arm, "psi": self.parts.psi, "phi_1": self.phi_1}
        share = torque.hub_share(mu=self.grip, D_i=self.parts.D_i, gamma=self.direction, **hub)
        return float(share)

    @property
    def M_t(self) -> float:
        """Largest torque [N m] (Eq. 20); 0 if the rollers do not hold; may be infinite."""
        if not self.wedges:
            return 0.0
        return float(torque.torque(p_t=self.p_t, **self._chain))

    @property
    def T(self) -> float:
        """Tangential force [N] of the hub in each corner (in Eq. 14)."""
        return self.M_t / (self.parts.z * self.arm)

    @property
    def F_s(self) -> float:
        """Radial force [N] of the hub in each corner (Eqs. 14 and 15)."""
        parts = self.parts
        return float(
            forces.radial_force(
                M_t=self.M_t, z=parts.z, lever=self.arm, psi=parts.psi, phi_1=self.phi_1
            )
        )

    @property
    def R(self) -> float:
        """Force [N] between hub and flat (in Eq. 16)."""
        return float(forces.contact_force(F_s=self.F_s, psi=self.parts.psi, phi_1=self.phi_1))

    @property
    def N(self) -> float:
        """Normal force [N] on a roller (Eq. 16); equal to F if M_t is 0."""
        gamma = self.direction
        return float(forces.normal_force(F=self.F, R=self.R, phi_1=self.phi_1, gamma=gamma))

    @property
    def p_0_ring(self) -> float:
        """Hertz's peak pressure [Pa] under N between roller and ring."""
        return self._hertz(R_2=self.parts.d_e / 2)

    @property
    def p_0_race(self) -> float:
        """Hertz's peak pressure [Pa] under N between roller and race."""
        return self._hertz(R_2=-self.parts.D_i / 2)

    @property
    def p_required(self) -> float | None:
        """Total pressure [Pa] required for M_wanted (Eq. 20); inf if rollers are expelled."""
        if self.M_wanted is None:
            return None
        if not self.wedges:
            return inf
        return float(torque.required_pressure(M_t=self.M_wanted, **self._chain))

    @property
    def margin(self) -> float | None:
        """Ratio of M_t to M_wanted; None without a target torque."""
        return None if self.M_wanted is None else self.M_t / self.M_wanted

    @property
    def remarks(self) -> tuple[str, ...]:
        """Messages on the causes of a torque that is zero or infinite."""
        found = []
        if not self.p_2 > 0:
            found.append(
                f"the ring does not press the rollers: p_t={self.p_t:g} Pa is not above "
                f"p_1r={self.p_1r:g} Pa, no torque"
            )
        if not self.wedges:
            found.append(f"free rollers are expelled: tan(alpha/2) is not below mu={self.mu:g}")
        if self.hub_share >= 1:
            found.append(
                f"the hub brings {self.hub_share:g} of N by itself: strength limits the torque, "
                "pressure does not"
            )
        return tuple(found)

    @property
    def _ring(self) -> dict[str, float]:
        return {"d_i": self.parts.d_i, "d_e": self.parts.d_e}

    @property
    def _chain(self) -> dict[str, float]:
        """Arguments of Eq. 20 that torque and required pressure have in common."""
        parts = self.parts
        geometry = {"z": parts.z, "D_i": parts.D_i, "d_i": parts.d_i, "b": parts.b}
        return {"p_1r": self.p_1r, "share": self.hub_share, "mu": self.grip, **geometry}

    def _hertz(self, *, R_2: float) -> float:
        """Peak pressure [Pa] on the radius R_2 [m], proportional to sqrt(N) for every N >= 0."""
        same = {"E_1": self.E, "nu_1": self.nu, "E_2": self.E, "nu_2": self.nu}
        E_star = hertz_line.contact_modulus(**same, assumption="plane strain")
        R = hertz_line.relative_radius(R_1=self.parts.d / 2, R_2=R_2)
        return sqrt(self.N / self.parts.b) * float(
            hertz_line.peak_pressure(P=1.0, R=R, E_star=E_star)
        )


Clutch = PolyhedralClutch  # its name in version 0.1
