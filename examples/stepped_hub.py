"""Press fit of a stepped hub, Lamé for each section: freewheel verify examples/stepped_hub.py."""

import numpy as np

import verify.case as vc

SOURCE = "derived: Lamé's stresses bound the force from below, one displacement field from above"


class SteppedHub(vc.Case):
    """A hub has a collar in the middle and thin ends; the solid shaft ends flush with the hub."""

    title = "Press fit of a hub with a step"
    source = "Shigley, Mechanical Engineering Design: press and shrink fits"
    place = "Lamé, section by section, both parts of one material"

    R: float = vc.given("25 mm", "mm", "R", "radius of the fit", gt=0)
    r_1: float = vc.given("50 mm", "mm", "r_1", "outer radius of the collar", gt=0)
    r_2: float = vc.given("40 mm", "mm", "r_2", "outer radius of the ends", gt=0)
    L_1: float = vc.given("40 mm", "mm", "L_1", "half the length of the collar", gt=0)
    L_2: float = vc.given("60 mm", "mm", "L_2", "length of an end", gt=0)
    delta: float = vc.given("20 µm", "µm", "δ", "radial interference", gt=0)
    E: float = vc.given("210 GPa", "GPa", "E", "Young's modulus", gt=0)
    nu: float = vc.given(0.3, "1", "ν", "Poisson's ratio", ge=0, lt=0.5)

    @vc.Quantity("p_{0}", "MPa", "pressure under section {0}", role="step").over(range(1, 3))
    def p(self, i: int) -> float:
        return (
            self.E * self.delta / (2 * self.R) * (1 - (self.R / (self.r_1, self.r_2)[i - 1]) ** 2)
        )

    @vc.Quantity("N", "kN", "normal force of the fit", safe="too low")
    def N(self) -> float:
        return 4 * np.pi * self.R * (self.p(1) * self.L_1 + self.p(2) * self.L_2)

    def reference(self, level: int) -> vc.Level:
        from fem.contact import pairs, problem
        from fem.plane.material import Elastic
        from meshes import join
        from meshes.revolution.section import section
        from meshes.rotor.stepped import stepped_section

        parts = [(self.L_1, 2 * self.r_1, 2 * self.R), (self.L_2, 2 * self.r_2, 2 * self.R)]
        hub = stepped_section(parts, first=self.R / 4, refine=level)
        shaft = section(r=np.linspace(0, self.R, 6 * level + 1), z=np.unique(hub.p[1]))
        fit = problem.ContactProblem(
            join.join({"hub": hub, "shaft": shaft}), materials=Elastic(E=self.E, nu=self.nu),
            assumption="axisymmetric", degree=2, supports={"hub.start": "y", "shaft.start": "y"},
            contacts=[pairs.Pair(slave="hub.bore", master="shaft.rim", interference=self.delta)],
        ).solve()  # fmt: skip
        return vc.solved(1 / level, N=2 * fit.touches[0].normal_force)

    def comparisons(self) -> list[vc.Comparison]:
        R, sections = self.R, ((self.L_1, self.r_1), (self.L_2, self.r_2))
        A = sum(L * (r**2 / R**2 - 1) for L, r in sections) / (1 - self.nu)  # for u_r = r
        B = sum(L * (1 - R**2 / r**2) for L, r in sections) / (1 + self.nu)  # for u_r = 1/r
        soft = 1 / A + 1 / B + (1 - self.nu) / (self.L_1 + self.L_2)  # last term: the shaft
        low = B * (1 + self.nu) / 2 * soft - 1  # Lamé's sum relative to the upper bound
        expected = vc.Expected(low, 0, SOURCE)
        return [vc.approximation(SteppedHub.N, order=1.09, expected=expected)]
