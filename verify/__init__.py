"""Compares every formula with a finite-element model and judges the difference.

In Python and in notebooks, `verify.run` and `verify.check` replace the commands `freewheel verify`
and `freewheel check`.
"""

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    """Return `run` or `check`, imported on first use, so that no case depends on their code."""
    if name in ("run", "check"):
        return getattr(import_module("verify.app.notebook"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
