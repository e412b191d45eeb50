"""Numbers for equations: powers of ten in TeX, brackets around negative numbers."""


def tex(value: float, digits: int = 6) -> str:
    r"""A number as TeX with at most `digits` significant digits.

    >>> tex(19.44), tex(3e-6), tex(-1.25e-5)
    ('19.44', '3\\cdot 10^{-6}', '-1.25\\cdot 10^{-5}')
    """
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    if not exponent:
        return mantissa
    power = rf"10^{{{int(exponent)}}}"
    return power if mantissa == "1" else rf"{mantissa}\cdot {power}"


def factor(value: float, digits: int = 6) -> str:
    """A number as a factor in a product; a negative number has brackets."""
    text = tex(value, digits)
    return f"({text})" if value < 0 else text
