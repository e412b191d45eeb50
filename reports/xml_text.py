"""Text without characters that XML or a typesetter does not accept."""

import re

_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def clean(text: str) -> str:
    """The text with a mark in place of each control character or half of a surrogate pair."""
    return _NOT_XML.sub("\ufffd", text)
