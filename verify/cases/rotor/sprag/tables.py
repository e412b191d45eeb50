"""Tables and sketch of the system with sprag clutch."""

from collections.abc import Sequence

import numpy as np

from verify.cases.rotor.sprag.assertions import STATEMENTS, Statement, opposite
from verify.cases.rotor.sprag.check_types import Arrays, arrays, held_of
from verify.cases.rotor.sprag.formulas import MODES, ORDERS
from verify.cases.rotor.sprag.inputs import RPM, SpragRotorInputs
from verify.cases.rotor.sprag.layout import (
    BETWEEN,
    CLUTCH,
    DISCS,
    GROUNDED,
    INNER,
    OUTER,
    PARAMETERS,
)
from verify.core.case import Context
from verify.core.figures import Array, Shape, Sketch, Table
from verify.form import sketches
from verify.form.sketches import arrow, leader, shape, text

UPPER = 4.2  # height of the outer rotor's axis above the inner rotor's axis in the sketch


def tables(context: Context) -> Sequence[Table]:
    if not context.fem or not arrays(context)["members"].size:
        return (unknowns(None),)
    a = arrays(context)
    return (table_1(context), facts(context), unknowns(a["members"]), slopes(a["elasticities"]))


def table_1(context: Context) -> Table:
    v, coarse = context.analytic, context.fem[0].values
    solid = arrays(context)["solid"]
    rows = []
    for i in range(MODES):
        exact, beams = v[f"frequency_{i + 1}"], coarse[f"frequency_{i + 1}"]
        rows.append((
            i + 1, "not available", round(beams, 3), round(exact, 3),
            f"{100 * (beams / exact - 1):.4f}", round(float(solid[-1, i]), 2),
            f"{100 * (exact / float(solid[-1, i]) - 1):+.2f}",
        ))  # fmt: skip
    return Table(
        title=f"Natural frequencies at {context.inputs.speed / RPM:.5g} r/min (layout of Table 1)",
        header=("mode", "paper [Hz]", "20 beam elements [Hz]", "exact beams [Hz]",
                "error of 20 elements [%]", "elastic bodies [Hz]", "error of exact beams [%]"),
        rows=tuple(rows),
        note="The frequencies are those of the system fitted from mid-range parameters. In each "
             "pair of modes, the first is backward whirl, the second is forward whirl. The numbers "
             "of Table 1 are not in the text of the paper that was available for this project.",
    )  # fmt: skip


def facts(context: Context) -> Table:
    a = arrays(context)
    other = opposite(a)
    most = np.sum([s.holds(a) & s.asked(a) for s in STATEMENTS], axis=0)
    rows = tuple(
        (s.name, s.place, held_of(s, a), _share(s, a), held_of(s, other), _share(s, other))
        for s in STATEMENTS
    )
    return Table(
        title="Statements of the paper that were not used in the fit",
        header=("statement", "place", "holds in", "%", "with opposite unbalances, holds in", "%"),
        rows=rows,
        note=f"At most {int(most.max())} of the "
             f"{len(STATEMENTS)} statements hold in the same set of parameters. For each "
             "statement, only sets are counted in which all compared responses have a peak "
             "near a critical speed.",
    )  # fmt: skip


def _share(statement: Statement, a: Arrays) -> str:
    asked = statement.asked(a)
    return f"{100 * float(statement.holds(a)[asked].mean()):.0f}" if asked.any() else "no set"


def unknowns(members: Array | None) -> Table:
    """Table of values missing in the paper: ranges with reasons, and ranges after the fit."""
    rows = []
    for i, p in enumerate(PARAMETERS):
        left = ("", "", "")
        if members is not None:
            spread = np.percentile(members[:, i] / p.factor, (5, 50, 95))
            left = tuple(f"{float(x):.3g}" for x in spread)  # type: ignore[assignment]
        rows.append((p.symbol, p.what, p.unit, p.low, p.high, *left, p.reason))
    return Table(
        title="Parameters that the paper does not print: ranges before and after the fit to three "
              "critical speeds",
        header=("symbol", "parameter", "unit", "lower limit", "upper limit", "5th percentile",
                "median", "95th percentile", "reason of the limits"),
        rows=tuple(rows),
        note="Before the fit, the logarithms of the values are uniformly distributed between the "
             "limits. Percentiles and medians are those after the fit. Discs are 20 mm wide. The "
             "ratio of bore to diameter of the drum is that of the outer race in Ref. 9. All parts "
             "are of steel.",
    )  # fmt: skip


def slopes(elasticities: Array) -> Table:
    """Table of median sensitivities of the critical speeds to the parameters.

    `elasticities` (m, 3, 12) are relative changes. The note states the effect of those
    combinations of parameters that the speeds determine.
    """
    middle = np.median(elasticities, axis=0)
    stiff = np.linalg.svd(middle, compute_uv=False)
    rows = tuple(
        (p.symbol, p.what, *(f"{float(x):+.3f}" for x in middle[:, i]))
        for i, p in enumerate(PARAMETERS)
    )
    return Table(
        title="Change of a critical speed in % for an increase of a parameter by 1 %",
        header=("symbol", "parameter", *(f"n_{k}" for k in ORDERS)), rows=rows,
        note="The values are medians over the sets. The three speeds determine three combinations "
             "of the parameters: a change of the first, second or third combination by 1 % changes "
             "the speeds by " + ", ".join(f"{float(x):.2g}" for x in stiff)
        + " %, respectively (root of the sum of squares). Changes in "
        f"{len(PARAMETERS) - len(stiff)} other combinations do not change the speeds.",
    )  # fmt: skip


def sketch(_: SpragRotorInputs) -> Sketch:
    """Sketch of Fig. 1 with equal node distances: outer rotor above, inner rotor below."""
    x = {n: n - 1.0 for n in range(1, OUTER + 1)}
    x |= {n: n - CLUTCH[1] + x[CLUTCH[0]] for n in range(OUTER + 1, OUTER + INNER + 1)}
    up = {n: UPPER if n <= OUTER else 0.0 for n in x}
    drum = [_box(x[7], x[8], UPPER, 1.0)]
    drum += [_box(x[8], x[OUTER], UPPER + side * 0.8, 0.2) for side in (1, -1)]
    shapes = [_box(x[1], x[7], UPPER, 0.45), *drum, _box(x[13], x[22], 0.0, 0.4)]
    for n in x:
        at = [x[n], up[n] + (1.25 if n <= OUTER else -1.4)]
        shapes.append(text(at, str(n)))
    for k, n in zip((1, 2, 5), GROUNDED, strict=True):
        away = -1 if n <= OUTER else 1  # direction away from the numbers
        foot, head = up[n] + 1.7 * away, up[n] + 0.5 * away
        shapes += [leader((x[n], foot), (x[n], head), f"bearing {k}")]
    for a, b in (*BETWEEN, CLUTCH):
        shapes.append(arrow((x[a], UPPER - 1), (x[b], 0.4), style="dimension"))
    first, high = x[BETWEEN[0][0]], UPPER / 2 - 0.4
    line = np.array([[first - 2.5, high - 0.7], [first - 0.2, high]])
    shapes.append(shape("leader", line, "bearing 3, clutch, bearing 4"))
    for k, n in enumerate(DISCS, 1):
        high = 0.45 if n <= OUTER else 0.4
        shapes += [_box(x[n] - 0.15, x[n] + 0.15, up[n] + side * (high + 0.2), 0.2)
                   for side in (1, -1)]  # fmt: skip
        tip = np.array([[x[n], up[n] + 2.7], [x[n], up[n] + (1.9 if n <= OUTER else 0.9)]])
        shapes.append(shape("load", tip, f"unbalance {k}"))
    return sketches.sketch(
        "nodes of Fig. 1 at equal distances, because no length is printed", shapes
    )


def _box(left: float, right: float, middle: float, half: float) -> Shape:
    low, high = middle - half, middle + half
    corners = [[left, low], [right, low], [right, high], [left, high]]
    return shape("body", np.array(corners))
