"""Tables and figures of the optimal crown."""

from collections.abc import Sequence

import numpy as np

from verify.cases.sprag.optimum.contact_figures import apart, at_counts, before_and_after, contact
from verify.cases.sprag.optimum.maps_figures import lines, maps, valley
from verify.cases.sprag.optimum.surrogate_figures import bars, designs, errors, longer, searches
from verify.cases.sprag.statements import measured
from verify.core.case import Context
from verify.core.figures import Figure, Table

MPa, um = 1e6, 1e-6


def tables(context: Context) -> Sequence[Table]:
    if not context.converging:
        return ()
    return (crowns(context), extra(context), *longer(context))


def crowns(context: Context) -> Table:
    """Table of the largest pressures of all crowns by all methods, each under its N_max."""
    found = measured(context)
    names = {"at hand": "printed" if context.is_paper else "given", "best": "optimal by slices",
             "free": "optimal with unloaded ends"}  # fmt: skip
    rows: list[tuple[str | float | None, ...]] = []
    for key, name in names.items():
        if f"{key}: crown" not in found:
            continue
        K_1, K_2, z_m = (float(x) for x in found[f"{key}: crown"])
        by = [float(found[f"{key}: {part}"].max()) / MPa for part in
              ("pressures", "strips 81", "strips 161", "cells 384", "cells 768")]  # fmt: skip
        by[0] = float(found[f"{key}: pressures"][0].max()) / MPa
        N = float(found[f"{key}: N_max"][0])
        rows.append((name, *(round(x, 4) for x in (K_1, K_2)), round(z_m / um, 2), round(N),
                     *(round(p) for p in by)))  # fmt: skip
    best = found["direct"][int(np.argmin(found["direct"][:, 3]))]
    return Table(
        title="Crowns and their largest pressures",
        header=("crown", "K_1", "K_2", "z_m [µm]", "N_max [N]",
                f"{context.inputs.slices} slices [MPa]", "81 strips", "161 strips",
                "half-space, 384 cells", "768 cells"),
        rows=tuple(rows),
        note="If the pressure grows with the number of strips or cells, the ends are loaded: on a "
        "half-space, their pressure has no limit. A search without surrogate ends at K_1 = "
        f"{best[0]:.4f}, K_2 = {best[1]:.4f}, z_m = {best[2] / um:.2f} µm with "
        f"{best[3] / MPa:.0f} MPa by slices.",
    )  # fmt: skip


def extra(context: Context) -> Table:
    """Table of errors of the surrogates at the extra designs, in the form of Table 2."""
    found = measured(context)
    true, one, two = found["extra largest"][:, 0], found["extra single"], found["extra two"]
    rows = tuple(
        (round(float(x[0]), 3), round(float(x[1]), 3), round(float(x[2]) / um, 2),
         round(float(t) / MPa, 1), round(float(a) / MPa, 1), round(100 * abs(float(t / a - 1)), 2),
         round(float(b) / MPa, 1), round(100 * abs(float(t / b - 1)), 2))
        for x, t, a, b in zip(found["extra"], true, one, two, strict=True)
    )  # fmt: skip
    return Table(
        title="Errors of the surrogates at the extra designs, in the form of Table 2",
        header=("K_1", "K_2", "z_m [µm]", "actual [MPa]", "single model [MPa]", "error [%]",
                "separate models [MPa]", "error [%]"),
        rows=rows,
        note="Predictions by a single kriging model, and by separate kriging models of the end "
        "slice and of the other slices. Errors are relative to the predicted value, as in Table 2. "
        "The paper does not print the designs of Table 2.",
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    return (
        *designs(context), *errors(context), bars(context), searches(context),
        *maps(context), lines(context), valley(context),
        *contact(context), at_counts(context), apart(context), *before_and_after(context),
    )  # fmt: skip
