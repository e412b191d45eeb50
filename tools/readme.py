"""Put the table of verdicts that `make verify` wrote into docs/verified.md, between its marks."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]
MARKS = re.compile(r"(<!-- verdicts -->\n).*?(<!-- /verdicts -->)", re.DOTALL)


def main() -> None:
    table = (ROOT / "reports" / "out" / "verdicts.md").read_text("utf-8")
    page = ROOT / "docs" / "verified.md"
    text, found = MARKS.subn(lambda m: m[1] + table + m[2], page.read_text("utf-8"))
    if found != 1:
        raise SystemExit(
            "docs/verified.md has no place for the table: <!-- verdicts --> <!-- /verdicts -->"
        )
    page.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
