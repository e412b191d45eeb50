"""Formulas of a clutch between two rotors, under even and uneven load."""

import math
from typing import ClassVar, Self

from analytic.rotor import clutch_inclined, clutch_tilted
from analytic.rotor import clutch_uniform as uniform
from analytic.rotor.clutch import LINE_CONTACT, Array, SpragCoupling
from analytic.rotor.clutch_state import under_torque
from verify.case import Quantity, State, shared
from verify.cases.rotor.clutch.inputs import SpragLink

FINE = 401  # number of slices that represents a continuous sprag
ENTRIES = {"K_xx": (0, 0), "K_yy": (1, 1), "K_tilt": (3, 3), "K_zz": (4, 4), "K_xz": (0, 4)}
ACROSS = {"K_xy": (0, 1), "K_yz": (1, 4)}  # zero by Eq. 3 wherever the x-axis halves a clutch
UNEVEN = {  # cause of the unevenness of each state, and its name in text
    "": ((), "even load"),
    "offset": (("with_offset",), "with an offset"),
    "crown": (("with_crown",), "with a crown"),
    "gap": (("with_gap",), "with sprags missing"),
    "together": (
        ("with_offset", "with_crown", "with_gap"),
        "with offset and crown, some sprags missing",
    ),
}


class ClutchStiffness(SpragLink):
    """Clutch stiffness under T.

    Closed forms apply to even load, sums over sprags to uneven load.
    """

    with_offset: ClassVar[bool] = False
    with_crown: ClassVar[bool] = False
    with_gap: ClassVar[bool] = False

    @Quantity("n", "1", "exponent of the force law of a line contact", source="Eq. 2", role="step")
    def n(self) -> float:
        return LINE_CONTACT

    @Quantity("N", "N", "normal force of a sprag", source="Eq. 9, torque equation", role="step",
              tex=r"\frac{T}{Z d_t}")  # fmt: skip
    def N(self) -> float:
        return float(uniform.normal_force(T=self.T, Z=self.Z, d_t=self.d_t))

    @Quantity("δ_0", "µm", "sum of the deflections of both contacts of a sprag",
              source="Eq. 2", role="step",
              tex=r"\delta_{kN} (\frac{N}{1000})^{1 / n}", fitted=True)  # fmt: skip
    def delta_0(self) -> float:
        return float(uniform.approach(N=self.N, k_n=self.k_n))

    @Quantity("γ_0", "deg", "angle of twist between the races under T", role="step")
    def twist(self) -> float:
        return self.delta_0 / self.d_t

    @Quantity("k", "N/µm", "tangent stiffness of a sprag", source="slope of Eq. 2", role="step",
              tex=r"\frac{n N}{\delta_0}")  # fmt: skip
    def k(self) -> float:
        return float(uniform.contact_stiffness(N=self.N, k_n=self.k_n))

    @Quantity("K_xx", "N/mm", "stiffness along x", source="Eq. 11", tex=r"\frac{Z k}{2}")
    def K_xx(self) -> float:
        radial = uniform.radial_stiffness
        return self.general("K_xx") if self.uneven else float(radial(Z=self.Z, k=self.k))

    @Quantity("K_yy", "N/mm", "stiffness along y", source="Eq. 11", tex=r"\frac{Z k}{2}")
    def K_yy(self) -> float:
        radial = uniform.radial_stiffness
        return self.general("K_yy") if self.uneven else float(radial(Z=self.Z, k=self.k))

    @Quantity("K_tilt", "N m/rad", "tilting stiffness", source="Eqs. 5, 7, 11",
              tex=r"\frac{Z k}{2} \frac{L_{we}^2}{12} (1 - \frac{1}{n_s^2})")  # fmt: skip
    def K_tilt(self) -> float:
        if self.uneven:
            return self.general("K_tilt")
        return float(uniform.tilting_stiffness(Z=self.Z, k=self.k, L=self.L, n_s=self.n_s))

    @Quantity("K_zz", "N m/rad", "torsional stiffness", source="Eq. 11", tex="Z k d_t^2")
    def K_zz(self) -> float:
        if self.uneven:
            return self.general("K_zz")
        return float(uniform.torsional_stiffness(Z=self.Z, k=self.k, d_t=self.d_t))

    @Quantity("K_xz", "N", "coupling of bending and torsion", source="Eqs. 3 to 11",
              when=lambda q: q.uneven)  # fmt: skip
    def K_xz(self) -> float:
        return self.general("K_xz")

    @Quantity("K_xz1", "N", "coupling of bending and torsion, first order in the offset",
              source="to first order in the offset",
              tex=r"\frac{Z}{2} k (n - 1) \frac{\Delta x}{\delta_0} d_t")  # fmt: skip
    def K_xz_first(self) -> float:
        return float(uniform.offset_coupling(Z=self.Z, k=self.k, d_t=self.d_t, dx=self.e,
                                             delta_0=self.delta_0))  # fmt: skip

    @Quantity("K_xy", "N/mm", "coupling of x and y due to the wedge angle",
              when=lambda q: q.with_gap,
              source="forces along the struts; zero by Eq. 3")  # fmt: skip
    def K_xy(self) -> float:
        """K_xy with sprags missing at psi_g: -k tan(nu) sum cos(2 psi_g)."""
        if self.with_offset:
            return self.inclined("K_xy")
        return clutch_inclined.coupling_across(self._gone, k=self._k_left, nu=self.nu)

    @Quantity("K_yz", "N", "coupling of y and torsion due to the wedge angle",
              when=lambda q: q.with_gap,
              source="forces along the struts; zero by Eq. 3")  # fmt: skip
    def K_yz(self) -> float:
        """K_yz with missing sprags, tan(nu) K_xz."""
        if self.with_offset:
            return self.inclined("K_yz")
        return clutch_inclined.coupling_with_torsion(
            self._gone, k=self._k_left, nu=self.nu, d_t=self.d_t
        )

    @Quantity(
        "K_y,γx",
        "N",
        "coupling of y and the tilt about x, clutch with offset and tilt",
        source="Eq. 7",
    )
    def K_y_tilt_x(self) -> float:
        return self._tilted["K_y_tilt_x"]

    @Quantity(
        "K_x,γy",
        "N",
        "coupling of x and the tilt about y, clutch with offset and tilt",
        source="Eq. 7",
    )
    def K_x_tilt_y(self) -> float:
        return self._tilted["K_x_tilt_y"]

    @Quantity("K_zz'", "N m/rad", "torsional stiffness, sprags pinned to both races")
    def K_zz_pinned(self) -> float:
        return clutch_inclined.held_torsional_stiffness(
            Z=self.Z, R_i=self.R_i, R_e=self.R_e, nu=self.nu, k=self.k, N=self.N
        )

    @Quantity("p", "1", "exponent of the power law of the stiffness as a function of the torque",
              tex=r"1 - \frac{1}{n}")  # fmt: skip
    def exponent(self) -> float:
        return 1 - 1 / LINE_CONTACT

    @property
    def uneven(self) -> bool:
        """Whether sprags carry unequal loads, or a sprag is loaded unevenly along its length."""
        return self.with_offset or self.with_crown or self.with_gap

    @shared
    def in_state(self) -> dict[str, Self]:
        """The clutch in all states, by key."""
        found = {key: self.variant(**dict.fromkeys(parts, True))
                 for key, (parts, _) in UNEVEN.items() if key}  # fmt: skip
        return {"": self, **found}

    def state(self, key: str) -> State:
        """The state that is named `key`, with its text for names of rows."""
        return State(self.in_state[key], key, UNEVEN[key][1])

    @shared
    def sums(self) -> SpragCoupling:
        """Clutch of Eqs. 3 to 11, with crown or missing sprags in the states that have them."""
        return self.clutch(crowned=self.with_crown, gap=self.with_gap)

    @shared
    def at_T(self) -> Array:
        """Displacements of the clutch under T, with a prescribed offset if the state has one."""
        return under_torque(self.sums, T=self.T, offset=(self._dx, 0, 0, 0))

    @shared
    def tangent(self) -> Array:
        """Stiffness matrix K (5, 5) under T, by Eqs. 3 to 11."""
        return self.sums.stiffness(self.at_T)

    def general(self, entry: str) -> float:
        """Entry of K by Eqs. 3 to 11."""
        return float(self.tangent[ENTRIES[entry]])

    @shared
    def _inclined(self) -> Array:
        """K (5, 5) with forces along the struts, and `FINE` slices."""
        clutch = self.clutch(crowned=self.with_crown, gap=self.with_gap, n_s=FINE)
        return clutch_inclined.inclined_stiffness(clutch, T=self.T, dx=self._dx)

    def inclined(self, entry: str) -> float:
        """Entry of the stiffness matrix K that is computed with sprag forces along the struts."""
        return float(self._inclined[(ENTRIES | ACROSS)[entry]])

    @shared
    def leaning(self) -> float:
        """Reduction of K_tilt [N m/rad] because the contact points tilt with the race."""
        return clutch_inclined.leaning(self.sums, self.at_T)

    @property
    def coupling(self) -> float:
        """Ratio of the coupling stiffness K_xz to √(K_xx K_zz)."""
        K = self.tangent
        return float(K[0, 4] / math.sqrt(K[0, 0] * K[4, 4]))

    @property
    def _dx(self) -> float:
        return self.e if self.with_offset else 0.0

    @property
    def _k_left(self) -> float:
        """Stiffness of a remaining sprag if some sprags are missing."""
        N = uniform.normal_force(T=self.T, Z=self.Z - self.missing, d_t=self.d_t)
        return float(uniform.contact_stiffness(N=N, k_n=self.k_n))

    @property
    def _gone(self) -> Array:
        return self.angles()[: self.missing]

    @shared
    def _tilted(self) -> dict[str, float]:
        return clutch_tilted.couplings(self.clutch(), T=self.T, **self.aside)

    @property
    def aside(self) -> dict[str, float]:
        """Offset [m] and tilt [rad] of the clutch in the state that has both, by name."""
        dx, tilt = clutch_tilted.aside(self.e, self.L, self.delta_0)
        return {"dx": dx, "tilt": tilt}
