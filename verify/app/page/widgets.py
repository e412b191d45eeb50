"""Elements of the page that can be used with the keyboard and with screen readers."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from markupsafe import Markup, escape
from nicegui import ui

VALUE = "event => emit(event.target.value)"
IS_DARK = "matchMedia('(prefers-color-scheme: dark)').matches"
ANSWERED = 10.0  # s within which a browser must answer


def button(text: str, on_click: Callable[[], Any], *, css: str = "", name: str = "") -> ui.html:
    """A button; `name` is its id, by which keyboard shortcuts and tests find it."""
    found = ui.html(escape(text), sanitize=False, tag="button").classes(css)
    found.props(f'type="button" id="{name}"' if name else 'type="button"')
    return found.on("click", on_click, args=[])


def enable(one: ui.html, on: bool) -> None:
    """Enable or disable a button."""
    one.props(remove="disabled") if on else one.props("disabled")


class Choice:
    """A labelled list to select one entry; `value` is the key of the selected entry."""

    def __init__(
        self, label: str, options: Mapping[str, str], name: str, value: str = "",
        on_change: Callable[[], Any] = lambda: None,
    ) -> None:  # fmt: skip
        self.value = value or next(iter(options), "")
        self.options, self.on_change = options, on_change
        items = Markup("").join(
            Markup('<option value="{}"{}>{}</option>').format(
                key, Markup(" selected") if key == self.value else "", text
            )
            for key, text in options.items()
        )
        html = Markup('{}<select id="{}">{}</select>').format(label, name, items)
        ui.html(html, sanitize=False, tag="label").on("change", self._take, js_handler=VALUE)

    def _take(self, event: Any) -> None:
        self.value = str(event.args)
        if self.is_offered:
            self.on_change()

    @property
    def is_offered(self) -> bool:
        """Whether the value is one of the options.

        A forged message of a browser can contain any other value.
        """
        return self.value in self.options


class Typed:
    """A labelled text field."""

    def __init__(self, label: str, name: str, value: str = "", example: str = "") -> None:
        self.value = value
        html = Markup(
            '{}<input id="{}" value="{}" placeholder="{}" maxlength="100" autocomplete="off">'
        ).format(label, name, value, example)
        ui.html(html, sanitize=False, tag="label").on("input", self._take, js_handler=VALUE)

    def _take(self, event: Any) -> None:
        self.value = str(event.args)[:200]


async def is_dark() -> bool:
    """Whether the browser prefers dark pages; False if it is too busy to answer."""
    try:
        return bool(await ui.run_javascript(IS_DARK, timeout=ANSWERED))
    except TimeoutError:
        return False


def tool(title: str, name: str) -> ui.element:
    """A section of the page that can be opened and closed."""
    found = ui.element("details").classes("tool").props(f'id="{name}"')
    with found:
        ui.html(escape(title), sanitize=False, tag="summary")
    return found


def html(content: str = "", css: str = "") -> ui.html:
    """HTML element; its texts must already be escaped."""
    return ui.html(content, sanitize=False).classes(css)


def message(text: str) -> str:
    """An error message as HTML."""
    return str(Markup('<p class="error" role="alert">{}</p>').format(text)) if text else ""


def chosen_of(groups: Sequence[tuple[str, Sequence[tuple[str, str]]]], chosen: str) -> Markup:
    """Options in groups. The first option equal to `chosen` is selected."""
    parts = []
    for title, names in groups:
        options = Markup("")
        for name, text in names:
            here, chosen = name == chosen, "" if name == chosen else chosen
            mark = Markup(" selected") if here else ""
            options += Markup('<option value="{}"{}>{}</option>').format(name, mark, text)
        parts.append(Markup('<optgroup label="{}">{}</optgroup>').format(title, options))
    return Markup("").join(parts)
