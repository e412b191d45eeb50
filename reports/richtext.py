"""Marked-up text as plain data, for the PDF and for the cells of a sheet."""

import re
from html.parser import HTMLParser
from typing import Any

from markupsafe import Markup

Run = str | list[Any]

VOID = {"br"}
_EXPONENT = re.compile(r"([−-]?[\d.]+)e([+−-]?\d+)")
RAISED = str.maketrans("0123456789−+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺")


def runs(text: str) -> list[Run]:
    """Text as runs: plain strings, and lists of a tag (var, sub, sup, small, br) and its runs.

    Only `Markup` contains tags; any other string is one unchanged run.
    """
    if not isinstance(text, Markup):
        return [text] if text else []
    parser = _Runs()
    parser.feed(text)
    parser.close()
    return parser.stack[0]


def digits(text: str) -> list[Run]:
    """A printed number as runs: 1.2e-08 gives 1.2×10⁻⁸; any other text is unchanged."""
    match = _EXPONENT.fullmatch(text)
    if not match:
        return runs(text)
    power = str(int(match[2].replace("−", "-"))).replace("-", "−")
    return [match[1], ["small", "×10", ["sup", power]]]


def plain(text: str) -> str:
    """Marked-up text as a plain string: exponents are raised digits, an index has an underscore."""
    return "".join(_plain(run) for run in runs(text))


def _plain(run: Run) -> str:
    if isinstance(run, str):
        return run
    tag, *inner = run
    text = "".join(_plain(part) for part in inner)
    if tag == "sup":
        return text.translate(RAISED)
    if tag == "br":
        return " "
    return f"_{text}" if tag == "sub" else text


class _Runs(HTMLParser):
    """Parser that converts nested tags into nested lists."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.stack: list[list[Run]] = [[]]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:  # noqa: ARG002
        if tag == "wbr":  # a place where a page may break a word
            return
        node: list[Run] = [tag]
        self.stack[-1].append(node)
        if tag not in VOID:
            self.stack.append(node)

    def handle_endtag(self, tag: str) -> None:  # noqa: ARG002
        if len(self.stack) > 1:
            self.stack.pop()

    def handle_data(self, data: str) -> None:
        self.stack[-1].append(data)
