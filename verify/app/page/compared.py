"""Two variants side by side: differences first, identical entries in a closed section."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from markupsafe import Markup

from verify.app.page.answer_view import table
from verify.app.page.answers import Shown
from verify.app.page.described import Described

SIDES = ("A (the form)", "B (stored)")
Row = tuple[str, str, str, str]  # symbol, meaning, A, B


def compared(
    case: Described, raws: tuple[Mapping[str, Any], Mapping[str, Any]], shown: tuple[Shown, Shown]
) -> Markup:
    """HTML of verdicts and margins, then of inputs and values with symbol and description."""
    same: list[Row] = []
    parts = [Markup("<h3>Variants side by side</h3>"), table(("", *SIDES), list(_answers(*shown)))]
    for title, rows in (("Inputs", _inputs(case, raws, shown)), ("Values", _values(*shown))):
        listed = list(rows)
        differ = [row for row in listed if row[2] != row[3]]
        same += [row for row in listed if row[2] == row[3]]
        if differ:
            parts.append(Markup("<h4>{} that differ ({})</h4>").format(title, len(differ)))
            parts.append(table(("symbol", "what", *SIDES), differ))
        elif listed:
            parts.append(Markup("<p>{} do not differ.</p>").format(title))
    if same:
        cells = table(("symbol", "what", "A and B"), [row[:3] for row in same])
        summary = Markup("<details><summary>Identical inputs and values ({})</summary>{}</details>")
        parts.append(summary.format(len(same), cells))
    return Markup("").join(parts)


def _answers(a: Shown, b: Shown) -> Iterator[tuple[str, str, str]]:
    yield "verdict", a.verdict or "wrong input", b.verdict or "wrong input"
    yield "design value", a.design, b.design
    yield "margin", a.margin, b.margin
    yield "limited by", a.limiting, b.limiting


def _inputs(
    case: Described, raws: tuple[Mapping[str, Any], Mapping[str, Any]], shown: tuple[Shown, Shown]
) -> Iterator[Row]:
    """Every input in the order of the form; inputs of tables are listed by entry."""
    given = [_flat(raw) for raw in raws]
    for field in case.fields:
        places = [(field.name, field)]
        if field.is_table:
            count = max(len(raw.get(field.name, ())) for raw in raws)
            places = [
                (f"{field.name}[{k}].{one.name}", one)
                for k in range(1, count + 1) for one in field.fields
            ]  # fmt: skip
        for place, one in places:
            a, b = (_text_of(place, g, s) for g, s in zip(given, shown, strict=True))
            if a or b:
                symbol = f"{place.rpartition('.')[0]} {one.symbol or one.name}".strip()
                yield symbol, one.what, a or "left out", b or "left out"


def _text_of(place: str, given: Mapping[str, str], shown: Shown) -> str:
    if place in given:
        return given[place]
    text = shown.assumed[place][0] if place in shown.assumed else ""
    return f"{text.partition(' = ')[2]}, assumed" if text else ""


def _flat(raw: Mapping[str, Any]) -> dict[str, str]:
    """Texts of inputs by their places, such as "supports[2].k" for an input in a table."""
    found: dict[str, str] = {}
    for name, value in raw.items():
        if isinstance(value, list):
            for k, entry in enumerate(value, start=1):
                found |= {f"{name}[{k}].{key}": str(text) for key, text in entry.items()}
        else:
            found[name] = str(value)
    return found


def _values(a: Shown, b: Shown) -> Iterator[Row]:
    """Values of the formulas with their units.

    They are empty if a variant has no answer.
    """
    if not (a.verdict and b.verdict):
        return
    sides = [{(s, what): f"{value} {unit}".strip() for s, value, unit, what in one.values}
             for one in (a, b)]  # fmt: skip
    names: Iterable[tuple[str, str]] = sides[0] | sides[1]
    for symbol, what in names:
        values = [side.get((symbol, what), "none") for side in sides]
        yield symbol, what, values[0], values[1]
