"""Imports between modules: the import contracts of the project."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[2]


def imported(body):
    """Names that statements import, inside functions too, but for those of type checking alone."""
    for node in body:
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            continue
        if isinstance(node, ast.ImportFrom):
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
            yield node.module or ""
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        for inner in ("body", "orelse", "finalbody", "handlers", "cases"):
            yield from imported(getattr(node, inner, []))


def test_no_module_imports_itself_through_others():
    paths = {
        ".".join(path.relative_to(ROOT).with_suffix("").parts): path
        for package in ("analytic", "fem", "meshes", "verify", "reports")
        for path in (ROOT / package).rglob("*.py")
        if path.name != "__init__.py"
    }
    graph = {
        name: paths.keys() & set(imported(ast.parse(path.read_text("utf-8")).body))
        for name, path in paths.items()
    }
    TopologicalSorter(graph).prepare()  # CycleError names the circle
