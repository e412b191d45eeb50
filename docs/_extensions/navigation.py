"""Shortens the side bar to packages: entries for 500 modules would make every page slow."""

from collections.abc import Callable
from typing import Any

DEPTH = 3


def setup(app: Any) -> dict[str, bool]:
    app.connect("html-page-context", shorten, priority=100)  # before the theme draws the side bar
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def shorten(_app: Any, _page: str, _template: str, context: dict[str, Any], _tree: Any) -> None:
    whole: Callable[..., str] | None = context.get("toctree")
    if whole:
        context["toctree"] = lambda **options: whole(**{**options, "maxdepth": DEPTH})
