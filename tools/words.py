"""Find words in texts and comments for which tools/words.toml prescribes another term.

    python -m tools.words [FILE ...]

Reads comments and strings of Python and JavaScript files, and the complete text of documents and
templates. Prints `file:line: word: replacement`. The exit status is 1 if a word was found.
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
READ = (".py", ".md", ".toml", ".cff", ".html", ".js", ".css", ".typ", ".j2", ".schema.json", ".in")
TEXTS = {
    tokenize.COMMENT,
    tokenize.STRING,
    getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING),  # from Python 3.12
}
F_STRING = re.compile(r"(?i)rf|fr|f")  # prefix of a string token, before Python 3.12
EXPRESSION = re.compile(r"\{([^{}\n]*)\}")
KEY = re.compile(r"[\"']\w+[\"']")  # of a dictionary or a schema
QUOTED = re.compile(r"`[\w.]+`")  # an identifier in a text
LITERAL = re.compile(r"'[^'\n]*'|\"[^\"\n]*\"")
SCRIPT = re.compile(r"(?<!:)//.*|/\*.*?\*/|'[^'\n]*'|\"[^\"\n]*\"|`[^`\n]*`")
IN_SCRIPT = re.compile(r"\$\{[^{}]*\}")  # expressions of template strings
TAGS = re.compile(r"\{\{.*?\}\}|\{%.*?%\}|(?:class|id|href)=\"[^\"]*\"")  # of page templates
NAMES = re.compile(r"#?[\w-]+(?:\.[\w-]+)+|#[\w-]+")  # of typst


class Word(NamedTuple):
    """A word to be replaced: pattern, replacement, and permitted phrases that contain it."""

    found: re.Pattern[str]
    instead: str
    allowed: re.Pattern[str] | None


def words(listed: Sequence[dict[str, Any]]) -> list[Word]:
    """Patterns of the list. Raises KeyError or re.error if an entry is invalid."""
    return [
        Word(
            re.compile(rf"(?<![\w-])(?:{one['pattern']})(?![\w-])", re.IGNORECASE),
            one["instead"],
            re.compile("|".join(map(re.escape, one["allowed"]))) if "allowed" in one else None,
        )
        for one in listed
    ]


def texts(path: Path) -> Iterator[tuple[int, str]]:
    """Lines of a file with their numbers; for a Python file, only comments and strings."""
    source = path.read_text("utf-8")
    if path.suffix == ".py":
        yield from _python(source)
        return
    in_script = path.suffix == ".js"
    for number, line in enumerate(source.splitlines(), 1):
        in_script = in_script or "<script" in line
        if in_script:
            yield number, " ".join(SCRIPT.findall(IN_SCRIPT.sub("", line)))
        else:
            code = {".typ": NAMES, ".j2": TAGS, ".json": KEY}.get(path.suffix)
            yield number, code.sub("", line) if code else line
        in_script = in_script and "</script" not in line


def _python(source: str) -> Iterator[tuple[int, str]]:
    tokens = list(tokenize.generate_tokens(io.StringIO(source).readline))
    for before, token, after in zip(
        [tokens[-1], *tokens], tokens, [*tokens[1:], tokens[-1]], strict=False
    ):
        is_key = after.string == ":" or (before.string == "[" and after.string == "]")
        if token.type in TEXTS and not (is_key and KEY.fullmatch(token.string)):
            text = token.string
            if token.type == tokenize.STRING and F_STRING.match(text):
                text = EXPRESSION.sub(lambda m: " ".join(LITERAL.findall(m[1])), text)
            for shift, line in enumerate(text.splitlines()):
                yield token.start[0] + shift, line


def found(path: Path, listed: Sequence[Word]) -> Iterator[tuple[int, str, str]]:
    """Line, word and replacement of each occurrence in a file."""
    for number, line in texts(path):
        text = QUOTED.sub("", line)
        for word in listed:
            plain = word.allowed.sub("", text) if word.allowed else text
            for match in word.found.finditer(plain):
                yield number, match[0], word.instead


def tracked(skipped: Sequence[str]) -> list[Path]:
    """Files of the project that are checked."""
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
    """Print every occurrence in the given files, or in the whole project."""
    settings = tomllib.loads(LIST.read_text("utf-8"))
    listed = words(settings["word"])
    paths = [Path(one).resolve() for one in arguments] or tracked(settings["skipped"])
    count = 0
    for path in paths:
        for number, word, instead in found(path, listed):
            name = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
            print(f"{name}:{number}: {word}: {instead}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
