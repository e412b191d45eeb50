"""The figure of a sweep: a line over one input, or a colour map over two inputs."""

from typing import Any

from verify.app.page.tasks import MARGIN, Swept

LIGHT = {"ink": "#16191d", "line": "#d5d9dd", "series": "#0b5cad", "limit": "#b3261e"}
DARK = {"ink": "#e8eaec", "line": "#394047", "series": "#6db3f8", "limit": "#ff8a80"}
RAMP = ["#0b5cad", "#56cbb6", "#f0e442", "#e69f00", "#b3261e"]


def options(found: Swept, *, dark: bool) -> dict[str, Any]:
    """Options of ECharts for the figure."""
    colours = DARK if dark else LIGHT
    axis = {
        "nameLocation": "middle", "nameGap": 30, "axisLabel": {"color": colours["ink"]},
        "nameTextStyle": {"color": colours["ink"]},
        "splitLine": {"lineStyle": {"color": colours["line"]}},
    }  # fmt: skip
    common: dict[str, Any] = {
        "grid": {"left": 70, "right": 24, "top": 30, "bottom": 56},
        "tooltip": {"trigger": "item", "confine": True}, "animation": False,
        "aria": {"enabled": True},
    }  # fmt: skip
    if len(found.axes) == 1:
        return common | _line(found, axis, colours)
    return common | _map(found, axis, colours)


def _line(found: Swept, axis: dict[str, Any], colours: dict[str, str]) -> dict[str, Any]:
    ((name, values),) = found.axes
    limit = {"silent": True, "symbol": "none", "lineStyle": {"color": colours["limit"]},
             "data": [{"yAxis": 1}]}  # fmt: skip
    series = {
        "type": "line", "name": found.label, "color": colours["series"], "symbolSize": 7,
        "data": [list(pair) for pair in zip(values, found.values[0], strict=True)],
    }  # fmt: skip
    return {
        "xAxis": axis | {"type": "value", "name": name, "scale": True},
        "yAxis": axis | {"type": "value", "name": found.label, "scale": True, "nameGap": 52},
        "dataZoom": [{"type": "inside"}], "tooltip": {"trigger": "axis", "confine": True},
        "series": [series | ({"markLine": limit} if found.label == MARGIN else {})],
    }  # fmt: skip


def _map(found: Swept, axis: dict[str, Any], colours: dict[str, str]) -> dict[str, Any]:
    (name, values), (second, lines) = found.axes
    cells = [
        [i, j, value]
        for j, row in enumerate(found.values) for i, value in enumerate(row) if value is not None
    ]  # fmt: skip
    ramp = RAMP[::-1] if found.label == MARGIN else RAMP  # small margins are red
    known = [cell[2] for cell in cells] or [0.0, 1.0]
    return {
        "xAxis": axis | {"type": "category", "name": name, "data": [f"{v:g}" for v in values]},
        "yAxis": axis | {"type": "category", "name": second, "data": [f"{v:g}" for v in lines],
                         "nameGap": 52},
        "visualMap": {
            "min": min(known), "max": max(known), "calculable": True, "orient": "vertical",
            "right": 0, "top": "middle", "inRange": {"color": ramp}, "precision": 3,
            "text": [found.label, ""], "textStyle": {"color": colours["ink"]},
        },
        "grid": {"left": 70, "right": 110, "top": 30, "bottom": 56},
        "series": [{"type": "heatmap", "name": found.label, "data": cells}],
    }  # fmt: skip
