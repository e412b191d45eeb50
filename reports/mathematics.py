"""Conversion of TeX into a tree of plain lists, for programs that cannot read TeX.

A node is a name followed by its parts: "row" (nodes), "letter" and "sign" (a character each),
"upright", "function" and "words" (a string each), "fraction" (two nodes), "scripts" (base, below
or None, above or None), "limits" (the same, above and below the base), "accent" (base,
character), "root" (node, index or None), "fenced" (opening, inner node, closing), "table" (rows of
nodes), "space" (a width in em), "break" and "align" (lines of one equation meet there).
"""

import html
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import groupby
from typing import Any
from xml.etree.ElementTree import Element

from latex2mathml.converter import convert_to_element

Node = list[Any]

ACCENTS = {"˙": "\u0307", "¨": "\u0308", "^": "\u0302", "¯": "\u0304", "~": "\u0303", "→": "\u20d7"}
LIMITS = "∑∏"
FENCES = ("prefix", "postfix")
DELIMITERS = {"(": ")", "[": "]", "{": "}", "|": "|", "‖": "‖", "⟨": "⟩"}


@lru_cache(maxsize=1024)
def tree(tex: str) -> Node:
    """TeX as nested lists. Raises ValueError for TeX that is not supported."""
    spaced = tex.replace(r"\mathrm{", r"\mathrm {")  # or one letter is read as an italic one
    return _row(list(convert_to_element(spaced)))


def _node(e: Element) -> Node:
    try:
        return KNOWN[e.tag](e)
    except KeyError:
        raise ValueError(f"the TeX element {e.tag} is not supported") from None


def _row(elements: Sequence[Element]) -> Node:
    """Node for elements in a row; matching brackets stretch, upright letters form words."""
    if len(elements) == 1:
        return _node(elements[0])
    if elements and _opens(elements):
        closes = elements[-1].get("form") == "postfix" or _is_closing(elements)
        inner = elements[1:-1] if closes else elements[1:]
        return ["fenced", _text(elements[0]), _row(inner), _text(elements[-1]) if closes else ""]
    for at in range(len(elements) - 2):
        if len(elements) > 3 and _is_closing(elements[at : at + 3]):  # a matrix among others
            parts = elements[:at], elements[at : at + 3], elements[at + 3 :]
            return ["row", *(_row(part) for part in parts if part)]
    nodes: list[Node] = []
    for upright, group in groupby(elements, lambda e: e.get("mathvariant") == "normal"):
        if upright:
            nodes.append(["upright", "".join(_text(e) for e in group)])
        else:
            nodes += [_node(e) for e in group]
    return nodes[0] if len(nodes) == 1 else ["row", *nodes]


def _opens(elements: Sequence[Element]) -> bool:
    """Whether a row begins with a stretched bracket, or is a matrix in brackets."""
    return elements[0].get("form") == "prefix" or _is_closing(elements)


def _is_closing(elements: Sequence[Element]) -> bool:
    return (
        len(elements) == 3
        and elements[1].tag == "mtable"
        and DELIMITERS.get(_text(elements[0])) == _text(elements[2])
    )


def _text(e: Element) -> str:
    return html.unescape(e.text or "")


def _identifier(e: Element) -> Node:
    text = _text(e)
    if text == "&":
        return ["align"]
    if e.get("mathvariant") == "normal":
        return ["upright", text]
    if e.get("mathvariant") == "bold-italic":
        return ["bold", text]
    return ["letter", text] if len(text) == 1 else ["function", text]


def _operator(e: Element) -> Node:
    text = _text(e)
    return ["sign", text] if len(text) == 1 else ["function", text] if text else ["row"]


def _space(e: Element) -> Node:
    if e.get("linebreak") == "newline":
        return ["break"]
    return ["space", float(e.get("width", "0em").removesuffix("em"))]


def _scripts(base: Element, below: Element | None, above: Element | None) -> Node:
    kind = "limits" if _text(base) in LIMITS and base.tag == "mo" else "scripts"
    return [kind, *(None if e is None else _node(e) for e in (base, below, above))]


def _over(e: Element) -> Node:
    base, mark = e
    if accent := ACCENTS.get(_text(mark)):
        return ["accent", _node(base), accent]
    return ["limits", _node(base), None, _node(mark)]


def _table(e: Element) -> Node:
    aligned = all(cell.get("columnalign") == "left" for row in e for cell in row)
    rows = [[_row(list(cell)) for cell in row] for row in e]
    return ["table", "left" if aligned else "center", rows]


def _parts(e: Element) -> Iterable[Node]:
    return (_node(part) for part in e)


KNOWN = {
    "mrow": lambda e: _row(list(e)),
    "mi": _identifier,
    "mn": lambda e: ["words", _text(e)],
    "mo": _operator,
    "mtext": lambda e: ["words", _text(e)],
    "mspace": _space,
    "mfrac": lambda e: ["fraction", *_parts(e)],
    "msub": lambda e: _scripts(e[0], e[1], None),
    "msup": lambda e: _scripts(e[0], None, e[1]),
    "msubsup": lambda e: _scripts(*e),
    "mover": _over,
    "munder": lambda e: ["limits", *_parts(e), None],
    "munderover": lambda e: ["limits", *_parts(e)],
    "msqrt": lambda e: ["root", _row(list(e)), None],
    "mroot": lambda e: ["root", *_parts(e)],
    "mtable": _table,
}
