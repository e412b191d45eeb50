"""Write tables of the last `make verify` between the marks of documents; update stored verdicts."""

import json
import re
from pathlib import Path

from pydantic import TypeAdapter

from verify.core.verdicts import FormulaVerdict
from verify.verdicts.record import keep

ROOT = Path(__file__).parents[1]
OUT = ROOT / "reports" / "out"
TABLES = {  # mark: file written by `make verify`, and the document with the mark
    "cases": ("cases.md", "docs/verified.md"),
    "verdicts": ("verdicts.md", "docs/verdicts.md"),
    "counts": ("verdict-counts.md", "README.md"),
}


def main() -> None:
    for mark, (written, document) in TABLES.items():
        _put(mark, (OUT / written).read_text("utf-8"), ROOT / document)
    found = json.loads((OUT / "results.json").read_text("utf-8"))["verdicts"]
    keep(TypeAdapter(tuple[FormulaVerdict, ...]).validate_python(found))


def _put(mark: str, table: str, page: Path) -> None:
    start, end = f"<!-- {mark} -->\n", f"<!-- /{mark} -->"
    marks = re.compile(f"({start}).*?({end})", re.DOTALL)
    text, found = marks.subn(lambda m: m[1] + table + m[2], page.read_text("utf-8"))
    if found != 1:
        raise SystemExit(f"{page.name} must contain exactly once: {start.strip()} ... {end}")
    page.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
