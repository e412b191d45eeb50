"""The sketch of a case, in which each dimension carries the name of its input."""

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
    """The drawing as SVG; `inputs` are names by symbol. "" where there is none."""
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
    """The input whose symbol a label begins with: "L_1/2 = 5.8 mm" is of L_1."""
    symbol = re.split(r"\s*[=/,]\s*", label)[0].strip()
    return inputs.get(symbol, "")
