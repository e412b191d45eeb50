"""Tables and sketch of the system with sprag clutch."""

from collections.abc import Sequence

import numpy as np

from verify.case import Context
from verify.cases.rotor_sprag_claims import arrays
from verify.cases.rotor_sprag_facts import STATEMENTS
from verify.cases.rotor_sprag_inputs import RPM, SpragRotorInputs
from verify.cases.rotor_sprag_layout import (
    BETWEEN,
    CENTRAL,
    CLUTCH,
    DISCS,
    GROUNDED,
    INNER,
    OUTER,
    PARAMETERS,
    layout,
)
from verify.cases.rotor_sprag_model import MODES
from verify.shown import Array, Shape, Sketch, Table

NODE_ROW = 1.35  # of the largest radius: where numbers stand


def tables(context: Context) -> Sequence[Table]:
    if not context.fem or not arrays(context)["members"].size:
        return (unknowns(None),)
    return (table_1(context), facts(context), unknowns(arrays(context)["members"]))


def table_1(context: Context) -> Table:
    v, coarse = context.analytic, context.fem[0].values
    solid = arrays(context)["solid"]
    rows = []
    for i in range(MODES):
        exact, beams = v[f"natural frequency {i + 1}"], coarse[f"natural frequency {i + 1}"]
        rows.append((
            i + 1, "not in the text", round(beams, 3), round(exact, 3),
            f"{100 * (beams / exact - 1):.4f}", round(float(solid[-1, i]), 2),
            f"{100 * (exact / float(solid[-1, i]) - 1):+.2f}",
        ))  # fmt: skip
    return Table(
        title=f"Natural frequencies at {context.inputs.speed / RPM:.5g} r/min (Table 1's layout)",
        header=("order", "paper [Hz]", "20 beam elements [Hz]", "exact beams [Hz]",
                "20 elements, error [%]", "elastic bodies [Hz]", "exact beams, error [%]"),
        rows=tuple(rows),
        note="of the central system, backward before forward; no figure of Table 1 is in the text",
    )  # fmt: skip


def facts(context: Context) -> Table:
    a = arrays(context)
    held = [statement.holds(a) for statement in STATEMENTS]
    most = np.sum(held, axis=0)
    rows = tuple(
        (s.name, s.place, f"{int(h.sum())} of {h.size}", f"{100 * float(h.mean()):.0f}")
        for s, h in zip(STATEMENTS, held, strict=True)
    )
    return Table(
        title="What was not fitted: statements of the paper in the members",
        header=("statement", "place", "holds in", "%"), rows=rows,
        note=f"no member was chosen by them; the one that holds most holds {int(most.max())} of "
        f"{len(STATEMENTS)}",
    )  # fmt: skip


def unknowns(members: Array | None) -> Table:
    """What the paper lacks: ranges with their reasons, and what three critical speeds leave."""
    rows = []
    for i, p in enumerate(PARAMETERS):
        left = ("", "", "")
        if members is not None:
            spread = np.percentile(members[:, i] / p.factor, (5, 50, 95))
            left = tuple(f"{float(x):.3g}" for x in spread)  # type: ignore[assignment]
        rows.append((p.symbol, p.what, p.unit, p.low, p.high, *left, p.reason))
    return Table(
        title="What the paper lacks: ranges, and what three critical speeds leave of them",
        header=("symbol", "what", "unit", "from", "to", "5 %", "50 %", "95 %", "reason"),
        rows=tuple(rows),
        note="even over the logarithm; discs 20 mm wide, a drum with the walls of Ref. 9's outer "
        "race; steel",
    )  # fmt: skip


def sketch(_: SpragRotorInputs) -> Sketch:
    """Fig. 1 as the central system, to scale."""
    s = layout(CENTRAL)
    z = s.z[0]
    largest = float(s.d_o[0].max()) / 2
    shapes = [_piece(s.d_o[0, e], s.d_i[0, e], z[node], z[node + 1], side)
              for e, node in enumerate(n for n in range(OUTER + INNER - 1) if n != OUTER - 1)
              for side in (1, -1)]  # fmt: skip
    shapes.append(Shape(style="axis", points=np.array([[z.min(), 0], [z.max(), 0]]) * [[1.03, 1]]))
    for n in range(1, OUTER + INNER + 1):
        height = NODE_ROW * largest if n <= OUTER else -NODE_ROW * largest
        shapes.append(Shape(style="text", points=np.array([[z[n - 1], height]]), label=str(n)))
    for label, n, m in (
        *((f"bearing {k}", n, 0) for k, n in zip((1, 2, 5), GROUNDED, strict=True)),
        *((f"bearing {k}", a, b) for k, (a, b) in zip((3, 4), BETWEEN, strict=True)),
        ("clutch", *CLUTCH), *((f"disc, unbalance {k}", n, 0) for k, n in enumerate(DISCS, 1)),
    ):  # fmt: skip
        up = 1 if n <= OUTER else -1
        far = 1.7 + 0.35 * ((n + (m > 0)) % 3)
        shapes.append(
            Shape(style="leader", label=label,
                  points=up * largest * np.array([[0, far], [0, 1.0]])
                  + np.array([[z[n - 1], 0.0], [z[n - 1], 0.0]]))
        )  # fmt: skip
    return Sketch(title="central system, to scale, the paper's nodes", shapes=tuple(shapes))


def _piece(d_o: float, d_i: float, start: float, end: float, side: int) -> Shape:
    low, high = side * d_i / 2, side * d_o / 2
    corners = [[start, low], [end, low], [end, high], [start, high]]
    return Shape(style="body", points=np.array(corners))
