"""Compares every formula with a finite-element model and judges the difference.

`verify.run` and `verify.check` are `freewheel verify` and `check` from Python and in notebooks.
"""

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    """The calls for scripts and notebooks, imported when used: no case depends on their code."""
    if name in ("run", "check"):
        return getattr(import_module("verify.app.notebook"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
