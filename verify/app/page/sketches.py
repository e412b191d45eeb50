"""The sketch of a case, in which each dimension is marked with the name of its input."""

import re
from collections.abc import Mapping

from markupsafe import escape

from reports.sketch import sketch
from reports.svg import lowered
from verify.core.figures import Sketch

_LABEL = re.compile(
    r'(?P<lines>(?:<path class="(?:dim|dim-head|load|head)" d="[^"]*"/>)*)'
    r'(?P<text><text class="sym"[^>]*>(?P<inner>.*?)</text>)'
)


def named_sketch(data: Sketch | None, inputs: Mapping[str, str]) -> str:
    """Sketch of a case as SVG; "" if the case has no sketch.

    `inputs` contains the names of the inputs by their symbols.
    """
    if data is None:
        return ""
    of_label = {
        str(lowered(shape.label)): name
        for shape in data.shapes
        if (name := _input_of(shape.label, inputs))
    }

    def grouped(match: re.Match[str]) -> str:
        name = of_label.get(match["inner"])
        return f'<g data-input="{escape(name)}">{match[0]}</g>' if name else match[0]

    return _LABEL.sub(grouped, str(sketch(data)))


def _input_of(label: str, inputs: Mapping[str, str]) -> str:
    """Name of the input with whose symbol a label begins.

    For example, "L_1/2 = 5.8 mm" belongs to L_1.
    """
    symbol = re.split(r"\s*[=/,]\s*", label)[0].strip()
    return inputs.get(symbol, "")
