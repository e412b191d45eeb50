"""Figures and tables of the surrogate: designs, errors and searches."""

from collections.abc import Sequence

import numpy as np

from verify.cases.sprag.optimum.deep import DEEP_25, DEEP_40, DESIGNS, ENGAGEMENTS, SEEDS
from verify.cases.sprag.optimum.inputs import Optimum25Inputs
from verify.cases.sprag.optimum.surrogate_claims import missed
from verify.cases.sprag.statements import measured
from verify.core.case import Context
from verify.core.figures import Array, Bars, Curves, Figure, Panel, Shapes, Table
from verify.form.plots import dots, line, plot
from verify.jobs.deep_results import Measured
from verify.jobs.deep_results import measured as deep_measured
from verify.papers.ledger import published

MPa, PERCENT = 1e6, 100
ASIDE = np.array([0.42, 0.30])  # direction of the third axis in an oblique view
TABLE_2 = 10  # rows


def deeper(context: Context) -> Measured | None:
    """Stored results of the long studies (`deep`) for the paper's clutch; None for other inputs."""
    if not context.is_paper:
        return None
    return deep_measured(DEEP_25 if isinstance(context.inputs, Optimum25Inputs) else DEEP_40)


def oblique(u: Array) -> Array:
    """Oblique projection (n, 2) of points (n, 3) in the unit cube; K_2 is the oblique axis."""
    return np.asarray(u[:, [0, 2]] + u[:, [1]] * ASIDE)


def designs(context: Context) -> Sequence[Figure]:
    """Figure of the designs in the space of the parameters (Fig. 10)."""
    found, box = measured(context), context.inputs.box
    corners = np.array([[a, b, c] for a in (0, 1) for b in (0, 1) for c in (0, 1)], dtype=float)
    edges = tuple(
        oblique(np.array([p, r])) for p in corners for r in corners
        if np.abs(p - r).sum() == 1 and p.sum() < r.sum()
    )  # fmt: skip
    return (
        Shapes(
            title="Designs (Fig. 10)", unit="fraction of each range",
            panels=tuple(
                Panel(name=name, lines=edges, dots=oblique(box.to_unit(found[key])))
                for name, key in ((f"{len(found['X'])} factorial designs", "X"),
                                  (f"{len(found['extra'])} random designs", "extra"))
            ),
            dots_name="design",
            note="K_1 increases to the right, z_m upwards, K_2 obliquely to the back.",
        ),
    )  # fmt: skip


def errors(context: Context) -> Sequence[Figure]:
    """Figure of the errors of the surrogates over the true pressure, with those of Table 2."""
    found, deep = measured(context), deeper(context)
    true = found["extra largest"][:, 0] / MPa
    more = deep.parts[0].arrays if deep else None
    curves = []
    for colour, (key, name) in enumerate(
        (("single", "single kriging model"), ("two", "separate kriging models"))
    ):
        x, y = true, PERCENT * missed(found, key)
        if more is not None:
            x, y = np.r_[x, more["true"] / MPa], np.r_[y, PERCENT * more[key]]
        curves.append(dots(name, x, y, 2 * colour))
    if context.is_paper and isinstance(context.inputs, Optimum25Inputs):
        actual, predicted = (
            np.array([published(f"huang2018:table2-row{k + 1}-{which}").value
                      for k in range(TABLE_2)])
            for which in ("actual", "predicted")
        )  # fmt: skip
        curves.append(dots("Table 2", actual, PERCENT * (predicted / actual - 1), 4))
    count = len(curves[0].x)
    note = f"{len(true)} designs that no surrogate uses" + (
        f", and {DESIGNS} more, computed on {deep.date}." if deep else
        f"; {DESIGNS} more are computed by `freewheel deep`." if context.is_paper
        else "."
    )  # fmt: skip
    return (
        plot(
            "Errors of the surrogates", "Pre_max [MPa]", "predicted/true − 1 [%]", curves,
            y_bottom=min(-0.1, *(float(c.y.min()) for c in curves)) if count else None, note=note,
        ),
    )  # fmt: skip


def bars(context: Context) -> Bars:
    """Bar chart of the errors of the surrogates, and of the leave-out estimates of these errors."""
    found = measured(context)
    items = []
    for key, name in (("single", "single kriging model"), ("two", "separate kriging models")):
        for words, error in (
            ("new designs", missed(found, key)),
            ("one level left out", found[f"level out {key}"]),
            ("one design left out", found[f"left out {key}"]),
        ):  # fmt: skip
            size = PERCENT * np.abs(error)
            items.append((f"{name}: {words}", float(size.mean()),
                          f"{size.mean():.2g} %, largest {size.max():.2g} %"))  # fmt: skip
    return Bars(
        title="Errors of kriging and their estimates",
        label="mean |error| [%]",
        items=tuple(items),
        note="The separate models are those of the end slice and of the other slices. If one "
        "design is left out, its neighbours with the same value of a parameter remain; the "
        "estimated error therefore does not contain the kink of the pressure between two "
        "values of this parameter.",
    )


def searches(context: Context) -> Curves:
    """Figure of the lowest pressure over the number of evaluations, with and without surrogate."""
    found = measured(context)
    curves = []
    for colour, (key, name) in enumerate(
        (
            ("GA", "genetic algorithm, on the surrogate"),
            ("DE", "differential evolution, on the surrogate"),
        )
    ):
        history = found[f"{key} history"]
        asked = np.linspace(0, float(found[f"{key} evaluations"][0]), len(history) + 1)[1:]
        curves.append(line(name, np.log10(asked), history / MPa, 2 * colour))
    tried = np.minimum.accumulate(found["direct"][:, 3]) / MPa
    curves.append(line("simplex, on computed engagements, from the given crown",
                       np.log10(np.arange(1, len(tried) + 1)), tried, 4))  # fmt: skip
    rounds = found["infill"]
    at = np.log10(len(found["X"]) + np.arange(1, len(rounds) + 1))
    curves += [
        dots("optimum of the surrogate, by a computed engagement", at, rounds[:, 4] / MPa, 5),
        dots("optimum of the surrogate, predicted", at, rounds[:, 3] / MPa, 1),
    ]  # fmt: skip
    low = min(float(c.y.min()) for c in curves)
    return plot(
        "Searches for the optimal crown", "number of evaluations", "Pre_max [MPa]", curves,
        y_bottom=0.998 * low, y_top=1.015 * low,
        x_names=tuple((float(k), f"{10**k:,}") for k in range(5)),
        note="For the optimum of the surrogate, the number of evaluations includes the computed "
        "engagements of the factorial.",
    )  # fmt: skip


def longer(context: Context) -> Sequence[Table]:
    """Table of the results of the long studies."""
    if not context.is_paper:
        return ()
    deep = deeper(context)
    if deep is None:
        missing = (("not computed for this version of the code",),)
        return (Table(title="Longer searches and more designs", header=("",), rows=missing,
                      note="`freewheel deep` computes them."),)  # fmt: skip
    whole, direct, seeds = (part.arrays for part in deep.parts)
    best = float(measured(context)["best true"][0])
    low = direct["direct"][:, 3]
    first = int(np.argmax(low <= best * 1.001)) + 1 if low.min() <= best * 1.001 else None

    def size(key: str) -> str:
        e = PERCENT * np.abs(whole[key])
        return f"mean error {e.mean():.2f} %, largest {e.max():.2f} %"

    slower = first is None or first > len(measured(context)["X"])
    remark = (
        "" if slower else
        f" The factorial requires {len(measured(context)['X'])} computed engagements. Kriging "
        "therefore does not reduce the number of computed engagements for the optimal crown; it "
        "gives the maps."
    )  # fmt: skip
    rows = (
        (f"errors of a single kriging model at {DESIGNS} designs", size("single")),
        (f"errors of separate kriging models at {DESIGNS} designs", size("two")),
        (f"lowest pressure by DIRECT with at most {ENGAGEMENTS} computed engagements",
         f"{low.min() / MPa:.1f} MPa, {low.min() / best - 1:+.2%} relative to the optimal crown"),
        ("engagements that DIRECT computes until the pressure is within 0.1 % of the optimum",
         str(first or "not reached")),
        (f"lowest pressures by the genetic algorithm with {SEEDS} random seeds",
         f"{seeds['GA'].min() / MPa:.2f} to {seeds['GA'].max() / MPa:.2f} MPa"),
        (f"lowest pressures by differential evolution with {SEEDS} random seeds",
         f"{seeds['DE'].min() / MPa:.2f} to {seeds['DE'].max() / MPa:.2f} MPa"),
    )  # fmt: skip
    return (Table(title="Longer searches and more designs", header=("study", "result"), rows=rows,
                  note=f"Computed on {deep.date}.{remark}"),)  # fmt: skip
