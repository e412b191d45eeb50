"""Style sheet without rules that no element of its page can match."""

import re
from collections.abc import Iterator

_STYLE = re.compile(r"<style>(.*?)</style>", re.DOTALL)
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")
_CLASS = re.compile(r"\.([A-Za-z][\w-]*)")
_INSIDE = re.compile(r"\([^()]*\)")
_GIVEN = re.compile(r'\bclass="([^"]*)"')
_SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)  # words in scripts can be classes


def used_rules(page: str) -> str:
    """The page with only those rules whose classes all occur in the page or in its scripts.

    Classes within brackets, as in :is(), are ignored: such a rule is retained.
    """
    given = {name for names in _GIVEN.findall(page) for name in names.split()}
    given |= {word for script in _SCRIPT.findall(page) for word in re.findall(r"[\w-]+", script)}

    def kept(rule: re.Match[str]) -> str:
        selectors = [one for one in _parts(rule[1]) if _required(one) <= given]
        return f"{','.join(selectors)}{{{rule[2]}}}" if selectors else ""

    def shorter(style: re.Match[str]) -> str:
        return f"<style>{_RULE.sub(kept, style[1])}</style>"

    return _STYLE.sub(shorter, page, count=1)


def _required(selector: str) -> set[str]:
    """Classes that an element matched by a selector, or one of its ancestors, must have."""
    bare, before = selector, ""
    while bare != before:
        before, bare = bare, _INSIDE.sub("", bare)
    return set(_CLASS.findall(bare))


def _parts(selectors: str) -> Iterator[str]:
    """Selectors of a list; commas within brackets do not separate selectors."""
    depth, start = 0, 0
    for i, letter in enumerate(selectors):
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            yield selectors[start:i]
            start = i + 1
    yield selectors[start:]
