"""Limits of oiled, hardened steel."""

from collections.abc import Iterator

HARD = 4000e6  # Pa, limit of hardened rollers in static contact (ISO 76)
FRICTION = 0.1  # upper estimate for oiled steel


def pressed(*pressures: float) -> Iterator[str]:
    """Warning if a peak pressure [Pa] exceeds `HARD`."""
    if (p := max(pressures)) > HARD:
        yield (
            f"pressure {p / 1e6:.4g} MPa exceeds {HARD / 1e6:g} MPa, the limit of hardened rollers "
            "in static contact (ISO 76)"
        )
