"""Error messages of formulas, rewritten in the units of parameter files."""

import re


def in_millimetres(rule: str) -> str:
    """Text of the violated rule of a formula, with lengths in mm."""
    return re.sub(r"=(\S+) m\b", lambda m: f" = {float(m[1]) * 1e3:.7g} mm", rule)
