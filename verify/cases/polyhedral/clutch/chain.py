"""Chain of formulas of the paper: from dimensions, friction, pressure to torque, Eqs. 6 to 21."""

from math import atan
from typing import Any

from analytic.polyhedral import bore_pressure, printed
from analytic.polyhedral.design import PolyhedralClutch
from analytic.polyhedral.parts import PolyhedralParts
from analytic.polyhedral.sector import Sector
from verify.case import Quantity, shared
from verify.cases.polyhedral.clutch.inputs import ClutchInputs


class PaperChain(ClutchInputs):
    """All values of the paper's corrected formulas; infinite if the clutch locks itself."""

    d_m = Quantity("d_m", "mm", "mean diameter of the ring", equation="6", role="step",
                   tex=r"\frac{d_i + d_e}{2}").reads(lambda q: q.full.parts.d_m)  # fmt: skip
    lever = Quantity(
        "r + r_1", "mm", "lever of the hub contact", source="Eq. 14", role="step",
        tex=r"\frac{a_f}{\cos\left(\psi\right)}",
    ).reads(lambda q: q.full.arm)  # fmt: skip
    sigma_t = Quantity("σ_t", "MPa", "hoop stress of the round ring", equation="9", role="step",
                       safe="too high",
                       tex=r"\frac{E j_D}{d_m}").reads(lambda q: q.full.sigma_t)  # fmt: skip
    p_1 = Quantity("p_1", "MPa", "pressure that closes the clearance of a thin ring",
                   equation="10", role="step", safe="too high",
                   tex=r"\frac{2 \delta_1 E j_D}{d_i d_m}").reads(lambda q: q.full.p_1)  # fmt: skip

    @Quantity("K", "1", "K in the middle of the flats", role="step",
              source="complex potentials")  # fmt: skip
    def K(self) -> float:
        ring = bore_pressure.stiffness_factors(
            sector=self.sector, nu=self.nu, assumption="plane stress"
        )
        return ring.mid

    p_1r = Quantity(
        "p_1r", "MPa", "pressure at which the ring reaches its rollers", equation="11", role="step",
        safe="too high", tex=r"K p_1",
    ).reads(lambda q: q.full.p_1r)  # fmt: skip
    sigma_tr = Quantity(
        "σ_tr", "MPa", "mean hoop stress in the corners under p_1r", equation="12", role="step",
        safe="too high", tex=r"\frac{p_{1r} d_i}{2 \delta_1}",
    ).reads(lambda q: q.full.sigma_tr)  # fmt: skip
    p_2 = Quantity("p_2", "MPa", "blocking pressure, p_t minus p_1r", equation="19", role="step",
                   safe="too low",
                   tex=r"\max\left(p_t - p_{1r}, 0\right)").reads(lambda q: q.full.p_2)  # fmt: skip
    F = Quantity(
        "F", "kN", "resultant of p_2 on a side of the polygon", equation="13", form="corrected",
        role="step", safe="too low", tex=r"p_2 b d_i \sin\left(\frac{\pi}{z}\right)",
    ).reads(lambda q: q.full.F)  # fmt: skip
    hub_share = Quantity(
        "s", "1", "share of N due to the hub force; self-locking if s ≥ 1", equation="16",
        role="step",
        tex=r"\frac{\mu_g D_i \cos\left(\varphi_1\right)}"
        r"{2 (r + r_1) \sin\left(\psi + \varphi_1\right)}",
    ).reads(lambda q: q.full.hub_share)  # fmt: skip
    M_20 = Quantity(
        "M_20", "N m", "torque", equation="20", form="corrected", safe="too low",
        tex=r"\frac{\mu_g D_i}{2} " r"\frac{z d_i \sin\left(\frac{\pi}{z}\right) b p_2}{1 - s}",
    ).reads(lambda q: q.full.M_t)  # fmt: skip

    @Quantity("M_21", "N m", "torque of the first design", equation="21", form="corrected",
              safe="too low")  # fmt: skip
    def M_21(self) -> float:
        first = self.paper(K=1.0, lever="d_i/2", gamma="radius", rho=0.0)
        return first.M_t

    @Quantity("M_20", "N m", "torque", equation="20", form="as printed", form_of="M_20",
              safe="too low",
              tex=r"\frac{\mu_g D_i}{2} \frac{\pi d_i b p_2}{1 - s}")  # fmt: skip
    def M_20_printed(self) -> float:
        return float(self.M_20 * printed.arc_over_chord(self.z))

    @Quantity("M_21", "N m", "torque of the first design", equation="21", form="as printed",
              form_of="M_21", safe="too low")  # fmt: skip
    def M_21_printed(self) -> float:
        return float(printed.first_torque(M_t=self.M_21, z=self.z))

    T = Quantity("T", "kN", "tangential component of R, at the torque M_20", equation="14",
                 role="step",
                 tex=r"\frac{M_{20}}{z (r + r_1)}").reads(lambda q: q.full.T)  # fmt: skip
    F_s = Quantity(
        "F_s", "kN", "radial component of R, at the torque M_20", equation="14", role="step",
        tex=r"\frac{T}{\tan\left(\psi + \varphi_1\right)}",
    ).reads(lambda q: q.full.F_s)  # fmt: skip
    R = Quantity(
        "R", "kN", "force between hub and one flat, at the torque M_20", source="Eq. 16",
        role="step",
        tex=r"\frac{F_s}{\cos\left(\psi + \varphi_1\right)}",
    ).reads(lambda q: q.full.R)  # fmt: skip
    N_16 = Quantity("N_16", "kN", "force of a roller, at the torque M_20", equation="16",
                    role="step",
                    tex=r"F + R \cos\left(\varphi_1\right)").reads(lambda q: q.full.N)  # fmt: skip

    @Quantity("p_20", "MPa", "pressure for the target torque", source="Eqs. 17 to 20",
              form="corrected", safe="too high", tex=r"p_{1r} + \frac{2 M_t}{\mu_g D_i z} "
              r"\frac{1 - s}{b d_i \sin\left(\frac{\pi}{z}\right)}")  # fmt: skip
    def p_20(self) -> float:
        found = self.full.p_required
        assert found is not None
        return found

    @Quantity("p_20", "MPa", "pressure for the target torque", equation="17", form="as printed",
              form_of="p_20", safe="too high")  # fmt: skip
    def p_17_printed(self) -> float:
        return float(printed.required_pressure(p_t=self.p_20, p_1r=self.p_1r, z=self.z))

    p_17 = Quantity(
        "p_2t", "MPa", "blocking pressure for the target torque", equation="17", form="corrected",
        safe="too high",
        tex=r"\frac{2 M_t}{\mu_g D_i z} \frac{1 - s}{b d_i \sin\left(\frac{\pi}{z}\right)}",
    ).reads(lambda q: q.p_20 - q.p_1r)  # fmt: skip
    p_17_arc = Quantity(
        "p_2t", "MPa", "blocking pressure for the target torque", equation="17", form="as printed",
        form_of="p_17", safe="too high",
    ).reads(lambda q: q.p_17_printed - q.p_1r)  # fmt: skip

    @shared
    def sector(self) -> Sector:
        """Geometry of half a sector, for the series."""
        return Sector(z=self.z, d_e=self.d_e, d_i=self.d_i, rho=self.rho)

    @shared
    def full(self) -> PolyhedralClutch:
        """The paper's formulas with K of the middle of the flats and the exact hub lever."""
        return self.paper(K=self.K)

    def paper(self, *, rho: float | None = None, **readings: Any) -> PolyhedralClutch:
        """The paper's formulas without misprints; `readings` choose among its definitions."""
        parts = PolyhedralParts(
            z=self.z, d_i=self.d_i, d_e=self.d_e, D_i=self.D_i, d=self.d, b=self.b, e=self.e,
            rho=self.rho if rho is None else rho,
        )  # fmt: skip
        return PolyhedralClutch(
            parts, p_t=self.p_t, E=self.E, nu=self.nu, mu=self.mu, phi_1=atan(self.tan_phi),
            alpha=self.alpha, M_wanted=self.M_t, **readings,
        )  # fmt: skip
