"""What claims of the line contacts read off their levels, and acceptance figures."""

from collections.abc import Callable, Sequence

from verify.core.case import Context, FemResult
from verify.core.figures import Array
from verify.judging import judge
from verify.judging.convergence import grid_convergence
from verify.judging.profile_checks import l2_error

PROFILE = 0.03  # acceptance figure of q(x) in L2
BLUNT = 1e-3  # of Hertz's shear over the finite elements': smoothed stresses are no sharper
LIMITS = "acceptance figure of the contact models"


def l2_errors(pressure: Callable[[Array], Array]) -> Callable[[Context], list[float]]:
    """Relative L2 errors of the finite-element pressure, per level, at its integration points."""

    def errors(context: Context) -> list[float]:
        found = []
        for result in context.fem:
            x, p, weight = (result.arrays[key] for key in ("x", "p", "weight"))
            exact = pressure(x)
            found.append(l2_error(p - exact, exact, weight))
        return found

    return errors


def relative_uncertainty(levels: Sequence[FemResult], key: str) -> float:
    """Standard uncertainty of the finest value over itself; infinite where it does not converge."""
    h, v = [r.h for r in levels], [r.values[key] for r in levels]
    u_it = max(r.u_it.get(key, 0.0) for r in levels)
    grid = grid_convergence(h, v, formal=2.0, scale=abs(v[-1]), u_it=u_it)
    return judge.numerical_uncertainty(grid, u_it) / abs(v[-1])
