"""Identifiers of values for programs: letters, digits and underscores."""

import re
import unicodedata

WORDS = {"/": " per ", "+": " plus ", "%": " percent", "°": " deg", "*": " star", "∞": " inf"}
GREEK = re.compile(r"GREEK (SMALL|CAPITAL) LETTER (\w+)")


def identifier(key: str) -> str:
    """Key of a value as an identifier: "K mid 3" gives "K_mid_3", "a/R" gives "a_per_R"."""
    for sign, word in WORDS.items():
        key = key.replace(sign, word)
    plain = "".join(_ascii(c) for c in key)
    name = re.sub(r"\W+", "_", plain, flags=re.ASCII).strip("_")
    return f"_{name}" if name[:1].isdigit() else name


def _ascii(character: str) -> str:
    if character.isascii():
        return character
    if greek := GREEK.match(unicodedata.name(character, "")):
        return greek[2].lower()
    base = unicodedata.normalize("NFKD", character)[0]
    return base if base.isascii() else " "
