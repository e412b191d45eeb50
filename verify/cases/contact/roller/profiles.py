"""Gaps of rollers for the reference, from the second implementation of crowns."""

from typing import TYPE_CHECKING

import numpy as np

from verify.cases.contact.roller.inputs import Crown, Design, Roller, Tilt

if TYPE_CHECKING:
    from analytic.contact.crown_again import Gap


def gap(q: Roller, design: Design | None = None) -> "Gap":
    """Function of y [m] that returns the gap [m] between roller and race, from tilt and crown.

    A crown `design` for the load F replaces the crown of the roller.
    """
    from analytic.contact import crown_again

    crown: Gap = np.zeros_like
    load = q.F
    if design is None and isinstance(q, Crown):
        design, load = Design(q.K_1, q.K_2, q.z_m), q.Q
    if design is not None:
        crown = crown_again.logarithmic(**design._asdict(), load=load, length=q.L, E_star=q.E_star)
    slope = np.tan(q.theta) if isinstance(q, Tilt) else 0.0
    return lambda y: np.asarray(crown(y) - slope * y)


def even_crowns(q: Roller) -> "dict[str, Gap]":
    """Crowns for uniform pressure under F, as functions of y, by their names in results."""
    from analytic.contact import crown_again

    law = {"load": q.F, "length": q.L, "E_star": q.E_star}
    return {"Lundberg": crown_again.lundberg(**law),
            "Johns": crown_again.johns_gohar(**law, half_width=q.b)}  # fmt: skip
