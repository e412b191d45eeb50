"""Recording of the project's functions that a task calls."""

import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import CodeType, FrameType
from typing import Any, Self

from verify.form.memoised import forget_memoised

ROOT = Path(__file__).parents[3]
PACKAGES = ("analytic", "fem", "meshes", "verify")


class Calls:
    """Context that records which functions of the project this thread calls.

    Code objects are stored by identity, because computing their hash would take longer than many
    functions.
    """

    def __init__(self) -> None:
        self._codes: dict[int, CodeType] = {}
        self._before: Any = None

    def __enter__(self) -> Self:
        codes = self._codes

        def note(frame: FrameType, event: str, _argument: Any) -> None:
            if event == "call":
                code = frame.f_code
                codes[id(code)] = code

        self._before = sys.getprofile()
        sys.setprofile(note)
        return self

    def __exit__(self, *_error: object) -> None:
        sys.setprofile(self._before)

    def names(self) -> list[str]:
        """Names of the called functions, each once, such as "analytic.ring.lame:stresses".

        A nested function has the name of the outer function. A method has the name
        "module:Class.method".
        """
        return sorted({name for code in self._codes.values() if (name := name_of(code))})


def called(work: Callable[[], Any]) -> tuple[Any, list[str]]:
    """Result of `work`, and the names of the functions that it called, as in `Calls.names`."""
    forget_memoised()
    calls = Calls()
    with calls:
        found = work()
    return found, calls.names()


def name_of(code: CodeType) -> str:
    """Module and function of code of the project, as text; empty for any other code."""
    module = _module(code.co_filename)
    if not module or code.co_qualname.startswith("<"):
        return ""
    return f"{module}:{code.co_qualname.partition('.<locals>')[0]}"


@cache
def _module(file: str) -> str:
    """Name of a module of the project; empty for any other file."""
    path = Path(file)
    if not path.is_relative_to(ROOT):
        return ""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts) if parts[0] in PACKAGES else ""
