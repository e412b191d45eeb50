"""Numbers that differ from another number in a single digit."""

from collections.abc import Iterator

from verify.papers.digits import half_last_digit, number


def is_misprint(value: float, printed: str) -> bool:
    """Whether `value`, rounded to the digits of `printed`, differs from `printed` in one digit.

    >>> is_misprint(27.6596, "27.86"), is_misprint(27.6596, "27.66"), is_misprint(7.66, "27.66")
    (True, False, False)
    """
    return _in_place(number(printed), printed) in set(_changed(_in_place(value, printed)))


def misprints(value: float, printed: str) -> Iterator[float]:
    """All numbers that differ from `value` in exactly one of the digits of `printed`."""
    unit = 2 * half_last_digit(printed)
    return (int(text) * unit for text in _changed(_in_place(value, printed)))


def _in_place(value: float, printed: str) -> str:
    """Digits of `value` down to the last printed place, with its sign."""
    return str(round(value / (2 * half_last_digit(printed))))


def _changed(text: str) -> Iterator[str]:
    """Texts in which one digit of `text` is replaced by another digit; no leading zero."""
    for n, digit in enumerate(text):
        if digit.isdigit():
            for other in "0123456789":
                leads = n == 0 or not text[n - 1].isdigit()
                if other != digit and not (leads and other == "0"):
                    yield text[:n] + other + text[n + 1 :]
