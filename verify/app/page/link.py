"""Converts a state of the page to the text of a link, and back."""

import base64
import binascii
import json
import zlib
from collections.abc import Mapping
from typing import Any

from verify.app.page.session import LONGEST_TEXT, State
from verify.core.inputs import LONGEST_NAME, MOST_ENTRIES, InputError

MOST_BYTES = 100_000  # of the state that a link holds
BROKEN = "the link holds no session: it was cut or changed"


def to_link(state: State) -> str:
    """Text of the state, with characters that are permitted in an address."""
    data = [state.case, state.name, state.raw, state.other]
    packed = zlib.compress(json.dumps(data, ensure_ascii=False).encode(), 9)
    return base64.urlsafe_b64encode(packed).decode().rstrip("=")


def from_link(text: str) -> State:
    """Return the state from the text of `to_link`.

    Raises InputError if the text is invalid or the state is too large.
    """
    try:
        packed = base64.b64decode(text + "=" * (-len(text) % 4), altchars=b"-_", validate=True)
        data = zlib.decompressobj().decompress(packed, MOST_BYTES)
        case, name, raw, other = json.loads(data)
    except (ValueError, TypeError, binascii.Error, zlib.error, RecursionError) as error:
        raise InputError(BROKEN) from error
    if not (
        _is_text(case) and _is_text(name) and len(name) <= LONGEST_NAME
        and _is_raw(raw) and (other is None or _is_raw(other))
    ):  # fmt: skip
        raise InputError(BROKEN)
    return State(case, name, raw, other)


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and len(value) <= LONGEST_TEXT


def _is_raw(value: Any) -> bool:
    """Whether a value contains only texts by name, and lists of such texts."""
    return isinstance(value, Mapping) and all(
        _is_text(one)
        or (isinstance(one, list) and len(one) <= MOST_ENTRIES and all(map(_is_entry, one)))
        for one in value.values()
    )


def _is_entry(value: Any) -> bool:
    return isinstance(value, Mapping) and all(map(_is_text, value.values()))
