"""The form of a case as HTML.

The attribute data-place marks input fields and places of messages.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from markupsafe import Markup

from reports.svg import lowered
from verify.app.page.described import Described, Field
from verify.app.page.session import text_at

ADD, REMOVE = "add", "remove"  # actions of buttons, with the table and the number of an entry


def form(case: Described, raw: Mapping[str, Any]) -> Markup:
    """HTML of required inputs, then optional inputs, then tables."""
    needed = [f for f in case.fields if f.needed and not f.is_table]
    optional = [f for f in case.fields if not f.needed and not f.is_table]
    tables = [f for f in case.fields if f.is_table]
    parts = [_group("Inputs", needed, raw)] if needed else []
    if optional:
        title = "May be left out: then assumed or not used"
        parts.append(_group(title, optional, raw))
    parts += [_table(field, raw) for field in tables]
    return Markup("").join(parts)


def _group(title: str, fields: list[Field], raw: Mapping[str, Any]) -> Markup:
    cells = Markup("").join(_cell(f, f.name, text_at(raw, f.name)) for f in fields)
    return Markup('<fieldset><legend>{}</legend><div class="fields">{}</div></fieldset>').format(
        title, cells
    )


def _table(table: Field, raw: Mapping[str, Any]) -> Markup:
    entries = Markup("").join(_entries(table, raw))
    return Markup(
        '<fieldset><legend>{}</legend><p class="soft">{}</p>{}'
        '<button type="button" data-action="{}" data-table="{}">Add an entry to {}</button>'
        "</fieldset>"
    ).format(table.name, table.what, entries, ADD, table.name, table.name)


def _entries(table: Field, raw: Mapping[str, Any]) -> Iterator[Markup]:
    for k in range(1, len(raw.get(table.name, ())) + 1):
        places = [(f, f"{table.name}[{k}].{f.name}") for f in table.fields]
        cells = Markup("").join(_cell(f, at, text_at(raw, at)) for f, at in places)
        yield Markup(
            '<div class="entry"><h3>{0}[{1}] <button type="button" data-action="{2}" '
            'data-table="{0}" data-entry="{1}">Remove<span class="hidden"> {0}[{1}]</span>'
            '</button></h3><div class="fields">{3}</div></div>'
        ).format(table.name, k, REMOVE, cells)


def _cell(field: Field, place: str, text: str) -> Markup:
    """HTML of one input: symbol, description, field, range, unit, and a place for messages."""
    return Markup(
        '<div class="field" data-at="{at}"><label for="in-{at}"><b>{symbol}</b> {what}</label>'
        '{control}<p class="rule" id="rule-{at}">{rule}</p>'
        '<p class="message" id="msg-{at}" aria-live="polite"></p></div>'
    ).format(
        at=place, symbol=lowered(field.symbol or field.name), what=lowered(field.what),
        control=_control(field, place, text), rule=_rule(field),
    )  # fmt: skip


def _rule(field: Field) -> str:
    unit = "" if field.unit == "1" else f"[{field.unit}]"
    return "; ".join(filter(None, (unit, field.rule, "whole number" if field.whole else "")))


def _control(field: Field, place: str, text: str) -> Markup:
    about = Markup('id="in-{0}" data-place="{0}" aria-describedby="rule-{0} msg-{0}"').format(place)
    if not field.words:
        return Markup(
            '<input {} data-unit="{}" value="{}" placeholder="{}" title="takes {}" '
            'maxlength="200" autocomplete="off" spellcheck="false">'
        ).format(about, "" if field.unit == "1" else field.unit, text,
                 "" if field.needed else "left out", field.takes or "a text")  # fmt: skip
    words = ["", *field.words]
    if text not in words:
        words.append(text)
    options = Markup("").join(
        Markup('<option value="{}"{}>{}</option>').format(
            word, Markup(" selected") if word == text else "", word or "left out"
        )
        for word in words
    )
    return Markup("<select {}>{}</select>").format(about, options)
