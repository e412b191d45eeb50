"""Links of documents to files without a page: README is the first page, a folder is plain text."""

import re
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
LINK = re.compile(r"\[([^\]]+)\]\(((?:\.\./)+)([^)#\s]+)\)")


def setup(app: Any) -> dict[str, bool]:
    app.connect("source-read", rewrite)
    return {"parallel_read_safe": True}


def rewrite(_app: Any, _page: str, source: list[str]) -> None:
    source[0] = LINK.sub(_link, source[0])


def _link(found: re.Match[str]) -> str:
    words, up, target = found.groups()
    if target == "README.md":
        return f"[{words}]({up.removeprefix('../')}index.md)"
    return words if (ROOT / target).is_dir() else found[0]
