"""Sprag clutch - flexible rotor system: 22 nodes, three critical speeds, unknown dimensions."""

from collections.abc import Iterator
from typing import ClassVar

from verify.case import Comparison, Level, Scan, drawn_by
from verify.cases.rotor.sprag import figures as drawn
from verify.cases.rotor.sprag import tables as tabulated
from verify.cases.rotor.sprag.claims import FITTED_SPEEDS, IDENTITIES, SHARES
from verify.cases.rotor.sprag.elastic import ELASTIC
from verify.cases.rotor.sprag.formulas import ORDERS, CentralSystem
from verify.cases.rotor.sprag.inputs import RPM
from verify.cases.rotor.sprag.linear import LINEAR_ROWS
from verify.core.case import Check
from verify.form.adapter import adapted


class SpragRotor(CentralSystem):
    """Model of two rotors with the paper's 22 nodes, and with twelve unknown parameters.

    The paper prints three critical speeds, but none of the dimensions and stiffnesses. Many sets of
    these parameters give all three speeds; each set is compared with all other statements of the
    paper. One set is fitted from mid-range parameters: its fit starts from the middle of each
    range. The system with this set is computed by exact transfer matrices, by refined beam elements
    and as elastic bodies.
    """

    id = "rotor-sprag"
    title = "Sprag clutch - flexible rotor system"
    source = "huang2022"
    place = "Sec. 1, Fig. 1; Secs. 2.1 to 2.3"
    levels: ClassVar = (1, 2, 4, 8)
    scans: ClassVar = (
        Scan(
            vary=("speed=2000r/min,5000r/min,10000r/min", "T=8N m,15N m,25N m", "offset=0.1,0.2"),
            star=True,
        ),
    )
    readings: ClassVar = (
        "critical speeds 1, 3 and 5 of the paper are the three lowest forward critical speeds, "
        "because unbalance on isotropic bearings excites forward whirl only; critical speeds 2, 4 "
        "and 6 belong to backward whirl, although each is lower than the forward critical speed of "
        "its pair",
        "the parameters are fitted with the mesh of the paper, one beam element in each of the 20 "
        "segments",
        "node 12 is the free end of the drum; in an overhung drum it moves more than node 11, "
        "which the paper states as the node with the highest amplitude",
    )
    assumptions: ClassVar = (
        "vibrations about the preloaded state are linear; bearings are isotropic unless stated "
        "otherwise",
        "the clutch is engaged, so that both rotors have the same speed; all parts are of steel; "
        "the shear coefficients are Hutchinson's",
        "Rayleigh damping acts on the absolute motion; over the sets of parameters, the logarithms "
        "of the damping ratios at critical speeds 1 and 5 are uniformly distributed from ζ_min to "
        "ζ_max",
        "both unbalances are in phase, because the paper prints no angle; results for opposite "
        "phase are also stated",
        "sprags carry unequal loads only because of an offset of the rings; all sprags have the "
        "same contact law",
        "races are rigid: the torsional stiffness of the clutch is too high, by the error of rigid "
        "races in the case sprag-wedge",
    )

    tables = staticmethod(tabulated.tables)
    figures = drawn_by(drawn.figures)
    sketch = tabulated.sketch

    def reference(self, level: int) -> Level:
        """Results of the fitted mid-range system; on the mesh of the paper, also the ensemble."""
        from verify.cases.rotor.sprag.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows on elements, fitted speeds, linear dynamics, elastic bodies, printed statements."""
        yield from (*IDENTITIES, *FITTED_SPEEDS, *LINEAR_ROWS, *ELASTIC, *SHARES)

    def advice(self) -> Iterator[str]:
        """Critical speeds, difference of the rig's speed from the nearest one, sprag deflection."""
        found = {k: self.critical_forward(k) for k in ORDERS}
        speeds = ", ".join(f"{n / RPM:.0f}" for n in found.values())
        near = min((abs(self.rig_speed / n - 1), k) for k, n in found.items())
        yield (
            "the forward critical speeds of the system fitted from mid-range parameters are "
            f"{speeds} r/min; its twelve parameters were fitted to three printed speeds, so that "
            "agreement with these speeds is no evidence for the value of any parameter"
        )
        yield (
            f"the difference between the speed of the test rig, {self.rig_speed / RPM:.5g} r/min, "
            f"and the nearest critical speed is {near[0]:.0%} of this critical speed (critical "
            f"speed {near[1]})"
        )
        yield (
            f"under {self.T:.3g} N m, the deflection of each sprag is {self.delta_0 * 1e6:.2g} µm; "
            f"the assumed offset of the rings, {self.offset * self.delta_0 * 1e6:.2g} µm, couples "
            "bending and torsion"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the speed of the test rig is critical, or if peaks merge."""
        for k in ORDERS:
            off = abs(self.rig_speed / self.critical_forward(k) - 1)
            if off < 0.1:
                yield (
                    f"the speed of the test rig, {self.rig_speed / RPM:.5g} r/min, is within "
                    f"{off:.1%} of critical speed {k}: orbits at this speed depend more on the "
                    "damping than on the stiffness"
                )
        if self.zeta_high > 0.05:
            yield (
                "critical speeds 3 and 5 differ by 12 %: with damping ratios above 5 %, the peaks "
                "of the response at these speeds merge"
            )


SPRAG_ROTOR = adapted(SpragRotor)
