"""Default limits of stress and contact pressure, each with its source.

The defaults are for steel. For another material there is no default: the file must give the limit.
"""

from dataclasses import dataclass

STEEL = (190e9, 220e9)  # Pa, Young's modulus
ROLLER_STATIC = 4000e6  # Pa
BALL_STATIC = 4200e6  # Pa
PERMANENT = "permanent deformation 1e-4 of the rolling element's diameter"
SOURCES = {
    ROLLER_STATIC: f"ISO 76, roller bearings of hardened steel ({PERMANENT})",
    BALL_STATIC: f"ISO 76, ball bearings of hardened steel ({PERMANENT})",
}
QUENCHED = "42CrMo4 quenched and tempered, ISO 683-2, minimum yield strength"
YIELD_BY_WALL = ((8e-3, 900e6), (20e-3, 750e6), (60e-3, 650e6), (100e-3, 550e6), (160e-3, 500e6))
STRIP_TENSILE = 1200e6  # Pa
STATIC_SHARE = 0.7  # of the tensile strength, static bending of leaf springs
STRIP = "static bending: 0.7 of 1200 MPa, the minimum tensile strength of strip C75S+QT (EN 10132)"
GIVEN = "given"


@dataclass(frozen=True)
class Strength:
    """A permissible stress or pressure [Pa] with its source.

    `value` is None if no default applies; `source` then states the reason.
    """

    value: float | None
    source: str
    assumed: bool


def is_steel(*moduli: float) -> bool:
    """Whether all Young's moduli [Pa] are in the range of steel."""
    return all(STEEL[0] <= E <= STEEL[1] for E in moduli)


def contact_pressure(given: float | None, *moduli: float, point: bool = False) -> Strength:
    """Permissible static contact pressure [Pa] of bodies with these Young's moduli [Pa].

    The limit is for line contact, or for point contact if `point` is True. Steel is assumed to be
    hardened to 58 HRC.
    """
    standard = BALL_STATIC if point else ROLLER_STATIC
    return _chosen(given, standard, SOURCES[standard], moduli)


def yield_strength(given: float | None, *moduli: float, wall: float) -> Strength:
    """Yield strength [Pa] of parts with these Young's moduli [Pa] and this wall thickness [m]."""
    default = next((R_p for thick, R_p in YIELD_BY_WALL if wall <= thick), None)
    if default is None and given is None:
        return Strength(None, f"no default yield strength for a wall of {wall * 1e3:.4g} mm", True)
    thick = next((t for t, _ in YIELD_BY_WALL if wall <= t), wall)
    source = f"{QUENCHED}, walls up to {thick * 1e3:g} mm"
    return _chosen(given, default, source, moduli)


def strip_strength(given: float | None, E: float) -> Strength:
    """Permissible static bending stress [Pa] of a spring strip with Young's modulus `E` [Pa]."""
    return _chosen(given, STATIC_SHARE * STRIP_TENSILE, STRIP, (E,))


def _chosen(
    given: float | None, default: float | None, source: str, moduli: tuple[float, ...]
) -> Strength:
    if given is not None:
        return Strength(given, GIVEN, False)
    if is_steel(*moduli):
        return Strength(default, source, True)
    E = ", ".join(f"{E / 1e9:.4g} GPa" for E in dict.fromkeys(moduli))
    return Strength(None, f"no default for a material with E = {E}, which is not steel", True)
