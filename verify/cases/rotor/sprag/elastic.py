"""Difference between elastic bodies (three-dimensional elasticity) and beams."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from analytic.rotor.inertia import discs_inertia, tubes_inertia
from verify.case import Comparison
from verify.cases.rotor.sprag.check_types import Rounded, arrays
from verify.cases.rotor.sprag.claims import WITHIN_PRINTED
from verify.cases.rotor.sprag.formulas import MODES, CentralSystem
from verify.cases.rotor.sprag.layout import CENTRAL, DISCS, OUTER, RHO, layout
from verify.cases.rotor.sprag.solid_fem import REFINED
from verify.core.case import Check, Context
from verify.core.figures import Array
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim
from verify.judging.convergence import grid_convergence


@dataclass(frozen=True, kw_only=True)
class Bodies(Claim):
    """Row of exact beams against elastic bodies with the same springs and discs, status SHOWN.

    No second source gives the flexibility of a drum on a shaft; therefore, no interval of the error
    is derived.
    """

    kind = Kind.APPROXIMATION

    order: int

    def rows(self, context: Context) -> list[Row]:
        formula = context.analytic[f"frequency_{self.order}"]
        values = arrays(context)["solid"][:, self.order - 1].tolist()
        h = [1 / refine for refine in REFINED]
        grid = grid_convergence(h, values, formal=2.0, scale=formula, u_it=0.0)
        u = judge.numerical_uncertainty(grid, 0.0)
        m, U = formula / values[-1] - 1, judge.expanded(u) / values[-1]
        wide = arrays(context)["solid, wide bands"][self.order - 1] / values[0] - 1
        within = "below" if abs(m) + U + abs(wide) < WITHIN_PRINTED else "above"
        reason = (
            f"the error of the beam model is {m:+.2%} ± {100 * U:.1g} %; if the bearing seats are "
            "20 mm wide instead of 10 mm, the frequency of the elastic bodies changes by "
            f"{wide:+.2%}; the sum of error, uncertainty and this change is {within} 0.3 %, the "
            "printed difference between beam models"
        )
        verdict = judge.Verdict(Status.SHOWN, reason, formula - values[-1])
        return [
            self._row(
                context.case, Kind.APPROXIMATION, verdict, analytic=formula, fem=values[-1],
                scale=values[-1], u_num=u, levels=tuple(zip(h, values, strict=True)),
            )
        ]  # fmt: skip


def drawn() -> Array:
    """Mass [kg], polar and diametral moment about node 1 [kg m^2] of beams with discs, (3,)."""
    s = layout(CENTRAL)
    nodes = s.z[0]
    ends = np.concatenate([nodes[1:OUTER], nodes[OUTER + 1 :]])
    tubes = tubes_inertia(end=ends, length=s.length[0], d_o=s.d_o[0], d_i=s.d_i[0], rho=RHO)
    return tubes + discs_inertia(
        z=nodes[np.array(DISCS) - 1], mass=s.mass[0], polar=s.polar[0], diametral=s.diametral[0]
    )


def inertia(i: int) -> Callable[[Context], float]:
    return lambda context: abs(float(arrays(context)["solid, inertia"][i] / drawn()[i] - 1))


ELASTIC: tuple[Comparison | Check, ...] = (
    *(Rounded(name=f"elastic bodies with discs: {what}", symbol=symbol, unit="1",
              residual=inertia(i), bound=1e-11, scale_name="the value of beams with discs",
              bound_reason="Gauss quadrature is exact on straight cells")
      for i, (what, symbol) in enumerate((
          ("mass", "Δm/m"), ("polar moment of inertia", "ΔI_p/I_p"),
          ("diametral moment of inertia about node 1", "ΔI_d/I_d")))),
    *(Comparison(check=Bodies(name=f"natural frequency {k}, elastic bodies", symbol=f"f_{k}",
                              unit="Hz", order=k), quantity=CentralSystem.frequency(k))
      for k in range(1, MODES + 1)),
)  # fmt: skip
