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
    """Model with the paper's 22 nodes and twelve unknown dimensions and stiffnesses.

    The paper prints three critical speeds, but none of the dimensions and stiffnesses. Many sets of
    parameters give all three speeds; each set is compared with all other statements of the paper.
    The set that is fitted from the middle of all ranges (the central system) is computed by exact
    transfer matrices, by refined beams and as elastic bodies.
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
        "orders 1, 3 and 5 are the three lowest forward whirls: on isotropic supports, unbalance "
        "excites only forward whirl, and the response peaks there; orders 2, 4 and 6 are the "
        "corresponding backward whirls, although their critical speeds are lower",
        "the parameters are fitted with the paper's mesh: one beam element in each of the 20 "
        "segments",
        "node 12 is the free end of the drum: it moves more than node 11 in every overhung drum",
    )
    assumptions: ClassVar = (
        "linear vibration about the preloaded state; isotropic bearings unless stated otherwise",
        "both rotors have the same speed (engaged clutch); steel; Hutchinson's shear coefficients",
        "Rayleigh damping acts on absolute motion; the damping ratios at critical speeds 1 and 5 "
        "are uniformly distributed over their range in the sets of parameters",
        "both unbalances in phase (no angle is printed); shares with opposite phase are also "
        "reported",
        "the load of the clutch is uneven in space (offset of the rings); all sprags have one "
        "contact law",
        "rigid races: the torsional stiffness of the clutch is that of rotor-clutch; it is too "
        "high, by the difference that sprag-wedge reports for the wind-up with rigid races",
    )

    tables = staticmethod(tabulated.tables)
    figures = drawn_by(drawn.figures)
    sketch = tabulated.sketch

    def reference(self, level: int) -> Level:
        """Beams of the central system; on the mesh of the paper, also the ensemble."""
        from verify.cases.rotor.sprag.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows on exact, fitted, linear and elastic results, and on the paper's statements."""
        yield from (*IDENTITIES, *FITTED_SPEEDS, *LINEAR_ROWS, *ELASTIC, *SHARES)

    def advice(self) -> Iterator[str]:
        """Critical speeds, difference of the rig's speed from the nearest one, sprag deflection."""
        found = {k: self.critical_forward(k) for k in ORDERS}
        speeds = ", ".join(f"{n / RPM:.0f}" for n in found.values())
        near = min((abs(self.rig_speed / n - 1), k) for k, n in found.items())
        yield (
            f"the central system has forward critical speeds at {speeds} r/min; twelve unknowns "
            "were fitted to these speeds, which are therefore no evidence for any of the unknowns"
        )
        yield (
            f"{self.rig_speed / RPM:.5g} r/min differs by {near[0]:.0%} from critical speed "
            f"{near[1]}"
        )
        yield (
            f"{self.T:.3g} N m deflects the sprags by {self.delta_0 * 1e6:.2g} µm: an offset of "
            f"{self.offset * self.delta_0 * 1e6:.2g} µm couples bending and torsion"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the speed of the test rig is critical, or if peaks merge."""
        for k in ORDERS:
            off = abs(self.rig_speed / self.critical_forward(k) - 1)
            if off < 0.1:
                yield (
                    f"{self.rig_speed / RPM:.5g} r/min is within {off:.1%} of critical speed {k}: "
                    "orbits at this speed depend more on the damping than on the stiffness"
                )
        if self.zeta_high > 0.05:
            yield "peaks 3 and 5 differ by 12 % in speed: with damping ratios above 5 % they merge"


SPRAG_ROTOR = adapted(SpragRotor)
