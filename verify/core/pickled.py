"""Results as bytes for the store, and back; only classes of the project and numpy are allowed."""

import pickle
from enum import Enum
from io import BytesIO
from typing import Any

OURS = ("verify.core.", "numpy")
MADE = (("builtins", "complex"), ("builtins", "slice"), ("collections", "OrderedDict"))


class _Reader(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        if (module, name) in MADE or module.startswith(OURS):
            return super().find_class(module, name)
        raise pickle.UnpicklingError(f"{module}.{name} is no class of a result")


class _Writer(pickle.Pickler):
    def reducer_override(self, value: Any) -> Any:
        """Members of enumerations by value: Python 3.11.2 writes them by the function getattr."""
        return (type(value), (value.value,)) if isinstance(value, Enum) else NotImplemented


def to_bytes(value: Any) -> bytes:
    """A result as bytes."""
    content = BytesIO()
    _Writer(content, protocol=5).dump(value)
    return content.getvalue()


def from_bytes(content: bytes) -> Any:
    """The result; UNREADABLE for bytes that are none."""
    return _Reader(BytesIO(content)).load()


UNREADABLE = (
    pickle.UnpicklingError, EOFError, ValueError, LookupError, TypeError, AttributeError,
    ImportError,
)  # fmt: skip
