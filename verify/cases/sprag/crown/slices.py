"""Dependence of the largest pressure of a crown on the number of slices or strips."""

import numpy as np

from verify.core.case import Context
from verify.core.figures import Curves
from verify.form.plots import curve, dashes, plot

MPa = 1e6
NAMES = ("no crown", "Eq. 21's crown", "(5, 0.7, 15 µm)")
FROM = 21  # slices
WITHIN = 5e-3


def hardly_by_slices(context: Context) -> tuple[float, float, str]:
    """Positive margin if p_max depends little on the number of slices: its spread is below WITHIN.

    The uncertainty and the text of the row are also returned. The text includes the pressures by
    strips.
    """
    found = context.fem[-1].arrays
    enough = found["counts"] >= FROM
    by_slices = found["counted, slices"][1][enough] / MPa
    strips = found["counted, strips"][1] / MPa
    spread = float(np.ptp(by_slices) / by_slices.mean())
    words = (
        f"by slices, p_max is {by_slices.min():.0f} to {by_slices.max():.0f} MPa; by strips on a "
        f"half-space, p_max is at the loaded ends: {strips[0]:.0f} MPa with "
        f"{found['counts'][0]:.0f} strips and {strips[-1]:.0f} MPa with "
        f"{found['counts'][-1]:.0f} strips"
    )
    return WITHIN - spread, 0.0, words


def by_number(context: Context) -> Curves:
    """Figure of p_max over the number of slices or strips, with and without a crown."""
    found = context.fem[-1].arrays
    n = found["counts"]
    curves = [
        curve(f"{name}, {by}", n, found[f"counted, {by}"][k] / MPa, style, 2 * k)
        for k, name in enumerate(NAMES)
        for by, style in (("slices", "line"), ("strips", "dashes"))
    ]  # fmt: skip
    curves += [
        dashes(name, n[[0, -1]], p, colour)
        for name, p, colour in (
            ("printed without crown, about 3500", 3500.0, 5),
            ("printed for Eq. 21, 2980", 2980.0, 3),
        )
    ]  # fmt: skip
    N = float(found["counted N"][0])
    return plot(
        "p_max over the number of slices", "slices or strips", "p_max [MPa]", curves,
        y_bottom=2500.0,
        note=f"The force is {N:.0f} N, the first force peak at 25 N m. At loaded ends, p_max grows "
        "without limit: without a crown in both models, with the crown of Eq. 21 only in the strip "
        "model, whose half-space continues beyond the end of the sprag. Horizontal lines: printed "
        "values.",
    )  # fmt: skip
