"""Temporary changes of constants and arguments in the finite elements of a case, for one rerun."""

import functools
import importlib
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from typing import Any

from verify.form.memoised import forget_memoised
from verify.judging.budget_statement import Argument, Change, Constant


@contextmanager
def changed(changes: Sequence[Change]) -> Iterator[None]:
    """Apply `changes` in the body of a `with` statement, and always restore the previous state.

    A changed function or class is replaced in every module that has imported it, because the
    result must not depend on which modules were imported before. A constant is replaced in the
    named module only. Raises LookupError if a name does not exist, and RuntimeError if a function
    that was to be called with other arguments was not called.
    """
    calls: dict[str, int] = {}
    forget_memoised()  # otherwise an earlier result would replace the changed one
    with ExitStack() as stack:
        stack.callback(forget_memoised)
        for change in changes:
            if isinstance(change, Argument):
                calls[change.target] = 0
                stack.enter_context(_called_with(change, calls))
            else:
                stack.enter_context(_other_value(change))
        yield
    for target, count in calls.items():
        if not count:
            raise RuntimeError(f"{target} was not called: the change had no effect")


@contextmanager
def _called_with(change: Argument, calls: dict[str, int]) -> Iterator[None]:
    _, _, original = _found(change.target)

    def counted(call: Callable[..., Any], *given: Any, **keywords: Any) -> Any:
        calls[change.target] += 1
        return call(*given, **{**keywords, **change.keywords})

    replacement = _like(original, counted)
    _replace(original, replacement)
    try:
        yield
    finally:
        _replace(replacement, original)  # also in modules that were imported in the meantime


def _replace(old: Any, new: Any) -> None:
    """Bind `new` to every name of a loaded module that is bound to `old`."""
    for module in list(sys.modules.values()):
        names = getattr(module, "__dict__", {})
        for name in [name for name, value in list(names.items()) if value is old]:
            names[name] = new


def _like(original: Any, counted: Callable[..., Any]) -> Any:
    """Replacement of `original` that counts its calls; a class is replaced by a subclass."""
    if not isinstance(original, type):
        return functools.partial(counted, original)

    start = vars(original)["__init__"]

    def __init__(self: Any, *given: Any, **keywords: Any) -> None:  # noqa: N807 - a method
        counted(functools.partial(start, self), *given, **keywords)

    return type(original.__name__, (original,), {"__init__": __init__})


@contextmanager
def _other_value(change: Constant) -> Iterator[None]:
    module, name, original = _found(change.target)
    if isinstance(original, bool) or not isinstance(original, int | float):
        raise LookupError(f"{change.target} must be a number to be changed by a factor")
    setattr(module, name, type(original)(original * change.factor))
    try:
        yield
    finally:
        setattr(module, name, original)


def _found(target: str) -> tuple[Any, str, Any]:
    module_name, _, name = target.partition(":")
    try:
        module = importlib.import_module(module_name)
        return module, name, getattr(module, name)
    except (ImportError, AttributeError) as error:
        raise LookupError(f"{target} does not exist and cannot be changed") from error
