"""State of a page: case, name, typed texts, a second variant, and the history."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

MOST_STEPS = 200  # that can be undone
LONGEST_TEXT = 200  # characters of one input


@dataclass(frozen=True)
class State:
    """One state of a page.

    `raw` are the inputs in the form of a parameter file, with the texts that the user typed.
    `other` are the raw inputs of the variant for comparison; None without a variant.
    """

    case: str
    name: str
    raw: Mapping[str, Any] = field(default_factory=dict)
    other: Mapping[str, Any] | None = None


@dataclass
class Session:
    """The present state with previous and undone states."""

    state: State
    before: list[State] = field(default_factory=list)
    after: list[State] = field(default_factory=list)
    edited: str = ""  # the input of the last edit, whose further edits are the same step

    def put(self, state: State, edited: str = "") -> None:
        """Make another state the present state.

        `edited` is the only input that has changed; "" for any other change.
        """
        if state == self.state:
            return
        if not edited or edited != self.edited:
            self.before = [*self.before[1 - MOST_STEPS :], self.state]
        self.after, self.state, self.edited = [], state, edited

    def edit(self, place: str, text: str) -> None:
        """Set the text of the input at `place`, such as "r_i", or "supports[2].k" in a table.

        An empty text omits the input. Raises ValueError if the text is too long, LookupError if the
        table has no such entry.
        """
        if len(text) > LONGEST_TEXT:
            raise ValueError(f"{place}: needs at most {LONGEST_TEXT} characters, got {len(text)}")
        raw = edited_raw(self.state.raw, place, text)
        self.put(replace(self.state, raw=raw), place)

    def undo(self) -> bool:
        """Go back one step. Returns whether there was a previous state."""
        if not self.before:
            return False
        self.after.append(self.state)
        self.state, self.edited = self.before.pop(), ""
        return True

    def redo(self) -> bool:
        """Repeat the last undone step. Returns whether there was an undone state."""
        if not self.after:
            return False
        self.before.append(self.state)
        self.state, self.edited = self.after.pop(), ""
        return True


def edited_raw(raw: Mapping[str, Any], place: str, text: str) -> dict[str, Any]:
    """Raw inputs after replacing the text of the input at `place`.

    Raises LookupError if the place is in a table that does not exist or has no such entry.
    """
    table, bracket, rest = place.partition("[")
    if not bracket:
        return _with(raw, place, text)
    number, _, key = rest.partition("].")
    entries = list(raw[table])
    entries[int(number) - 1] = _with(entries[int(number) - 1], key, text)
    return {**raw, table: entries}


def text_at(raw: Mapping[str, Any], place: str) -> str:
    """Text of the input at one place; "" if the input is omitted."""
    table, bracket, rest = place.partition("[")
    if not bracket:
        return str(raw.get(place, ""))
    number, _, key = rest.partition("].")
    return str(raw[table][int(number) - 1].get(key, ""))


def with_entry(raw: Mapping[str, Any], table: str, entry: Mapping[str, Any]) -> dict[str, Any]:
    """Raw inputs with one additional entry in a table."""
    return {**raw, table: [*raw.get(table, ()), dict(entry)]}


def without_entry(raw: Mapping[str, Any], table: str, number: int) -> dict[str, Any]:
    """Raw inputs without entry `number` of a table, counted from 1."""
    left = [one for k, one in enumerate(raw[table], start=1) if k != number]
    return {**raw, table: left} if left else {k: v for k, v in raw.items() if k != table}


def _with(raw: Mapping[str, Any], key: str, text: str) -> dict[str, Any]:
    if not text.strip():
        return {k: v for k, v in raw.items() if k != key}
    return {**raw, key: text}
