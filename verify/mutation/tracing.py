"""Which functions of the project a piece of work calls."""

import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

ROOT = Path(__file__).parents[2]
PACKAGES = ("analytic", "fem", "meshes", "verify")


def called(work: Callable[[], Any]) -> tuple[Any, list[str]]:
    """What `work` returns, and the functions that it called: "analytic.ring.lame:stresses".

    A function inside another counts as the outer one; methods are "module:Class.method".
    """
    codes: set[CodeType] = set()

    def note(frame: FrameType, event: str, _argument: Any) -> None:
        if event == "call":
            codes.add(frame.f_code)

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        found = work()
    finally:
        sys.setprofile(before)
    return found, named(codes)


def named(codes: Iterable[CodeType]) -> list[str]:
    """The project's functions among code objects."""
    return sorted({name for code in codes if (name := name_of(code))})


def name_of(code: CodeType) -> str:
    """Module and function of the project's code; empty for any other."""
    path = Path(code.co_filename)
    if not path.is_relative_to(ROOT):
        return ""
    module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
    if module.partition(".")[0] not in PACKAGES or code.co_qualname.startswith("<"):
        return ""
    return f"{module}:{code.co_qualname.partition('.<locals>')[0]}"
