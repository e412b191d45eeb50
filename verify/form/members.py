"""Members of a case's class that its formulas or its reference use."""

import ast
from collections.abc import Collection, Iterator
from pathlib import Path
from sys import modules

from verify.core import module_syntax
from verify.core.inputs import Inputs
from verify.form.quantity import CaseError, Declared, Family

MACHINERY = ("verify.core.", "verify.form.", "pydantic.")  # of no case


def reached(
    form: type[Inputs], start: Collection[str], *, formulas: bool
) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
    """Members that the members `start` use, and `start`: module, class and names of members.

    A member counts as used if an attribute with its name is read from any object; the result may
    contain too many members, but never too few. Without `formulas`, quantities that a reference
    must not read are omitted.
    """
    bodies = {cls: dict(_body(cls)) for cls in _classes(form)}
    hidden = set() if formulas else {name for name in _names(form) if _is_formula(form, name)}
    declared = [vars(c)[name] for c in _classes(form) for name in vars(c)]
    methods = {  # a member of a family is its method
        d.quantity.name: d.quantity.formula.__name__ for d in declared if isinstance(d, Declared)
    }
    found: set[str] = set()
    queue = list(start)
    while queue:
        name = queue.pop()
        if (name := methods.get(name, name)) in found or name in hidden:
            continue
        found.add(name)
        nodes = [body[name] for body in bodies.values() if name in body]
        queue += [n.attr for one in nodes for n in ast.walk(one) if isinstance(n, ast.Attribute)]
    return tuple(
        (cls.__module__, cls.__name__, tuple(sorted(found & body.keys())))
        for cls, body in bodies.items() if found & body.keys()
    )  # fmt: skip


def check_names(form: type[Inputs]) -> None:
    """Raise CaseError if a class declares two members with the same name."""
    for cls in _classes(form):
        lines: dict[str, int] = {}
        for name, node in _body(cls):
            if name in lines:
                file = Path(modules[cls.__module__].__file__ or "").name
                rule = f"{cls.__name__}.{name}: this name is already declared in line {lines[name]}"
                raise CaseError(f"{file}:{node.lineno}: {rule}")
            lines[name] = node.lineno


def _classes(form: type[Inputs]) -> list[type]:
    return [c for c in form.__mro__ if not f"{c.__module__}.".startswith((*MACHINERY, "builtins."))
            and issubclass(c, Inputs)]  # fmt: skip


def _names(form: type[Inputs]) -> Iterator[str]:
    for cls in _classes(form):
        yield from vars(cls)


def _is_formula(form: type[Inputs], name: str) -> bool:
    declared = next((vars(c)[name] for c in form.__mro__ if name in vars(c)), None)
    one = next(iter(declared.members.values())) if isinstance(declared, Family) else declared
    return isinstance(one, Declared) and one.quantity.role != "geometry"


def _body(cls: type) -> Iterator[tuple[str, ast.stmt]]:
    """Members of a class in the code of its file; empty for a class inside a function."""
    body = module_syntax.tree(cls.__module__).body
    nodes = (n for n in body if isinstance(n, ast.ClassDef) and n.name == cls.__name__)
    found = next(nodes, None)
    for node in found.body if found else ():
        if isinstance(node, ast.FunctionDef):
            yield node.name, node
        for target in node.targets if isinstance(node, ast.Assign) else ():
            if isinstance(target, ast.Name):
                yield target.id, node
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            yield node.target.id, node
