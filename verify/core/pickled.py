"""Conversion of results to bytes for the store, and back.

Only classes of the project and of numpy are allowed.
"""

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
        raise pickle.UnpicklingError(f"{module}.{name} is not a permitted class in a stored result")


class _Writer(pickle.Pickler):
    def reducer_override(self, value: Any) -> Any:
        """Pickle enumeration members by class and value (Python 3.11.2 would use getattr)."""
        return (type(value), (value.value,)) if isinstance(value, Enum) else NotImplemented


def to_bytes(value: Any) -> bytes:
    """Bytes of a result."""
    content = BytesIO()
    _Writer(content, protocol=5).dump(value)
    return content.getvalue()


def from_bytes(content: bytes) -> Any:
    """Result from its bytes.

    Raises one of the exceptions UNREADABLE if the bytes are not a result.
    """
    return _Reader(BytesIO(content)).load()


UNREADABLE = (
    pickle.UnpicklingError, EOFError, ValueError, LookupError, TypeError, AttributeError,
    ImportError,
)  # fmt: skip
