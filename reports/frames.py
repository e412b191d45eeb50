"""Picture of a field with its frame: bitmap, undeformed outline, colour bar, labels."""

import base64
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from markupsafe import Markup

from reports import svg
from reports.drawing_process import DrawingProcess
from reports.picture_cache import Drawn
from reports.pictures import draw
from reports.viewer import viewer
from verify.core.figures import Picture
from verify.core.results import CaseResult

NOTHING = Markup("")
WIDTH = 400.0
BAR = 180.0  # length of the colour bar
FEW = 2.0  # decades; shorter bars get marks between the powers of ten


@dataclass(frozen=True)
class Frame:
    """A picture on the page: `svg`, or a `view` that can be rotated.

    `by` is the program that drew it; `why` is the reason if this program is not pyvista.
    """

    caption: str
    note: str
    svg: Markup = NOTHING
    view: Markup = NOTHING
    by: str = ""
    why: str = ""


def frames(
    cases: Sequence[CaseResult], cache: Path | None, hint: str = "",
    process: DrawingProcess | None = None,
) -> Mapping[str, list[Frame]]:  # fmt: skip
    """Pictures by id of the case; a picture whose field the case does not have is omitted."""
    wanted = [
        (case.id, field, picture)
        for case in cases
        for picture in case.pictures
        for field in case.fields
        if field.name == picture.field
    ]
    requests = [(field, picture) for _, field, picture in wanted]
    drawn = draw(requests, cache, hint=hint, process=process)
    found: dict[str, list[Frame]] = {case.id: [] for case in cases}
    for (case_id, field, picture), result in zip(wanted, drawn, strict=True):
        found[case_id].append(frame(picture, result))
        if picture.width:
            note = f"{picture.caption}: the centre line is extended over the width of the strip."
            found[case_id].append(Frame(picture.caption, note, view=viewer(field, picture)))
    return found


def frame(picture: Picture, drawn: Drawn) -> Frame:
    """Picture with its outline, colour bar and the scale factor of its deformation."""
    k = WIDTH / drawn.width
    height = k * drawn.height
    x0, y0, x1, y1 = drawn.rectangle

    def at(point: Sequence[float]) -> tuple[float, float]:
        return (
            WIDTH * (point[0] - x0) / (x1 - x0),
            height * (y1 - point[1]) / (y1 - y0),
        )

    less = ", relative to their mean in the window" if picture.window else ""
    times = f"Displacements × {svg.plain(drawn.exaggeration)}{less}; dashed: undeformed outline."
    moved = times if drawn.exaggeration else ""
    data = base64.b64encode(drawn.image).decode()
    body = [
        Markup(
            '<image href="data:image/webp;base64,{}" width="{:g}" height="{:.1f}" '
            'preserveAspectRatio="none"/>'
        ).format(data, WIDTH, height),
        _clipped(
            [svg.polyline([at(p) for p in line], "outline") for line in drawn.outline if moved],
            _name(picture, drawn),
            height,
        ),
        *_colour_bar(picture, drawn, height + 14),
    ]
    return Frame(
        caption=picture.caption,
        note=moved,
        svg=svg.drawing(WIDTH, height + 52, body, picture.caption, "frame"),
        by=drawn.by,
        why=drawn.why,
    )


def _clipped(lines: Sequence[Markup], name: str, height: float) -> Markup:
    """SVG of lines clipped to the picture, because a window displays only a part of them."""
    return Markup(
        '<defs><clipPath id="clip-{0}"><rect width="{1:g}" height="{2:.1f}"/></clipPath></defs>'
        '<g clip-path="url(#clip-{0})">{3}</g>'
    ).format(name, WIDTH, height, Markup("").join(lines))


def _name(picture: Picture, drawn: Drawn) -> str:
    """Prefix of the definitions of this picture, unique on its page."""
    return sha256(repr((drawn.ramp, drawn.rectangle, picture)).encode()).hexdigest()[:10]


def _colour_bar(picture: Picture, drawn: Drawn, y: float) -> list[Markup]:
    """SVG of the colour bar with round numbers and symbol; empty for a picture without data."""
    if not drawn.ramp:
        return []
    name = f"ramp-{_name(picture, drawn)}"
    last = max(len(drawn.ramp) - 1, 1)
    stops = Markup("").join(
        Markup('<stop offset="{:.4f}" stop-color="{}"/>').format(i / last, colour)
        for i, colour in enumerate(drawn.ramp)
    )
    unit = "" if picture.unit == "1" else f" [{picture.unit}]"
    parts = [
        Markup('<defs><linearGradient id="{}">{}</linearGradient></defs>').format(name, stops),
        Markup('<rect x="0" y="{:.1f}" width="{:g}" height="9" fill="url(#{})"/>').format(
            y, BAR, name
        ),
        svg.text(BAR + 10, y + 9, f"{picture.symbol}{unit}"),
    ]
    for value, words in _named(picture, drawn):
        x = BAR * (value - drawn.low) / ((drawn.high - drawn.low) or 1.0)
        parts += [
            Markup('<path d="M{:.1f},{:.1f}v4" class="outline"/>').format(x, y + 9),
            svg.text(x, y + 25, words, "", "start" if x < 8 else "middle"),
        ]
    return parts


def _named(picture: Picture, drawn: Drawn) -> list[tuple[float, str]]:
    """Positions along the bar with their numbers.

    They are round numbers; on a logarithmic bar, powers of ten, or 1, 2 and 5 per decade.
    """
    low, high = drawn.low, drawn.high
    if not picture.decades:
        return [(v, svg.plain(v)) for v in svg.ticks(low, high, 4)]
    whole = range(math.floor(low), math.ceil(high) + 1)
    digits = (1.0,) if high - low >= FEW else (1.0, 2.0, 5.0)
    places = [(math.log10(d) + e, svg.plain(d * 10.0**e)) for e in whole for d in digits]
    return [(v, words) for v, words in places if low - 1e-9 <= v <= high + 1e-9]
