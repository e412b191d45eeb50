"""Claims of case spring-width on its shells: accepted differences, limits, other elements."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.spring.frame import Head, Tail
from analytic.spring.wide_leaf import width_factor
from verify.cases.spring.claims import stored
from verify.cases.spring.curve.inputs import CurveInputs
from verify.cases.spring.width.inputs import WidthInputs
from verify.cases.spring.width.reference import ENDS
from verify.core.case import Context
from verify.core.figures import Array
from verify.judging import judge
from verify.judging.checks import Margin
from verify.judging.convergence import grid_convergence
from verify.judging.tolerance_checks import Pair, farthest
from verify.papers.ledger import published

OfContext = Callable[[Context], Pair]
N_PER_MM = 1e3
LIMIT = 0.005  # tolerance of the factor at the ends of the sweep
TAKEN = 0.002  # tolerance of the factor used for the whole curve
ESTIMATE = 0.001  # tolerance of the factor of the spring estimated from the factor of a leaf
SWEEP = 0.005  # the same tolerance over all widths
SOLID = 1e-3  # tolerance of the factor against solids
HEAD = 5e-4  # change of the factor with the supports of head and tail
UNIFORM = 5e-5  # change of the factor with the distribution of the head's force
MET = 0.01  # largest difference from the printed stiffness, relative to it


def relative_uncertainty(context: Context, key: str, formal: float | None = None) -> float:
    """Relative standard uncertainty of the finest value of `key`; infinite without convergence."""
    h, v = context.series(key)
    grid = grid_convergence(h, v, formal=formal, scale=abs(v[-1]))
    return judge.numerical_uncertainty(grid) / abs(v[-1])


def sweep_uncertainty(context: Context) -> float:
    """Relative uncertainty of width factors on the sweep's mesh, by comparison with all meshes.

    It is the largest relative difference at the width of the inputs and at the narrowest width.
    """
    series = (context.series(key)[1] for key in ("f", "f_narrowest"))
    return max(abs(value / f[-1] - 1) for f in series for value in f)


def sweep(context: Context) -> Array:
    """Widths [m] and width factors f, shape (m, 2), in order of increasing width."""
    names = ("narrow", "medium", "wide")
    found: Any = [row for name in names for row in stored(context, f"sweep_{name}")]
    return np.array(sorted(map(tuple, found)))


def limits(context: Context) -> tuple[float, float]:
    """Width factors of an infinitely narrow and of an infinitely wide spring."""
    return 1.0, context.analytic["k_wide"] / context.analytic["k_narrow"]


def narrow(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Lists for narrow strips: width/thickness, relative error of plane stress, its uncertainty."""
    h, f = stored(context, "sweep_narrow").T
    u = [sweep_uncertainty(context)] * len(h)
    return (h / context.inputs.b).tolist(), (limits(context)[0] / f - 1).tolist(), u


def wide(context: Context) -> tuple[list[float], list[float], list[float]]:
    """Lists for wide strips: leaf length/width, relative error of plane strain, its uncertainty."""
    h, f = stored(context, "sweep_wide").T
    u = [sweep_uncertainty(context)] * len(h)
    return (context.inputs.leaf / h).tolist(), (limits(context)[1] / f - 1).tolist(), u


def at_end(which: int) -> OfContext:
    """Function that returns a pair: limit of the width factor, and width factor by the shell.

    The width is the smallest (`which` = 0) or the largest (`which` = -1) of the sweep.
    """

    def pair(context: Context) -> Pair:
        h, f = map(float, sweep(context)[which])
        limit = limits(context)[which]
        U = judge.expanded(sweep_uncertainty(context)) * f
        return Pair(limit, f, U, f"difference {f / limit - 1:+.3%} at h = {h * 1e3:.4g} mm")

    return pair


def taken(context: Context) -> Pair:
    """Pair of width factors: that of case spring-curve, and that by the shell."""
    default = CurveInputs.model_fields["width_factor"].default
    f = context.series("f")[1][-1]
    U = judge.expanded(relative_uncertainty(context, "f")) * f
    return Pair(default, f, U, f"{default:g} in spring-curve, {f:.5f} by the shell")


def estimate(context: Context) -> Pair:
    """Pair of width factors at the inputs' width: of a leaf, and of the spring by the shell."""
    f, leaf = context.series("f")[1][-1], context.analytic["f"]
    U = judge.expanded(relative_uncertainty(context, "f")) * f
    return Pair(leaf, f, U, f"leaf {leaf:.5f}, spring {f:.5f}: {leaf / f - 1:+.3%}")


def leaf_factor(q: WidthInputs, h: Any) -> Array:
    """Width factors of a middle leaf for the widths h [m], shape (m,)."""
    return np.asarray(width_factor(h, q.leaf, nu=q.nu), dtype=np.float64)


def estimates(context: Context) -> Pair:
    """Pair of width factors (leaf, spring) at the width where they differ most."""
    h, f = sweep(context).T
    leaves = leaf_factor(context.inputs, h)
    off = leaves / f - 1
    found = farthest(leaves, f, judge.expanded(sweep_uncertainty(context)))
    worst = int(abs(off).argmax())
    words = f"largest difference of the leaf {off[worst]:+.2%}, at h = {h[worst] * 1e3:.3g} mm"
    return replace(found, words=words)


def solids(name: str) -> OfContext:
    """Function that returns a pair: relative stiffness of a loop by shell and by solid.

    Each stiffness is relative to the value of its model in plane strain.
    """

    def pair(context: Context) -> Pair:
        keys = f"shell_{name}", f"solid_{name}"
        shell, solid = (context.series(key)[1][-1] for key in keys)
        u = (relative_uncertainty(context, key, formal=4) for key in keys)  # quadratic elements
        U = judge.expanded(math.hypot(*u)) * solid
        words = f"relative to plane strain: shell {shell:.5f}, solid {solid:.5f}, difference " \
            f"{shell / solid - 1:+.1e}"  # fmt: skip
        return Pair(shell, solid, U, words)

    return pair


def ends(context: Context) -> Pair:
    """Pair of the largest and the smallest width factor of all end conditions, on one mesh."""
    f = stored(context, "ends")
    return Pair(float(f.max()), float(f.min()), 0.0, f"{f.min():.5f} to {f.max():.5f}")


def uniform(context: Context) -> Pair:
    """Pair of width factors on one mesh: with a straight head, and with a uniform force on it."""
    line, force = map(float, stored(context, "uniform"))
    words = f"relative increase of the displacement by a uniform force: {1 - force / line:+.1e}"
    return Pair(line, force, 0.0, words)


def readings(context: Context) -> dict[tuple[Tail, Head], tuple[float, float]]:
    """Width factor and stiffness [N/m] by the shell, for each pair of end conditions."""
    found: dict[tuple[Tail, Head], tuple[float, float]] = {}
    for (tail, head), f in zip(ENDS, stored(context, "ends"), strict=True):
        found[tail, head] = float(f), float(f * context.inputs.held(tail, head).k_narrow)
    return found


def meets(tail: Tail, head: Head) -> Margin:
    """Function that returns a positive margin if k_1 is within MET of k_1 of the paper's shell."""

    def margin(context: Context) -> tuple[float, float, str]:
        printed = published("wang2023:k1-fea").value * N_PER_MM
        k = readings(context)[tail, head][1]
        U = judge.expanded(sweep_uncertainty(context), 0.5 / math.sqrt(3) / printed)
        off = k / printed - 1
        return MET - abs(off), U, f"{k / N_PER_MM:.4f} N/mm, {off:+.2%} from the printed value"

    return margin
