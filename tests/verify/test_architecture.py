"""Where modules may import others; import contracts state which."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[2]
# a half-space, and what it and finite elements take of formulas: crowns, a load
REFERENCE = {"reference", "pressed", "gap", "even_crowns", "plane_at_middle", "_best_crown", "grip"}


def test_only_what_makes_the_reference_or_is_compiled_imports_below_the_top_of_a_file():
    """Finite elements or a half-space, on which results depend, and what `dynamic` runs."""
    for path in (ROOT / "verify" / "cases").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.FunctionDef) and not (
                "fem" in node.name
                or "dynamic" in node.name
                or node.name in REFERENCE
                or path.stem in ("reference", "fem")
            ):
                inner = [n for n in ast.walk(node) if isinstance(n, ast.Import | ast.ImportFrom)]
                assert not inner, f"{path.name}: {node.name}"


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


def test_no_module_imports_itself_by_way_of_others():
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
