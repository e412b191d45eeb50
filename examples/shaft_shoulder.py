"""Stress at a shoulder by Peterson's fit: freewheel verify examples/shaft_shoulder.py."""

import numpy as np

import verify.case as vc

SOURCE = (
    "Tipton, Sorem, Schmidt, Machine Design, 8 January 2009: Peterson underpredicts by up to 24 %"
)


class ShaftShoulder(vc.Case):
    """A round shaft in tension has a shoulder with a fillet; the formula is fitted to a chart."""

    title = "Stress concentration at a shoulder"
    source = "Pilkey, Peterson's Stress Concentration Factors"
    place = "stepped tension bar of circular section, 0.1 <= h/r <= 2"

    D: float = vc.given("60 mm", "mm", "D", "larger diameter", gt=0)
    d: float = vc.given("40 mm", "mm", "d", "smaller diameter", gt=0)
    r: float = vc.given("6 mm", "mm", "r", "radius of the fillet", gt=0)

    @vc.Quantity("K_t", "1", "stress concentration factor", safe="too high")
    def K_t(self) -> float:
        x, s = (self.D - self.d) / (2 * self.r), 1 - self.d / self.D  # h/r and 2 h/D
        C = np.array([[0.926, 1.157, -0.099], [0.012, -3.036, 0.961],
                      [-0.302, 3.977, -1.744], [0.365, -2.098, 0.878]])  # fmt: skip
        return float(s ** np.arange(4) @ C @ [1, x**0.5, x])

    def reference(self, level: int) -> vc.Level:
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.contact.blocks import Block, Edge, mesh_blocks

        e, f, c = self.D / 2, self.d / 2, (self.d / 2 + self.r, -self.r)
        o, a, b, p, q = (0.0, -4 * f), (f, -4 * f), (f, -self.r), (0.0, -self.r), (c[0], 0.0)
        s, t, u, v, w = (e, 0.0), (e, f), (0.0, f), (e, 4 * e), (0.0, 4 * e)
        names: dict[tuple[tuple[float, float], ...], str]
        names = {(o, a): "start", (b, q): "fillet", (v, w): "end"}

        def edge(*ends: tuple[float, float]) -> Edge:
            arc = c if ends == (b, q) else None
            return Edge(ends[0], ends[1], 12 * level, arc, name=names.get(ends, ""))

        corners = (o, a, b, p), (p, b, q, u), (u, q, s, t), (u, t, v, w)
        edges = [(edge(g, h), edge(h, i), edge(i, j), edge(j, g)) for g, h, i, j in corners]
        mesh = mesh_blocks([Block(four, "shaft") for four in edges])
        shaft = solve_plane(mesh, materials=Elastic(E=210e9, nu=0.3), assumption="axisymmetric",
                            supports={"end": "y"}, tractions={"start": (0, -1.0)})  # fmt: skip
        fillet = shaft.on_boundary("fillet")  # hoop stress about c acts along the surface
        angle = np.arctan2(*(fillet.x[::-1].T - c[::-1]).T)
        fit = np.polynomial.Polynomial.fit(angle, fillet.polar(c)[2], 8)
        peak = fit(np.linspace(angle.min(), angle.max(), 1000)).max()
        return vc.solved(1 / level, vc.plane_field(shaft, "von_mises"), K_t=float(peak))

    def comparisons(self) -> list[vc.Comparison]:
        expected, wide = vc.Expected(-0.24, 0, SOURCE), (0.2, "known error of the chart")
        return [vc.approximation(ShaftShoulder.K_t, order=2, expected=expected, sensitivity=wide)]
