"""Gaps of rollers as the reference takes them, from the second writing of the crowns."""

from typing import TYPE_CHECKING, Any

import numpy as np

from verify.cases.contact.roller.inputs import Crown, Design, Roller, Tilt

if TYPE_CHECKING:
    from analytic.contact.crown_again import Gap


def gap(q: Roller) -> "Gap":
    """Height over the race at y: of the crown where there is one, and of the tilt."""
    crown: Gap = np.zeros_like
    if isinstance(q, Crown):
        crown = logarithmic(q, Design(q.K_1, q.K_2, q.z_m), q.Q)
    return tilted(crown, np.tan(q.theta) if isinstance(q, Tilt) else 0.0)


def tilted(crown: "Gap", slope: float) -> "Gap":
    """A crown whose axis has a slope."""
    return lambda y: np.asarray(crown(y) - slope * y)


def logarithmic(q: Roller, design: Design, load: float) -> "Gap":
    """Eq. 1 with a design's K_1, K_2 and z_m."""
    from analytic.contact import crown_again

    return crown_again.logarithmic(**design._asdict(), load=load, **sizes(q))


def lundberg(q: Roller) -> "Gap":
    """Lundberg's crown for F."""
    from analytic.contact import crown_again

    return crown_again.lundberg(load=q.F, **sizes(q))


def johns_gohar(q: Roller) -> "Gap":
    """Johns and Gohar's crown for F."""
    from analytic.contact import crown_again

    return crown_again.johns_gohar(load=q.F, half_width=q.b, **sizes(q))


def sizes(q: Roller) -> dict[str, Any]:
    """What all crowns take."""
    return {"length": q.L, "E_star": q.E_star}
