"""Loads, pressures and shares as text in messages of a freewheel."""


def newton_metres(T: float) -> str:
    return f"{T:.4g} N m" if T < 1e4 else f"{T / 1e3:.4g} kN m"


def newton(F: float) -> str:
    return f"{F:.4g} N" if F < 1e4 else f"{F / 1e3:.4g} kN"


def pascal(p: float) -> str:
    return f"{p / 1e6:.4g} MPa" if p < 1e10 else f"{p / 1e9:.3g} GPa"


def share(part: float) -> str:
    """Share `part` of the random samples as text in per cent; a single sample is 0.005 % of all."""
    if part == 0:
        return "none"
    return "all" if part == 1 else f"{100 * part:.3g} %"
