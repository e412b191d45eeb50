"""Value of a printed number, and its uncertainty, which follows from its digits."""

import re

_NUMBER = re.compile(
    r"(?P<sign>[-+−]?)(?P<mantissa>\d+(?:\.\d+)?)(?:(?:e|\s*[×x]\s*10\^?)(?P<exponent>[-+−]?\d+))?"
)


def _parts(printed: str) -> tuple[str, int]:
    match = _NUMBER.fullmatch(printed.strip())
    if match is None:
        raise ValueError(f"{printed!r} must be a printed number such as 0.601 or 1.4×10^-5")
    sign = "-" if match["sign"] in ("-", "−") else ""
    exponent = int((match["exponent"] or "0").replace("−", "-"))
    return sign + match["mantissa"], exponent


def number(printed: str) -> float:
    """Value of a printed number.

    >>> number("1.4×10^-5")
    1.4e-05
    """
    mantissa, exponent = _parts(printed)
    return float(f"{mantissa}e{exponent}")


def is_number(text: str) -> bool:
    """Whether a text consists of a printed number only.

    >>> is_number("0.601"), is_number("k_1"), is_number("")
    (True, False, False)
    """
    return _NUMBER.fullmatch(text.strip()) is not None


def half_last_digit(printed: str) -> float:
    """Half a unit of the last printed place.

    >>> half_last_digit("0.613"), half_last_digit("3500")
    (0.0005, 0.5)
    """
    mantissa, exponent = _parts(printed)
    decimals = len(mantissa.partition(".")[2])
    return float(f"0.5e{exponent - decimals}")
