"""Sprag clutch - flexible rotor system: 22 nodes, three critical speeds, and no dimensions."""

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
    """The paper's 22 nodes with twelve unknown dimensions and stiffnesses.

    The paper prints three critical speeds, but none of the dimensions and stiffnesses. Many sets of
    parameters give all three speeds; each set is compared with all other statements of the paper.
    The set found from the middle of all ranges (the central system) is computed by exact transfer
    matrices, by refined beams and as elastic bodies.
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
        "orders 1, 3 and 5 are the three lowest forward whirls: unbalance drives no other on "
        "isotropic supports, and the response peaks there; orders 2, 4 and 6 are their backward "
        "partners, though these lie below",
        "the paper's mesh is what was fitted: one beam element in each of the 20",
        "node 12 is the drum's free end: it moves more than node 11 in every overhung drum",
    )
    assumptions: ClassVar = (
        "linear vibration about the preloaded state; isotropic bearings unless stated otherwise",
        "both rotors turn at one speed (engaged clutch); steel; Hutchinson's shear coefficients",
        "Rayleigh damping acts on absolute motion: damping ratios at critical speeds 1 and 5 are "
        "even over their range in the sets of parameters",
        "both unbalances in phase (no angle is printed); shares in opposite phase are reported too",
        "a clutch load uneven in space (offset of the rings), all sprags on one contact law",
        "rigid races: the clutch's torsional stiffness is that of rotor-clutch, too high by "
        "the difference that sprag-wedge finds for the wind-up of rigid races",
    )

    tables = staticmethod(tabulated.tables)
    figures = drawn_by(drawn.figures)
    sketch = tabulated.sketch

    def reference(self, level: int) -> Level:
        """The central system as beams; on the mesh of the paper, also the ensemble."""
        from verify.cases.rotor.sprag.reference import solve

        return solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Exact, fitted, linear and elastic rows, and statements of the paper."""
        yield from (*IDENTITIES, *FITTED_SPEEDS, *LINEAR_ROWS, *ELASTIC, *SHARES)

    def advice(self) -> Iterator[str]:
        """Critical speeds, the nearest critical speed, and the sprags' deformation."""
        found = {k: self.critical_forward(k) for k in ORDERS}
        speeds = ", ".join(f"{n / RPM:.0f}" for n in found.values())
        near = min((abs(self.rig_speed / n - 1), k) for k, n in found.items())
        yield (
            f"the central system has forward critical speeds at {speeds} r/min, to which twelve "
            "unknowns were fitted: no evidence for any of them"
        )
        yield f"{self.rig_speed / RPM:.5g} r/min lies {near[0]:.0%} off critical speed {near[1]}"
        yield (
            f"{self.T:.3g} N m deflect its sprags by {self.delta_0 * 1e6:.2g} µm: an offset of "
            f"{self.offset * self.delta_0 * 1e6:.2g} µm couples bending and torsion here"
        )

    def warnings(self) -> Iterator[str]:
        """Warnings if the speed of the test rig is critical, or if peaks merge."""
        for k in ORDERS:
            off = abs(self.rig_speed / self.critical_forward(k) - 1)
            if off < 0.1:
                yield (
                    f"{self.rig_speed / RPM:.5g} r/min is within {off:.1%} of critical speed {k}: "
                    "orbits there depend more on the damping than on the stiffness"
                )
        if self.zeta_high > 0.05:
            yield "peaks 3 and 5 differ by 12 % in speed: damping ratios above 5 % merge them"


SPRAG_ROTOR = adapted(SpragRotor)
