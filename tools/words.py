"""Find words in texts and comments that the glossary replaces.

    python -m tools.words [FILE ...]

Reads comments and strings of Python files and whole texts of documents and templates. Prints
`file:line: word: what stands in its place`; exit status 1 where a word was found.
"""

import io
import re
import shutil
import subprocess
import sys
import tokenize
import tomllib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
LIST = ROOT / "tools" / "words.toml"
READ = (".py", ".md", ".toml", ".cff", ".html", ".js", ".css", ".in")
TEXTS = {
    tokenize.COMMENT,
    tokenize.STRING,
    getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING),  # from Python 3.12
}


class Word(NamedTuple):
    """A word to replace: where it is found, what stands in its place, and phrases that may stay."""

    found: re.Pattern[str]
    instead: str
    allowed: re.Pattern[str] | None


def words(listed: Sequence[dict[str, Any]]) -> list[Word]:
    """The list as patterns; raises KeyError and re.error where an entry is wrong."""
    return [
        Word(
            re.compile(rf"(?<![\w-])(?:{one['pattern']})(?![\w-])", re.IGNORECASE),
            one["instead"],
            re.compile("|".join(map(re.escape, one["allowed"]))) if "allowed" in one else None,
        )
        for one in listed
    ]


def texts(path: Path) -> Iterator[tuple[int, str]]:
    """Lines of a file with their numbers; of a Python file, its comments and strings only."""
    source = path.read_text("utf-8")
    if path.suffix != ".py":
        yield from enumerate(source.splitlines(), 1)
        return
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type in TEXTS:
            for shift, line in enumerate(token.string.splitlines()):
                yield token.start[0] + shift, line


def found(path: Path, listed: Sequence[Word]) -> Iterator[tuple[int, str, str]]:
    """Line, word and replacement of each occurrence in a file."""
    for number, line in texts(path):
        for word in listed:
            plain = word.allowed.sub("", line) if word.allowed else line
            for match in word.found.finditer(plain):
                yield number, match[0], word.instead


def tracked(skipped: Sequence[str]) -> list[Path]:
    """Files of the project whose texts are read."""
    git = shutil.which("git") or "git"
    listed = subprocess.run(  # noqa: S603
        [git, "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    return [
        ROOT / name
        for name in listed
        if name.endswith(READ) and not name.startswith(tuple(skipped)) and (ROOT / name).is_file()
    ]


def main(arguments: Sequence[str]) -> int:
    """Print every occurrence in the files given, or in the whole project."""
    settings = tomllib.loads(LIST.read_text("utf-8"))
    listed = words(settings["word"])
    paths = [Path(one).resolve() for one in arguments] or tracked(settings["skipped"])
    count = 0
    for path in paths:
        for number, word, instead in found(path, listed):
            print(f"{path.relative_to(ROOT)}:{number}: {word}: {instead}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
