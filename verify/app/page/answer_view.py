"""The answer as HTML: verdict, design value, margin, limits, values, messages."""

from collections.abc import Sequence

from markupsafe import Markup

from reports.svg import lowered
from verify.app.page.answers import Cells, Shown

STYLE = {"holds": "pass", "fails": "fail", "cannot say": "undecided"}
ELSEWHERE = ("design value:", "margin:", "assumed inputs:")  # lines that are displayed separately
MOST_FAULTS = 20  # that are listed
MARK = {"holds": "✓", "fails": "✗", "cannot say": "?"}


def answer(shown: Shown) -> Markup:
    """The answer with its verdict first; if an input is wrong, the error without a verdict."""
    if not shown.verdict:
        return _faults(shown)
    first, *rest = shown.lines
    return Markup(
        '<p class="verdict {}"><span aria-hidden="true">{}</span> {}</p><dl class="key">'
        "<div><dt>Design value</dt><dd>{}</dd></div><div><dt>Margin</dt><dd>{}{}</dd></div></dl>"
        "{}{}{}{}{}"
    ).format(
        STYLE[shown.verdict], MARK[shown.verdict], shown.verdict.capitalize(),
        lowered(shown.design or "none"), shown.margin or "none",
        lowered(shown.limiting and f" ({shown.limiting})"),
        Markup("<p>{}</p>").format(first.partition(f": {shown.verdict}")[2].removeprefix(": ")),
        _list([one for one in rest if not _is_elsewhere(one)]),
        _list(shown.warnings, "warnings"), _limits(shown.limits), _values(shown),
    )  # fmt: skip


def _is_elsewhere(line: str) -> bool:
    return line.startswith(ELSEWHERE) or line.endswith("listed below the limits")


def brief(shown: Shown) -> Markup:
    """Summary in one line for a narrow screen, where the form is below the answer."""
    if not shown.verdict:
        return Markup("No answer: an input is wrong")
    margin = f", margin {shown.margin}" if shown.margin else ""
    return Markup("{} {}{}").format(MARK[shown.verdict], shown.verdict.capitalize(), margin)


def _faults(shown: Shown) -> Markup:
    lines = [v if v.startswith(f"{k} = ") else f"{k}: {v}" for k, v in shown.faults.items()]
    count = f"{len(lines)} inputs are wrong" if len(lines) > 1 else "an input is wrong"
    if len(lines) > MOST_FAULTS:
        lines[MOST_FAULTS:] = [f"and {len(lines) - MOST_FAULTS} more, marked in the form"]
    return Markup('<p class="verdict none">No answer: {}</p>{}<p class="soft">{}</p>').format(
        count, _list(lines or [shown.fault], "warnings"),
        "The sketch is that of the last inputs with an answer.",
    )  # fmt: skip


def _list(lines: Sequence[str], css: str = "") -> Markup:
    if not lines:
        return Markup("")
    items = Markup("").join(Markup("<li>{}</li>").format(lowered(one)) for one in lines)
    return Markup('<ul class="{}">{}</ul>').format(css, items)


def _limits(cells: Cells) -> Markup:
    if not cells:
        return Markup("")
    header = ("", "criterion", "value", "limit", "margin", "source")
    rows = [(*c[:4], c[4].removeprefix("margin "), c[5]) for c in cells]
    return Markup('<h3>Limits</h3><div class="limits">{}</div>').format(table(header, rows))


def _values(shown: Shown) -> Markup:
    body = table(("symbol", "value", "unit", "what"), shown.values)
    notes = _list(shown.notes)
    assumed = table(("assumed", "source"), tuple(shown.assumed.values())) if shown.assumed else ""
    parts = Markup("<details><summary>Values of the formulas</summary>{}{}</details>").format(
        notes, body
    )
    if assumed:
        parts += Markup("<details><summary>Assumed inputs ({})</summary>{}</details>").format(
            len(shown.assumed), assumed
        )
    return parts


def evidence(shown: Shown) -> Markup:
    """HTML of the rows that were judged with finite elements."""
    header, *rows = shown.rows or ((),)
    return (
        Markup("<p><b>{}</b></p>").format(shown.rows_title)
        + table(header, rows)
        + _list(shown.rows_notes)
    )


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> Markup:
    """Cells as a table that can be scrolled if it is too wide."""
    head = Markup("").join(Markup('<th scope="col">{}</th>').format(lowered(c)) for c in header)
    body = Markup("").join(
        Markup("<tr>{}</tr>").format(
            Markup("").join(Markup("<td>{}</td>").format(lowered(c)) for c in row)
        )
        for row in rows
    )
    return Markup(
        '<div class="wide" tabindex="0"><table><thead><tr>{}</tr></thead><tbody>{}</tbody>'
        "</table></div>"
    ).format(head, body)
