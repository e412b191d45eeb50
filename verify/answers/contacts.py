"""Criteria for rollers, spheres and crowned rollers in contact."""

from typing import Any

from verify.answers.assessment import Assessment
from verify.answers.strengths import GIVEN, Strength
from verify.core.case import Values

OTHER = "no limit is known for this material"


def line(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of a line contact: Hertzian pressure, and subsurface shear if R_p is given."""
    moduli = (q.E,) if hasattr(q, "E") else (q.E_1, q.E_2)
    part.pressure("contact_pressure", "Hertzian pressure", v["p_0"], *moduli, option=OTHER)
    _subsurface(q, v["tau_max"], part)


def sphere(q: Any, v: Values, part: Assessment) -> None:
    """Criteria of both point contacts of a sphere (with a flat and with a second sphere)."""
    for key, body, p in (
        ("flat", "flat", v["p_0_flat"]), ("sphere", "second sphere", v["p_0"]),
    ):  # fmt: skip
        part.pressure(f"contact_pressure_{key}", f"Hertzian pressure on the {body}",
                      p, q.E_1, q.E_2, contact="point", option=OTHER)  # fmt: skip
    _subsurface(q, max(v["tau_upper_flat"], v["tau_upper"]), part)


def slip(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a roller under an alternating tangential force: Hertzian pressure."""
    p = v["p_0"]
    part.pressure("contact_pressure", "Hertzian pressure", p, q.E, option=OTHER)


def roller(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a crowned roller: largest pressure away from its ends.

    If the ends carry load, the pressure at the ends is unknown; a part that meets the criterion is
    then undecided.
    """
    p = v["p_max"]
    part.pressure("contact_pressure", "largest pressure away from the ends", p, q.E_1, q.E_2,
                  option=OTHER)  # fmt: skip
    if q.loaded_ends:
        part.unknowns.append(
            "the ends of the roller carry load: the pressure at the ends is unbounded in this "
            "model and "
            "increases with the number of strips; a crown unloads the ends"
        )


def crowns(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a roller with Lundberg's crown: pressure at mid-length."""
    part.pressure("contact_pressure", "pressure at mid-length, Lundberg's crown",
                  v["p_mid"], q.E_1, q.E_2, option=OTHER)  # fmt: skip


def end_face(q: Any, v: Values, part: Assessment) -> None:
    """Criterion of a crowned roller: pressure at mid-length.

    There is no criterion for the pressure at the end face, because it is unbounded in this model.
    """
    part.pressure("contact_pressure", "pressure at mid-length, crowned", v["p_mid"],
                  q.E_1, q.E_2, option=OTHER)  # fmt: skip
    part.unknowns.append(
        "the pressure at the end face is unbounded in this model: compare the load on the end "
        "zones with the load on the end zones of the crowned roller"
    )


def _subsurface(q: Any, shear: float, part: Assessment) -> None:
    if q.R_p is not None:
        part.stress("subsurface_shear", "largest shear stress below the surface", shear,
                    Strength(q.R_p / 2, f"{GIVEN} R_p / 2 (Tresca)", False))  # fmt: skip
