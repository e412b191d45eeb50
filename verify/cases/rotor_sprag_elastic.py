"""How far the elastic bodies are from the beams: three-dimensional elasticity, told."""

from dataclasses import dataclass

from verify import judge
from verify.case import Context
from verify.cases.rotor_sprag_claims import WITHIN_PRINTED
from verify.cases.rotor_sprag_kinds import arrays
from verify.cases.rotor_sprag_model import MODES
from verify.cases.rotor_sprag_solid_fem import REFINED
from verify.claims import Claim
from verify.convergence import grid_convergence
from verify.results import Kind, Row, Status


@dataclass(frozen=True, kw_only=True)
class Bodies(Claim):
    """Exact beams over elastic bodies of revolution with the same springs and discs: SHOWN.

    No second source says how much a bell on a shaft yields, so that no interval is expected.
    """

    kind = Kind.APPROXIMATION

    order: int

    def rows(self, context: Context) -> list[Row]:
        formula = context.analytic[f"natural frequency {self.order}"]
        values = arrays(context)["solid"][:, self.order - 1].tolist()
        h = [1 / refine for refine in REFINED]
        grid = grid_convergence(h, values, formal=2.0, scale=formula, u_it=0.0)
        u = judge.numerical_uncertainty(grid, 0.0)
        m, U = formula / values[-1] - 1, judge.expanded(u) / values[-1]
        within = "within" if abs(m) + U < WITHIN_PRINTED else "not surely within"
        said = f"beams {m:+.2%} ± {100 * U:.1g} %: {within} the 0.3 % of beam against beam"
        verdict = judge.Verdict(Status.SHOWN, said, formula - values[-1])
        return [
            self._row(
                context.case, Kind.APPROXIMATION, verdict, analytic=formula, fem=values[-1],
                scale=values[-1], u_num=u, levels=tuple(zip(h, values, strict=True)),
            )
        ]  # fmt: skip


ELASTIC = tuple(
    Bodies(name=f"natural frequency {k}, elastic bodies", symbol=f"f_{k}", unit="Hz", order=k)
    for k in range(1, MODES + 1)
)
