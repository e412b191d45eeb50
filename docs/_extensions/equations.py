"""Draws equations during the build with the typesetter of the reports, without script or font.

`reports.equations` draws an equation as SVG in the colour of the text.
"""

import re
from typing import Any

from docutils.nodes import SkipNode
from sphinx.util import logging

from reports.equations import Equations
from reports.glyphs import SYMBOLS
from reports.mathematics import tree

LOGGER = logging.getLogger(__name__)
GLYPHS = f'<svg width="0" height="0" style="position:absolute" aria-hidden="true">{SYMBOLS}</svg>'
SIZES = re.compile(r"\\[td](?=frac)|\\!")  # sizes and spaces; the typesetter chooses its values
_of_page: dict[str, Equations] = {}


def setup(app: Any) -> dict[str, bool]:
    app.add_html_math_renderer("typeset", (inline, None), (display, None))
    app.connect("html-page-context", place)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def inline(translator: Any, node: Any) -> None:
    """Write an equation within a line of text."""
    translator.body.append(_asked(translator, node))
    raise SkipNode


def display(translator: Any, node: Any) -> None:
    """Write an equation on a separate line; on a narrow page, it can be scrolled."""
    translator.body.append(f'<div class="equation" tabindex="0">{_asked(translator, node)}</div>')
    raise SkipNode


def _asked(translator: Any, node: Any) -> str:
    page = translator.builder.current_docname
    tex = SIZES.sub(lambda found: "\\" if found[0] != r"\!" else "", node.astext().strip())
    try:
        tree(tex)
    except (ValueError, LookupError) as error:
        LOGGER.warning("no drawing of the equation %s: %s", tex, error, location=node)
    return str(_of_page.setdefault(page, Equations()).maths(tex))


def place(_app: Any, page: str, _template: str, context: dict[str, Any], _tree: Any) -> None:
    """Insert the drawings into a page."""
    if equations := _of_page.pop(page, None):
        context["body"] = equations.placed([GLYPHS + context["body"]])[0]
