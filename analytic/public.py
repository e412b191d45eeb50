"""Public names of packages, imported when they are first used.

The public names of a package are the names that its stub `__init__.pyi` imports. Type checkers and
editors read the same stub. Importing the package or one of its modules does not import the modules
of the other names.
"""

import ast
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any


def lazily(package: str, file: str) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` for the package whose `__init__.py` is `file`.

    `__all__` is the sorted list of the public names. Unknown names raise AttributeError.

    >>> from analytic import ring
    >>> ring.__all__[:2]
    ['FourierRing', 'LoadedRace']
    """

    @cache
    def homes() -> dict[str, tuple[str, str]]:
        """Module of every public name, and the name in that module."""
        stub = ast.parse(Path(file).with_suffix(".pyi").read_text("utf-8"))
        imports = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
        return {a.asname or a.name: (str(i.module), a.name) for i in imports for a in i.names}

    @cache
    def earlier() -> dict[str, str]:
        """For each renamed public name of version 0.1, the present name."""
        stub = ast.parse(Path(file).with_suffix(".pyi").read_text("utf-8"))
        named = [
            x for x in stub.body if isinstance(x, ast.Assign) and isinstance(x.value, ast.Name)
        ]
        return {ast.unparse(x.targets[0]): ast.unparse(x.value) for x in named}

    def public(name: str) -> Any:
        if name == "__all__":
            return sorted(homes())
        name = earlier().get(name, name)
        if name.startswith("__") or name not in homes():
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module, there = homes()[name]
        if module == package:
            return import_module(f"{module}.{there}")
        return getattr(import_module(module), there)

    return public, lambda: sorted(homes())
