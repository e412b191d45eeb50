"""The gallery: runs each script of examples/gallery, and writes code, output and picture."""

import ast
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from sphinx.errors import ExtensionError

ROOT = Path(__file__).parents[2]
SCRIPTS = ROOT / "examples" / "gallery"
PAGES = ROOT / "docs" / "gallery" / "_generated"
PAGE = """# {title}

{text}

```text
{printed}
```

![{title}]({name}.png)

```{{literalinclude}} ../../../examples/gallery/{name}.py
:language: python
:lines: {first}-
```
"""
CARD = "[![{title}](_generated/{name}.png) {title}](_generated/{name}.md)\n"


def setup(app: Any) -> dict[str, bool]:
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True}


def write(_app: Any) -> None:
    """Run all scripts; write their pages and the cards of the first page."""
    PAGES.mkdir(parents=True, exist_ok=True)
    scripts = sorted(SCRIPTS.glob("*.py"))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        printed = list(pool.map(run, scripts))
    cards = [page(script, text) for script, text in zip(scripts, printed, strict=True)]
    (PAGES / "cards.txt").write_text("\n".join(cards), "utf-8")


def run(script: Path) -> str:
    """Output of a script; its picture is written to the folder of the pages."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "MPLBACKEND": "agg"}
    done = subprocess.run(  # noqa: S603 - a fixed command
        [sys.executable, str(script)], cwd=PAGES, env=environment, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    if done.returncode or not (PAGES / f"{script.stem}.png").exists():
        raise ExtensionError(f"{script.name} failed: {done.stderr}")
    return done.stdout.strip()


def page(script: Path, printed: str) -> str:
    """Write the page of a script; returns the card of the script for the first page."""
    source = script.read_text("utf-8")
    node = ast.parse(source)
    text = ast.get_docstring(node) or ""
    title = text.split("\n")[0].partition(":")[0].rstrip(".")
    first = (node.body[0].end_lineno or 0) + 2
    (PAGES / f"{script.stem}.md").write_text(
        PAGE.format(title=title, text=text, printed=printed, name=script.stem, first=first), "utf-8"
    )
    return CARD.format(name=script.stem, title=title)
