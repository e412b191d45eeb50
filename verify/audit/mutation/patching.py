"""Replacement of running code by a mutant, permanently for this process.

The code object of a function is replaced, so that all names of the function refer to the mutant.
This also applies to methods and cached functions. A constant is set in every module that has it.
Caches of functions of the project are cleared, but other results of the old code remain. Therefore,
each mutant needs a new process.
"""

import ast
import builtins
import gc
import sys
from collections.abc import Iterator
from importlib import import_module
from types import CodeType, FunctionType, ModuleType

from verify.audit.mutation.sites import Changed, Source, constant_of, owners
from verify.form.memoised import forget_memoised


class NotPatchedError(RuntimeError):
    """No function in this process has the code that the mutant changes."""


def patch(of: Source, changed: Changed) -> int:
    """Replace the code in every function that contains it; return the number of replacements.

    Raises NotPatchedError if there is no such function.
    """
    import_module(of.module)  # finite-element modules, which are imported only for solving
    forget_memoised()
    changed.place.put(changed.node)
    try:
        name = changed.mutant.function
        owner = next(item for known, item in owners(of.tree) if known == name)
        if isinstance(owner, ast.FunctionDef):
            in_defaults = any(node is changed.node for node in ast.walk(owner.args))
            return _patch_function(of, name, owner, in_defaults)
        return _set_constant(of, name, owner)
    finally:
        changed.place.put(changed.place.node)


def _patch_function(of: Source, name: str, owner: ast.FunctionDef, in_defaults: bool) -> int:
    codes = {
        (code.co_qualname, code.co_firstlineno): code
        for code in _codes(compile(of.tree, str(of.path), "exec"))
        if code.co_qualname == name or code.co_qualname.startswith(f"{name}.<locals>.")
    }
    patched = 0
    for function in functions(str(of.path)):
        old = function.__code__
        code = codes.get((old.co_qualname, old.co_firstlineno))
        if code is None or len(code.co_freevars) != len(old.co_freevars):
            continue
        function.__code__ = code
        if in_defaults and code.co_qualname == name:
            _set_defaults(function, owner.args)
        patched += 1
    if not patched:
        raise NotPatchedError(f"{of.module}: {name} does not exist and cannot be changed")
    return patched


def functions(path: str) -> Iterator[FunctionType]:
    """All functions of one file in this process, including wrapped functions."""
    for item in gc.get_objects():
        if type(item) is FunctionType and item.__code__.co_filename == path:
            yield item


def _codes(code: CodeType) -> Iterator[CodeType]:
    for item in code.co_consts:
        if isinstance(item, CodeType):
            yield item
            yield from _codes(item)


def _set_defaults(function: FunctionType, given: ast.arguments) -> None:
    def value(node: ast.expr) -> object:
        return eval(  # noqa: S307 - source of the project
            compile(ast.Expression(node), "<default>", "eval"), function.__globals__
        )

    if given.defaults:
        function.__defaults__ = tuple(value(node) for node in given.defaults)
    named = zip(given.kwonlyargs, given.kw_defaults, strict=True)
    if any(given.kw_defaults):
        function.__kwdefaults__ = {
            argument.arg: value(node) for argument, node in named if node is not None
        }


def _set_constant(of: Source, name: str, owner: ast.stmt) -> int:
    module = sys.modules[of.module]
    old = getattr(module, constant_of(owner))
    assert isinstance(owner, ast.Assign | ast.AnnAssign)
    assert owner.value is not None
    code = compile(ast.Expression(owner.value), str(of.path), "eval")
    new = eval(code, vars(module))  # noqa: S307 - source of the project
    holders = [m for m in holding(name, old) if m is not builtins]
    for holder in holders:
        setattr(holder, name, new)
    return len(holders)


def holding(name: str, value: object) -> list[ModuleType]:
    """Modules in which `name` refers to the object `value`."""
    return [m for m in list(sys.modules.values()) if getattr(m, "__dict__", {}).get(name) is value]
