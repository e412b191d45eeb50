"""What an engineer should know of a line contact before trusting Hertz's formulas."""

from collections.abc import Sequence

from verify.cases.contact.line.inputs import LineInputs

STATIC_RATING = 4.0e9  # Pa, ISO 76: pressure of roller bearings at their static load rating


def warnings(q: LineInputs, a: float, p_0: float, shear: float) -> Sequence[str]:
    """Of the half-width a [m], peak pressure p_0 [Pa] and largest shear stress [Pa]."""
    found = []
    ratio = a / q.smallest
    if ratio > 0.05:
        found.append(
            f"a = {a * 1e3:.4g} mm is {ratio:.1%} of the smallest body, {q.smallest_name} of "
            f"{q.smallest * 1e3:.4g} mm: Hertz takes it for a half plane, which it hardly is"
        )
    if q.R_p is not None and 2 * shear > q.R_p:
        found.append(
            f"Tresca stress 2 τ_max = {2 * shear / 1e6:.4g} MPa below the surface exceeds R_p = "
            f"{q.R_p / 1e6:.4g} MPa: the roller yields and Hertz no longer holds"
        )
    if q.R_p is None and p_0 > STATIC_RATING:
        found.append(
            f"p_0 = {p_0 / 1e6:.4g} MPa is beyond 4000 MPa, the static rating of hardened rollers "
            "(ISO 76): expect lasting dents; give R_p"
        )
    if a > q.L / 10:
        found.append(
            f"L = {q.L * 1e3:.4g} mm is only {q.L / a:.3g} times a: no line contact, the ends "
            "carry their share differently"
        )
    return found
