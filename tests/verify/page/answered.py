"""Answers of the page to texts as typed, without a browser."""

from typing import Any

from verify.app.page.answers import shown
from verify.app.page.described import Described, Field, describe
from verify.app.page.toml_text import as_values

TEXTS = ("", " ", "0", "-1", "1e30", "3,5", "nan", "5 furlongs", "12", "0.3", "40 mm", "-2 mm",
         "1e-9 mm", "210 GPa", "50 N m", "2000 r/min", "2 kg", "left", "<b>", "\u2603", '"',
         "10 %")  # fmt: skip
RING = {"r_i": "60 mm", "r_o": "80 mm", "p_i": "100 MPa", "E": "210 GPa", "nu": "0.3"}


def quietly(_state: Any) -> None:
    """Progress that no one sees."""


def answered(case: str, raw: dict[str, Any], *, notes: bool = False) -> Any:
    return shown(case, "my part", as_values(raw, describe(case).whole), notes, quietly)


def places(case: Described, raw: dict[str, Any]) -> list[tuple[str, Field]]:
    """Every input of a form, those of tables too."""
    found = [(f.name, f) for f in case.fields if not f.is_table]
    for table in (f for f in case.fields if f.is_table):
        for k in range(1, len(raw.get(table.name, ())) + 1):
            found += [(f"{table.name}[{k}].{f.name}", f) for f in table.fields]
    return found
